//! Integration and difference of configurations, against the exponential and the logarithm of screws.
//!
//! In: motions from rest to several turns. Errors are at most some units of rounding, also near rest and near
//! 180°.

use crate::sample::{Random, agree, largest};
use homogen::robot::manifold::{
    difference_floating, difference_planar, difference_spherical, exp, integrate_floating,
    integrate_planar, integrate_spherical, log, normalized,
};
use homogen::{Chain, Inertia, Joint, Pose, Real, Scalar, Screw, Velocity, rotation, vector};
use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Angles at which simple formulas lose accuracy.
const ANGLES: [f64; 14] = [
    0.0, 1e-300, 1e-160, 1e-40, 1e-20, 1e-10, 1e-8, 1e-5, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.13,
];

/// Distances from 180°.
const SHORT_OF_PI: [f64; 6] = [1e-2, 1e-5, 1e-8, 1e-12, 1e-15, 0.0];

fn pose<T: Real>([x, y, z, qx, qy, qz, qw]: [T; 7]) -> Pose<T> {
    Pose::new(rotation::from_quaternion([qw, qx, qy, qz]), [x, y, z])
}

fn entries<T: Real>(pose: &Pose<T>) -> Vec<T> {
    [pose.rotation().as_flattened(), &pose.translation()].concat()
}

fn anywhere<T: Real>(random: &mut Random) -> [T; 7] {
    let [x, y, z, a, b, c, d]: [T; 7] = random.numbers();
    let [a, b, c, d] = normalized([a, b, c, d]);
    [x, y, z, a, b, c, d]
}

fn scaled<T: Real, const N: usize>(by: f64, vector: [f64; N]) -> [T; N] {
    vector.map(|entry| T::constant(by * entry))
}

/// For lengths whose squares overflow, as 10³⁰⁰, or vanish, as 10⁻³¹⁰.
fn a_quaternion_of_any_length_is_normalized<T: Real>(sizes: &[f64], least_digits: f64) {
    let direction = [0.5, -0.1, 0.7, -0.5];
    let length: f64 = vector::norm(direction);
    for &size in sizes {
        let quaternion = direction.map(|entry| T::constant(size * entry));
        let found = normalized(quaternion);
        for (found, entry) in found.iter().zip(direction) {
            let off = (found.to_f64() - entry / length).abs();
            assert!(off < least_digits, "{size:e}: {found}");
        }
        let alone = normalized([
            T::constant(0.0),
            T::constant(-size),
            T::constant(0.0),
            T::constant(0.0),
        ]);
        assert_eq!(alone.map(T::to_f64), [0.0, -1.0, 0.0, 0.0], "{size:e}");
    }
}

#[test]
fn quaternions_of_any_length_are_normalized() {
    let sizes = [
        1e300, 1.7e308, 1e200, 1e100, 1e13, 1.0, 1e-13, 1e-150, 1e-200, 1e-300,
    ];
    a_quaternion_of_any_length_is_normalized::<f64>(&sizes, 4e-16);
    a_quaternion_of_any_length_is_normalized::<f64>(&[1e-310], 1e-12);
    a_quaternion_of_any_length_is_normalized::<f64>(&[5e-323], 0.1);
    let sizes = [3e38, 1e30, 1e20, 1e13, 1.0, 1e-13, 1e-20, 1e-30, 1e-36];
    a_quaternion_of_any_length_is_normalized::<f32>(&sizes, 2e-7);
    a_quaternion_of_any_length_is_normalized::<f32>(&[1e-41], 1e-3);
}

#[test]
fn zero_and_infinite_quaternions_become_nan() {
    for bad in [
        [0.0; 4],
        [f64::NAN, 0.0, 0.0, 1.0],
        [1.0, f64::INFINITY, 0.0, 0.0],
        [f64::INFINITY, -f64::INFINITY, 0.0, 0.0],
    ] {
        let found = normalized(bad);
        assert!(
            found.iter().all(|entry| entry.is_nan()),
            "{bad:?}: {found:?}"
        );
    }
}

#[test]
fn ordinary_quaternions_have_the_bits_of_the_plain_formula() {
    let mut random = Random::new(43);
    for round in 0..2000 {
        let size = 10.0_f64.powi(round % 23 - 11);
        let quaternion: [f64; 4] = random.numbers();
        let quaternion = quaternion.map(|entry| size * entry);
        let [x, y, z, w] = quaternion;
        let length = (x * x + y * y + z * z + w * w).sqrt();
        assert_eq!(
            normalized(quaternion),
            quaternion.map(|entry| entry / length)
        );
    }
}

