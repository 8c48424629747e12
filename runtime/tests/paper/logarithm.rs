//! § 2.3 and § 5: axis, angle, pitch and point from Q, and the instantaneous screw axis from W.

use crate::dense::{assert_same, assert_within, size, size_of, unit_roundoff};
use crate::sample::{Random, angles, displacements, units, velocities};
use homogen::vector::{add, dot, matrix_product, norm, scale, sub, unit};
use homogen::{Displacement, Real, Screw, Velocity, rotation};

/// ‖a − b‖, or ‖a + b‖ if that is less: at π the sign of an axis is undetermined.
fn apart<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    let (minus, plus) = (norm(sub(a, b)), norm(add(a, b)));
    if minus < plus { minus } else { plus }
}

fn exponential_undoes_logarithm<T: Real>() {
    for q in displacements::<T>(100) {
        let (l, phi) = q.log();
        let turns = l.u() != [T::constant(0.0); 3];
        assert!(phi >= T::constant(0.0) && !(turns && phi > T::constant(std::f64::consts::PI)));
        let scale = T::constant(1.0).max(size_of(&q.to_matrix()));
        assert_same(&l.exp(phi).to_matrix(), &q.to_matrix(), scale, 24.0);
    }
}

fn logarithm_undoes_exponential<T: Real>() {
    let mut random = Random::new(101);
    for u in units::<T>(101) {
        for phi in [1e-3, 0.1, 1.0, 2.0, 3.0].map(T::constant) {
            let (point, pitch) = (random.vector(), random.number());
            let l = Screw::helical(u, point, pitch);
            let (found, angle) = l.exp(phi).log();
            assert_within([angle], [phi], phi, 16.0);
            assert_within(found.u(), u, T::constant(1.0), 16.0);
            // The position of the axis is determined to u / φ.
            assert_within(found.b(), l.b(), T::constant(4.0) / phi.min_one(), 16.0);
        }
    }
}

/// The smaller of a number and 1.
trait MinOne {
    fn min_one(self) -> Self;
}

impl<T: Real> MinOne for T {
    fn min_one(self) -> Self {
        if self < T::constant(1.0) {
            self
        } else {
            T::constant(1.0)
        }
    }
}

/// Hard case `log_tiny`, and every other angle up to π.
///
/// 4 units are those of the logarithm; R, computed in the same type, may have as many.
fn axis_and_angle_at_every_angle<T: Real>() {
    let units_allowed = T::constant(8.0) * unit_roundoff();
    for u in units::<T>(102) {
        for phi in angles::<T>() {
            let pi = T::constant(std::f64::consts::PI);
            if phi <= T::constant(0.0) || phi >= pi {
                continue;
            }
            let r = rotation::from_axis_angle(u, phi);
            let (axis, angle) = rotation::axis_angle(&r);
            assert_within([angle], [phi], phi, 8.0);
            assert!(
                apart(axis, u) <= units_allowed,
                "{phi:?}: {axis:?} is not {u:?}"
            );
        }
    }
}

/// The logarithm alone: R computed in f64 and rounded to f32 has an error of half a unit an entry.
#[test]
fn axis_and_angle_of_rounded_rotations() {
    for u in units::<f64>(111) {
        for phi in angles::<f64>() {
            if phi <= 1e-30 || phi > std::f64::consts::PI {
                continue;
            }
            let r = rotation::from_axis_angle(u, phi);
            let (axis, angle) = rotation::axis_angle(&r.map(|row| row.map(rounded)));
            assert_within([angle], [rounded(phi)], rounded(phi), 4.0);
            let error = apart(axis.map(f64::from), u);
            assert!(
                error <= 4.0 * f64::from(unit_roundoff::<f32>()),
                "{phi}: {axis:?} is not {u:?}"
            );
        }
    }
}

fn rounded(x: f64) -> f32 {
    homogen::Scalar::constant(x)
}

/// Hard case `log_near_pi`: axis to 4 units up to its sign, in all octants.
fn axis_near_180_degrees<T: Real>() {
    let pi = std::f64::consts::PI;
    for u in units::<T>(103) {
        for less in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15, 0.0] {
            let phi = T::constant(pi - less);
            let r = rotation::from_axis_angle(u, phi);
            let (axis, angle) = rotation::axis_angle(&r);
            assert!(
                apart(axis, u) <= T::constant(4.0) * unit_roundoff(),
                "π − {less:e}: {axis:?} is not {u:?}"
            );
            assert_within([angle], [phi], phi, 4.0);
            assert_within([norm(axis)], [T::constant(1.0)], T::constant(1.0), 4.0);
        }
        // 180°: R = 2 u uᵗ − I, exactly symmetric.
        let r = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                T::constant(2.0) * u[i] * u[j] - T::constant(if i == j { 1.0 } else { 0.0 })
            })
        });
        let (axis, angle) = rotation::axis_angle(&r);
        assert!(apart(axis, u) <= T::constant(4.0) * unit_roundoff());
        assert_within([angle], [T::constant(pi)], T::constant(pi), 4.0);
    }
}

