//! A robot, link by link, as matrices of numbers.

use super::{Approximate, Matrix};

/// What a link hangs on, and by which motion.
pub(crate) struct Body {
    /// The body it hangs on; none of those that hang on the base.
    pub(crate) parent: Option<usize>,
    /// M of the joint's frame in the parent link's, at q = 0.
    pub(crate) placement: Matrix<Approximate>,
    /// u and b of the joint in the link's frame.
    pub(crate) screw: [[Approximate; 3]; 2],
    /// Which coordinate moves it; or where it is held.
    pub(crate) moved: Moved,
    /// J of the link in its frame.
    pub(crate) inertia: Matrix<Approximate>,
}

/// What gives a joint its coordinate.
#[derive(Clone, Copy)]
pub(crate) enum Moved {
    /// An entry of q.
    By(usize),
    /// Nothing: it stays where it is.
    Held(f64),
}

/// A robot, link by link, parents before children.
pub(crate) struct Robot {
    pub(crate) bodies: Vec<Body>,
    /// Acceleration of gravity in frame 0.
    pub(crate) gravity: [Approximate; 3],
    /// The bodies whose frames are asked for; none for the base.
    pub(crate) frames: Vec<Option<usize>>,
}
