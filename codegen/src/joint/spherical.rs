//! Rotation about a point.

use super::{Along, Definition, Freedom, JointKind, Posture};

pub(super) const DEFINITION: Definition = Definition {
    word: "spherical",
    freedoms: &[
        Freedom::turn("wx", Along::Frame(0)),
        Freedom::turn("wy", Along::Frame(1)),
        Freedom::turn("wz", Along::Frame(2)),
    ],
    posture: Some(Posture::Spherical),
    make: |_| JointKind::Spherical,
};