/// The angle by the arc cosine of the trace, the axis by division by 2 sin φ.
fn by_arc_cosine<T: Real>(r: &[[T; 3]; 3]) -> ([T; 3], T) {
    let (one, half) = (T::constant(1.0), T::constant(0.5));
    let cosine = half * (r[0][0] + r[1][1] + r[2][2] - one);
    let sine = (one - cosine * cosine).max(T::constant(0.0)).sqrt();
    let differences = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
    (differences.map(|d| half * d / sine), sine.atan2(cosine))
}

/// The axis from the diagonal, uₓ² = (Rₓₓ − cos φ)/(1 − cos φ), as used for |sin φ| < 0.1; without signs.
fn by_diagonal<T: Real>(r: &[[T; 3]; 3]) -> [T; 3] {
    let one = T::constant(1.0);
    let cosine = T::constant(0.5) * (r[0][0] + r[1][1] + r[2][2] - one);
    std::array::from_fn(|i| ((r[i][i] - cosine) / (one - cosine)).abs().sqrt())
}

/// Common formulas lose the axis or the angle where those of this crate are accurate.
fn common_formulas_lose_digits<T: Real>() {
    let u = unit([1.0, 2.0, 2.0].map(T::constant)).expect("not zero");
    let limit = T::constant(4.0) * unit_roundoff::<T>();
    let lost = |error: T| !error.is_finite() || error > T::constant(0.01);
    let pi = T::constant(std::f64::consts::PI);
    let root = T::EPSILON.sqrt();
    for phi in [T::constant(0.25) * root, pi - T::constant(0.25) * root] {
        let r = rotation::from_axis_angle(u, phi);
        let (axis, angle) = rotation::axis_angle(&r);
        assert!(apart(axis, u) <= limit && (angle - phi).abs() <= limit * phi);
        let (axis, angle) = by_arc_cosine(&r);
        let from_zero_or_pi = if phi < T::constant(1.0) {
            phi
        } else {
            pi - phi
        };
        assert!(lost(apart(axis, u)), "{axis:?}");
        assert!(lost((angle - phi).abs() / from_zero_or_pi), "{angle:?}");
    }
    let small = rotation::from_axis_angle(u, T::constant(0.25) * root);
    assert!(lost(apart(by_diagonal(&small), u)));
}

/// Hard case `log_drifted_R`: the error is at most four times the defect of orthogonality.
fn logarithm_of_a_drifted_rotation<T: Real>() {
    let mut random = Random::new(104);
    for drift in [1e-15, 1e-12, 1e-9, 1e-6, 1e-3] {
        for u in units::<T>(104) {
            let phi = random.positive::<T>() * T::constant(2.6) + T::constant(0.5);
            let r = rotation::from_axis_angle(u, phi);
            let drifted = r.map(|row| row.map(|x| x + T::constant(drift) * random.number()));
            let defect = rotation::defect(&drifted).max(T::constant(4.0) * T::EPSILON);
            let (axis, angle) = rotation::axis_angle(&drifted);
            assert!((angle - phi).abs() <= T::constant(4.0) * defect);
            assert!(
                apart(axis, u) <= T::constant(4.0) * defect.max(T::constant(drift)),
                "{axis:?} {u:?}"
            );
        }
    }
}

/// Hard case `screw_axis_far`: an axis at 10⁶ m and φ = 10⁻⁶; the error is that of Q.
fn screw_axis_far_away<T: Real>() {
    for u in units::<T>(105) {
        let aside = unit(homogen::vector::cross(
            u,
            [0.6, -0.64, 0.48].map(T::constant),
        ))
        .expect("not parallel");
        let point = scale(T::constant(1e6), aside);
        for phi in [1e-6, 1e-3, 1.0].map(T::constant) {
            let q = Screw::helical(u, point, T::constant(0.5)).exp(phi);
            let (l, angle) = q.log();
            let scale = size(q.translation()).max(T::constant(1.0));
            assert_within(l.exp(angle).translation(), q.translation(), scale, 16.0);
            let flat = |q: &Displacement<T>| q.rotation().as_flattened().to_vec();
            assert_within(flat(&l.exp(angle)), flat(&q), T::constant(1.0), 16.0);
        }
    }
}

