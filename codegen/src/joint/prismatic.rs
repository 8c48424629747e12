//! Translation along an axis.

use super::{Along, Definition, DegreeOfFreedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "prismatic",
    degrees_of_freedom: &[DegreeOfFreedom::translation("shift", Along::Axis)],
    manifold: None,
    make: |_| JointKind::Prismatic,
};
