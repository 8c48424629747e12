//! Y = W J = ∫ṖPᵗdm, the moments of velocity: J has the moments of mass, Y those of its flow. The momentum matrix is
//! its skew part, Γ = Y − Yᵗ (paper, eq. 13); Ṁ and the Coriolis terms use the rest.

use std::ops::Add;

use super::{Action, Inertia, Rotation, Screw, Vector};
use crate::expression::Term;

/// Moments of velocity Y: N, p; 0, 0.
#[derive(Clone, Copy, Debug)]
pub struct Flow<E> {
    /// N = ∫ṙrᵗdm about the origin of the frame [kg m²/s].
    pub n: Rotation<E>,
    /// p = ∫ṙ dm, the linear momentum [kg m/s].
    pub p: Vector<E>,
}

impl<'g> Flow<Term<'g>> {
    /// W J of a rotation about the origin of the frame.
    #[must_use]
    pub fn of_rotation(omega: Vector<Term<'g>>, j: Inertia<Term<'g>>) -> Self {
        let columns = j.second.rows().map(|column| omega.cross(Vector(column)));
        Self {
            n: Rotation::from_columns(columns),
            p: omega.cross(j.q),
        }
    }

    /// The same flow in other axes.
    #[must_use]
    pub fn rotate(self, rotation: Rotation<Term<'g>>) -> Self {
        Self {
            n: rotation * self.n * rotation.transposed(),
            p: rotation * self.p,
        }
    }

    /// The same after a rotation about z, with four multiplications for the plane and four for each other
    /// pair: with w = s(a − d) + c(b + b') the block (a, b; b', d) becomes
    /// (a − sw, cw − b'; cw − b, d + sw).
    #[must_use]
    pub fn rotate_about_z(self, angle: (Term<'g>, Term<'g>)) -> Self {
        let (sine, cosine) = angle;
        if sine.is_zero() {
            return self.rotate(Rotation::about_z(angle));
        }
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.n.0;
        let w = sine * (xx - yy) + cosine * (xy + yx);
        let (along, across) = (sine * w, cosine * w);
        let rotate = |x: Term<'g>, y: Term<'g>| [cosine * x - sine * y, sine * x + cosine * y];
        let ([xz, yz], [zx, zy]) = (rotate(xz, yz), rotate(zx, zy));
        Self {
            n: Rotation([
                [xx - along, across - yx, xz],
                [across - xy, yy + along, yz],
                [zx, zy, zz],
            ]),
            p: Rotation::about_z(angle) * self.p,
        }
    }

    /// The same flow in a frame with parallel axes in which the origin is at t: T Y Tᵗ = N + p tᵗ, p.
    #[must_use]
    pub fn translate(self, t: Vector<Term<'g>>) -> Self {
        Self {
            n: self.n + dyad(self.p, t),
            p: self.p,
        }
    }

    /// The flow of the same bodies if all velocities grow by v: v qᵗ and m v are added.
    #[must_use]
    pub fn faster(self, v: Vector<Term<'g>>, j: Inertia<Term<'g>>) -> Self {
        Self {
            n: self.n + dyad(v, j.q),
            p: self.p + v * j.mass,
        }
    }

    /// skew\[X Y\] for X = u̲, b; 0, 0, which does not depend on b.
    #[must_use]
    pub fn rotated_by(self, u: Vector<Term<'g>>) -> Action<Term<'g>> {
        // u̲ N + Nᵗ u̲ is the cross matrix of (Tr(N) 1 − N) u.
        Action {
            c: without_trace(self.n) * u,
            f: u.cross(self.p),
        }
    }

    /// skew\[L Yᵗ\], which is a couple alone.
    #[must_use]
    pub fn against(self, l: Screw<Term<'g>>) -> Vector<Term<'g>> {
        without_trace(self.n.transposed()) * l.u + self.p.cross(l.b)
    }
}

/// Tr(N) 1 − N.
fn without_trace(n: Rotation<Term<'_>>) -> Rotation<Term<'_>> {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = n.0;
    Rotation([
        [yy + zz, -xy, -xz],
        [-yx, xx + zz, -yz],
        [-zx, -zy, xx + yy],
    ])
}

/// a bᵗ.
fn dyad<'g>(a: Vector<Term<'g>>, b: Vector<Term<'g>>) -> Rotation<Term<'g>> {
    Rotation(a.0.map(|entry| (b * entry).0))
}

impl Add for Flow<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            n: self.n + other.n,
            p: self.p + other.p,
        }
    }
}
