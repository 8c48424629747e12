//! Does not move.

use super::{Definition, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "fixed",
    freedoms: &[],
    make: |_| JointKind::Fixed,
};
