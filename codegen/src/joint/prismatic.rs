//! Slides along its axis.

use super::{Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "prismatic",
    freedoms: &[("shift", Freedom::Slide)],
    make: |_| JointKind::Prismatic,
};
