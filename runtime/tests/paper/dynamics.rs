//! § 4.5 and § 4.6: Newton–Euler, momentum, weight and energies.

use crate::dense::{assert_same, assert_within, combine, product, size_of, skew, trace, transpose};
use crate::sample::{Random, inertias, poses, velocities};
use homogen::vector::{add, cross, dot, product as turn, scale as times};
use homogen::{Acceleration, Direction, Inertia, Momentum, Point, Real, Velocity, normalize};

/// Every inertia with every velocity and a random acceleration.
fn states<T: Real>(seed: u64) -> Vec<(Inertia<T>, Velocity<T>, Acceleration<T>)> {
    let mut random = Random::new(seed);
    let bodies = inertias(seed);
    velocities(seed)
        .into_iter()
        .zip(bodies.into_iter().cycle())
        .map(|(w, j)| {
            let h = Acceleration::from_parts(random.vector(), w.omega(), random.vector());
            (j, w, h)
        })
        .collect()
}

fn action_is_skew_of_acceleration_and_inertia<T: Real>() {
    for (j, _, h) in states::<T>(70) {
        // (18), (25)
        let literal = skew(&product(&h.to_matrix(), &j.to_matrix()));
        let scale = T::constant(4.0) * size_of(&j.to_matrix());
        assert_same(&j.action(&h).to_matrix(), &literal, scale, 4.0);
        let other = combine(
            1.0,
            &product(&h.to_matrix(), &j.to_matrix()),
            -1.0,
            &product(&j.to_matrix(), &transpose(&h.to_matrix())),
        );
        assert_same(&literal, &other, scale, 4.0);
        assert_eq!(
            normalize::skew(&product(&h.to_matrix(), &j.to_matrix())),
            literal
        );
    }
}

fn action_is_newton_and_euler<T: Real>() {
    for (j, w, h) in states::<T>(71) {
        if j.mass() == T::constant(0.0) {
            continue;
        }
        // (19): f = m a_G, c = I ω̇ + ω × (I ω) + (G − O) × f, I about the centre of mass.
        let center = j.center_of_mass();
        let tensor = j.tensor_at_center_of_mass();
        let f = (h * Point(center)).scaled(j.mass()).0;
        let gyroscopic = cross(w.omega(), turn(&tensor, w.omega()));
        let c = add(
            add(turn(&tensor, h.omega_dot()), gyroscopic),
            cross(center, f),
        );
        let phi = j.action(&h);
        let scale = T::constant(8.0) * size_of(&j.to_matrix());
        assert_within(phi.f(), f, scale, 4.0);
        assert_within(phi.c(), c, scale, 4.0);
    }
}

fn momentum_is_skew_of_velocity_and_inertia<T: Real>() {
    for (j, w, _) in states::<T>(72) {
        // (20), (26)
        let literal = skew(&product(&w.to_matrix(), &j.to_matrix()));
        let scale = T::constant(4.0) * size_of(&j.to_matrix());
        assert_same(&j.momentum(&w).to_matrix(), &literal, scale, 4.0);
    }
}

fn momentum_as_vectors<T: Real>() {
    for (j, w, _) in states::<T>(73) {
        if j.mass() == T::constant(0.0) {
            assert_eq!(j.momentum(&w), Momentum::zero());
            continue;
        }
        // (21): ρ = m v_G, γ = I ω + (G − O) × ρ.
        let center = j.center_of_mass();
        let rho = (w * Point(center)).scaled(j.mass()).0;
        let gamma = add(
            turn(&j.tensor_at_center_of_mass(), w.omega()),
            cross(center, rho),
        );
        let scale = T::constant(8.0) * size_of(&j.to_matrix());
        assert_within(j.momentum(&w).rho(), rho, scale, 4.0);
        assert_within(j.momentum(&w).gamma(), gamma, scale, 4.0);
    }
}

