//! Motion of a body relative to its parent.
//!
//! In: coordinates. Out: the displacement Q of the body, and the screws L of its velocities, constant in its own frame.

use super::matrix::Matrix;
use crate::big::Big;

/// The motion of a body relative to its parent.
#[derive(Clone, Debug)]
pub enum Motion {
    /// None: a constant displacement along a screw.
    Held {
        /// L in frame (i); zero if there is no screw.
        screw: Matrix,
        /// The displacement \[rad or m\].
        at: Big,
    },
    /// Displacement by factor · coordinate + offset; a mimic joint has the coordinate of the mimicked joint.
    Along {
        /// L in frame (i), for a unit of the joint's own displacement.
        screw: Matrix,
        /// The index of the coordinate.
        coordinate: usize,
        /// The index of the velocity.
        velocity: usize,
        /// The factor of coordinate and velocity.
        factor: Big,
        /// The offset of the displacement.
        offset: Big,
    },
    /// A configuration space whose coordinates are not the integrals of its velocities.
    Manifold {
        /// The configuration space.
        manifold: Manifold,
        /// The index of its first coordinate.
        coordinate: usize,
        /// The index of its first velocity.
        velocity: usize,
    },
}

/// The configuration space of a joint whose velocities are in the axes of the moved body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manifold {
    /// x, y and the angle about z.
    Planar,
    /// A quaternion x, y, z, w.
    Spherical,
    /// x, y, z and a quaternion.
    Floating,
}

impl Motion {
    /// The motion of a fixed joint.
    #[must_use]
    pub fn none() -> Self {
        Self::Held {
            screw: Matrix::zero(),
            at: Big::zero(),
        }
    }

    /// True if a velocity moves it, its own or that of a mimicked joint.
    #[must_use]
    pub const fn moves(&self) -> bool {
        !matches!(self, Self::Held { .. })
    }

    /// Q at these coordinates.
    #[must_use]
    pub fn displacement(&self, q: &[Big]) -> Matrix {
        match self {
            Self::Held { screw, at } => exponential(screw, at),
            Self::Along {
                screw,
                coordinate,
                factor,
                offset,
                ..
            } => exponential(screw, &(factor * &q[*coordinate] + offset)),
            Self::Manifold {
                manifold,
                coordinate,
                ..
            } => manifold.displacement(&q[*coordinate..]),
        }
    }

    /// The index of each velocity that moves the body, and L in frame (i) for a unit of it.
    #[must_use]
    pub fn screws(&self) -> Vec<(usize, Matrix)> {
        match self {
            Self::Held { .. } => Vec::new(),
            Self::Along {
                screw,
                velocity,
                factor,
                ..
            } => vec![(*velocity, screw.times(factor))],
            Self::Manifold {
                manifold, velocity, ..
            } => {
                let screws = manifold.screws();
                (*velocity..).zip(screws).collect()
            }
        }
    }

    /// The index of the first entry of its quaternion among the coordinates, if it has one.
    #[must_use]
    pub fn quaternion(&self) -> Option<usize> {
        match self {
            Self::Manifold {
                manifold: Manifold::Spherical,
                coordinate,
                ..
            } => Some(*coordinate),
            Self::Manifold {
                manifold: Manifold::Floating,
                coordinate,
                ..
            } => Some(coordinate + 3),
            _ => None,
        }
    }
}

impl Manifold {
    /// The numbers of its coordinates and velocities.
    #[must_use]
    pub const fn counts(self) -> (usize, usize) {
        match self {
            Self::Planar => (3, 3),
            Self::Spherical => (4, 3),
            Self::Floating => (7, 6),
        }
    }

    fn displacement(self, q: &[Big]) -> Matrix {
        match self {
            Self::Planar => {
                let shift = Matrix::translation(&[q[0].clone(), q[1].clone(), Big::zero()]);
                &shift * &exponential(&rotation_screw(2), &q[2])
            }
            Self::Spherical => rotation(q),
            Self::Floating => {
                let shift = Matrix::translation(&[q[0].clone(), q[1].clone(), q[2].clone()]);
                &shift * &rotation(&q[3..])
            }
        }
    }

    fn screws(self) -> Vec<Matrix> {
        match self {
            Self::Planar => vec![
                translation_screw(0),
                translation_screw(1),
                rotation_screw(2),
            ],
            Self::Spherical => (0..3).map(rotation_screw).collect(),
            Self::Floating => (0..3)
                .map(translation_screw)
                .chain((0..3).map(rotation_screw))
                .collect(),
        }
    }
}

