//! Q = exp(L φ) of tiny motions.
//!
//! In: screws, and angles from the smallest numbers to 0.1 rad and beyond. Out: errors of R − I and t, entry by entry.

use homogen::Screw;
use homogen::vector::{add, cross, negate, scale};
use homogen_tests::states::Random;

use crate::hard_cases_geometry::exact::{exact, excess, rotation, sine_versine, translation};
use crate::hard_cases_geometry::measure::{Number, direction, hold, size, units, vector};
use crate::hard_cases_geometry::worst::{ARCS, EXPONENTIALS, VERSINES};

/// u, b, φ.
type State<T> = [T; 7];

fn states<T: Number>() -> Vec<State<T>> {
    let mut random = Random::new(1);
    let mut states = Vec::new();
    for k in 0..1200 {
        let u = direction::<T>(&mut random);
        let pitch = T::constant(f64::from(k % 2));
        let b = add(negate(cross(u, vector(&mut random))), scale(pitch, u));
        let phi = match k % 20 {
            0 => T::constant(0.0),
            1 => T::MIN_POSITIVE * T::constant(random.unit()),
            2 => size(&mut random, -1.0, 0.8),
            _ => size(&mut random, T::LEAST, -1.0),
        };
        let ([ux, uy, uz], [bx, by, bz]) = (u, b);
        states.push([ux, uy, uz, bx, by, bz, phi]);
    }
    states
}

/// The worst entry of R − I and of t, relative to the sum of the sizes of its terms, which may cancel. Errors of the
/// diagonal of R are relative to 1.
fn error<T: Number>(&[ux, uy, uz, bx, by, bz, phi]: &State<T>) -> f64 {
    let (u, b) = ([ux, uy, uz], [bx, by, bz]);
    let q = Screw::new(u, b).exp(phi);
    let (u, b, phi) = (exact(u), exact(b), phi.big());
    let (r, (t, t_size)) = (rotation(&u, &phi), translation(&u, &b, &phi));
    let (sine, versine) = sine_versine(&phi);
    let mut worst = 0.0_f64;
    for i in 0..3 {
        worst = worst.max(units(q.translation()[i], &t[i], &t_size[i]));
        for j in 0..3 {
            let size = if i == j {
                homogen_tests::big::Big::one()
            } else {
                (&u[3 - i - j] * &sine).abs() + (&u[i] * &u[j] * &versine).abs()
            };
            worst = worst.max(units(q.rotation()[i][j], &r[i][j], &size));
        }
    }
    worst
}

/// Up to 0.1 rad, which the case requires, the worst is 3.0 u. Beyond, t is a sum of three terms of one size, the last
/// of them with seven roundings: 4.0 u.
fn tiny<T: Number>() {
    hold(
        [("exp_tiny", 4.0), ("exp_beyond", 5.0)],
        &EXPONENTIALS,
        &states::<T>(),
        |state| {
            if state[6].abs() <= T::constant(0.1) {
                [error(state), 0.0]
            } else {
                [0.0, error(state)]
            }
        },
    );
}

/// The versine is an entry of t for a rotation about z at distance 1 from the axis.
fn versines<T: Number>() {
    let mut random = Random::new(2);
    let states: Vec<[T; 1]> = (0..1200)
        .map(|k| match k % 20 {
            0 => [T::constant(0.0)],
            1 => [T::MIN_POSITIVE * T::constant(random.unit())],
            _ => [size(&mut random, 0.5 * T::LEAST, 0.8)],
        })
        .collect();
    // The worst is 2.9 u.
    hold([("versine_small", 4.0)], &VERSINES, &states, |&[phi]| {
        let [zero, one] = [0.0, 1.0].map(T::constant);
        let q = Screw::new([zero, zero, one], [zero, -one, zero]).exp(phi);
        let (_, exact) = sine_versine(&phi.big());
        [units(q.translation()[0], &exact, &exact)]
    });
}

/// φ − sin φ, a factor in t, also on both sides of the series' end.
fn arcs<T: Number>() {
    let mut random = Random::new(16);
    let states: Vec<[T; 1]> = (0..1200)
        .map(|k| match k % 4 {
            0 => [T::constant(2.0) + T::EPSILON * T::constant(f64::from(k - 600))],
            1 => [size(&mut random, 0.0, 4.0)],
            _ => [size(&mut random, T::LEAST / 3.0, 0.8)],
        })
        .collect();
    // The worst is 2.9 u.
    hold([("arc_less_sine", 4.0)], &ARCS, &states, |&[phi]| {
        let exact = excess(&phi.big());
        [units(phi.minus_sine(phi.sin_cos().0), &exact, &exact)]
    });
}

crate::in_every_type! {
    /// A factor in the translation of hard case 1.
    arc_less_sine => arcs;
    /// Hard case 1.
    exp_tiny => tiny;
    /// Hard case 2.
    versine_small => versines;
}
