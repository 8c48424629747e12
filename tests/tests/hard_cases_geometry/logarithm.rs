//! Axis and angle of rotations: tiny ones, half turns, and matrices that are no rotations any more.
//!
//! In: an axis and an angle, the exact rotation of which is rounded to the type, or a matrix. Out:
//! errors of the axis and angle found.

use std::array::from_fn;
use std::f64::consts::PI;

use homogen::rotation;
use homogen_tests::big::Big;
use homogen_tests::states::Random;

use crate::exact::{
    self, Matrix, Vector, add, axis_angle, distance, exact, exact_matrix, nearest_matrix,
    nearest_rotation, norm, product, sub, transpose, unit,
};
use crate::measure::{Number, direction, hold, size};
use crate::worst::{DRIFTED, NEAR_PI, TINY};

/// The larger error of axis and angle, in u; the axis may point the other way where `either`.
fn error<T: Number>(r: &Matrix, axis: &Vector, angle: &Big, either: bool) -> f64 {
    let (found, found_angle) = rotation::axis_angle(&nearest_matrix::<T>(r));
    if !found.iter().chain([&found_angle]).all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let found = exact(found);
    let u = Big::new(T::UNIT);
    let mut apart = norm(&sub(&found, axis)).to_f64();
    if either {
        apart = apart.min(norm(&add(&found, axis)).to_f64());
    }
    let angle_error = (found_angle.big() - angle).abs() / (angle * u);
    angle_error.to_f64().max(apart / T::UNIT)
}

fn tiny<T: Number>() {
    let mut random = Random::new(3);
    let states: Vec<[T; 4]> = (0..1200)
        .map(|k| {
            let [x, y, z] = direction(&mut random);
            let least = if k % 2 == 0 { -12.0 } else { T::LEAST };
            [x, y, z, size::<T>(&mut random, least, -1.0).abs()]
        })
        .collect();
    // Met: 3.8 u.
    hold([("log_tiny", 4.0)], &TINY, &states, |&[x, y, z, phi]| {
        let (axis, phi) = (unit(&exact([x, y, z])), phi.big());
        [error::<T>(
            &exact::rotation(&axis, &phi),
            &axis,
            &phi,
            false,
        )]
    });
}

/// The last number is what is missing to π.
fn near_pi<T: Number>() {
    let mut random = Random::new(4);
    let states: Vec<[T; 4]> = (0..1200)
        .map(|k| {
            let [x, y, z] = direction(&mut random);
            let less = match k % 10 {
                0 => T::constant(0.0),
                1 => T::EPSILON * T::constant(random.unit().abs()),
                _ => size::<T>(&mut random, -15.0, -2.0).abs(),
            };
            [x, y, z, less]
        })
        .collect();
    // Met: 2.3 u.
    hold(
        [("log_near_pi", 4.0)],
        &NEAR_PI,
        &states,
        |&[x, y, z, less]| {
            let axis = unit(&exact([x, y, z]));
            let phi = Big::pi() - less.big();
            // What is less than the rounding of R leaves both directions open.
            let either = less.to_f64() <= 4.0 * T::UNIT;
            [error::<T>(
                &exact::rotation(&axis, &phi),
                &axis,
                &phi,
                either,
            )]
        },
    );
}

fn drifted<T: Number>() {
    let mut random = Random::new(5);
    let states: Vec<[T; 9]> = (0..1200)
        .map(|k| {
            let axis = unit(&exact(direction::<T>(&mut random)));
            let phi = match k % 4 {
                0 => size::<T>(&mut random, -9.0, -1.0).abs(),
                1 => T::constant(PI) - size::<T>(&mut random, -9.0, -1.0).abs(),
                _ => T::constant(PI * 0.5 * (random.unit() + 1.0)),
            };
            let drift = size::<T>(&mut random, -15.0, -6.0);
            let r = exact::rotation(&axis, &phi.big());
            from_fn(|k| T::nearest(&r[k / 3][k % 3]) + drift * T::constant(random.unit()))
        })
        .collect();
    // Met: 3.8 where R is only rounded, 1.3 beside a larger defect.
    hold([("log_drifted_r", 4.0)], &DRIFTED, &states, |entries| {
        [drift_error(entries)]
    });
}

/// How far the rotation of axis and angle found is from the nearest one, in parts of the defect.
fn drift_error<T: Number>(entries: &[T; 9]) -> f64 {
    let r: [[T; 3]; 3] = from_fn(|i| from_fn(|j| entries[3 * i + j]));
    let (found, found_angle) = rotation::axis_angle(&r);
    if !found.iter().chain([&found_angle]).all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let r = exact_matrix(&r);
    let identity = from_fn(|i| from_fn(|j| Big::new(f64::from(u8::from(i == j)))));
    let defect = distance(&product(&transpose(&r), &r), &identity);
    // A rotation without a defect is found to as many units as in the cases above.
    let defect = defect + Big::new(T::UNIT);
    // The rotations are compared: an axis means the less, the smaller the angle is.
    let nearest = nearest_rotation(&r);
    let (_, angle) = axis_angle(&nearest);
    let rebuilt = exact::rotation(&unit(&exact(found)), &found_angle.big());
    let apart = distance(&rebuilt, &nearest).max((found_angle.big() - angle).abs());
    (apart / defect).to_f64()
}

crate::in_every_type! {
    /// Hard case 3.
    log_tiny => tiny;
    /// Hard case 4.
    log_near_pi => near_pi;
    /// Hard case 5, in parts of the defect of orthogonality.
    log_drifted_r => drifted;
}
