//! Φ, the action matrix (paper, eq. 14) of a wrench: a force and a couple.

use std::ops::{Add, Sub};

use super::{Acceleration, Inertia, Pose, Screw, Vector};
use crate::expression::{Block, LabelledBodies, Numeral, Term};

/// A wrench Φ: c̲, f; −fᵗ, 0.
#[derive(Clone, Copy, Debug)]
pub struct Action<E> {
    /// Couple about the origin of the frame [N m].
    pub c: Vector<E>,
    /// Resultant force \[N\].
    pub f: Vector<E>,
}

impl<'g> Action<Term<'g>> {
    /// The wrench that gives a body of inertia J the acceleration H: Φ = skew\[H J\] (eqs. 18 and 25).
    #[must_use]
    pub fn of(h: Acceleration<Term<'g>>, j: Inertia<Term<'g>>) -> Self {
        let g = h.g();
        let [[_, gxy, gxz], [gyx, _, gyz], [gzx, gzy, _]] = g;
        let [xx, yy, zz, xy, xz, yz] = j.second.0;
        // The diagonal of G enters by differences, in each of which one square of ω cancels.
        let [ox, oy, oz] = h.omega.0.map(|entry| entry * entry);
        let couple = Vector([
            gzx * xy + gzy * yy - gyz * zz - gyx * xz + (oz - oy) * yz,
            gxy * yz + gxz * zz - gzx * xx - gzy * xy + (ox - oz) * xz,
            gyx * xx + gyz * xz - gxy * yy - gxz * yz + (oy - ox) * xy,
        ]);
        Self {
            c: couple + j.q.cross(h.a),
            f: Vector(g.map(|row| Vector(row).dot(j.q))) + h.a * j.mass,
        }
    }

    /// The wrench that accelerates a body of inertia J along a screw from rest, per unit of acceleration: skew\[L J\].
    #[must_use]
    pub fn of_screw(l: Screw<Term<'g>>, j: Inertia<Term<'g>>) -> Self {
        let (c, f) = j.skew(l.u, l.b);
        Self { c, f }
    }

    /// M Φ Mᵗ (eq. 17).
    #[must_use]
    pub fn change_frame(self, pose: Pose<Term<'g>>) -> Self {
        let f = pose.rotation * self.f;
        Self {
            c: pose.rotation * self.c + pose.translation.cross(f),
            f,
        }
    }

    /// M⁻¹ Φ M⁻ᵗ: the wrench in the frame at a pose.
    #[must_use]
    pub fn seen_from(self, pose: Pose<Term<'g>>) -> Self {
        let back = pose.rotation.transposed();
        Self {
            c: back * (self.c - pose.translation.cross(self.f)),
            f: back * self.f,
        }
    }

    /// L Φ + Φ Lᵗ: the derivative of a wrench that moves along a screw.
    #[must_use]
    pub fn moved_along(self, screw: Screw<Term<'g>>) -> Self {
        Self {
            c: screw.u.cross(self.c) + screw.b.cross(self.f),
            f: screw.u.cross(self.f),
        }
    }

    /// The pseudo scalar product L ⊗ Φ = u·c + b·f: the power of the wrench at unit velocity.
    #[must_use]
    pub fn along(self, screw: Screw<Term<'g>>) -> Term<'g> {
        screw.u.dot(self.c) + screw.b.dot(self.f)
    }

    /// The same wrench about another pole.
    #[must_use]
    pub fn about(self, pole: Vector<Term<'g>>) -> Self {
        Self {
            c: self.c - pole.cross(self.f),
            ..self
        }
    }

    /// The six entries c, f.
    #[must_use]
    pub fn entries(self) -> [Term<'g>; 6] {
        let ([cx, cy, cz], [fx, fy, fz]) = (self.c.0, self.f.0);
        [cx, cy, cz, fx, fy, fz]
    }

    /// Labels it as the wrench on a body, in a frame.
    pub fn label(self, body: Numeral, frame: Numeral) {
        self.c
            .label(Block::Couple.of(LabelledBodies::Body(body)).seen_in(frame));
        self.f
            .label(Block::Force.of(LabelledBodies::Body(body)).seen_in(frame));
    }
}

impl Sub for Action<Term<'_>> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            c: self.c - other.c,
            f: self.f - other.f,
        }
    }
}

impl Add for Action<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            c: self.c + other.c,
            f: self.f + other.f,
        }
    }
}
