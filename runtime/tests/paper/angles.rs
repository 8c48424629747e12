//! SPACELIB's Cardan and Euler angles: twelve sequences, positions, rates and second rates.

use crate::dense::{assert_same, assert_within};
use crate::jet::Jet;
use crate::sample::Random;
use homogen::angles::Sequence;
use homogen::angles::{
    acceleration, from_rotation, omega, omega_dot, other_angles, pose, rates, rotation,
    second_rates, velocity,
};
use homogen::rotation::from_axis_angle;
use homogen::vector::{
    add, axial, identity, matrix_product, matrix_scale, matrix_sum, product, transpose,
};
use homogen::{Error, Point, Real, Scalar, Screw};
use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI};

fn flat<T: Real>(x: &[[T; 3]; 3]) -> Vec<T> {
    x.as_flattened().to_vec()
}

/// Singular middle angles: ±π/2 for Cardan, 0 and π for Euler sequences.
fn singular(sequence: Sequence) -> [f64; 2] {
    if sequence.is_euler() {
        [0.0, PI]
    } else {
        [FRAC_PI_2, -FRAC_PI_2]
    }
}

/// Regular angles, and angles at and near the singularity.
fn samples<T: Real>(sequence: Sequence, seed: u64) -> Vec<[T; 3]> {
    let mut random = Random::new(seed);
    let mut list = vec![[T::constant(0.0); 3]];
    let mut angle = || random.number::<T>() * T::constant(3.1);
    for _ in 0..100 {
        list.push([angle(), angle(), angle()]);
    }
    for middle in singular(sequence) {
        for away in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2] {
            for sign in [-1.0, 1.0] {
                list.push([angle(), T::constant(middle + sign * away), angle()]);
                list.push([T::constant(0.0), T::constant(middle + sign * away), angle()]);
            }
        }
    }
    list
}

/// A rotation about x, y or z, written out.
fn elementary<T: Scalar>(axis: usize, angle: T) -> [[T; 3]; 3] {
    let (s, c) = angle.sin_cos();
    let (o, i) = (T::constant(0.0), T::constant(1.0));
    match axis {
        0 => [[i, o, o], [o, c, -s], [o, s, c]],
        1 => [[c, o, s], [o, i, o], [-s, o, c]],
        _ => [[c, -s, o], [s, c, o], [o, o, i]],
    }
}

fn rotation_is_the_product_of_three<T: Real>() {
    for sequence in Sequence::ALL {
        let [i, j, k] = sequence.axes();
        for angles in samples::<T>(sequence, 120) {
            let [a, b, c] = angles;
            let literal = matrix_product(
                &matrix_product(&elementary(i, a), &elementary(j, b)),
                &elementary(k, c),
            );
            let found = rotation(sequence, angles);
            assert_within(flat(&found), flat(&literal), T::constant(1.0), 8.0);
        }
    }
}

/// Rotations about x, y and z by explicit matrices, also about an axis through any point.
fn rotations_about_the_axes_of_the_frame<T: Real>() {
    let mut random = Random::new(127);
    for (axis, u) in identity::<T>().into_iter().enumerate() {
        for angle in crate::sample::angles::<T>() {
            let literal = elementary(axis, angle);
            let r = from_axis_angle(u, angle);
            assert_within(flat(&r), flat(&literal), T::constant(1.0), 4.0);
            let (point, arm) = (random.vector(), random.vector());
            let q = Screw::revolute(u, point).exp(angle);
            let size = T::constant(4.0);
            assert_within((q * Point(point)).0, point, size, 8.0);
            let moved = add(point, product(&literal, arm));
            assert_within((q * Point(add(point, arm))).0, moved, size, 8.0);
        }
    }
}

/// Hard case `cardan_gimbal`: the angles reproduce the rotation within 8 units, singular or not.
fn angles_rebuild_the_rotation<T: Real>() {
    for sequence in Sequence::ALL {
        for angles in samples::<T>(sequence, 121) {
            let r = rotation(sequence, angles);
            let found = from_rotation(sequence, &r);
            assert_within(
                flat(&rotation(sequence, found)),
                flat(&r),
                T::constant(1.0),
                8.0,
            );
            let other = other_angles(sequence, found);
            assert_within(
                flat(&rotation(sequence, other)),
                flat(&r),
                T::constant(1.0),
                16.0,
            );
            let beta = found[1].to_f64();
            let range = if sequence.is_euler() {
                0.0..=PI + 1e-6
            } else {
                -FRAC_PI_2 - 1e-6..=FRAC_PI_2 + 1e-6
            };
            assert!(range.contains(&beta), "{sequence:?}: {beta}");
        }
    }
}

fn angles_come_back_away_from_singularities<T: Real>() {
    let mut random = Random::new(122);
    for sequence in Sequence::ALL {
        for _ in 0..50 {
            let beta = if sequence.is_euler() {
                T::constant(1.5) + random.number()
            } else {
                random.number()
            };
            let angles = [
                random.number::<T>() * T::constant(3.0),
                beta,
                random.number::<T>() * T::constant(3.0),
            ];
            let found = from_rotation(sequence, &rotation(sequence, angles));
            assert_within(found, angles, T::constant(3.0), 16.0);
        }
    }
}

