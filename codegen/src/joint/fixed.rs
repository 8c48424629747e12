//! No motion.

use super::{Definition, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "fixed",
    freedoms: &[],
    posture: None,
    make: |_| JointKind::Fixed,
};
