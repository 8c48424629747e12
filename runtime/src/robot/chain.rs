//! A robot as data.
//!
//! In: joints and named frames. Out: a constant that the recursions at run time read
//! ([`crate::generic`]) and that generated code carries beside its straight-line functions; who
//! carries whom, and which entries of q and of q̇ are whose. It computes nothing itself.

use super::joint::{Joint, Motion};
use crate::matrix::Pose;
use core::ops::Range;

/// A tree of bodies and joints, parents before children.
///
/// Body i is what joint i carries, and frame (i) is fixed in it; frame (0), the base, is what has no
/// joint. `N` is the number of velocities (and of accelerations, torques and forces), `F` of named
/// frames, `Q` of coordinates and `B` of joints; the last two need not be written where every joint has
/// one coordinate of its own. What they are of each joint is said by [`Motion`]. Numbers are f64 whatever
/// the type that a function is asked for.
///
/// ```
/// use homogen::{Chain, Frame, Inertia, Joint, Pose, Screw};
///
/// const PLACE: Pose<f64> = Pose::new(
///     [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///     [0.0, 0.0, 0.4],
/// );
/// const SLIDE: Screw<f64> = Screw::new([0.0; 3], [0.0, 0.0, 1.0]);
/// const TOOL: Inertia<f64> = Inertia::new([0.02, 0.02, 0.01, 0.0, 0.0, 0.0], [0.0, 0.0, 0.1], 1.5);
/// static LIFT: Chain<1, 1> = Chain::new(
///     [Joint::new("lift", None, PLACE, SLIDE, TOOL)],
///     [Frame::new("flange", Some(0), PLACE)],
///     [0.0, 0.0, -9.81],
/// );
/// assert_eq!(LIFT.tip().name, "flange");
/// assert_eq!(LIFT.check(1e-9), Ok(()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain<const N: usize, const F: usize, const Q: usize = N, const B: usize = N> {
    /// The joints, parents before children; their order is that of q and of q̇.
    pub joints: [Joint; B],
    /// Named frames; the first one is the tip.
    pub frames: [Frame; F],
    /// The acceleration of gravity in frame (0) [m/s²].
    pub gravity: [f64; 3],
}

/// A frame that is fixed in a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Its name.
    pub name: &'static str,
    /// The joint whose body carries it; `None` is the base.
    pub body: Option<usize>,
    /// Its pose in the frame of that body \[m\].
    pub placement: Pose<f64>,
}

impl<const N: usize, const F: usize, const Q: usize, const B: usize> Chain<N, F, Q, B> {
    /// A robot; nothing is checked, so that it can be a constant (`check` does, when asked).
    #[inline]
    #[must_use]
    pub const fn new(joints: [Joint; B], frames: [Frame; F], gravity: [f64; 3]) -> Self {
        Self {
            joints,
            frames,
            gravity,
        }
    }

    /// The first frame if there is one, else the frame of the last body (of the base, without joints).
    #[must_use]
    pub fn tip(&self) -> Frame {
        self.frames.first().copied().unwrap_or(Frame {
            name: self.joints.last().map_or("base", |joint| joint.name),
            body: B.checked_sub(1),
            placement: UNMOVED,
        })
    }

    /// The frame of that name.
    #[must_use]
    pub fn frame(&self, name: &str) -> Option<Frame> {
        self.frames.iter().find(|frame| frame.name == name).copied()
    }

    /// Whether body `body` is carried, directly or not, by joint `joint`.
    ///
    /// A parent that does not come before its child ends the walk.
    #[must_use]
    pub fn carries(&self, joint: usize, body: Option<usize>) -> bool {
        let mut at = body;
        while let Some(i) = at {
            if i == joint {
                return true;
            }
            at = self.parent(i);
        }
        false
    }

    /// Which entries of q say where joint `joint` is: its own, or the one of the joint it follows; none
    /// where there is no such joint.
    #[must_use]
    pub fn coordinates(&self, joint: usize) -> Range<usize> {
        self.entries(joint, Motion::coordinates)
    }

    /// Which entries of q̇, and with other units of q̈ and τ, belong to joint `joint`: its own, or the one of
    /// the joint it follows; none where there is no such joint.
    #[must_use]
    pub fn velocities(&self, joint: usize) -> Range<usize> {
        self.entries(joint, Motion::velocities)
    }

    /// The entries of a joint in a list of which each joint has so many of its own.
    fn entries(&self, joint: usize, own: fn(Motion) -> usize) -> Range<usize> {
        let Some(Joint { motion, .. }) = self.joints.get(joint) else {
            return 0..0;
        };
        let mover = match *motion {
            Motion::Following { leader, .. } => leader,
            _ => joint,
        };
        let before = self.joints.iter().take(mover);
        let start = before.map(|joint| own(joint.motion)).sum();
        let count = self.joints.get(mover).map_or(0, |mover| own(mover.motion));
        start..start + count
    }

    /// The parent of joint `i`, where it comes before it.
    pub(crate) fn parent(&self, i: usize) -> Option<usize> {
        self.joints
            .get(i)
            .and_then(|joint| joint.parent)
            .filter(|parent| *parent < i)
    }
}

impl Frame {
    /// A frame at `placement` in the frame of `body`.
    #[inline]
    #[must_use]
    pub const fn new(name: &'static str, body: Option<usize>, placement: Pose<f64>) -> Self {
        Self {
            name,
            body,
            placement,
        }
    }
}

/// The identity, as a constant.
pub(crate) const UNMOVED: Pose<f64> = Pose::new(
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [0.0; 3],
);
