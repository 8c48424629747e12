//! Axis and angle of rotations: tiny ones, half turns, and matrices that are not orthogonal.
//!
//! In: an axis and an angle, whose exact rotation is rounded to the type, or a matrix. Out: errors of the computed axis
//! and angle.

use std::array::from_fn;
use std::f64::consts::PI;

use homogen::rotation;
use homogen_tests::big::Big;
use homogen_tests::states::Random;

use crate::hard_cases_geometry::exact::{
    self, Matrix, Vector, add, axis_angle, distance, exact, exact_matrix, nearest_matrix,
    nearest_rotation, norm, product, sub, transpose, unit,
};
use crate::hard_cases_geometry::measure::{Number, direction, hold, size};
use crate::hard_cases_geometry::worst::{DRIFTED, NEAR_PI, TINY};

/// The larger error of axis and angle, in u; if `either`, the axis may have the other sign.
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
    // The worst is 3.8 u.
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

/// The last number of a state is π − φ.
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
    // The worst is 2.3 u.
    hold(
        [("log_near_pi", 4.0)],
        &NEAR_PI,
        &states,
        |&[x, y, z, less]| {
            let axis = unit(&exact([x, y, z]));
            let phi = Big::pi() - less.big();
            // Below the rounding of R, both directions are right.
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
    // The worst are 3.8 where R is only rounded, and 1.3 with a larger defect.
    hold([("log_drifted_r", 4.0)], &DRIFTED, &states, |entries| {
        [drift_error(entries)]
    });
}

/// The distance of the rotation by the computed axis and angle from the nearest rotation, relative to the defect.
fn drift_error<T: Number>(entries: &[T; 9]) -> f64 {
    let r: [[T; 3]; 3] = from_fn(|i| from_fn(|j| entries[3 * i + j]));
    let (found, found_angle) = rotation::axis_angle(&r);
    if !found.iter().chain([&found_angle]).all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let r = exact_matrix(&r);
    let identity = from_fn(|i| from_fn(|j| Big::new(f64::from(u8::from(i == j)))));
    let defect = distance(&product(&transpose(&r), &r), &identity);
    // The unit covers rotations without a defect.
    let defect = defect + Big::new(T::UNIT);
    // Rotations are compared, since an axis is ill-defined at small angles.
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
    /// Hard case 5, relative to the defect of orthogonality.
    log_drifted_r => drifted;
}
