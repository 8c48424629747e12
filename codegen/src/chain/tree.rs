//! How links hang on the base: what is left of a description's names once they refer to each other.

use crate::description::Number;
use crate::expression::Double;

/// The part of a description that is modelled.
#[derive(Debug)]
pub struct Tree {
    /// Index of the link taken as fixed.
    pub base: usize,
    /// Joints downstream of the base, parents before children and siblings as described, each with
    /// the links it connects.
    pub branches: Vec<Branch>,
    /// The link that poses and Jacobians are of.
    pub tip: Option<usize>,
    /// Further links whose frames are asked for.
    pub frames: Vec<usize>,
    /// Links on which something acts from outside.
    pub external: Vec<usize>,
    /// Links that are not modelled.
    pub dropped: Vec<usize>,
}

/// A joint of the tree.
#[derive(Debug)]
pub struct Branch {
    /// Index of the joint.
    pub joint: usize,
    /// Index of the link it hangs on.
    pub parent: usize,
    /// Index of the link it carries.
    pub child: usize,
    /// Where it is held still [rad or m]; none where it moves.
    pub held: Option<Number>,
    /// What moves it, where it has no coordinate of its own.
    pub follows: Option<Follow>,
}

/// What moves a joint that follows: multiplier · q + offset.
#[derive(Clone, Copy, Debug)]
pub struct Follow {
    /// The joint that has the coordinate q, by its place in the description.
    pub leader: usize,
    /// What q is multiplied by.
    pub multiplier: Double,
    /// What is added [rad or m].
    pub offset: Double,
}
