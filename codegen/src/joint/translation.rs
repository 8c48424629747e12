//! Slides along x, y and z of its frame, which stays parallel to itself.

use super::{Along, Definition, Freedom, JointKind};

pub(super) const DEFINITION: Definition = Definition {
    word: "translation",
    freedoms: &[
        Freedom::slide("x", Along::Frame(0)),
        Freedom::slide("y", Along::Frame(1)),
        Freedom::slide("z", Along::Frame(2)),
    ],
    posture: None,
    make: |_| JointKind::Translation,
};