fn weight_is_the_action_of_gravity<T: Real>() {
    let mut random = Random::new(74);
    for j in inertias::<T>(74) {
        let g = times(T::constant(10.0), random.vector());
        let literal = skew(&product(
            &Acceleration::gravity(g).to_matrix(),
            &j.to_matrix(),
        ));
        let scale = T::constant(20.0) * size_of(&j.to_matrix());
        assert_same(&j.weight(g).to_matrix(), &literal, scale, 4.0);
        // A freely falling body needs no wrench besides its weight.
        let falling = Acceleration::gravity(g).less_gravity(g);
        assert_eq!(falling, Acceleration::zero());
        let held = j.action(&Acceleration::zero().less_gravity(g)) + j.weight(g);
        assert_same(&held.to_matrix(), &[[T::constant(0.0); 4]; 4], scale, 4.0);
    }
}

/// H_g, SPACELIB's `gtom`: g in the last column and zeros, so that every point has the same acceleration. Like
/// every H it is a tensor: a translation does not change it, a rotation rotates g.
fn gravity_as_a_matrix<T: Real>() {
    let mut random = Random::new(82);
    for m in poses::<T>(82) {
        let g = times(T::constant(10.0), random.vector());
        let h_g = Acceleration::gravity(g);
        let zero = T::constant(0.0);
        let [x, y, z] = g;
        let row = |last| [zero, zero, zero, last];
        assert_eq!(h_g.to_matrix(), [row(x), row(y), row(z), row(zero)]);
        let p = random.vector();
        assert_eq!((h_g * Point(p)).0, g);
        assert_eq!((h_g * Direction(p)).0, [zero; 3]);
        assert_eq!(Acceleration::from_parts([zero; 3], [zero; 3], g), h_g);
        let turned = Acceleration::gravity(turn(m.rotation(), g));
        assert_same(
            &m.change_frame(&h_g).to_matrix(),
            &turned.to_matrix(),
            T::constant(20.0),
            8.0,
        );
    }
}

fn newton_holds_in_any_frame<T: Real>() {
    for ((j, w, h), m) in states::<T>(75).into_iter().zip(poses::<T>(75)) {
        // (18) and (20), after a change of frame of both sides.
        let reach = size_of(&m.to_matrix());
        let scale = T::constant(16.0) * size_of(&j.to_matrix()) * reach * reach;
        let phi = m.change_frame(&j).action(&m.change_frame(&h));
        assert_same(
            &phi.to_matrix(),
            &m.change_frame(&j.action(&h)).to_matrix(),
            scale,
            4.0,
        );
        let gamma = m.change_frame(&j).momentum(&m.change_frame(&w));
        assert_same(
            &gamma.to_matrix(),
            &m.change_frame(&j.momentum(&w)).to_matrix(),
            scale,
            4.0,
        );
    }
}

fn kinetic_energy_is_half_the_trace<T: Real>() {
    for (j, w, _) in states::<T>(76) {
        // (22), (24)
        let wj = product(&w.to_matrix(), &j.to_matrix());
        let literal = T::constant(0.5) * trace(&product(&wj, &transpose(&w.to_matrix())));
        let scale = T::constant(4.0) * size_of(&j.to_matrix());
        assert_within([j.kinetic_energy(&w)], [literal], scale, 4.0);
        let paired = w.pseudo_scalar_product(&j.momentum(&w));
        assert_within([paired], [T::constant(2.0) * literal], scale, 4.0);
    }
}

fn coupling_of_two_screws_is_the_trace<T: Real>() {
    let mut random = Random::new(81);
    for j in inertias::<T>(81) {
        let (a, b) = (random.screw::<T>(), random.screw());
        let lj = product(&a.to_matrix(), &j.to_matrix());
        let literal = trace(&product(&lj, &transpose(&b.to_matrix())));
        let scale = T::constant(16.0) * size_of(&j.to_matrix());
        assert_within(
            [j.coupling(&a, &b), j.coupling(&b, &a)],
            [literal; 2],
            scale,
            4.0,
        );
    }
}

