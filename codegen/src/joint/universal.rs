//! Rotation about a first axis, and about a second one that the first rotation moves (Cardan joint).

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "universal",
    freedoms: &[
        Freedom::rotation("first", Along::Axis),
        Freedom::rotation("second", Along::Second),
    ],
    posture: None,
    make: |_| JointKind::Universal,
};