/// R = 1 + 2 w v̲ + 2 v̲² of a quaternion v, w of length 1.
fn rotation(q: &[Big]) -> Matrix {
    let nothing = [(); 3].map(|()| Big::zero());
    let two = Big::new(2.0);
    let v = Matrix::screw(&[q[0].clone(), q[1].clone(), q[2].clone()], &nothing);
    let once = v.times(&(&two * &q[3]));
    &(&Matrix::identity() + &once) + &(&v * &v).times(&two)
}

/// L about a coordinate axis.
#[must_use]
pub fn rotation_screw(axis: usize) -> Matrix {
    Matrix::screw(&unit(axis), &[(); 3].map(|()| Big::zero()))
}

/// L along a coordinate axis.
#[must_use]
pub fn translation_screw(axis: usize) -> Matrix {
    Matrix::screw(&[(); 3].map(|()| Big::zero()), &unit(axis))
}

fn unit(axis: usize) -> [Big; 3] {
    core::array::from_fn(|k| if k == axis { Big::one() } else { Big::zero() })
}

/// Q = 1 + L φ + L² (1 − cos φ) + L³ (φ − sin φ), the series of § 5 summed by u̲ⁿ⁺² = −u̲ⁿ.
pub(super) fn exponential(l: &Matrix, phi: &Big) -> Matrix {
    let (sine, cosine) = phi.sin_cos();
    let square = l * l;
    let cube = &square * l;
    let linear = &Matrix::identity() + &l.times(phi);
    let quadratic = square.times(&(Big::one() - cosine));
    &(&linear + &quadratic) + &cube.times(&(phi - sine))
}

/// The rotation that takes z to the unit normal (a, b, c) of a plane, and x to the normalised projection of (c², a²,
/// b²) on that plane. A normal along an axis of the frame permutes the axes cyclically. Where a, b and c are equal to
/// 1e-6, (1, 0, 0) is projected instead, since the projection of (c², a², b²) vanishes.
#[must_use]
pub fn across(normal: &[Big; 3]) -> Matrix {
    let [a, b, c] = normal.each_ref().map(Big::to_f64);
    let spread = (a - b).abs().max((b - c).abs()).max((c - a).abs());
    let guide = if spread < 1e-6 {
        unit(0)
    } else {
        let [a, b, c] = normal;
        [c * c, a * a, b * b]
    };
    let along = guide
        .iter()
        .zip(normal)
        .fold(Big::zero(), |sum, (x, n)| sum + x * n);
    let projection: [Big; 3] = core::array::from_fn(|k| &guide[k] - &normal[k] * &along);
    let square = projection.iter().fold(Big::zero(), |sum, x| sum + x * x);
    let length = square.sqrt();
    let x = projection.map(|entry| entry / &length);
    of_columns(&x, &cross(normal, &x), normal)
}

/// The rotation that takes z to the unit axis of a loop. An axis along one of the frame permutes the axes cyclically;
/// otherwise x is the normalised product of the frame's axis that is farthest from the loop's axis with the latter.
#[must_use]
pub fn with_z(axis: &[Big; 3]) -> Matrix {
    let zero = Big::zero();
    let alone = (0..3).find(|&k| axis[(k + 1) % 3] == zero && axis[(k + 2) % 3] == zero);
    let x = if let Some(k) = alone {
        unit((k + 1) % 3)
    } else {
        let sizes = axis.each_ref().map(Big::abs);
        let farthest = (1..3).fold(
            0,
            |least, k| if sizes[k] < sizes[least] { k } else { least },
        );
        let product = cross(&unit(farthest), axis);
        let square = product.iter().fold(Big::zero(), |sum, x| sum + x * x);
        let length = square.sqrt();
        product.map(|entry| entry / &length)
    };
    of_columns(&x, &cross(axis, &x), axis)
}

fn of_columns(x: &[Big; 3], y: &[Big; 3], z: &[Big; 3]) -> Matrix {
    let columns = [x, y, z];
    Matrix::of(|i, j| {
        if i < 3 && j < 3 {
            columns[j][i].clone()
        } else if i == j {
            Big::one()
        } else {
            Big::zero()
        }
    })
}

fn cross(a: &[Big; 3], b: &[Big; 3]) -> [Big; 3] {
    core::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &a[i] * &b[j] - &a[j] * &b[i]
    })
}
