//! Rotation about a first axis, and about a second one that the first rotation moves (Cardan joint).

use super::{Along, Definition, DegreeOfFreedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "universal",
    degrees_of_freedom: &[
        DegreeOfFreedom::rotation("first", Along::Axis),
        DegreeOfFreedom::rotation("second", Along::Second),
    ],
    manifold: None,
    make: |_| JointKind::Universal,
};
