//! Translation along x, y and z of the joint's frame, without rotation.

use super::{Along, Definition, DegreeOfFreedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "translation",
    degrees_of_freedom: &[
        DegreeOfFreedom::translation("x", Along::Frame(0)),
        DegreeOfFreedom::translation("y", Along::Frame(1)),
        DegreeOfFreedom::translation("z", Along::Frame(2)),
    ],
    manifold: None,
    make: |_| JointKind::Translation,
};
