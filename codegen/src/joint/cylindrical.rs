//! Turns about its axis and slides along it, each for itself.

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
