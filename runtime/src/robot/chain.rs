//! A robot as data.
//!
//! In: joints with their placements, screws and inertias, and named frames. Out: a constant that
//! the recursions at run time read ([`crate::generic`]) and that generated code carries beside its
//! straight-line functions; and who carries whom. It computes nothing itself.

use crate::matrix::{Inertia, Pose, Screw};

/// A tree of bodies and joints of one degree of freedom each, parents before children.
///
/// Body i is what joint i carries, and frame (i) is fixed in it; frame (0), the base, is what has no
/// joint. `N` is the number of joints, `F` of named frames. Numbers are f64 whatever the type that a
/// function is asked for.
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
pub struct Chain<const N: usize, const F: usize> {
    /// The joints, parents before children; their order is that of q.
    pub joints: [Joint; N],
    /// Named frames; the first one is the tip.
    pub frames: [Frame; F],
    /// The acceleration of gravity in frame (0) [m/s²].
    pub gravity: [f64; 3],
}

/// A joint and the body that it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: &'static str,
    /// The joint that carries the body it stands on; `None` is the base.
    pub parent: Option<usize>,
    /// M_parent,i at q = 0 \[m\].
    pub placement: Pose<f64>,
    /// L of the joint, in frame (i).
    pub screw: Screw<f64>,
    /// J of body i, in frame (i).
    pub inertia: Inertia<f64>,
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

impl<const N: usize, const F: usize> Chain<N, F> {
    /// A robot; nothing is checked, so that it can be a constant (`check` does, when asked).
    #[inline]
    #[must_use]
    pub const fn new(joints: [Joint; N], frames: [Frame; F], gravity: [f64; 3]) -> Self {
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
            body: N.checked_sub(1),
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

    /// The parent of joint `i`, where it comes before it.
    pub(crate) fn parent(&self, i: usize) -> Option<usize> {
        self.joints
            .get(i)
            .and_then(|joint| joint.parent)
            .filter(|parent| *parent < i)
    }
}

impl Joint {
    /// A joint: `placement` is M_parent,i at q = 0, `screw` its L in frame (i), `inertia` the J of
    /// body i in frame (i).
    #[inline]
    #[must_use]
    pub const fn new(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        screw: Screw<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self {
            name,
            parent,
            placement,
            screw,
            inertia,
        }
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