/// M exp(W) by the paper's screws, without quaternions.
fn a_step_is_the_exponential_of_a_velocity<T: Real>() {
    let mut random = Random::new(41);
    for angle in ANGLES.into_iter().chain([4.0, 6.25, 7.0, 100.0]) {
        let (q, axis, v) = (anywhere::<T>(&mut random), random.unit(), random.numbers());
        let omega: [T; 3] = scaled(angle, axis);
        let [vx, vy, vz]: [T; 3] = v;
        let there = integrate_floating(q, [vx, vy, vz, omega[0], omega[1], omega[2]]);
        let motion = Velocity::new(omega, v).displacement(T::constant(1.0));
        let expected = pose(q) * motion.to_relative_pose();
        // An angle of a hundred radians has an error of two digits itself.
        let size = 1.0f64.max(angle);
        agree(&entries(&pose(there)), &entries(&expected), 16.0, size);
        let turned = integrate_spherical([q[3], q[4], q[5], q[6]], omega);
        agree(&turned, &there[3..], 0.0, 1.0);
    }
}

/// The difference gives the step back, up to 180°, with a small relative error of the angle.
fn a_difference_is_the_step<T: Real>() {
    let mut random = Random::new(42);
    let near = SHORT_OF_PI.map(|short| PI - short);
    for angle in ANGLES.into_iter().chain(near) {
        for _ in 0..20 {
            let (q, axis) = (anywhere::<T>(&mut random), random.unit());
            let omega: [T; 3] = scaled(angle, axis);
            let v: [T; 3] = random.numbers();
            let step = [v[0], v[1], v[2], omega[0], omega[1], omega[2]];
            let there = integrate_floating(q, step);
            let found = difference_floating(q, there);
            let (found_v, found_omega) = found.split_at(3);
            // At 180° either sense of rotation is right: compare the configurations.
            let again = integrate_floating(q, found);
            agree(&entries(&pose(again)), &entries(&pose(there)), 24.0, 2.0);
            if angle < 3.1 {
                agree(found_omega, &omega, 16.0, 1.0);
                agree(found_v, &v, 32.0, 1.0);
                agree(
                    &difference_spherical(
                        [q[3], q[4], q[5], q[6]],
                        [there[3], there[4], there[5], there[6]],
                    ),
                    found_omega,
                    0.0,
                    1.0,
                );
            } else {
                let size = vector::norm([found[3], found[4], found[5]]).to_f64();
                assert!((size - PI).abs() < 0.1, "{size}");
            }
        }
    }
}

/// The logarithm of a quaternion of a rotation vector is the vector, to units of its own size.
fn logarithms_keep_their_digits<T: Real>() {
    let mut random = Random::new(43);
    for angle in ANGLES {
        let omega: [T; 3] = scaled(angle, random.unit());
        let found = log(exp(omega));
        agree(&found, &omega, 12.0, largest(&omega));
        // A quaternion and its negative are the same rotation, and its length does not matter.
        let opposite = exp(omega).map(|entry| -(entry + entry));
        agree(&log(opposite), &found, 4.0, largest(&omega));
    }
    let half = [0.6, 0.0, -0.8, 0.0].map(T::constant);
    agree(&log(half), &scaled(PI, [0.6, 0.0, -0.8]), 8.0, PI);
}

fn planar_steps<T: Real>() {
    let mut random = Random::new(44);
    for angle in ANGLES.into_iter().chain([PI, 4.0, -6.0, 7.0]) {
        let q: [T; 3] = random.numbers();
        let [vx, vy]: [T; 2] = random.numbers();
        let there = integrate_planar(q, [vx, vy, T::constant(angle)]);
        let about_z = Screw::new([0.0, 0.0, 1.0].map(T::constant), [T::constant(0.0); 3]);
        let turn = |angle: T, x: T, y: T| {
            let turn = about_z.exp(angle).to_relative_pose();
            Pose::from_translation([x, y, T::constant(0.0)]) * turn
        };
        let zero = T::constant(0.0);
        let velocity = Velocity::new([zero, zero, T::constant(angle)], [vx, vy, zero]);
        let motion = velocity.displacement(T::constant(1.0));
        let expected = turn(q[2], q[0], q[1]) * motion.to_relative_pose();
        agree(
            &entries(&turn(there[2], there[0], there[1])),
            &entries(&expected),
            24.0,
            2.0,
        );
        let found = difference_planar(q, there);
        if angle.abs() < PI {
            agree(&found, &[vx, vy, T::constant(angle)], 32.0, 2.0);
        }
        assert!(found[2].abs().to_f64() < PI + 1e-6);
        let again = integrate_planar(q, found);
        agree(
            &entries(&turn(again[2], again[0], again[1])),
            &entries(&expected),
            48.0,
            2.0,
        );
    }
}

