//! A robot as data for the generic recursions of the runtime.

use crate::closure::Row;
use crate::joint::Posture;
use crate::schedule::Program;

/// A robot as data for the generic recursions of the runtime.
#[derive(Clone, Debug)]
pub struct ChainData {
    /// The joints' names, parents before children.
    pub names: Vec<String>,
    /// The joint that carries the link on which each joint hangs; none where that is the base.
    pub parents: Vec<Option<u16>>,
    /// What moves each joint.
    pub motions: Vec<DataMotion>,
    /// Further frames, the tip's first: name, and the joint that carries it.
    pub frames: Vec<(String, Option<u16>)>,
    /// How many of the last frames are acted on from outside, and whether that is in frame 0.
    pub external: (usize, bool),
    /// The drives of which something is modelled: each the joint, and which of its velocities.
    pub driven: Vec<(u16, u16)>,
    /// The numbers, of parameters only. A joint has 28: placement at q = 0 in its parent's frame
    /// (rows of the upper 3×4 block), screw (u, b), pseudo-inertia (xx, yy, zz, xy, xz, yz, the
    /// first moments qx, qy, qz, and m). A frame has 12, its placement. Gravity has 3, and each drive
    /// has 3: armature, damping, friction.
    pub program: Program,
    /// What its loops hold together.
    pub loops: LoopsData,
}

/// What closes the loops of a robot, as data.
#[derive(Clone, Debug)]
pub struct LoopsData {
    /// The loops.
    pub loops: Vec<LoopData>,
    /// Which velocities are driven.
    pub driven: Vec<bool>,
    /// The numbers, of parameters only. A loop has 25: the placements of its two frames, and the length of
    /// a rod, or the cosine of the angle of two axes.
    pub program: Program,
}

/// What closes a loop, as data.
#[derive(Clone, Debug)]
pub struct LoopData {
    /// Its name.
    pub name: String,
    /// The frames that it holds together: name, and the joint that carries it.
    pub frames: [(String, Option<u16>); 2],
    /// What it closes.
    pub rows: Vec<Row>,
}

/// What moves a joint of a [`ChainData`], whose coordinates and velocities follow those of the joints before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DataMotion {
    /// A coordinate of its own, along the screw.
    Along,
    /// That of another joint, times a number, along the screw.
    Follows {
        /// The joint.
        leader: u16,
        /// The number.
        multiplier: f64,
    },
    /// A posture; the screw is that of its first velocity.
    Posture(Posture),
}

impl DataMotion {
    /// How many coordinates and velocities it has.
    #[must_use]
    pub const fn counts(self) -> (usize, usize) {
        match self {
            Self::Along => (1, 1),
            Self::Follows { .. } => (0, 0),
            Self::Posture(posture) => (posture.coordinates().len(), posture.velocities()),
        }
    }
}
