//! Generated code on scalars other than `f32` and `f64`: dual numbers, with slopes that other generated functions give
//! too, and packs of four numbers.

use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen::{Robot, Scalar};

/// The Panda-class arm.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf")]
#[robot(generate(forward_kinematics, velocity, inverse_dynamics, mass_matrix))]
struct Panda;

const Q: [f64; 7] = [0.3, -0.7, 0.2, -1.9, 0.4, 1.6, -0.5];
const QD: [f64; 7] = [0.6, -0.2, 0.9, 0.1, -0.8, 0.5, 1.1];
const QDD: [f64; 7] = [-1.0, 0.4, 0.3, 2.0, -0.6, 0.7, 0.2];

/// A value and its derivative.
#[derive(Clone, Copy)]
struct Dual {
    value: f64,
    slope: f64,
}

fn dual(value: f64, slope: f64) -> Dual {
    Dual { value, slope }
}

/// Values with slopes.
fn duals(values: [f64; 7], slopes: [f64; 7]) -> [Dual; 7] {
    std::array::from_fn(|i| dual(values[i], slopes[i]))
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        dual(self.value + other.value, self.slope + other.slope)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        dual(self.value - other.value, self.slope - other.slope)
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        dual(self.value * other.value, slope)
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        dual(value, (self.slope - value * other.slope) / other.value)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        dual(-self.value, -self.slope)
    }
}

impl Scalar for Dual {
    fn constant(value: f64) -> Self {
        dual(value, 0.0)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        dual(root, self.slope / (2.0 * root))
    }

    fn sign(self) -> Self {
        dual(Scalar::sign(self.value), 0.0)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (
            dual(sine, cosine * self.slope),
            dual(cosine, -sine * self.slope),
        )
    }
}

/// Four numbers, as in a SIMD register.
#[derive(Clone, Copy)]
struct Pack([f64; 4]);

impl Pack {
    fn zip(self, other: Self, operation: fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|lane| {
            operation(self.0[lane], other.0[lane])
        }))
    }
}

impl Add for Pack {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, f64::add)
    }
}

impl Sub for Pack {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, f64::sub)
    }
}

impl Mul for Pack {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.zip(other, f64::mul)
    }
}

impl Div for Pack {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.zip(other, f64::div)
    }
}

impl Neg for Pack {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(f64::neg))
    }
}

impl Scalar for Pack {
    fn constant(value: f64) -> Self {
        Self([value; 4])
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(std::array::from_fn(|lane| {
            Scalar::mul_add(self.0[lane], factor.0[lane], term.0[lane])
        }))
    }

    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    fn sin_cos(self) -> (Self, Self) {
        let pairs = self.0.map(homogen::trigonometry::double::sin_cos);
        (
            Self(pairs.map(|(sine, _)| sine)),
            Self(pairs.map(|(_, cosine)| cosine)),
        )
    }
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{a} is not {b}");
}

/// dM/dt = W M.
#[test]
fn the_slope_of_the_pose_is_the_velocity() {
    let pose = Panda.forward_kinematics(&duals(Q, QD));
    let rate = Panda.velocity(&Q, &QD);
    let ([wx, wy, wz], v) = (rate.omega(), rate.v());
    let omega_cross = |[x, y, z]: [f64; 3]| [wy * z - wz * y, wz * x - wx * z, wx * y - wy * x];
    let at = omega_cross(pose.translation().map(|entry| entry.value));
    for i in 0..3 {
        close(pose.translation()[i].slope, at[i] + v[i]);
        for column in 0..3 {
            let axis = pose.rotation().map(|row| row[column].value);
            close(pose.rotation()[i][column].slope, omega_cross(axis)[i]);
        }
    }
}

/// ∂τ/∂q̈ = M(q).
#[test]
fn the_slope_of_the_torques_is_the_mass_matrix() {
    let mass = Panda.mass_matrix(&Q);
    for (column, entries) in mass.into_iter().enumerate() {
        let unit = std::array::from_fn(|i| if i == column { 1.0 } else { 0.0 });
        let still = [0.0; 7];
        let torques =
            Panda.inverse_dynamics(&duals(Q, still), &duals(QD, still), &duals(QDD, unit));
        // Rows are columns, since the matrix is symmetric.
        for (torque, entry) in torques.into_iter().zip(entries) {
            close(torque.slope, entry);
        }
    }
}

#[test]
fn every_lane_of_a_pack_has_the_bits_of_a_single_number() {
    let lanes = [1.0, -0.5, 0.1, 2.0];
    let pack = |values: [f64; 7]| values.map(|value| Pack(lanes.map(|lane| lane * value)));
    let together = Panda.inverse_dynamics(&pack(Q), &pack(QD), &pack(QDD));
    for (index, lane) in lanes.into_iter().enumerate() {
        let scaled = |values: [f64; 7]| values.map(|value| lane * value);
        let alone = Panda.inverse_dynamics(&scaled(Q), &scaled(QD), &scaled(QDD));
        for joint in 0..7 {
            assert_eq!(together[joint].0[index].to_bits(), alone[joint].to_bits());
        }
    }
}
