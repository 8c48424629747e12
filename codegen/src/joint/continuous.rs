//! Turns about its axis, without limits.

use super::{Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "continuous",
    freedoms: &[("angle", Freedom::Turn)],
    make: |_| JointKind::Continuous,
};
