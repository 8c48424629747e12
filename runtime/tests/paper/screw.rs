//! § 5 and § 2.3: the screw axis matrix and the finite motion exp(L φ).

use crate::dense::{
    Dense, assert_same, assert_within, combine, product, size_of, transpose, unit_roundoff,
};
use crate::jet::Jet;
use crate::sample::{Random, angles, units};
use homogen::vector::{
    add, identity, matrix_product, matrix_scale, matrix_sum, outer, product as turn, scale, sub,
    underscore,
};
use homogen::{Action, Inertia, Jacobian, Point, Pose, Real, Screw, Velocity, rotation};

/// Revolute, prismatic and screw pairs in all directions.
fn screws<T: Real>(seed: u64) -> Vec<Screw<T>> {
    let mut random = Random::new(seed);
    units(seed)
        .into_iter()
        .flat_map(|u| {
            [
                Screw::revolute(u, [T::constant(0.0); 3]),
                Screw::revolute(u, random.vector()),
                Screw::prismatic(u),
                Screw::helical(u, random.vector(), random.number()),
            ]
        })
        .collect()
}

fn coordinates_are_axis_point_and_pitch<T: Real>() {
    let mut random = Random::new(90);
    for u in units::<T>(90) {
        let (point, pitch) = (random.vector(), random.number());
        let l = Screw::helical(u, point, pitch);
        assert_within([l.pitch()], [pitch], T::constant(2.0), 8.0);
        // The nearest point of the axis: the part of the given point perpendicular to the axis.
        let along = homogen::vector::dot(u, point);
        let nearest = sub(point, scale(along, u));
        assert_within(l.axis_point(), nearest, T::constant(2.0), 16.0);
        // b = −u̲ p_ax + p u.
        let b = add(
            scale(T::constant(-1.0), turn(&underscore(u), point)),
            scale(pitch, u),
        );
        assert_within(l.b(), b, T::constant(2.0), 4.0);
        // (u̲, −u̲ p_ax) of a hinge there, which does not move its axis, and (0, u) of a prismatic pair.
        let hinge = Screw::revolute(u, point);
        assert_eq!(hinge.u(), u);
        let on_axis = add(point, scale(pitch, u));
        assert_within(
            (hinge * Point(on_axis)).0,
            [T::constant(0.0); 3],
            T::constant(4.0),
            8.0,
        );
        let b = turn(&underscore(u), point).map(|x| -x);
        assert_within(hinge.b(), b, T::constant(2.0), 2.0);
        let slide = Screw::prismatic(u);
        assert_eq!((slide.u(), slide.b()), ([T::constant(0.0); 3], u));
        // Points of the axis move along it only.
        assert_within((l * Point(point)).0, scale(pitch, u), T::constant(4.0), 8.0);
    }
}

fn exponential_is_the_series<T: Real>() {
    for l in screws::<T>(91) {
        for phi in angles::<T>() {
            // Cancellation makes the series useless far from zero.
            if phi.abs() > T::constant(4.0) {
                continue;
            }
            let x: Dense<T> = l.to_matrix().map(|row| row.map(|e| e * phi));
            let mut term = Pose::identity().to_matrix();
            let mut sum = term;
            for n in 1..40 {
                term = combine(1.0 / f64::from(n), &product(&term, &x), 0.0, &x);
                sum = combine(1.0, &sum, 1.0, &term);
            }
            let scale = T::constant(8.0) * size_of(&l.to_matrix());
            assert_same(&l.exp(phi).to_matrix(), &sum, scale, 24.0);
        }
    }
}

fn rotation_and_translation_of_a_finite_motion<T: Real>() {
    let mut random = Random::new(92);
    for u in units::<T>(92) {
        for phi in angles::<T>() {
            let (point, pitch) = (random.vector(), random.number::<T>());
            let q = Screw::helical(u, point, pitch).exp(phi);
            // R = I + u̲ sin φ + u̲² (1 − cos φ); t = (I − R) p_ax + p φ u.
            let (sine, cosine) = phi.sin_cos();
            let square = matrix_product(&underscore(u), &underscore(u));
            let literal = matrix_sum(
                &matrix_sum(&identity(), &matrix_scale(sine, &underscore(u))),
                &matrix_scale(T::constant(1.0) - cosine, &square),
            );
            let flat = |x: &[[T; 3]; 3]| x.as_flattened().to_vec();
            assert_within(flat(q.rotation()), flat(&literal), T::constant(1.0), 12.0);
            let r = rotation::from_axis_angle(u, phi);
            assert_within(flat(&r), flat(&literal), T::constant(1.0), 12.0);
            let moved = sub(point, turn(q.rotation(), point));
            let t = add(moved, scale(pitch * phi, u));
            assert_within(q.translation(), t, T::constant(4.0).max(phi.abs()), 16.0);
            assert!(rotation::defect(q.rotation()) <= T::constant(16.0) * T::EPSILON);
        }
    }
}