#[test]
fn steps_in_double_precision() {
    a_step_is_the_exponential_of_a_velocity::<f64>();
    a_difference_is_the_step::<f64>();
    logarithms_keep_their_digits::<f64>();
    planar_steps::<f64>();
}

#[test]
fn steps_in_single_precision() {
    a_step_is_the_exponential_of_a_velocity::<f32>();
    a_difference_is_the_step::<f32>();
    logarithms_keep_their_digits::<f32>();
    planar_steps::<f32>();
}

/// A number without an order, like a pack.
#[derive(Clone, Copy, Debug)]
struct Unordered(f64);

macro_rules! operation {
    ($trait:ident $method:ident $operator:tt) => {
        impl $trait for Unordered {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    };
}
operation!(Add add +);
operation!(Sub sub -);
operation!(Mul mul *);
operation!(Div div /);

impl Neg for Unordered {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for Unordered {
    fn constant(value: f64) -> Self {
        Self(value)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
}

/// The default methods of [`Scalar`], among them the sign.
#[test]
fn numbers_without_an_order_take_the_same_steps() {
    let mut random = Random::new(45);
    for angle in ANGLES
        .into_iter()
        .chain(SHORT_OF_PI.map(|short| PI - short))
    {
        let q = anywhere::<f64>(&mut random);
        let omega: [f64; 3] = scaled(angle, random.unit());
        let step = [0.5, -0.25, 1.0, omega[0], omega[1], omega[2]];
        let there = integrate_floating(q, step);
        let unordered = integrate_floating(q.map(Unordered), step.map(Unordered));
        agree(&unordered.map(|x| x.0), &there, 8.0, 2.0);
        let found = difference_floating(q.map(Unordered), unordered).map(|x| x.0);
        let again = integrate_floating(q, found);
        agree(&entries(&pose(again)), &entries(&pose(there)), 32.0, 2.0);
    }
    for (number, sign) in [
        (2.0, 1.0),
        (-1e-9, -1.0),
        (0.0, 0.0),
        (-0.0, 0.0),
        (-3.0, -1.0),
    ] {
        assert_eq!((Unordered(number).sign().0, number.sign()), (sign, sign));
    }
}

/// All types of joints, one of them a mimic joint.
fn chain(random: &mut Random) -> Chain<13, 0, 15, 6> {
    let here = random.pose();
    let inertia = Inertia::zero();
    let hinge = |name, parent| {
        let z = Screw::new([0.0, 0.0, 1.0], [0.0; 3]);
        Joint::new(name, parent, here, z, inertia)
    };
    Chain::new(
        [
            Joint::floating("root", None, here, inertia),
            hinge("follower", Some(0)).mimic(3, -2.0),
            Joint::spherical("ball", Some(1), here, inertia),
            hinge("leader", Some(2)),
            Joint::planar("puck", Some(0), here, inertia),
            hinge("slow", Some(4)).mimic(3, 0.5),
        ],
        [],
        [0.0; 3],
    )
}

#[test]
fn a_chain_steps_joint_by_joint() {
    let mut random = Random::new(46);
    let chain = chain(&mut random);
    let lists = |joint| (chain.coordinates(joint), chain.velocities(joint));
    assert_eq!(lists(0), (0..7, 0..6));
    assert_eq!(lists(1), (11..12, 9..10));
    assert_eq!(lists(2), (7..11, 6..9));
    assert_eq!(lists(4), (12..15, 10..13));
    let mut neutral = [0.0; 15];
    (neutral[6], neutral[10]) = (1.0, 1.0);
    assert_eq!(chain.neutral::<f64>(), neutral);

    let wild: [f64; 15] = random.numbers();
    let q = chain.normalize(&wild);
    for quaternion in [3, 7] {
        let entries = &q[quaternion..quaternion + 4];
        let square: f64 = entries.iter().map(|entry| entry * entry).sum();
        agree(&[square], &[1.0], 8.0, 1.0);
    }
    assert_eq!((&q[..3], &q[11..]), (&wild[..3], &wild[11..]));
    let v: [f64; 13] = random.numbers();
    let there = chain.integrate(&q, &v);
    agree(&chain.difference(&q, &there), &v, 32.0, 1.0);
    agree(&there[11..12], &[q[11] + v[9]], 0.0, 1.0);
    agree(&chain.difference(&q, &q), &[0.0; 13], 4.0, 1.0);
}
