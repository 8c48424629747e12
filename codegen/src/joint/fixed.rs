//! No motion.

use super::{Definition, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "fixed",
    degrees_of_freedom: &[],
    manifold: None,
    make: |_| JointKind::Fixed,
};
