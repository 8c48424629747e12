//! Turns about its axis and slides along it, in a fixed ratio.

use super::{Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "screw",
    freedoms: &[("angle", Freedom::Helix)],
    make: |pitch| JointKind::Screw { pitch },
};
