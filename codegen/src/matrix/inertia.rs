//! J, the pseudo-inertia (paper, eq. 16): mass, first and second moments of a body.

use std::ops::{Add, Sub};

use super::{Pose, Rotation, Vector};
use crate::expression::{Block, Component, Double, Graph, LabelledBodies, Numeral, Term};

/// A symmetric 3×3 block: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Debug)]
pub struct Symmetric<E>(pub [E; 6]);

/// A pseudo-inertia J = ∫PPᵗdm: ∫rrᵗdm, q; qᵗ, m.
#[derive(Clone, Copy, Debug)]
pub struct Inertia<E> {
    /// Second moments ∫rrᵗdm about the origin of the frame [kg m²].
    pub second: Symmetric<E>,
    /// First moments q = ∫r dm [kg m].
    pub q: Vector<E>,
    /// Mass m \[kg\].
    pub mass: E,
}

impl<E: Copy> Symmetric<E> {
    /// The matrix by rows.
    pub const fn rows(self) -> [[E; 3]; 3] {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }

    /// The upper triangle of a matrix that is known to be symmetric.
    pub const fn from_rows([[xx, xy, xz], [_, yy, yz], [_, _, zz]]: [[E; 3]; 3]) -> Self {
        Self([xx, yy, zz, xy, xz, yz])
    }
}

impl<'g> Symmetric<Term<'g>> {
    fn zero(graph: &'g Graph) -> Self {
        Self([graph.constant(0.0); 6])
    }

    /// From the usual inertia tensor: ∫rrᵗdm = ½ Tr(I) − I (after eq. 16). The tensor is given as xx, xy, xz, yy, yz,
    /// zz.
    #[must_use]
    pub fn from_tensor([xx, xy, xz, yy, yz, zz]: [Term<'g>; 6]) -> Self {
        let half = xx.graph().constant(0.5);
        let trace = (xx + yy + zz) * half;
        Self([trace - xx, trace - yy, trace - zz, -xy, -xz, -yz])
    }

    /// R S Rᵗ.
    #[must_use]
    pub fn rotate(self, rotation: Rotation<Term<'g>>) -> Self {
        let rows = self.rows().map(|row| (rotation * Vector(row)).0);
        Self::from_rows((rotation * Rotation(rows)).0)
    }

    /// R S Rᵗ for a rotation about z, with four multiplications for the plane and four for the
    /// rest: with w = s(a − b) + 2ch the block (a, b, h) becomes (a − sw, b + sw, cw − h).
    #[must_use]
    pub fn rotate_about_z(self, (sine, cosine): (Term<'g>, Term<'g>)) -> Self {
        // The identity must give back the same expressions.
        if sine.is_zero() && (cosine * cosine).value().is_some_and(Double::is_one) {
            return self;
        }
        let [xx, yy, zz, xy, xz, yz] = self.0;
        let w = sine * (xx - yy) + cosine * (xy + xy);
        let along = sine * w;
        Self([
            xx - along,
            yy + along,
            zz,
            cosine * w - xy,
            cosine * xz - sine * yz,
            sine * xz + cosine * yz,
        ])
    }

    /// R S Rᵗ for a rotation about z, with no subtraction except for the product of inertia: the block
    /// (a, b, h) becomes (c²a + s²b − 2sch, s²a + c²b + 2sch, sc(a − b) + (c² − s²)h).
    #[must_use]
    pub fn rotate_in_full_about_z(self, (sine, cosine): (Term<'g>, Term<'g>)) -> Self {
        let rotated = self.rotate_about_z((sine, cosine));
        let [xx, yy, _, xy, _, _] = self.0;
        // A block that is the same in all directions across the axis stays as it is.
        if sine.is_zero() || ((xx - yy).is_zero() && xy.is_zero()) {
            return rotated;
        }
        let [_, _, zz, _, xz, yz] = rotated.0;
        let (ss, cc, sc) = (sine * sine, cosine * cosine, sine * cosine);
        let across = sc * (xy + xy);
        Self([
            cc * xx + ss * yy - across,
            ss * xx + cc * yy + across,
            zz,
            sc * (xx - yy) + (cc - ss) * xy,
            xz,
            yz,
        ])
    }

    /// abᵗ of a and b that are multiples of one vector.
    #[must_use]
    pub fn half_product(a: Vector<Term<'g>>, b: Vector<Term<'g>>) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (a.0, b.0);
        Self([ax * bx, ay * by, az * bz, ax * by, ax * bz, ay * bz])
    }

    /// Sets a row and the column with the same index to zero.
    pub fn clear(&mut self, axis: usize, zero: Term<'g>) {
        for k in [[0, 3, 4], [1, 3, 5], [2, 4, 5]][axis] {
            self.0[k] = zero;
        }
    }

