//! `neutral`, `integrate`, `difference` and `normalize` in files for `core` alone.
//!
//! In: a robot with every type of joint; states with rotations near zero, near half a turn and beyond. Out: the bits of
//! the runtime, in both precisions, and identities between the four functions.

use std::array::from_fn;
use std::f64::consts::PI;

use homogen::{Real, Robot};
use homogen_tests::states::Random;

/// The robot by the runtime.
#[derive(Robot)]
#[robot(urdf = "../robots/every_joint.urdf", generate(gravity))]
struct OfRuntime;

/// Includes a file, and implements its functions for its type.
macro_rules! file {
    ($module:ident, $file:literal, $number:ty) => {
        mod $module {
            include!(concat!(env!("OUT_DIR"), "/", $file));
        }

        impl OfFile for $number {
            fn neutral() -> [Self; 25] {
                $module::Joints.neutral()
            }

            fn integrate(q: &[Self; 25], v: &[Self; 23]) -> [Self; 25] {
                $module::Joints.integrate(q, v)
            }

            fn difference(start: &[Self; 25], end: &[Self; 25]) -> [Self; 23] {
                $module::Joints.difference(start, end)
            }

            fn normalize(q: &[Self; 25]) -> [Self; 25] {
                $module::Joints.normalize(q)
            }
        }
    };
}

/// The functions of a file.
trait OfFile: Real {
    fn neutral() -> [Self; 25];
    fn integrate(q: &[Self; 25], v: &[Self; 23]) -> [Self; 25];
    fn difference(start: &[Self; 25], end: &[Self; 25]) -> [Self; 23];
    fn normalize(q: &[Self; 25]) -> [Self; 25];
}

file! { single, "joints_f32.rs", f32 }
file! { double, "joints_f64.rs", f64 }

/// The first indices of the quaternions in q and of the angular velocities in v.
const QUATERNIONS: [(usize, usize); 2] = [(0, 0), (20, 19)];

/// A configuration and velocities: tiny, near half a turn, or of any size up to several full turns.
fn state<T: Real>(random: &mut Random, index: i32) -> ([T; 25], [T; 23]) {
    let size = 10.0_f64.powi(index % 12 - 10);
    let q = from_fn(|_| T::constant(random.unit()));
    let mut v = from_fn(|_| size * random.unit());
    if index % 3 == 0 {
        // Near half a turn, about any axis.
        for (_, first) in QUATERNIONS {
            let omega = &mut v[first..first + 3];
            let length = omega.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
            let angle = PI * (1.0 + size * random.unit());
            for entry in omega {
                *entry *= angle / length;
            }
        }
    }
    (OfRuntime.normalize(&q), v.map(T::constant))
}

fn assert_bits<T: OfFile>() {
    let mut random = Random::new(20);
    assert_eq!(T::neutral(), OfRuntime.neutral());
    for exponent in [-45, -38, -20, 0, 20, 38] {
        let q: [T; 25] = from_fn(|_| T::constant(random.unit() * 10.0_f64.powi(exponent)));
        let [found, expected] = [T::normalize(&q), OfRuntime.normalize(&q)];
        // Zero in single precision gives NaN in both.
        let same = |k: usize| {
            found[k] == expected[k] || !(found[k].is_finite() || expected[k].is_finite())
        };
        assert!((0..25).all(same), "1e{exponent}");
    }
    for index in 0..4000 {
        let (q, v) = state::<T>(&mut random, index);
        let ahead = OfRuntime.integrate(&q, &v);
        assert_eq!(T::integrate(&q, &v), ahead, "{index}");
        let (other, _) = state::<T>(&mut random, index);
        for end in [q, ahead, other] {
            let apart = OfRuntime.difference(&q, &end);
            assert_eq!(T::difference(&q, &end), apart, "{index}");
        }
    }
}

#[test]
fn files_have_the_bits_of_the_runtime() {
    assert_bits::<f32>();
    assert_bits::<f64>();
}

fn assert_identities<T: OfFile>() {
    let mut random = Random::new(21);
    let neutral = T::neutral();
    let close = |a: T, b: T, size: T| (a - b).abs() <= T::constant(16.0) * T::EPSILON * size;
    let one = T::constant(1.0);
    for index in 0..4000 {
        let (q, v) = state::<T>(&mut random, index);
        // At most half a turn.
        let v: [T; 23] = from_fn(|k| {
            let size = v[k].abs().to_f64();
            v[k] * T::constant(1.7 / size.max(1.7))
        });
        for start in [neutral, q] {
            let end = T::integrate(&start, &v);
            for (first, _) in QUATERNIONS {
                let square = end[first..first + 4]
                    .iter()
                    .fold(T::constant(0.0), |sum, &entry| sum + entry * entry);
                assert!(close(square, one, one), "{index}: {square:?}");
            }
            let found = T::difference(&start, &end);
            for k in 0..23 {
                assert!(
                    close(found[k], v[k], T::constant(4.0)),
                    "{index}, velocity {k}: {:?}, not {:?}",
                    found[k],
                    v[k]
                );
            }
            let again = T::integrate(&start, &found);
            // A quaternion and its negative are the same rotation.
            assert!(
                (0..25).all(|k| close(again[k], end[k], T::constant(8.0))),
                "{index}"
            );
            let normalized = T::normalize(&end);
            assert!(
                (0..25).all(|k| close(normalized[k], end[k], one)),
                "{index}"
            );
        }
        assert_eq!(T::difference(&q, &q), [T::constant(0.0); 23]);
        assert_eq!(T::integrate(&neutral, &[T::constant(0.0); 23]), neutral);
    }
}

#[test]
fn difference_inverts_integrate() {
    assert_identities::<f32>();
    assert_identities::<f64>();
}