fn potential_energy_is_minus_the_trace<T: Real>() {
    let mut random = Random::new(77);
    for j in inertias::<T>(77) {
        let g = times(T::constant(10.0), random.vector());
        let literal = -trace(&product(
            &Acceleration::gravity(g).to_matrix(),
            &j.to_matrix(),
        ));
        let scale = T::constant(10.0) * size_of(&j.to_matrix());
        assert_within([j.potential_energy(g)], [literal], scale, 4.0);
        // A fall by d loses the work of the weight.
        let d = random.vector();
        let moved = homogen::Pose::from_translation(d).change_frame(&j);
        let lost = j.potential_energy(g) - moved.potential_energy(g);
        assert_within(
            [lost],
            [dot(j.weight(g).f(), d)],
            T::constant(4.0) * scale,
            4.0,
        );
    }
}

fn principal_axes_give_the_printed_special_case<T: Real>() {
    let mut random = Random::new(78);
    for _ in 0..50 {
        // After (26): at rest, in the principal frame, c_x = (I_yy + I_zz) ω̇_x … and f = m a.
        let moments = [random.positive::<T>(), random.positive(), random.positive()];
        let [xx, yy, zz] = moments;
        let zero = T::constant(0.0);
        let m = random.positive::<T>();
        let j = Inertia::new([xx, yy, zz, zero, zero, zero], [zero; 3], m);
        let (omega_dot, a) = (random.vector(), random.vector());
        let phi = j.action(&Acceleration::from_parts(omega_dot, [zero; 3], a));
        let [p, q, r] = omega_dot;
        let expected = [(yy + zz) * p, (xx + zz) * q, (xx + yy) * r];
        assert_within(phi.c(), expected, T::constant(2.0), 4.0);
        assert_within(phi.f(), times(m, a), T::constant(1.0), 2.0);
    }
}

fn power_is_the_rate_of_kinetic_energy<T: Real>() {
    for (j, w, h) in states::<T>(79) {
        // d/dt ½ Tr(W J Wᵗ) in the frame of the body's points: Σ dm Ṗ · P̈ = W ⊗ Φ.
        let wj = product(&w.to_matrix(), &j.to_matrix());
        let literal = trace(&product(&wj, &transpose(&h.to_matrix())));
        let scale = T::constant(16.0) * size_of(&j.to_matrix());
        assert_within([w.power(&j.action(&h))], [literal], scale, 4.0);
    }
}

fn actions_and_momenta_add_and_oppose<T: Real>() {
    let mut random = Random::new(80);
    for _ in 0..50 {
        let (force, p) = (random.vector::<T>(), random.vector());
        let phi = homogen::Action::of_force(force, p);
        assert_eq!(phi + -phi, homogen::Action::zero());
        assert_eq!(phi - -phi, phi + phi);
        // f Pᵗ − P fᵗ (§ 4.1).
        let f4 = Direction(force).to_homogeneous();
        let p4 = Point(p).to_homogeneous();
        let dyad = std::array::from_fn(|i| std::array::from_fn(|j| f4[i] * p4[j]));
        assert_same(&phi.to_matrix(), &skew(&dyad), T::constant(1.0), 2.0);
        let gamma = Momentum::of_particle(T::constant(2.0), p, force);
        assert_eq!(gamma - -gamma, gamma + gamma);
        assert_eq!(gamma + -gamma, Momentum::zero());
    }
}

in_both_precisions! {
    action_is_skew_of_acceleration_and_inertia
    action_is_newton_and_euler
    momentum_is_skew_of_velocity_and_inertia
    momentum_as_vectors
    weight_is_the_action_of_gravity
    gravity_as_a_matrix
    newton_holds_in_any_frame
    kinetic_energy_is_half_the_trace
    coupling_of_two_screws_is_the_trace
    potential_energy_is_minus_the_trace
    principal_axes_give_the_printed_special_case
    power_is_the_rate_of_kinetic_energy
    actions_and_momenta_add_and_oppose
}
