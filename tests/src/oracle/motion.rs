//! What a joint does to the body that it carries.
//!
//! In: coordinates. Out: the displacement Q of the body, and the screws L that its velocities move it
//! along, constant in its moved frame. It knows neither who hangs on whom nor a description.

use super::matrix::Matrix;
use crate::big::Big;

/// What moves a body.
#[derive(Clone, Debug)]
pub enum Motion {
    /// Nothing: it stays so far along its screw.
    Held {
        /// L in frame (i); null where there is no screw.
        screw: Matrix,
        /// How far.
        at: Big,
    },
    /// A coordinate, times a factor and from an offset on: of a joint that follows another, the other's.
    Along {
        /// L in frame (i), for a unit of the joint's own.
        screw: Matrix,
        /// The place of the coordinate.
        coordinate: usize,
        /// The place of the velocity.
        velocity: usize,
        /// What both are multiplied by.
        factor: Big,
        /// What is added to the coordinate.
        offset: Big,
    },
    /// A posture, whose coordinates and velocities begin there.
    Posture {
        /// Which.
        posture: Posture,
        /// The place of its first coordinate.
        coordinate: usize,
        /// The place of its first velocity.
        velocity: usize,
    },
}

/// What velocities in the moved frame lead to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Posture {
    /// x, y and the angle about z.
    Planar,
    /// A quaternion x, y, z, w.
    Spherical,
    /// x, y, z and a quaternion.
    Floating,
}

impl Motion {
    /// A screw that nothing moves along: of a fixed joint.
    #[must_use]
    pub fn none() -> Self {
        Self::Held {
            screw: Matrix::zero(),
            at: Big::zero(),
        }
    }

    /// Whether it has or takes a velocity.
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
            Self::Posture {
                posture,
                coordinate,
                ..
            } => posture.displacement(&q[*coordinate..]),
        }
    }

    /// The place of each velocity that moves the body, and L in frame (i) for a unit of it.
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
            Self::Posture {
                posture, velocity, ..
            } => {
                let screws = posture.screws();
                (*velocity..).zip(screws).collect()
            }
        }
    }

    /// Where its quaternion begins among the coordinates, if it has one.
    #[must_use]
    pub fn quaternion(&self) -> Option<usize> {
        match self {
            Self::Posture {
                posture: Posture::Spherical,
                coordinate,
                ..
            } => Some(*coordinate),
            Self::Posture {
                posture: Posture::Floating,
                coordinate,
                ..
            } => Some(coordinate + 3),
            _ => None,
        }
    }
}

impl Posture {
    /// How many coordinates and how many velocities it has.
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
                &shift * &exponential(&turn(2), &q[2])
            }
            Self::Spherical => turned(q),
            Self::Floating => {
                let shift = Matrix::translation(&[q[0].clone(), q[1].clone(), q[2].clone()]);
                &shift * &turned(&q[3..])
            }
        }
    }

    fn screws(self) -> Vec<Matrix> {
        match self {
            Self::Planar => vec![slide(0), slide(1), turn(2)],
            Self::Spherical => (0..3).map(turn).collect(),
            Self::Floating => (0..3).map(slide).chain((0..3).map(turn)).collect(),
        }
    }
}

/// R = 1 + 2 w v̲ + 2 v̲² of a quaternion v, w of length 1.
fn turned(q: &[Big]) -> Matrix {
    let nothing = [(); 3].map(|()| Big::zero());
    let two = Big::new(2.0);
    let v = Matrix::screw(&[q[0].clone(), q[1].clone(), q[2].clone()], &nothing);
    let once = v.times(&(&two * &q[3]));
    &(&Matrix::identity() + &once) + &(&v * &v).times(&two)
}

/// L about a coordinate axis.
#[must_use]
pub fn turn(axis: usize) -> Matrix {
    Matrix::screw(&unit(axis), &[(); 3].map(|()| Big::zero()))
}

/// L along a coordinate axis.
#[must_use]
pub fn slide(axis: usize) -> Matrix {
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

/// A turn that takes z to the normal (a, b, c) of a plane, a direction of length 1, and x to what is left of (c², a²,
/// b²) in that plane: about an axis of the frame, x and y go to those that follow it. Nothing is left where all
/// entries are the same, to a millionth: there x goes to what is left of (1, 0, 0).
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
    let left: [Big; 3] = core::array::from_fn(|k| &guide[k] - &normal[k] * &along);
    let square = left.iter().fold(Big::zero(), |sum, x| sum + x * x);
    let length = square.sqrt();
    let x = left.map(|entry| entry / &length);
    of_columns(&x, &cross(normal, &x), normal)
}

/// A turn that takes z to the axis of a loop, a direction of length 1. Along an axis of the frame, x and y go to
/// those that follow it; else x goes to the product of the axis with that of the frame that it is farthest from.
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
