//! Rotation about a point.

use super::{Along, Definition, DegreeOfFreedom, JointKind, Manifold};

pub(super) const DEFINITION: Definition = Definition {
    word: Manifold::Spherical.word(),
    degrees_of_freedom: &[
        DegreeOfFreedom::rotation("wx", Along::Frame(0)),
        DegreeOfFreedom::rotation("wy", Along::Frame(1)),
        DegreeOfFreedom::rotation("wz", Along::Frame(2)),
    ],
    manifold: Some(Manifold::Spherical),
    make: |_| JointKind::Spherical,
};
