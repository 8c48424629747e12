//! The robot as data, for the generic recursions of the runtime.

use crate::closure::ResidualKind;
use crate::joint::Manifold;
use crate::schedule::Program;

/// The robot as data, for the generic recursions of the runtime.
#[derive(Clone, Debug)]
pub struct ChainData {
    /// Names of the joints, parents before children.
    pub names: Vec<String>,
    /// Joint that carries the parent link of each joint; `None` for the base.
    pub parents: Vec<Option<u16>>,
    /// Motion of each joint.
    pub motions: Vec<DataMotion>,
    /// Frames, the end effector's first: name, and the joint that carries it.
    pub frames: Vec<(String, Option<u16>)>,
    /// Number of the last frames that external wrenches act on, and whether these are given in frame 0.
    pub external: (usize, bool),
    /// Modelled actuators: the joint, and the index of one of its velocities.
    pub actuated: Vec<(u16, u16)>,
    /// Numbers; the program reads parameters only. A joint has 28: placement at q = 0 in its parent's frame (rows of
    /// the upper 3×4 block), screw (u, b), and pseudo-inertia (xx, yy, zz, xy, xz, yz, the first moments qx, qy, qz,
    /// and m). A frame has 12, its placement. Gravity has 3. Each actuator has 3: armature, damping, friction.
    pub program: Program,
    /// Closed loops.
    pub loops: LoopsData,
}

/// Closed loops of a robot as data.
#[derive(Clone, Debug)]
pub struct LoopsData {
    /// Loops.
    pub loops: Vec<LoopData>,
    /// For each velocity: true if it is actuated.
    pub actuated: Vec<bool>,
    /// Numbers; the program reads parameters only. A loop has 25: the placements of its two frames, and the length of a
    /// rod or the cosine of the angle between two axes.
    pub program: Program,
}

/// Closed loop as data.
#[derive(Clone, Debug)]
pub struct LoopData {
    /// Name.
    pub name: String,
    /// Frames A and B that it connects: name, and the joint that carries it.
    pub frames: [(String, Option<u16>); 2],
    /// Residuals.
    pub rows: Vec<ResidualKind>,
}

/// Motion of a joint of [`ChainData`]. Its coordinates and velocities follow those of the joints before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DataMotion {
    /// One coordinate along the screw.
    Along,
    /// Mimic joint: the coordinate of another joint times a factor, along the screw.
    Mimic {
        /// The mimicked joint.
        mimicked: u16,
        /// The factor.
        multiplier: f64,
    },
    /// Several coordinates with quaternions or planar ones; the screw is that of the first velocity.
    Manifold(Manifold),
}

impl DataMotion {
    /// Numbers of its coordinates and velocities.
    #[must_use]
    pub const fn counts(self) -> (usize, usize) {
        match self {
            Self::Along => (1, 1),
            Self::Mimic { .. } => (0, 0),
            Self::Manifold(manifold) => (manifold.coordinates().len(), manifold.velocities()),
        }
    }
}
