//! Any motion.

use super::{Along, Definition, DegreeOfFreedom, JointKind, Manifold};

pub(super) const DEFINITION: Definition = Definition {
    word: Manifold::Floating.word(),
    degrees_of_freedom: &[
        DegreeOfFreedom::translation("vx", Along::Frame(0)),
        DegreeOfFreedom::translation("vy", Along::Frame(1)),
        DegreeOfFreedom::translation("vz", Along::Frame(2)),
        DegreeOfFreedom::rotation("wx", Along::Frame(0)),
        DegreeOfFreedom::rotation("wy", Along::Frame(1)),
        DegreeOfFreedom::rotation("wz", Along::Frame(2)),
    ],
    manifold: Some(Manifold::Floating),
    make: |_| JointKind::Floating,
};
