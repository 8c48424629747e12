//! Rotation about an axis, within limits.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "revolute",
    freedoms: &[Freedom::rotation("angle", Along::Axis)],
    posture: None,
    make: |_| JointKind::Revolute,
};
