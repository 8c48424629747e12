//! Rotation about an axis, without limits.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "continuous",
    freedoms: &[Freedom::rotation("angle", Along::Axis)],
    posture: None,
    make: |_| JointKind::Continuous,
};
