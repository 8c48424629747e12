//! Rotation about an axis and translation along it, in a fixed ratio.

use super::{Along, Definition, DegreeOfFreedom, JointKind, Movement};

pub(super) const DEFINITION: Definition = Definition {
    word: "screw",
    degrees_of_freedom: &[DegreeOfFreedom {
        name: "angle",
        movement: Movement::Helix,
        along: Along::Axis,
    }],
    manifold: None,
    make: |pitch| JointKind::Screw { pitch },
};
