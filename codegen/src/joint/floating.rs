//! Any motion.

use super::{Along, Definition, Freedom, JointKind, Posture};

pub(super) const DEFINITION: Definition = Definition {
    word: "floating",
    freedoms: &[
        Freedom::translation("vx", Along::Frame(0)),
        Freedom::translation("vy", Along::Frame(1)),
        Freedom::translation("vz", Along::Frame(2)),
        Freedom::rotation("wx", Along::Frame(0)),
        Freedom::rotation("wy", Along::Frame(1)),
        Freedom::rotation("wz", Along::Frame(2)),
    ],
    posture: Some(Posture::Floating),
    make: |_| JointKind::Floating,
};
