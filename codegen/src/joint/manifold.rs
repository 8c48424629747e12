//! Coordinates of joints whose degrees of freedom have no coordinates of their own: planar, spherical, floating.
//!
//! Defines names and kinds of the coordinates, and the displacement Q that they describe. The orders of `Spherical` and
//! `Floating` are Pinocchio's, so that states can be exchanged unchanged.

#[cfg(feature = "files")]
mod steps;

use crate::expression::Term;
use crate::matrix::{Pose, Rotation, Vector};
use crate::space::Kind;

/// Coordinates of a joint whose velocities are in the frame of the moved body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manifold {
    /// x, y and the angle about z.
    Planar,
    /// A unit quaternion, scalar last.
    Spherical,
    /// x, y, z and a unit quaternion, scalar last.
    Floating,
}

impl Manifold {
    /// Its name in descriptions, in generated code and in data.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Planar => "planar",
            Self::Spherical => "spherical",
            Self::Floating => "floating",
        }
    }

    /// Index of the first entry of the quaternion among the coordinates, if there is one.
    #[must_use]
    pub fn quaternion(self) -> Option<usize> {
        let mut entries = self.coordinates().iter();
        entries.position(|(_, kind)| *kind == Kind::Quaternion)
    }

    /// Names and kinds of the coordinates.
    #[must_use]
    pub const fn coordinates(self) -> &'static [(&'static str, Kind)] {
        const FLOATING: [(&str, Kind); 7] = [
            ("x", Kind::Translation),
            ("y", Kind::Translation),
            ("z", Kind::Translation),
            ("qx", Kind::Quaternion),
            ("qy", Kind::Quaternion),
            ("qz", Kind::Quaternion),
            ("qw", Kind::Quaternion),
        ];
        const PLANAR: [(&str, Kind); 3] = [
            ("x", Kind::Translation),
            ("y", Kind::Translation),
            ("angle", Kind::Rotation),
        ];
        match self {
            Self::Planar => &PLANAR,
            Self::Spherical => FLOATING.split_at(3).1,
            Self::Floating => &FLOATING,
        }
    }

    /// Number of velocities.
    #[must_use]
    pub const fn velocities(self) -> usize {
        match self {
            Self::Planar | Self::Spherical => 3,
            Self::Floating => 6,
        }
    }

    /// Maximum distance of the body's origin from its rest position, for given ranges of the coordinates \[m\].
    #[must_use]
    pub fn reach(self, range: impl Fn(usize) -> [f64; 2]) -> f64 {
        let kinds = self.coordinates().iter().enumerate();
        let translations = kinds.filter(|(_, (_, kind))| matches!(kind, Kind::Translation));
        let farthest = translations.map(|(entry, _)| {
            let [least, most] = range(entry);
            least.abs().max(most.abs())
        });
        farthest.map(|far| far * far).sum::<f64>().sqrt()
    }

    /// Q: the displacement from rest to these coordinates.
    #[must_use]
    pub fn displacement<'g>(self, q: impl Fn(usize) -> Term<'g>) -> Pose<Term<'g>> {
        match self {
            Self::Planar => Pose {
                rotation: Rotation::about_z(q(2).sin_cos()),
                translation: Vector([q(0), q(1), q(0).graph().constant(0.0)]),
            },
            Self::Spherical => Pose::rotation(rotation_matrix([q(0), q(1), q(2)], q(3))),
            Self::Floating => Pose {
                rotation: rotation_matrix([q(3), q(4), q(5)], q(6)),
                translation: Vector([q(0), q(1), q(2)]),
            },
        }
    }
}

impl Manifold {
    /// The rates of the coordinates if velocity `k` is 1 and the others are 0: a column of N in q̇ = N v. Velocities
    /// are those of the moved body in its own frame, linear before angular.
    #[must_use]
    pub fn rates<'g>(self, k: usize, q: impl Fn(usize) -> Term<'g>) -> Vec<Term<'g>> {
        let constant = |value: f64| q(0).graph().constant(value);
        let [zero, one] = [0.0, 1.0].map(constant);
        match (self, k) {
            (Self::Planar, 2) => vec![zero, zero, one],
            (Self::Planar, _) => {
                let axis = Rotation::about_z(q(2).sin_cos()).column(k);
                vec![axis.0[0], axis.0[1], zero]
            }
            (Self::Spherical, _) => rotating([0, 1, 2].map(&q), q(3), k).into(),
            (Self::Floating, 0..3) => {
                let axis = rotation_matrix([3, 4, 5].map(&q), q(6)).column(k);
                axis.0.into_iter().chain([zero; 4]).collect()
            }
            (Self::Floating, _) => {
                let rates = rotating([3, 4, 5].map(&q), q(6), k - 3);
                [zero; 3].into_iter().chain(rates).collect()
            }
        }
    }
}

/// The rates of a quaternion v, w whose frame rotates about its own axis `k` at 1 rad/s: ½ (w e + v × e, −v·e).
fn rotating<'g>(v: [Term<'g>; 3], w: Term<'g>, k: usize) -> [Term<'g>; 4] {
    let [next, last] = [(k + 1) % 3, (k + 2) % 3];
    let half = w.graph().constant(0.5);
    let mut rates = [half * w; 4];
    rates[next] = half * v[last];
    rates[last] = -(half * v[next]);
    rates[3] = -(half * v[k]);
    rates
}

/// R = 1 + 2 w v̲ + 2 v̲² of a unit quaternion v, w.
fn rotation_matrix<'g>([x, y, z]: [Term<'g>; 3], w: Term<'g>) -> Rotation<Term<'g>> {
    let one = w.graph().constant(1.0);
    let [twice_x, twice_y, twice_z] = [x + x, y + y, z + z];
    let (xx, yy, zz) = (twice_x * x, twice_y * y, twice_z * z);
    let (xy, xz, yz) = (twice_y * x, twice_z * x, twice_z * y);
    let (wx, wy, wz) = (twice_x * w, twice_y * w, twice_z * w);
    Rotation([
        [one - (yy + zz), xy - wz, xz + wy],
        [xy + wz, one - (xx + zz), yz - wx],
        [xz - wy, yz + wx, one - (xx + yy)],
    ])
}

#[cfg(test)]
mod tests;