fn motions_along_one_screw_add<T: Real>() {
    for l in screws::<T>(93) {
        for (a, b) in [(0.3, 0.9), (-2.0, 1.5), (0.0, 3.0), (1e-6, 2.0)] {
            let (a, b) = (T::constant(a), T::constant(b));
            let literal = l.exp(a) * l.exp(b);
            assert_same(
                &l.exp(a + b).to_matrix(),
                &literal.to_matrix(),
                T::constant(8.0),
                32.0,
            );
            assert_same(
                &l.exp(-a).to_matrix(),
                &l.exp(a).inverse().to_matrix(),
                T::constant(4.0),
                16.0,
            );
            assert_same(
                &(-l).exp(a).to_matrix(),
                &l.exp(-a).to_matrix(),
                T::constant(4.0),
                16.0,
            );
        }
    }
}

/// The same screw for automatic derivatives.
fn still<T: Real>(l: &Screw<T>) -> Screw<Jet<T>> {
    Screw::new(l.u().map(Jet::still), l.b().map(Jet::still))
}

/// dQ/dφ = L Q, d²Q/dφ² = L² Q and dP/dφ = L P at every φ.
fn derivative_of_a_finite_motion<T: Real>() {
    let mut random = Random::new(98);
    for l in screws::<T>(98) {
        for phi in angles::<T>() {
            let moving = still(&l).exp(Jet::moving(phi));
            let part = |part: fn(Jet<T>) -> T| moving.to_matrix().map(|row| row.map(part));
            let (value, slope, second) = (part(|x| x.0), part(|x| x.1), part(|x| x.2));
            let scale = T::constant(4.0).max(phi.abs());
            assert_same(&value, &l.exp(phi).to_matrix(), scale, 2.0);
            let lq = product(&l.to_matrix(), &value);
            assert_same(&slope, &lq, scale, 24.0);
            assert_same(&second, &product(&l.to_matrix(), &lq), scale, 48.0);
            let p = random.vector();
            let path = moving * Point(p.map(Jet::still));
            let found = l.derivative(l.exp(phi) * Point(p));
            assert_within(found.0, path.0.map(|x| x.1), scale, 48.0);
            assert_eq!(found, l * (l.exp(phi) * Point(p)));
        }
    }
}

fn derivatives_of_pose_and_inertia_along_a_screw<T: Real>() {
    let mut random = Random::new(99);
    for l in screws::<T>(99) {
        // Part II: ∂M/∂q = L M and ∂J/∂q = L J + J Lᵗ for a body that the joint carries.
        let (m, j) = (random.pose::<T>(), random.inertia::<T>());
        let step = still(&l)
            .exp(Jet::moving(T::constant(0.0)))
            .to_relative_pose();
        let still_m = Pose::new(
            m.rotation().map(|row| row.map(Jet::still)),
            m.translation().map(Jet::still),
        );
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = j.second_moments();
        let moments = [xx, yy, zz, xy, xz, yz].map(Jet::still);
        let still_j = Inertia::new(moments, j.q().map(Jet::still), Jet::still(j.mass()));
        let slope = |x: Dense<Jet<T>>| x.map(|row| row.map(|x| x.1));
        let (dense_l, dense_m, dense_j) = (l.to_matrix(), m.to_matrix(), j.to_matrix());
        let literal = product(&dense_l, &dense_m);
        assert_same(
            &slope((step * still_m).to_matrix()),
            &literal,
            T::constant(4.0),
            4.0,
        );
        let left = product(&dense_l, &dense_j);
        let literal = combine(1.0, &left, 1.0, &transpose(&left));
        let scale = T::constant(4.0) * size_of(&dense_j);
        assert_same(
            &slope(step.change_frame(&still_j).to_matrix()),
            &literal,
            scale,
            8.0,
        );
    }
}

fn rates_along_a_screw<T: Real>() {
    let mut random = Random::new(95);
    for l in screws::<T>(95) {
        // W = L φ̇ and H = L φ̈ + L² φ̇².
        let (rate, second) = (random.number::<T>(), random.number::<T>());
        let w = combine(rate.to_f64(), &l.to_matrix(), 0.0, &l.to_matrix());
        assert_same(&l.velocity(rate).to_matrix(), &w, T::constant(1.0), 2.0);
        let square = product(&l.to_matrix(), &l.to_matrix());
        let rate2 = (rate * rate).to_f64();
        let h = combine(second.to_f64(), &l.to_matrix(), rate2, &square);
        assert_same(
            &l.acceleration(rate, second).to_matrix(),
            &h,
            T::constant(4.0),
            8.0,
        );
    }
}

