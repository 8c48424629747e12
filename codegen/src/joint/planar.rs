//! Translation in the plane perpendicular to an axis, and rotation about the axis.

use super::{Along, Definition, DegreeOfFreedom, JointKind, Manifold};

pub(super) const DEFINITION: Definition = Definition {
    word: Manifold::Planar.word(),
    degrees_of_freedom: &[
        DegreeOfFreedom::translation("vx", Along::Frame(0)),
        DegreeOfFreedom::translation("vy", Along::Frame(1)),
        DegreeOfFreedom::rotation("wz", Along::Frame(2)),
    ],
    manifold: Some(Manifold::Planar),
    make: |_| JointKind::Planar,
};
