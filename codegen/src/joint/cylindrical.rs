//! Rotation about an axis and translation along it, independent of each other.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "cylindrical",
    freedoms: &[
        Freedom::turn("angle", Along::Axis),
        Freedom::slide("shift", Along::Axis),
    ],
    posture: None,
    make: |_| JointKind::Cylindrical,
};
