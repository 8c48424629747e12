//! Any motion.

use super::{Along, Definition, Freedom, JointKind, Posture};

pub(super) const DEFINITION: Definition = Definition {
    word: "floating",
    freedoms: &[
        Freedom::slide("vx", Along::Frame(0)),
        Freedom::slide("vy", Along::Frame(1)),
        Freedom::slide("vz", Along::Frame(2)),
        Freedom::turn("wx", Along::Frame(0)),
        Freedom::turn("wy", Along::Frame(1)),
        Freedom::turn("wz", Along::Frame(2)),
    ],
    posture: Some(Posture::Floating),
    make: |_| JointKind::Floating,
};
