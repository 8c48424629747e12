//! Translation along an axis.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "prismatic",
    freedoms: &[Freedom::translation("shift", Along::Axis)],
    posture: None,
    make: |_| JointKind::Prismatic,
};
