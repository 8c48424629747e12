//! Turns about its axis and slides along it, each for itself.

use super::{Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "cylindrical",
    freedoms: &[("angle", Freedom::Turn), ("shift", Freedom::Slide)],
    make: |_| JointKind::Cylindrical,
};