    /// abᵗ + baᵗ.
    fn product(a: Vector<Term<'g>>, b: Vector<Term<'g>>) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (a.0, b.0);
        let twice = |product| product + product;
        Self([
            twice(ax * bx),
            twice(ay * by),
            twice(az * bz),
            ax * by + ay * bx,
            ax * bz + az * bx,
            ay * bz + az * by,
        ])
    }
}

impl<E: Copy> Inertia<E> {
    /// Applies a function to each entry.
    pub fn map<F: Copy>(self, mut f: impl FnMut(E) -> F) -> Inertia<F> {
        Inertia {
            second: Symmetric(self.second.0.map(&mut f)),
            q: self.q.map(&mut f),
            mass: f(self.mass),
        }
    }

    /// xx, yy, zz, xy, xz, yz; q; m.
    pub const fn entries(self) -> [E; 10] {
        let ([xx, yy, zz, xy, xz, yz], [x, y, z]) = (self.second.0, self.q.0);
        [xx, yy, zz, xy, xz, yz, x, y, z, self.mass]
    }
}

impl<'g> Inertia<Term<'g>> {
    /// The inertia of no mass.
    pub fn zero(graph: &'g Graph) -> Self {
        Self {
            second: Symmetric::zero(graph),
            q: Vector::zero(graph),
            mass: graph.constant(0.0),
        }
    }

    /// The inertia of a mass at the origin with second moments about it.
    #[must_use]
    pub fn central(mass: Term<'g>, second: Symmetric<Term<'g>>) -> Self {
        Self {
            second,
            q: Vector::zero(mass.graph()),
            mass,
        }
    }

    /// M J Mᵗ (eq. 17).
    #[must_use]
    pub fn change_frame(self, pose: Pose<Term<'g>>) -> Self {
        self.rotate(pose.rotation).translate(pose.translation)
    }

    /// M J Mᵗ for a rotation.
    #[must_use]
    pub fn rotate(self, rotation: Rotation<Term<'g>>) -> Self {
        Self {
            second: self.second.rotate(rotation),
            q: rotation * self.q,
            mass: self.mass,
        }
    }

    /// M J Mᵗ for a rotation about z.
    #[must_use]
    pub fn rotate_about_z(self, angle: (Term<'g>, Term<'g>)) -> Self {
        Self {
            second: self.second.rotate_about_z(angle),
            q: Rotation::about_z(angle) * self.q,
            mass: self.mass,
        }
    }

    /// The same, with the second moments rotated [in full](Symmetric::rotate_in_full_about_z).
    #[must_use]
    pub fn rotate_in_full_about_z(self, angle: (Term<'g>, Term<'g>)) -> Self {
        Self {
            second: self.second.rotate_in_full_about_z(angle),
            ..self.rotate_about_z(angle)
        }
    }

    /// M J Mᵗ for a translation by t: ∫rrᵗ + t qᵗ + q tᵗ + m t tᵗ, which is ∫rrᵗ + t hᵗ + h tᵗ
    /// with h = q + ½ m t.
    #[must_use]
    pub fn translate(self, t: Vector<Term<'g>>) -> Self {
        let half = self.mass.graph().constant(0.5);
        let shifted = t * self.mass;
        Self {
            second: self.second + Symmetric::product(t, self.q + shifted * half),
            q: self.q + shifted,
            mass: self.mass,
        }
    }

    /// skew\[X J\] for X = u̲, b; 0, 0: the couple and the force, or the angular and the linear
    /// momentum (eqs. 20 and 26).
    #[must_use]
    pub fn skew(
        self,
        u: Vector<Term<'g>>,
        b: Vector<Term<'g>>,
    ) -> (Vector<Term<'g>>, Vector<Term<'g>>) {
        let [x, y, z] = u.0;
        let [xx, yy, zz, xy, xz, yz] = self.second.0;
        let angular = Vector([
            x * (yy + zz) - y * xy - z * xz,
            y * (xx + zz) - x * xy - z * yz,
            z * (xx + yy) - x * xz - y * yz,
        ]);
        (angular + self.q.cross(b), u.cross(self.q) + b * self.mass)
    }

    /// Labels it as the inertia of a body, in a frame.
    pub fn label(self, body: Numeral, frame: Numeral) {
        let whole = Block::Inertia.of(LabelledBodies::Body(body)).seen_in(frame);
        let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        for (entry, (row, column)) in self.second.0.into_iter().zip(pairs) {
            entry.label(whole.entry(Component::Second(row, column)));
        }
        self.q.label(whole);
        self.mass.label(whole.entry(Component::Mass));
    }
}

impl Add for Symmetric<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Symmetric<Term<'_>> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Add for Inertia<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            second: self.second + other.second,
            q: self.q + other.q,
            mass: self.mass + other.mass,
        }
    }
}

impl Sub for Inertia<Term<'_>> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            second: Symmetric(std::array::from_fn(|k| {
                self.second.0[k] - other.second.0[k]
            })),
            q: self.q - other.q,
            mass: self.mass - other.mass,
        }
    }
}
