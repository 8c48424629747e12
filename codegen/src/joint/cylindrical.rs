//! Rotation about an axis and translation along it, independent of each other.

use super::{Along, Definition, DegreeOfFreedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "cylindrical",
    degrees_of_freedom: &[
        DegreeOfFreedom::rotation("angle", Along::Axis),
        DegreeOfFreedom::translation("shift", Along::Axis),
    ],
    manifold: None,
    make: |_| JointKind::Cylindrical,
};
