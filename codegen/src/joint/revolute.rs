//! Rotation about an axis, within limits.

use super::{Along, Definition, DegreeOfFreedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "revolute",
    degrees_of_freedom: &[DegreeOfFreedom::rotation("angle", Along::Axis)],
    manifold: None,
    make: |_| JointKind::Revolute,
};
