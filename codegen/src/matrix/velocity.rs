//! W, the velocity matrix (paper, eq. 6): the angular velocity of a body and the velocity of its
//! pole, the point of the body that passes the origin of the frame.

use std::ops::{Add, Sub};

use super::{Pose, Rotation, Screw, Vector};
use crate::expression::{Block, Graph, LabelledBodies, Numeral, Term};

/// A velocity matrix W: ω̲, v₀; 0, 0.
#[derive(Clone, Copy, Debug)]
pub struct Velocity<E> {
    /// Angular velocity ω [rad/s].
    pub omega: Vector<E>,
    /// Velocity of the pole [m/s].
    pub v: Vector<E>,
}

impl<'g> Velocity<Term<'g>> {
    /// At rest.
    pub fn zero(graph: &'g Graph) -> Self {
        Self {
            omega: Vector::zero(graph),
            v: Vector::zero(graph),
        }
    }

    /// L q̇.
    #[must_use]
    pub fn of_screw(screw: Screw<Term<'g>>, rate: Term<'g>) -> Self {
        Self {
            omega: screw.u * rate,
            v: screw.b * rate,
        }
    }

    /// The same as a screw, at unit rate.
    #[must_use]
    pub fn screw(self) -> Screw<Term<'g>> {
        Screw {
            u: self.omega,
            b: self.v,
        }
    }

    /// Labels it as the motion of bodies, in a frame.
    pub fn label(self, of: LabelledBodies, frame: Numeral) {
        self.omega
            .label(Block::AngularVelocity.of(of).seen_in(frame));
        self.v.label(Block::LinearVelocity.of(of).seen_in(frame));
    }

    /// The same motion in other axes, with the same pole.
    #[must_use]
    pub fn rotate(self, rotation: Rotation<Term<'g>>) -> Self {
        Self {
            omega: rotation * self.omega,
            v: rotation * self.v,
        }
    }

    /// The same motion with another point of the body as the pole.
    #[must_use]
    pub fn move_pole(self, pole: Vector<Term<'g>>) -> Self {
        Self {
            v: self.v + self.omega.cross(pole),
            ..self
        }
    }

    /// The same motion in a frame of the body with this pose in its present one: M⁻¹ W M.
    #[must_use]
    pub fn seen_from(self, frame: Pose<Term<'g>>) -> Self {
        self.move_pole(frame.translation)
            .rotate(frame.rotation.transposed())
    }

    /// The derivative of a screw that is fixed to the body, L̇ = W L − L W: that of M L M⁻¹ with Ṁ = W M.
    #[must_use]
    pub fn rate_of(self, screw: Screw<Term<'g>>) -> Screw<Term<'g>> {
        Screw {
            u: self.omega.cross(screw.u),
            b: self.omega.cross(screw.b) + self.v.cross(screw.u),
        }
    }

    /// M W M⁻¹ (eq. 8).
    #[must_use]
    pub fn change_frame(self, pose: Pose<Term<'g>>) -> Self {
        let omega = pose.rotation * self.omega;
        Self {
            omega,
            v: pose.rotation * self.v - omega.cross(pose.translation),
        }
    }
}

/// Wᵢₖ = Wᵢⱼ + Wⱼₖ (eq. 10).
impl Add for Velocity<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            omega: self.omega + other.omega,
            v: self.v + other.v,
        }
    }
}

impl Sub for Velocity<Term<'_>> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            omega: self.omega - other.omega,
            v: self.v - other.v,
        }
    }
}
