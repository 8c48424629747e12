//! Turns about its first axis, and about the second, which the first one turns (Cardan's).

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "universal",
    freedoms: &[
        Freedom::turn("first", Along::Axis),
        Freedom::turn("second", Along::Second),
    ],
    posture: None,
    make: |_| JointKind::Universal,
};
