//! Rotation about an axis and translation along it, in a fixed ratio.

use super::{Along, Definition, Freedom, JointKind, Movement};

pub(super) const DEFINITION: Definition = Definition {
    word: "screw",
    freedoms: &[Freedom {
        name: "angle",
        movement: Movement::Helix,
        along: Along::Axis,
    }],
    posture: None,
    make: |pitch| JointKind::Screw { pitch },
};
