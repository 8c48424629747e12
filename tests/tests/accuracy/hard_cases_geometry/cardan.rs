//! Cardan and Euler angles at and near their singular middle angles, for all twelve sequences.
//!
//! In: exact rotations rounded to the type, and angular velocities. Out: the distance of the rotation by the computed
//! angles from the given one, and of the angular velocity by the computed rates.

use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI};

use homogen::angles::{Sequence, from_rotation, rates};
use homogen_tests::big::Big;
use homogen_tests::states::Random;

use crate::hard_cases_geometry::exact::{
    Matrix, add, distance, dot, exact, exact_matrix, nearest_matrix, norm, product, rotation,
    scale, sub,
};
use crate::hard_cases_geometry::measure::{Number, direction, hold, size};
use crate::hard_cases_geometry::worst::CARDAN;

/// The index of the sequence, α, β, γ, ω.
type State<T> = [T; 7];

fn states<T: Number>() -> Vec<State<T>> {
    let mut random = Random::new(8);
    let mut states = Vec::new();
    for k in 0..1200_usize {
        let sequence = Sequence::ALL[k % 12];
        let singular = match (sequence.is_euler(), random.chance(2)) {
            (true, true) => 0.0,
            (true, false) => PI,
            (false, true) => FRAC_PI_2,
            (false, false) => -FRAC_PI_2,
        };
        let away = match k / 12 % 5 {
            0 => T::constant(0.0),
            1 => T::constant(random.unit()),
            _ => size(&mut random, -15.0, -2.0),
        };
        let mut angle = || match random.below(4) {
            0 => T::constant([0.0, FRAC_PI_2, -FRAC_PI_2, PI][random.below(4)]),
            _ => T::constant(PI * random.unit()),
        };
        let (alpha, gamma) = (angle(), angle());
        let speed = match k / 12 % 4 {
            0 => T::constant(0.0),
            1 => T::MIN_POSITIVE * T::constant(random.unit()),
            _ => size(&mut random, -6.0, 2.0),
        };
        let [x, y, z] = homogen::vector::scale(speed, direction(&mut random));
        let number = f64::from(u8::try_from(k % 12).expect("twelve"));
        let beta = T::constant(singular) + away;
        states.push([T::constant(number), alpha, beta, gamma, x, y, z]);
    }
    states
}

fn sequence<T: Number>(number: T) -> Sequence {
    let is = |k: usize| f64::from(u8::try_from(k).expect("twelve")) == number.to_f64();
    Sequence::ALL[(0..12).find(|&k| is(k)).expect("a sequence")]
}

/// The rotation by an angle about x, y or z.
fn elementary(axis: usize, angle: &Big) -> Matrix {
    rotation(
        &from_fn(|i| Big::new(f64::from(u8::from(i == axis)))),
        angle,
    )
}

/// The rotations by the first angle, by the first two, and by all three.
fn rotations(sequence: Sequence, angles: &[Big; 3]) -> [Matrix; 3] {
    let [i, j, k] = sequence.axes();
    let first = elementary(i, &angles[0]);
    let second = product(&first, &elementary(j, &angles[1]));
    let third = product(&second, &elementary(k, &angles[2]));
    [first, second, third]
}

/// The error of R by the angles that were computed for R, in u.
fn angles_error<T: Number>(&[number, alpha, beta, gamma, ..]: &State<T>) -> f64 {
    let sequence = sequence(number);
    let [.., r] = rotations(sequence, &exact([alpha, beta, gamma]));
    let r = nearest_matrix::<T>(&r);
    let found = from_rotation(sequence, &r);
    if !found.iter().all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let [.., rebuilt] = rotations(sequence, &exact(found));
    (distance(&rebuilt, &exact_matrix(&r)) / Big::new(T::UNIT)).to_f64()
}

/// The error of ω by the rates that were computed for ω, in u of its terms; 0 if the rates are refused at the singular
/// angle, infinite if elsewhere.
fn rates_error<T: Number>(&[number, alpha, beta, gamma, x, y, z]: &State<T>) -> f64 {
    let sequence = sequence(number);
    let angles = exact([alpha, beta, gamma]);
    let (sine, cosine) = angles[1].sin_cos();
    let determinant = if sequence.is_euler() { sine } else { cosine };
    let Ok(found) = rates(sequence, [alpha, beta, gamma], [x, y, z]) else {
        let tiny = determinant.abs() <= Big::new(8.0 * T::UNIT);
        return if tiny { 0.0 } else { f64::INFINITY };
    };
    if !found.iter().all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let [i, j, k] = sequence.axes();
    let [first, second, _] = rotations(sequence, &angles);
    let column = |x: &Matrix, k: usize| from_fn(|i| x[i][k].clone());
    let axes = [elementary(i, &Big::zero()), first, second];
    let axes = [
        column(&axes[0], i),
        column(&axes[1], j),
        column(&axes[2], k),
    ];
    let (omega, found) = (exact([x, y, z]), exact(found));
    let parts: [_; 3] = from_fn(|i| scale(&found[i], &axes[i]));
    let sum = parts
        .iter()
        .fold(sub(&omega, &omega), |sum, part| add(&sum, part));
    let size = parts
        .iter()
        .fold(norm(&omega), |size, part| size + norm(part));
    let apart = sub(&sum, &omega);
    let unit = size * Big::new(T::UNIT) + Big::new(T::UNDERFLOW);
    (dot(&apart, &apart).sqrt() / unit).to_f64()
}

fn gimbal<T: Number>() {
    // The worst are 4.1 and 1.1 u; the limits are about twice as large.
    let limits = [("cardan_gimbal, R", 8.0), ("cardan_gimbal, rates", 2.0)];
    hold(limits, &CARDAN, &states::<T>(), |state| {
        [angles_error(state), rates_error(state)]
    });
}

crate::in_every_type! {
    /// Hard case 8.
    cardan_gimbal => gimbal;
}
