//! Rotation about an axis and translation along it, independent of each other.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "cylindrical",
    freedoms: &[
        Freedom::rotation("angle", Along::Axis),
        Freedom::translation("shift", Along::Axis),
    ],
    posture: None,
    make: |_| JointKind::Cylindrical,
};
