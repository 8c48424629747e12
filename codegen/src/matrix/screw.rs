//! L, the screw axis matrix (paper, § 5): direction and moment of the axis of a motion.

use std::ops::Add;

use super::{Pose, Vector};
use crate::expression::Term;

/// A screw axis L: u̲, b; 0, 0 with b = −u̲ p + pitch u for a point p of the axis.
#[derive(Clone, Copy, Debug)]
pub struct Screw<E> {
    /// Direction of the axis; zero for a translation.
    pub u: Vector<E>,
    /// Velocity of the pole at unit velocity of the joint.
    pub b: Vector<E>,
}

impl<'g> Screw<Term<'g>> {
    /// The same screw in the frame in which the pose is given: M L M⁻¹ (eq. 8).
    #[must_use]
    pub fn change_frame(self, pose: Pose<Term<'g>>) -> Self {
        let u = pose.rotation * self.u;
        Self {
            u,
            b: pose.rotation * self.b - u.cross(pose.translation),
        }
    }

    /// The six entries u, b.
    #[must_use]
    pub fn entries(self) -> [Term<'g>; 6] {
        let ([ux, uy, uz], [bx, by, bz]) = (self.u.0, self.b.0);
        [ux, uy, uz, bx, by, bz]
    }
}

impl Add for Screw<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            u: self.u + other.u,
            b: self.b + other.b,
        }
    }
}
