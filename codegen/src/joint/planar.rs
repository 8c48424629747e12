//! Translation in the plane perpendicular to an axis, and rotation about the axis.

use super::{Along, Definition, Freedom, JointKind, Posture};

pub(super) const DEFINITION: Definition = Definition {
    word: "planar",
    freedoms: &[
        Freedom::translation("vx", Along::Frame(0)),
        Freedom::translation("vy", Along::Frame(1)),
        Freedom::rotation("wz", Along::Frame(2)),
    ],
    posture: Some(Posture::Planar),
    make: |_| JointKind::Planar,
};
