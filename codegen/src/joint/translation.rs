//! Translation along x, y and z of the joint's frame, without rotation.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "translation",
    freedoms: &[
        Freedom::translation("x", Along::Frame(0)),
        Freedom::translation("y", Along::Frame(1)),
        Freedom::translation("z", Along::Frame(2)),
    ],
    posture: None,
    make: |_| JointKind::Translation,
};