fn logarithm_without_rotation<T: Real>() {
    let zero = [T::constant(0.0); 3];
    let (l, phi) = Displacement::<T>::identity().log();
    assert_eq!((l.b(), phi), (zero, T::constant(0.0)));
    for u in units::<T>(106) {
        for length in [1e-30, 1e-3, 1.0, 1e6].map(T::constant) {
            let q = Screw::prismatic(u).exp(length);
            let (l, phi) = q.log();
            assert_eq!(l.u(), zero);
            assert_within(l.b(), u, T::constant(1.0), 8.0);
            assert_within([phi], [length], length, 8.0);
        }
    }
    // A rotation so small that the position of the axis overflows.
    let tiny = T::MIN_POSITIVE;
    let q = Displacement::new(
        rotation::from_axis_angle([T::constant(0.0), T::constant(0.0), T::constant(1.0)], tiny),
        [T::constant(1e6), T::constant(0.0), T::constant(0.0)],
    );
    let (l, phi) = q.log();
    assert_same(
        &l.exp(phi).to_matrix(),
        &q.to_matrix(),
        T::constant(1e6),
        16.0,
    );
}

/// Hard case `isa_slow`: continuous down to rest, without NaN, 8 units.
fn instantaneous_screw_axis_of_every_velocity<T: Real>() {
    let mut list = velocities::<T>(107);
    let mut random = Random::new(107);
    for size in [1e-12, 1e-6, 1e-3, 1.0, 1e-40, 0.0] {
        for fast in [0.0, 1e-12, 1.0] {
            list.push(Velocity::new(
                scale(T::constant(size), random.unit()),
                scale(T::constant(fast), random.unit()),
            ));
        }
    }
    for w in list {
        let (l, rate) = w.instantaneous_screw_axis();
        let scale = size_of(&w.to_matrix());
        assert_same(&l.velocity(rate).to_matrix(), &w.to_matrix(), scale, 8.0);
        assert!(l.u().into_iter().chain(l.b()).all(Real::is_finite));
        let turning = norm(l.u());
        let moving = if turning == T::constant(0.0) {
            norm(l.b())
        } else {
            turning
        };
        let one = T::constant(1.0);
        assert!(rate == T::constant(0.0) || (moving - one).abs() <= T::constant(4.0) * T::EPSILON);
        if turning > T::constant(0.0) {
            // Points of the axis move along it, with the pitch times the rate.
            let velocity = (w * homogen::Point(l.axis_point())).0;
            let along = homogen::vector::scale(l.pitch() * rate, l.u());
            assert_within(velocity, along, T::constant(3.0) * scale, 16.0);
        }
    }
}

fn short_times_are_infinitesimal<T: Real>() {
    for w in velocities::<T>(108) {
        // dP = W P dt, to second order.
        let dt = T::EPSILON.sqrt();
        let p = homogen::Point([0.4, -0.7, 0.2].map(T::constant));
        let step = w.displacement(dt) * p - p;
        let expected = (w * p).scaled(dt);
        assert_within(step.0, expected.0, T::constant(2.0), 16.0);
        let whole = w.displacement(T::constant(2.0));
        let twice = w.displacement(T::constant(1.0)) * w.displacement(T::constant(1.0));
        assert_same(
            &whole.to_matrix(),
            &twice.to_matrix(),
            T::constant(4.0),
            32.0,
        );
    }
}

fn quaternions_and_back<T: Real>() {
    for q in displacements::<T>(109) {
        let quaternion = rotation::to_quaternion(q.rotation());
        assert!(quaternion[0] >= T::constant(0.0));
        let back = rotation::from_quaternion(quaternion);
        let flat = |r: &[[T; 3]; 3]| r.as_flattened().to_vec();
        assert_within(flat(&back), flat(q.rotation()), T::constant(1.0), 12.0);
    }
}

fn rotations_about_one_axis_commute_with_their_axis<T: Real>() {
    for u in units::<T>(110) {
        let r = rotation::from_axis_angle(u, T::constant(1.1));
        assert_within(homogen::vector::product(&r, u), u, T::constant(1.0), 8.0);
        let twice = matrix_product(&r, &r);
        let (axis, angle) = rotation::axis_angle(&twice);
        assert_within([angle], [T::constant(2.2)], T::constant(2.2), 8.0);
        assert!(dot(axis, u) > T::constant(0.999));
        assert!(apart(axis, u) <= T::constant(16.0) * unit_roundoff());
    }
}

in_both_precisions! {
    exponential_undoes_logarithm
    logarithm_undoes_exponential
    axis_and_angle_at_every_angle
    axis_near_180_degrees
    common_formulas_lose_digits
    logarithm_of_a_drifted_rotation
    screw_axis_far_away
    logarithm_without_rotation
    instantaneous_screw_axis_of_every_velocity
    short_times_are_infinitesimal
    quaternions_and_back
    rotations_about_one_axis_commute_with_their_axis
}
