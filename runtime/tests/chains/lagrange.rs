//! Lagrange's formulation: derivatives of M and J, and the same torques as Newton–Euler.

use crate::jet::Jet;
use crate::sample::{Random, agree, largest};
use homogen::open_chain::{inertias, poses, screws};
use homogen::{Action, Real, lagrange, open_chain};
use homogen_magnitude::Magnitude;
use std::array::from_fn;

/// ∂M/∂qₘ = Lₘ M and ∂J/∂qₘ = Lₘ J + J Lₘᵗ, against automatic derivatives of the positions.
#[test]
fn derivatives_of_poses_and_inertias() {
    for seed in 0..100 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let q: [f64; 7] = random.numbers();
        let poses_0 = poses(&chain, &q);
        let (screws, inertias_0) = (screws(&chain, &poses_0), inertias(&chain, &poses_0));
        for (m, l) in screws.iter().enumerate() {
            let jets = from_fn(|i| {
                if i == m {
                    Jet::moving(q[i])
                } else {
                    Jet::still(q[i])
                }
            });
            let poses = poses(&chain, &jets);
            let inertias = inertias(&chain, &poses);
            for h in (0..7).filter(|h| chain.carries(m, Some(*h))) {
                let exact = poses[h].to_matrix().map(|row| row.map(|x| x.1));
                let ours = lagrange::pose_derivative(l, &poses_0[h]);
                agree(ours.as_flattened(), exact.as_flattened(), 128.0, 10.0);
                let exact = inertias[h].to_matrix().map(|row| row.map(|x| x.1));
                let ours = lagrange::inertia_derivative(l, &inertias_0[h]).to_matrix();
                let size = largest(inertias_0[h].to_matrix().as_flattened());
                agree(
                    ours.as_flattened(),
                    exact.as_flattened(),
                    128.0,
                    10.0 * size,
                );
            }
        }
    }
}

/// The largest differences in units of rounding, relative to the sum of magnitudes of the joint, and to the
/// largest torque.
fn lagrange_against_newton_euler<T: Real>() -> [f64; 2] {
    let mut worst = [0.0; 2];
    let unit = 0.5 * T::EPSILON.to_f64();
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, mut qd, qdd]: [[T; 7]; 3] = from_fn(|_| random.numbers());
        let mut external: [Action<T>; 7] = random.actions();
        if seed % 10 == 0 {
            qd = [T::constant(0.0); 7];
        }
        if seed % 7 == 0 {
            external = [Action::zero(); 7];
        }
        let newton = open_chain::inverse_dynamics(&chain, &q, &qd, &qdd, &external);
        let energy = lagrange::inverse_dynamics(&chain, &q, &qd, &qdd, &external);
        let size = |x: T| Magnitude::<f64>::given(x.to_f64());
        let sizes = open_chain::inverse_dynamics(
            &chain,
            &q.map(size),
            &qd.map(size),
            &qdd.map(size),
            &external.map(|phi| Action::new(phi.c().map(size), phi.f().map(size))),
        );
        for ((a, b), size) in newton.iter().zip(&energy).zip(sizes) {
            let error = (*a - *b).abs().to_f64() / unit;
            let relative = [error / size.size(), error / largest(&newton)];
            worst = from_fn(|k| relative[k].max(worst[k]));
        }
    }
    worst
}

#[test]
fn lagrange_equals_newton_euler() {
    for [summed, torque] in [
        lagrange_against_newton_euler::<f64>(),
        lagrange_against_newton_euler::<f32>(),
    ] {
        println!("{summed:.2} u of the sums of magnitudes, {torque:.1} u of the largest torque");
        assert!(summed <= 0.1 && torque <= 40.0);
    }
}

#[test]
fn the_mass_matrix_is_symmetric_and_gives_the_kinetic_energy() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd]: [[f64; 7]; 2] = from_fn(|_| random.numbers());
        let mass = lagrange::mass_matrix(&chain, &q);
        assert_eq!(mass, from_fn(|i| from_fn(|m| mass[m][i])));
        let motions = open_chain::motions(&chain, &q, &qd, &[0.0; 7]);
        let inertias = inertias(&chain, &motions.map(|motion| motion.pose));
        let bodies = inertias.iter().zip(&motions);
        let energy: f64 = bodies.map(|(j, m)| j.kinetic_energy(&m.velocity)).sum();
        let quadratic: f64 = (0..7)
            .flat_map(|i| (0..7).map(move |m| (i, m)))
            .map(|(i, m)| 0.5 * mass[i][m] * qd[i] * qd[m])
            .sum();
        let size = largest(mass.as_flattened());
        agree(&[energy], &[quadratic], 64.0, 7.0 * size);
    }
}

#[cfg(feature = "nalgebra")]
#[test]
fn both_agree_with_the_dense_recursions() {
    use homogen::generic;
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd, qdd]: [[f64; 7]; 3] = from_fn(|_| random.numbers());
        let none = [Action::zero(); 7];
        let dense = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        let size = largest(&dense);
        let ours = open_chain::inverse_dynamics(&chain, &q, &qd, &qdd, &none);
        agree(&ours, &dense, 64.0, size);
        let bias = lagrange::bias(&chain, &q, &qd, &none);
        agree(&bias, &generic::bias(&chain, &q, &qd), 64.0, size);
        let mass = lagrange::mass_matrix(&chain, &q);
        let dense = generic::mass_matrix(&chain, &q);
        let size = largest(dense.as_flattened());
        agree(mass.as_flattened(), dense.as_flattened(), 64.0, size);
    }
}

/// Zero mass is allowed and needs no torque.
#[test]
fn a_chain_without_mass_needs_no_torque() {
    let mut random = Random::new(1);
    let mut chain = random.chain();
    for joint in &mut chain.joints {
        joint.inertia = homogen::Inertia::zero();
    }
    let [q, qd, qdd]: [[f64; 7]; 3] = from_fn(|_| random.numbers());
    let none = [Action::zero(); 7];
    let newton = open_chain::inverse_dynamics(&chain, &q, &qd, &qdd, &none);
    let energy = lagrange::inverse_dynamics(&chain, &q, &qd, &qdd, &none);
    agree(&newton, &[0.0; 7], 0.0, 1.0);
    agree(&energy, &[0.0; 7], 0.0, 1.0);
}