/// ω and ω̇ of three elementary rotations whose angles are jets: ω̲ = Ṙ Rᵗ and ω̲̇ = R̈ Rᵗ − ω̲².
fn spin<T: Real>(
    sequence: Sequence,
    angles: [T; 3],
    speed: [T; 3],
    change: [T; 3],
) -> ([T; 3], [T; 3]) {
    let [i, j, k] = sequence.axes();
    let [a, b, c] = from_fn(|n| Jet(angles[n], speed[n], change[n]));
    let r = matrix_product(
        &matrix_product(&elementary(i, a), &elementary(j, b)),
        &elementary(k, c),
    );
    let part = |part: fn(Jet<T>) -> T| r.map(|row| row.map(part));
    let back = transpose(&part(|x| x.0));
    let w = matrix_product(&part(|x| x.1), &back);
    let square = matrix_scale(T::constant(-1.0), &matrix_product(&w, &w));
    let w_dot = matrix_sum(&matrix_product(&part(|x| x.2), &back), &square);
    (axial(&w), axial(&w_dot))
}

fn rates_and_second_rates_are_derivatives<T: Real>() {
    let mut random = Random::new(123);
    for sequence in Sequence::ALL {
        for angles in samples::<T>(sequence, 123) {
            let (speed, change) = (random.vector::<T>(), random.vector::<T>());
            let (w, w_dot) = spin(sequence, angles, speed, change);
            // Sums of three rates, and of six products of them and three second rates.
            assert_within(omega(sequence, angles, speed), w, T::constant(3.0), 4.0);
            let found = omega_dot(sequence, angles, speed, change);
            assert_within(found, w_dot, T::constant(9.0), 8.0);
            let (sine, cosine) = angles[1].sin_cos();
            let distance = if sequence.is_euler() { sine } else { cosine }.abs();
            if distance > T::constant(1e-3) {
                // The inverse has the condition number 1/(distance from the singularity).
                let found = rates(sequence, angles, w).expect("not singular");
                assert_within(found, speed, T::constant(3.0) / distance, 8.0);
                let found = second_rates(sequence, angles, speed, w_dot).expect("not singular");
                assert_within(found, change, T::constant(9.0) / distance, 8.0);
            }
        }
    }
}

fn rates_come_back_or_are_refused<T: Real>() {
    let mut random = Random::new(125);
    for sequence in Sequence::ALL {
        let mut refused = 0;
        for angles in samples::<T>(sequence, 125) {
            let (speed, change) = (random.vector::<T>(), random.vector::<T>());
            let (sine, cosine) = angles[1].sin_cos();
            let distance = if sequence.is_euler() { sine } else { cosine }.abs();
            let w = omega(sequence, angles, speed);
            match rates(sequence, angles, w) {
                Ok(found) => {
                    // The condition number is 1/(distance from the singularity).
                    assert_within(found, speed, T::constant(2.0) / distance, 16.0);
                    let w_dot = omega_dot(sequence, angles, speed, change);
                    let found = second_rates(sequence, angles, speed, w_dot).expect("not singular");
                    assert_within(found, change, T::constant(8.0) / distance, 16.0);
                }
                Err(Error::Degenerate { value, .. }) => {
                    assert!(value.abs() <= T::EPSILON.to_f64());
                    assert!(
                        distance <= T::constant(4.0) * T::EPSILON,
                        "{sequence:?}: {distance:?}"
                    );
                    assert!(second_rates(sequence, angles, speed, w).is_err());
                    refused += 1;
                }
                Err(other) => panic!("{other}"),
            }
        }
        assert!(refused >= 2, "{sequence:?} was never refused");
    }
}

fn typed_matrices_from_angles<T: Real>() {
    let mut random = Random::new(126);
    for sequence in Sequence::ALL {
        for angles in samples::<T>(sequence, 126) {
            let (speed, change) = (random.vector(), random.vector());
            let (p, v, a) = (random.vector(), random.vector(), random.vector());
            let m = pose(sequence, angles, p);
            assert_eq!(
                (*m.rotation(), m.translation()),
                (rotation(sequence, angles), p)
            );
            let found = from_rotation(sequence, m.rotation());
            let back = pose(sequence, found, p).to_matrix();
            assert_same(&back, &m.to_matrix(), T::constant(1.0), 8.0);
            let w = velocity(sequence, angles, speed, p, v);
            assert_eq!(w.omega(), omega(sequence, angles, speed));
            assert_within((w * Point(p)).0, v, T::constant(4.0), 8.0);
            let h = acceleration(sequence, angles, speed, change, p, a);
            assert_within((h * Point(p)).0, a, T::constant(32.0), 8.0);
            let square = h.velocity_derivative(&w);
            let expected = omega_dot(sequence, angles, speed, change);
            assert_within(square.omega(), expected, T::constant(16.0), 8.0);
        }
    }
    let identity = pose(Sequence::Xyz, [T::constant(0.0); 3], [T::constant(0.0); 3]);
    assert_same(
        &identity.to_matrix(),
        &homogen::Pose::identity().to_matrix(),
        T::constant(1.0),
        0.0,
    );
}

in_both_precisions! {
    rotation_is_the_product_of_three
    rotations_about_the_axes_of_the_frame
    angles_rebuild_the_rotation
    angles_come_back_away_from_singularities
    rates_and_second_rates_are_derivatives
    rates_come_back_or_are_refused
    typed_matrices_from_angles
}
