//! Screw axes of displacements and of velocities, far away and at infinity.
//!
//! In: displacements about axes at 10⁶ m, and velocities down to rest. Out: the distance of the motion along the
//! computed screw from the given one.

use std::array::from_fn;

use homogen::vector::{add, cross, negate, scale};
use homogen::{Displacement, Screw, Velocity};
use homogen_tests::big::Big;
use homogen_tests::states::Random;

use crate::hard_cases_geometry::exact::{self, exact, exact_matrix, norm};
use crate::hard_cases_geometry::measure::{Number, direction, hold, size, units, vector};
use crate::hard_cases_geometry::worst::{FAR, SLOW};

/// A displacement: the entries of R, then t.
type Motion<T> = [T; 12];

/// The exact motion along a screw, rounded.
fn motion<T: Number>(l: &Screw<T>, phi: T) -> Motion<T> {
    let (u, b, phi) = (exact::unit(&exact(l.u())), exact(l.b()), phi.big());
    let r = exact::rotation(&u, &phi);
    let (t, _) = exact::translation(&u, &b, &phi);
    from_fn(|k| T::nearest(if k < 9 { &r[k / 3][k % 3] } else { &t[k - 9] }))
}

fn far<T: Number>() {
    let mut random = Random::new(6);
    let states: Vec<Motion<T>> = (0..1200)
        .map(|k| {
            let u = direction(&mut random);
            let distance = if k % 2 == 0 {
                T::constant(1e6)
            } else {
                size(&mut random, -3.0, 9.0)
            };
            let b = negate(cross(u, scale(distance, vector(&mut random))));
            let b = add(b, scale(T::constant(random.unit()), u));
            let phi = if k % 3 == 0 {
                T::constant(1e-6)
            } else {
                size::<T>(&mut random, -9.0, 0.49).abs()
            };
            motion(&Screw::new(u, b), phi)
        })
        .collect();
    // The worst is 5.2 u; the limit is twice as large.
    hold([("screw_axis_far", 10.0)], &FAR, &states, |state| {
        [far_error(state)]
    });
}

/// The distance of the motion along the computed screw from the given one; R relative to 1, t relative to its length.
fn far_error<T: Number>(state: &Motion<T>) -> f64 {
    let r: [[T; 3]; 3] = from_fn(|i| from_fn(|j| state[3 * i + j]));
    let t: [T; 3] = from_fn(|i| state[9 + i]);
    let (l, phi) = Displacement::new(r, t).log();
    if !l
        .u()
        .iter()
        .chain(&l.b())
        .chain([&phi])
        .all(|x| x.is_finite())
    {
        return f64::NAN;
    }
    let (u, b, phi) = (exact(l.u()), exact(l.b()), phi.big());
    let rotated = exact::distance(&exact::rotation(&u, &phi), &exact_matrix(&r));
    let (moved, _) = exact::translation(&u, &b, &phi);
    let t = exact(t);
    let unit = Big::new(T::UNIT);
    let moved = norm(&exact::sub(&moved, &t)) / (norm(&t) * &unit);
    moved.max(rotated / unit).to_f64()
}

/// ω and v, each fast, slow or zero, on both sides of the point at which the axis is too far away to be representable.
fn velocities<T: Number>() -> Vec<[T; 6]> {
    let mut random = Random::new(7);
    let most = -T::LEAST;
    (0..2100)
        .map(|k| {
            let zero = T::constant(0.0);
            let subnormal = T::MIN_POSITIVE * T::constant(random.unit());
            let angular = match k % 6 {
                0 => zero,
                1 => subnormal,
                2 => size(&mut random, -12.0, 0.0),
                3 => T::MIN_POSITIVE * size(&mut random, 0.0, 1.0),
                _ => size(&mut random, T::LEAST, 0.0),
            };
            let linear = match k % 7 {
                0 => zero,
                1 => subnormal,
                2 => size(&mut random, 0.0, most),
                _ => size(&mut random, -3.0, 3.0),
            };
            let [wx, wy, wz] = scale(angular, direction(&mut random));
            let [vx, vy, vz] = scale(linear, direction(&mut random));
            [wx, wy, wz, vx, vy, vz]
        })
        .collect()
}

/// The error of W from the computed screw and rate, and of the length of the screw.
fn slow_error<T: Number>(&[wx, wy, wz, vx, vy, vz]: &[T; 6]) -> f64 {
    let (omega, v) = ([wx, wy, wz], [vx, vy, vz]);
    let (l, rate) = Velocity::new(omega, v).instantaneous_screw_axis();
    let (u, b) = (l.u(), l.b());
    if !u.iter().chain(&b).chain([&rate]).all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let zero = T::constant(0.0);
    let rotates = u != [zero; 3];
    let (u, b, rate) = (exact(u), exact(b), rate.big());
    let (omega, v) = (exact(omega), exact(v));
    let lost = Big::new(T::UNDERFLOW) * (Big::one() + &rate);
    // An axis farther away than the largest number is at infinity, and its rotation is dropped.
    let dropped = if rotates {
        Big::zero()
    } else {
        norm(&v) / Big::new(T::LARGEST)
    };
    let mut worst = 0.0_f64;
    for i in 0..3 {
        for (along, given, dropped) in [(&u[i], &omega[i], &dropped), (&b[i], &v[i], &Big::zero())]
        {
            let error = (along * &rate - given).abs();
            let size = given.abs() * Big::new(T::UNIT) + &lost + dropped;
            worst = worst.max((error / size).to_f64());
        }
    }
    let speed = norm(if rotates { &omega } else { &v });
    if speed > Big::zero() {
        let length = norm(if rotates { &u } else { &b });
        worst = worst.max(((length - Big::one()).abs() / Big::new(T::UNIT)).to_f64());
        worst = worst.max(units(T::nearest(&rate), &speed, &speed));
    }
    worst
}

fn slow<T: Number>() {
    // The worst is 2.5 u; the limit is twice as large.
    hold([("isa_slow", 5.0)], &SLOW, &velocities::<T>(), |w| {
        [slow_error(w)]
    });
}

crate::in_every_type! {
    /// Hard case 6.
    screw_axis_far => far;
    /// Hard case 7.
    isa_slow => slow;
}