fn pseudo_scalar_product_is_power_at_unit_rate<T: Real>() {
    let mut random = Random::new(96);
    for l in screws::<T>(96) {
        let phi = Action::new(random.vector(), random.vector());
        let one = T::constant(1.0);
        let power = l.velocity(one).power(&phi);
        assert_within(
            [l.pseudo_scalar_product(&phi)],
            [power],
            T::constant(4.0),
            4.0,
        );
        // It does not depend on the frame.
        let m = random.pose::<T>();
        let seen = m
            .change_frame(&l)
            .pseudo_scalar_product(&m.change_frame(&phi));
        assert_within([seen], [power], T::constant(16.0), 16.0);
        // The work of a force at a point is that of its component along the point's path.
        let (force, point) = (random.vector::<T>(), random.vector());
        let work = homogen::vector::dot(force, (l * Point(point)).0);
        let found = l.pseudo_scalar_product(&Action::of_force(force, point));
        assert_within([found], [work], T::constant(4.0), 16.0);
    }
}

fn columns_of_a_jacobian<T: Real>() {
    let mut random = Random::new(97);
    for _ in 0..20 {
        let columns: [Screw<T>; 3] = std::array::from_fn(|_| random.screw());
        let rates = random.vector();
        let sum = columns
            .iter()
            .zip(rates)
            .fold(Velocity::zero(), |w, (l, rate)| w + l.velocity(rate));
        assert_eq!(Jacobian::velocity(&columns, &rates), sum);
        let (angular, linear) = (
            columns.to_matrix_angular_first(),
            columns.to_matrix_linear_first(),
        );
        for (j, l) in columns.iter().enumerate() {
            for i in 0..3 {
                assert_eq!((angular[i][j], angular[i + 3][j]), (l.u()[i], l.b()[i]));
                assert_eq!((linear[i][j], linear[i + 3][j]), (l.b()[i], l.u()[i]));
            }
        }
    }
}

/// Hard case `exp_tiny`: every entry of R − I and of t to 4 units of its own size.
///
/// R cannot represent the diagonal of R − I. The other entries are compared with the first terms of the
/// series, which are exact to rounding for such φ.
fn exponential_of_tiny_angles<T: Real>() {
    let u = homogen::vector::unit([2.0, -3.0, 6.0].map(T::constant)).expect("not zero");
    let point = [0.5, 1.5, -0.25].map(T::constant);
    for pitch in [0.0, 1.0] {
        let l = Screw::helical(u, point, T::constant(pitch));
        let mut phi = T::constant(1e-4);
        while phi > T::constant(16.0) * T::MIN_POSITIVE {
            let q = l.exp(phi);
            let half = T::constant(0.5) * phi * phi;
            let first = scale(phi, l.b());
            let t = add(first, scale(half, turn(&underscore(u), l.b())));
            let bound = T::constant(4.0) * unit_roundoff::<T>();
            // The next term of the series.
            let rest = phi * phi * phi;
            for (a, b) in q.translation().into_iter().zip(t) {
                assert!(
                    (a - b).abs() <= bound * b.abs() + rest,
                    "{phi:?}: {a:?} is not {b:?}"
                );
            }
            let square = outer(u, u);
            for (i, j, sign) in [(2, 1, 0), (0, 2, 1), (1, 0, 2)] {
                let expected = phi * u[sign] + half * square[i][j];
                let entry = q.rotation()[i][j];
                assert!(
                    (entry - expected).abs() <= bound * expected.abs() + rest,
                    "{phi:?}"
                );
            }
            phi = phi * T::constant(1e-3);
        }
    }
}

/// Hard case `versine_small`: 1 − cos φ to 4 units, where cos φ rounds to 1.
fn versine_of_small_angles<T: Real>() {
    // A rotation about z with the pole displaced along x: b = (0, −1, 0), t_x = versine.
    let l = Screw::revolute(
        [0.0, 0.0, 1.0].map(T::constant),
        [1.0, 0.0, 0.0].map(T::constant),
    );
    for exponent in 2..12 {
        let phi = T::constant(10.0_f64.powi(-exponent));
        let versine = l.exp(phi).translation()[0];
        // 1 − cos φ = φ²/2 − φ⁴/24 + φ⁶/720 − …
        let square = phi * phi;
        let series = square
            * T::constant(0.5)
            * (T::constant(1.0)
                - square
                    * T::constant(1.0 / 12.0)
                    * (T::constant(1.0) - square * T::constant(1.0 / 30.0)));
        assert_within([versine], [series], series, 4.0);
    }
}

in_both_precisions! {
    coordinates_are_axis_point_and_pitch
    exponential_is_the_series
    rotation_and_translation_of_a_finite_motion
    motions_along_one_screw_add
    derivative_of_a_finite_motion
    derivatives_of_pose_and_inertia_along_a_screw
    rates_along_a_screw
    pseudo_scalar_product_is_power_at_unit_rate
    columns_of_a_jacobian
    exponential_of_tiny_angles
    versine_of_small_angles
}
