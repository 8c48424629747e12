//! Rotation about an axis, without limits.

use super::{Along, Definition, DegreeOfFreedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "continuous",
    degrees_of_freedom: &[DegreeOfFreedom::rotation("angle", Along::Axis)],
    manifold: None,
    make: |_| JointKind::Continuous,
};
