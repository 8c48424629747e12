//! Generated code on scalars other than `f32` and `f64`: dual numbers, with slopes that other generated functions give
//! too, and packs of four numbers; the rounding of `f64` on the processor at hand.

use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen::{Robot, Scalar};
use homogen_random::Random;
use homogen_tests::fused_sines;
use homogen_tests::tested::{F64, Fused64};

/// The Panda-class arm.
#[derive(Robot)]
#[robot(urdf = "../../robots/panda_class.urdf")]
#[robot(generate(forward_kinematics, velocity, inverse_dynamics, mass_matrix))]
struct Panda;

/// The same arm, without fused products on any processor.
#[derive(Robot)]
#[robot(urdf = "../../robots/panda_class.urdf", reproducible)]
#[robot(generate(forward_kinematics, velocity, inverse_dynamics, mass_matrix))]
struct Reproducible;

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
        let pairs = self.0.map(fused_sines::double::unfused);
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
    let together = Reproducible.inverse_dynamics(&pack(Q), &pack(QD), &pack(QDD));
    for (index, lane) in lanes.into_iter().enumerate() {
        let scaled = |values: [f64; 7]| values.map(|value| lane * value);
        let alone = Reproducible.inverse_dynamics(&scaled(Q), &scaled(QD), &scaled(QDD));
        for joint in 0..7 {
            assert_eq!(together[joint].0[index].to_bits(), alone[joint].to_bits());
        }
    }
}

/// True if this processor fuses products with sums, in a build for it or by a choice at run time.
fn fuses() -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let has = std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let has = cfg!(target_arch = "aarch64");
    has
}

/// The bits of inverse dynamics, of the mass matrix and of the pose in random states, in a type of number.
macro_rules! bits {
    ($robot:expr, $number:expr, $bare:expr) => {{
        let mut random = Random::new(11);
        let mut state = || std::array::from_fn(|_| $number(4.0 * random.unit() - 2.0));
        let states = (0..100).map(|_| [state(), state(), state()]);
        let results = states.flat_map(|[q, qd, qdd]| {
            let tau = $robot.inverse_dynamics(&q, &qd, &qdd);
            let mass = $robot.mass_matrix(&q);
            let pose = $robot.forward_kinematics(&q);
            let numbers = [&tau[..], mass.as_flattened(), &pose.translation()];
            numbers
                .concat()
                .into_iter()
                .map(|x| $bare(x).to_bits())
                .collect::<Vec<u64>>()
        });
        results.collect::<Vec<u64>>()
    }};
}

#[test]
fn f64_is_rounded_as_in_a_build_for_the_processor() {
    let found = bits!(Panda, f64::from, f64::from);
    let unfused = bits!(Panda, F64, |x: F64| x.0);
    let fused = bits!(Panda, Fused64, |x: Fused64| x.0);
    assert!(fused != unfused);
    assert!(found == if fuses() { fused } else { unfused });
}

/// Those of the same equations without fused products.
#[test]
fn reproducible_robots_have_the_same_bits_on_every_processor() {
    let found = bits!(Reproducible, f64::from, f64::from);
    assert!(found == bits!(Panda, F64, |x: F64| x.0));
    let in_packs = bits!(
        Reproducible,
        |x| homogen::Pack([x, 0.0, 1.0, x]),
        |x: homogen::Pack<f64, 4>| x.0[3]
    );
    assert!(found == in_packs);
}
