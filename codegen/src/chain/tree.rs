//! How links hang on the base: what is left of a description's names once they refer to each other.

use std::collections::HashMap;

use crate::description::{JointId, LinkId, Number};
use crate::expression::Double;

/// The part of a description that is modelled.
#[derive(Debug)]
pub struct Tree {
    /// The link taken as fixed.
    pub base: LinkId,
    /// Joints downstream of the base, parents before children and siblings as described, each with
    /// the links it connects.
    pub branches: Vec<Branch>,
    /// The link that poses and Jacobians are of.
    pub tip: Option<LinkId>,
    /// Further links whose frames are asked for.
    pub frames: Vec<LinkId>,
    /// Links on which something acts from outside.
    pub external: Vec<LinkId>,
    /// Links that are not modelled.
    pub dropped: Vec<LinkId>,
    /// Joints that the request locks, those outside the tree among them, and where \[rad or m\].
    pub locks: HashMap<JointId, Number>,
}

/// A joint of the tree.
#[derive(Debug)]
pub struct Branch {
    /// The joint.
    pub joint: JointId,
    /// The link it hangs on.
    pub parent: LinkId,
    /// The link it carries.
    pub child: LinkId,
    /// Where it is held still [rad or m]; none where it moves.
    pub held: Option<Number>,
    /// What moves it, where it has no coordinate of its own.
    pub follows: Option<Follow>,
}

/// What moves a joint that follows: multiplier · q + offset.
#[derive(Clone, Copy, Debug)]
pub struct Follow {
    /// The joint that has the coordinate q.
    pub leader: JointId,
    /// What q is multiplied by.
    pub multiplier: Double,
    /// What is added [rad or m].
    pub offset: Double,
}
