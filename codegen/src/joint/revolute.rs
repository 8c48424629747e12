//! Turns about its axis, within limits.

use super::{Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "revolute",
    freedoms: &[("angle", Freedom::Turn)],
    make: |_| JointKind::Revolute,
};
