//! Rotation about a point.

use super::{Along, Definition, Freedom, JointKind, Posture};

pub(super) const DEFINITION: Definition = Definition {
    word: "spherical",
    freedoms: &[
        Freedom::rotation("wx", Along::Frame(0)),
        Freedom::rotation("wy", Along::Frame(1)),
        Freedom::rotation("wz", Along::Frame(2)),
    ],
    posture: Some(Posture::Spherical),
    make: |_| JointKind::Spherical,
};
