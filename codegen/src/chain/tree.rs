//! The tree of links, with names resolved to numbers.

use std::collections::HashMap;

use crate::description::{JointId, LinkId, Number};
use crate::expression::Double;

/// The part of a description that is modelled.
#[derive(Debug)]
pub struct Tree {
    /// The link taken as fixed.
    pub base: LinkId,
    /// Joints downstream of the base, parents before children and siblings in the order of the description.
    pub branches: Vec<Branch>,
    /// The end effector, the link of poses and Jacobians.
    pub tip: Option<LinkId>,
    /// Further links whose frames are requested.
    pub frames: Vec<LinkId>,
    /// Links with an external wrench.
    pub external: Vec<LinkId>,
    /// Pairs of links whose collision spheres have distances; empty for all that no joint joins.
    pub collision_pairs: Vec<[LinkId; 2]>,
    /// Links that are not modelled.
    pub dropped: Vec<LinkId>,
    /// Joints that the request locks, with their coordinates \[rad or m\], including those outside the tree.
    pub locks: HashMap<JointId, Number>,
}

impl Tree {
    /// True if a joint between two links moves.
    pub fn move_apart(&self, links: [LinkId; 2]) -> bool {
        let [a, b] = links.map(|link| {
            let mut at = link;
            // Children come after parents, so one pass backwards meets the path in order.
            for branch in self.branches.iter().rev() {
                if branch.child == at && branch.held.is_some() {
                    at = branch.parent;
                }
            }
            at
        });
        a != b
    }
}

/// A joint of the tree.
#[derive(Debug)]
pub struct Branch {
    /// The joint.
    pub joint: JointId,
    /// The parent link.
    pub parent: LinkId,
    /// The child link.
    pub child: LinkId,
    /// The coordinate at which it is held [rad or m]; `None` if it moves.
    pub held: Option<Number>,
    /// The mimicked joint, for a mimic joint.
    pub mimics: Option<MimicLaw>,
}

/// The motion of a mimic joint: multiplier · q + offset.
#[derive(Clone, Copy, Debug)]
pub struct MimicLaw {
    /// The joint that has the coordinate q.
    pub mimicked: JointId,
    /// The multiplier.
    pub multiplier: Double,
    /// The offset [rad or m].
    pub offset: Double,
}
