//! A robot as data: joints, bodies and frames.
//!
//! In: joints and named frames. Out: a constant for the recursions at run time ([`crate::generic`]), which
//! generated code has beside its straight-line functions; the bodies that a joint carries, and the entries
//! of q and q̇ of each joint.

use super::joint::{Joint, Motion};
use crate::matrix::Pose;
use core::ops::Range;

/// A tree of bodies and joints, parents before children.
///
/// Body i hangs on joint i, and frame (i) is fixed in it. Frame (0) is the base, which has no joint.
///
/// | parameter | number of |
/// |---|---|
/// | `N` | degrees of freedom: entries of q̇, q̈ and τ |
/// | `F` | named frames |
/// | `Q` | coordinates |
/// | `B` | joints |
///
/// `Q` and `B` need not be written if every joint has one coordinate of its own. [`Motion`] lists the
/// coordinates and velocities of each type of joint. The data are `f64`; functions compute in any type.
///
/// ```
/// use homogen::{Chain, Frame, Inertia, Joint, Pose, Screw};
///
/// const PLACE: Pose<f64> = Pose::new(
///     [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///     [0.0, 0.0, 0.4],
/// );
/// const AXIS: Screw<f64> = Screw::new([0.0; 3], [0.0, 0.0, 1.0]);
/// const TOOL: Inertia<f64> = Inertia::new([0.02, 0.02, 0.01, 0.0, 0.0, 0.0], [0.0, 0.0, 0.1], 1.5);
/// static LIFT: Chain<1, 1> = Chain::new(
///     [Joint::new("lift", None, PLACE, AXIS, TOOL)],
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
    /// Named frames; the first one is the end effector.
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
    /// A robot. Nothing is checked, so that it can be a constant; `check` checks it.
    #[inline]
    #[must_use]
    pub const fn new(joints: [Joint; B], frames: [Frame; F], gravity: [f64; 3]) -> Self {
        Self {
            joints,
            frames,
            gravity,
        }
    }

    /// The frame of the end effector: the first named frame; without one the frame of the last body; without
    /// joints that of the base.
    #[must_use]
    pub fn tip(&self) -> Frame {
        self.frames.first().copied().unwrap_or(Frame {
            name: self.joints.last().map_or("base", |joint| joint.name),
            body: B.checked_sub(1),
            placement: UNMOVED,
        })
    }

    /// The frame of this name.
    #[must_use]
    pub fn frame(&self, name: &str) -> Option<Frame> {
        self.frames.iter().find(|frame| frame.name == name).copied()
    }

    /// True if joint `joint` moves body `body`, directly or through other joints.
    ///
    /// The search ends at a parent that does not come before its child.
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

    /// The range in q of the coordinates of joint `joint`: its own, or that of the mimicked joint. Empty if
    /// there is no such joint.
    #[must_use]
    pub fn coordinates(&self, joint: usize) -> Range<usize> {
        self.entries(joint, Motion::coordinates)
    }

    /// The range in q̇, q̈ and τ of the velocities of joint `joint`: its own, or that of the mimicked joint.
    /// Empty if there is no such joint.
    #[must_use]
    pub fn velocities(&self, joint: usize) -> Range<usize> {
        self.entries(joint, Motion::velocities)
    }

    /// The range of a joint in a list where each joint has `own` entries.
    fn entries(&self, joint: usize, own: fn(Motion) -> usize) -> Range<usize> {
        let Some(Joint { motion, .. }) = self.joints.get(joint) else {
            return 0..0;
        };
        let mover = match *motion {
            Motion::Mimic { mimicked, .. } => mimicked,
            _ => joint,
        };
        let before = self.joints.iter().take(mover);
        let start = before.map(|joint| own(joint.motion)).sum();
        let count = self.joints.get(mover).map_or(0, |mover| own(mover.motion));
        start..start + count
    }

    /// The parent of joint `i`, if it comes before it.
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
