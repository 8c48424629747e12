//! H, the acceleration matrix (paper, eq. 7), kept as ω, ω̇ and a₀: rotating ω and ω̇ and rebuilding G costs a third of
//! rotating G.

use super::{Rotation, Vector};
use crate::expression::{Block, Graph, LabelledBodies, Numeral, Term};

/// An acceleration matrix H: G, a₀; 0, 0 with G = ω̲̇ + ω̲².
#[derive(Clone, Copy, Debug)]
pub struct Acceleration<E> {
    /// Angular velocity ω [rad/s].
    pub omega: Vector<E>,
    /// Angular acceleration ω̇ [rad/s²].
    pub omega_dot: Vector<E>,
    /// Acceleration of the pole [m/s²].
    pub a: Vector<E>,
}

impl<'g> Acceleration<Term<'g>> {
    /// The acceleration of a frame that does not rotate and whose origin accelerates by `a`.
    #[must_use]
    pub fn linear(a: Vector<Term<'g>>) -> Self {
        let zero = Vector::zero(graph_of(a));
        Self {
            omega: zero,
            omega_dot: zero,
            a,
        }
    }

    /// Labels it as the motion of a body relative to frame 0, in a frame.
    pub fn label(self, body: Numeral, frame: Numeral) {
        let of = LabelledBodies::FromBase(body);
        self.omega
            .label(Block::AngularVelocity.of(of).seen_in(frame));
        self.omega_dot
            .label(Block::AngularAcceleration.of(of).seen_in(frame));
        self.a
            .label(Block::LinearAcceleration.of(of).seen_in(frame));
    }

    /// The block G = ω̲̇ + ω̲², by rows.
    #[must_use]
    pub fn g(self) -> [[Term<'g>; 3]; 3] {
        let [x, y, z] = self.omega.0;
        let [dx, dy, dz] = self.omega_dot.0;
        let (xx, yy, zz) = (x * x, y * y, z * z);
        let (xy, xz, yz) = (x * y, x * z, y * z);
        [
            [-(yy + zz), xy - dz, xz + dy],
            [xy + dz, -(xx + zz), yz - dx],
            [xz - dy, yz + dx, -(xx + yy)],
        ]
    }

    /// The upper three rows of (G, a₀), one after the other.
    #[must_use]
    pub fn entries(self) -> [Term<'g>; 12] {
        let g = self.g();
        std::array::from_fn(|k| match (k / 4, k % 4) {
            (row, 3) => self.a.0[row],
            (row, column) => g[row][column],
        })
    }

    /// Acceleration of a point of the body (eq. 7): G p + a.
    #[must_use]
    pub fn point(self, point: Vector<Term<'g>>) -> Vector<Term<'g>> {
        Vector(self.g().map(|row| Vector(row).dot(point))) + self.a
    }

    /// The same motion in other axes, with the same pole.
    #[must_use]
    pub fn rotate(self, rotation: Rotation<Term<'g>>) -> Self {
        Self {
            omega: rotation * self.omega,
            omega_dot: rotation * self.omega_dot,
            a: rotation * self.a,
        }
    }

    /// The same motion with another point of the body as the pole.
    #[must_use]
    pub fn move_pole(self, pole: Vector<Term<'g>>) -> Self {
        Self {
            a: self.point(pole),
            ..self
        }
    }
}

fn graph_of(vector: Vector<Term<'_>>) -> &Graph {
    vector.x().graph()
}
