//! Part II, the recursions over a chain: against closed forms, against each other, and against automatic
//! derivatives of positions and energies.
#![cfg(feature = "nalgebra")]

use crate::dense::{assert_same, assert_within, combine, product, size};
use crate::jet::Jet;
use crate::sample::Random;
use homogen::open_chain::{inertias, motions, poses};
use homogen::robot::{
    Bias as _, BodyJacobian as _, ForwardKinematics as _, GeometricJacobian as _, Gravity as _,
    InverseDynamics as _, MassMatrix as _, SpatialJacobian as _, TipAcceleration as _,
    TipVelocity as _,
};
use homogen::{Chain, Frame, Inertia, Jacobian, Joint, Pose, Real, Screw, generic};
use nalgebra::RealField;

const N: usize = 6;

/// A tree: a trunk of three joints with two branches; revolute, prismatic and screw pairs.
fn tree(random: &mut Random) -> Chain<N, 2> {
    let parents = [None, Some(0), Some(1), Some(1), Some(3), Some(0)];
    let joints = std::array::from_fn(|i| {
        let screw = match i {
            2 => Screw::prismatic(random.unit()),
            4 => Screw::helical(random.unit(), random.vector(), 0.2),
            _ => Screw::revolute(random.unit(), random.vector()),
        };
        Joint::new("joint", parents[i], random.pose(), screw, random.inertia())
    });
    let frames = [
        Frame::new("tip", Some(4), random.pose()),
        Frame::new("elbow", Some(2), random.pose()),
    ];
    Chain::new(joints, frames, [0.5, -1.0, -9.81])
}

fn state<T: Real>(random: &mut Random) -> [[T; N]; 3] {
    std::array::from_fn(|_| std::array::from_fn(|_| random.number()))
}

fn newton_euler_and_lagrange_agree<T: Real + RealField + Copy>() {
    let mut random = Random::new(210);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, qd, qdd] = state::<T>(&mut random);
        let tau = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        let mass = generic::mass_matrix(&chain, &q);
        let bias = generic::bias(&chain, &q, &qd);
        let sum: [T; N] =
            std::array::from_fn(|i| (0..N).fold(bias[i], |sum, k| sum + mass[i][k] * qdd[k]));
        let scale = T::constant(50.0) * size(tau);
        assert_within(tau, sum, scale, 8.0);
        assert_eq!(chain.inverse_dynamics(&q, &qd, &qdd), tau);
        assert_eq!((chain.bias(&q, &qd), chain.mass_matrix(&q)), (bias, mass));
        let transposed: [[T; N]; N] = std::array::from_fn(|i| std::array::from_fn(|k| mass[k][i]));
        let flat = |m: &[[T; N]; N]| m.as_flattened().to_vec();
        assert_within(flat(&mass), flat(&transposed), size(flat(&mass)), 8.0);
    }
}

fn gravity_is_inverse_dynamics_at_rest<T: Real + RealField + Copy>() {
    let mut random = Random::new(211);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, _, _] = state::<T>(&mut random);
        let zero = [T::constant(0.0); N];
        let at_rest = generic::inverse_dynamics(&chain, &q, &zero, &zero);
        let gravity = generic::gravity(&chain, &q);
        assert_within(gravity, at_rest, T::constant(50.0) * size(at_rest), 8.0);
        assert_eq!(chain.gravity(&q), gravity);
    }
}

fn kinetic_energy_is_that_of_the_mass_matrix<T: Real + RealField + Copy>() {
    let mut random = Random::new(212);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, qd, _] = state::<T>(&mut random);
        let mass = generic::mass_matrix(&chain, &q);
        let half = T::constant(0.5);
        let mut sum = T::constant(0.0);
        for i in 0..N {
            for k in 0..N {
                sum += half * qd[i] * mass[i][k] * qd[k];
            }
        }
        let energy = generic::kinetic_energy(&chain, &q, &qd);
        assert_within(
            [energy],
            [sum],
            T::constant(20.0) * Real::max(energy, T::constant(1.0)),
            8.0,
        );
    }
}

/// Gravity is the derivative of the potential energy of all bodies by each coordinate.
#[test]
fn gravity_is_the_gradient_of_potential_energy() {
    let mut random = Random::new(213);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, _, _] = state::<f64>(&mut random);
        let gravity = generic::gravity(&chain, &q);
        let g = chain.gravity.map(Jet::still);
        let whole = generic::potential_energy(&chain, &q);
        for (i, torque) in gravity.into_iter().enumerate() {
            let along = std::array::from_fn(|k| {
                if k == i {
                    Jet::moving(q[k])
                } else {
                    Jet::still(q[k])
                }
            });
            let bodies = inertias(&chain, &poses(&chain, &along));
            let energy = bodies
                .iter()
                .fold(Jet::still(0.0), |sum, j| sum + j.potential_energy(g));
            assert_within([energy.0, energy.1], [whole, torque], 100.0, 32.0);
        }
    }
}

/// Power of the torques = rate of kinetic and potential energy.
#[test]
fn torques_do_the_work_that_energy_gains() {
    let mut random = Random::new(214);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, qd, qdd] = state::<f64>(&mut random);
        let along = std::array::from_fn(|i| Jet(q[i], qd[i], qdd[i]));
        let rates = std::array::from_fn(|i| Jet(qd[i], qdd[i], 0.0));
        let motions = motions(&chain, &along, &rates, &[Jet::still(0.0); N]);
        let bodies = inertias(&chain, &motions.map(|motion| motion.pose));
        let g = chain.gravity.map(Jet::still);
        let energies = bodies.iter().zip(&motions);
        let energy = energies.fold(Jet::still(0.0), |sum, (j, motion)| {
            sum + j.kinetic_energy(&motion.velocity) + j.potential_energy(g)
        });
        let whole =
            generic::kinetic_energy(&chain, &q, &qd) + generic::potential_energy(&chain, &q);
        let tau = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        let power: f64 = (0..N).map(|i| tau[i] * qd[i]).sum();
        assert_within([energy.0, energy.1], [whole, power], 200.0, 32.0);
    }
}

fn jacobians_differ_by_a_change_of_frame<T: Real + RealField + Copy>() {
    let mut random = Random::new(215);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, qd, _] = state::<T>(&mut random);
        for frame in chain.frames {
            let m = generic::forward_kinematics(&chain, &frame, &q);
            let spatial = generic::spatial_jacobian(&chain, &frame, &q);
            let body = generic::body_jacobian(&chain, &frame, &q);
            let geometric = generic::geometric_jacobian(&chain, &frame, &q);
            let shift = Pose::from_translation(m.translation());
            let (reach, one) = (size(m.translation()), T::constant(1.0));
            let scale = T::constant(4.0) * (one + reach) * (one + reach);
            for i in 0..N {
                let same = |a: Screw<T>, b: Screw<T>| {
                    assert_same(&a.to_matrix(), &b.to_matrix(), scale, 8.0);
                };
                same(m.change_frame(&body[i]), spatial[i]);
                same(shift.change_frame(&geometric[i]), spatial[i]);
                assert!(
                    chain.carries(i, frame.body)
                        || spatial[i] == Screw::new([T::constant(0.0); 3], [T::constant(0.0); 3])
                );
            }
            let w = generic::velocity(&chain, &frame, &q, &qd);
            let sum = spatial.velocity(&qd);
            assert_same(&sum.to_matrix(), &w.to_matrix(), scale, 8.0);
        }
        assert_eq!(chain.frame("tip"), Some(chain.tip()));
        assert_eq!(
            chain.forward_kinematics(&q),
            generic::forward_kinematics(&chain, &chain.tip(), &q)
        );
        assert_eq!(
            chain.spatial_jacobian(&q),
            generic::spatial_jacobian(&chain, &chain.tip(), &q)
        );
        assert_eq!(
            chain.body_jacobian(&q),
            generic::body_jacobian(&chain, &chain.tip(), &q)
        );
        assert_eq!(
            chain.geometric_jacobian(&q),
            generic::geometric_jacobian(&chain, &chain.tip(), &q)
        );
    }
}

/// Part II: H̃₀ₕ = Σ(W₀,ᵢ₋₁ Wᵢ − Wᵢ W₀,ᵢ₋₁) + W₀ₕ², the acceleration at q̈ = 0.
fn acceleration_without_second_rates<T: Real + RealField + Copy>() {
    let mut random = Random::new(218);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, qd, _] = state::<T>(&mut random);
        let rest = [T::constant(0.0); N];
        for frame in chain.frames {
            let mut w = homogen::Velocity::zero();
            let mut sum = [[T::constant(0.0); 4]; 4];
            let columns = generic::spatial_jacobian(&chain, &frame, &q);
            for (l, rate) in columns.iter().zip(qd) {
                let w_i = l.velocity(rate);
                let (before, own) = (w.to_matrix(), w_i.to_matrix());
                let bracket = combine(1.0, &product(&before, &own), -1.0, &product(&own, &before));
                sum = combine(1.0, &sum, 1.0, &bracket);
                w = w + w_i;
            }
            let square = product(&w.to_matrix(), &w.to_matrix());
            let literal = combine(1.0, &sum, 1.0, &square);
            let h = generic::acceleration(&chain, &frame, &q, &qd, &rest);
            assert_same(&h.to_matrix(), &literal, T::constant(4.0), 64.0);
        }
    }
}

#[test]
fn rates_of_the_tip_are_derivatives_of_its_pose() {
    let mut random = Random::new(216);
    for _ in 0..20 {
        let chain = tree(&mut random);
        let [q, qd, qdd] = state::<f64>(&mut random);
        let along = std::array::from_fn(|i| Jet(q[i], qd[i], qdd[i]));
        let body = chain.tip().body.expect("not of the base");
        let placement = chain.tip().placement;
        let placement = Pose::new(
            placement.rotation().map(|row| row.map(Jet::still)),
            placement.translation().map(Jet::still),
        );
        let moving = (poses(&chain, &along)[body] * placement).to_matrix();
        let part = |part: fn(Jet) -> f64| moving.map(|row| row.map(part));
        let now = part(|x| x.0);
        let m = generic::forward_kinematics(&chain, &chain.tip(), &q);
        assert_same(&m.to_matrix(), &now, 8.0, 8.0);
        let w = generic::velocity(&chain, &chain.tip(), &q, &qd);
        assert_same(&product(&w.to_matrix(), &now), &part(|x| x.1), 16.0, 16.0);
        let h = generic::acceleration(&chain, &chain.tip(), &q, &qd, &qdd);
        assert_same(&product(&h.to_matrix(), &now), &part(|x| x.2), 64.0, 16.0);
        assert_eq!(
            (chain.velocity(&q, &qd), chain.acceleration(&q, &qd, &qdd)),
            (w, h)
        );
    }
}

/// The two-link arm in a vertical plane, with its textbook torques.
#[test]
fn two_link_arm_in_closed_form() {
    let (l1, l2, m1, m2, g) = (0.7, 0.4, 2.0, 1.5, 9.81);
    let along = |x: f64| Pose::from_translation([x, 0.0, 0.0]);
    let z = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]);
    let bob = |m: f64, x: f64| Inertia::of_particle(m, [x, 0.0, 0.0]);
    let chain = Chain::<2, 0>::new(
        [
            Joint::new("shoulder", None, along(0.0), z, bob(m1, l1)),
            Joint::new("elbow", Some(0), along(l1), z, bob(m2, l2)),
        ],
        [],
        [0.0, -g, 0.0],
    );
    let mut random = Random::new(217);
    for _ in 0..50 {
        let mut two = || [random.number::<f64>(), random.number()];
        let (q, qd, qdd) = (two(), two(), two());
        let (s2, c2) = q[1].sin_cos();
        let (c1, c12) = (q[0].cos(), (q[0] + q[1]).cos());
        let h = m2 * l1 * l2 * s2;
        let m11 = m1 * l1 * l1 + m2 * (l1 * l1 + l2 * l2 + 2.0 * l1 * l2 * c2);
        let (m12, m22) = (m2 * (l2 * l2 + l1 * l2 * c2), m2 * l2 * l2);
        let gravity = [
            (m1 + m2) * g * l1 * c1 + m2 * g * l2 * c12,
            m2 * g * l2 * c12,
        ];
        let tau = [
            m11 * qdd[0] + m12 * qdd[1] - h * (2.0 * qd[0] * qd[1] + qd[1] * qd[1]) + gravity[0],
            m12 * qdd[0] + m22 * qdd[1] + h * qd[0] * qd[0] + gravity[1],
        ];
        assert_within(
            generic::inverse_dynamics(&chain, &q, &qd, &qdd),
            tau,
            50.0,
            8.0,
        );
        assert_within(generic::gravity(&chain, &q), gravity, 50.0, 8.0);
        let mass = generic::mass_matrix(&chain, &q);
        assert_within(
            mass.as_flattened().to_vec(),
            [m11, m12, m12, m22],
            4.0,
            16.0,
        );
        let tip: Pose<f64> = chain.forward_kinematics(&q);
        let elbow = [l1 * c1, l1 * q[0].sin(), 0.0];
        assert_within(tip.translation(), elbow, 1.0, 4.0);
    }
}

in_both_precisions! {
    acceleration_without_second_rates
    newton_euler_and_lagrange_agree
    gravity_is_inverse_dynamics_at_rest
    kinetic_energy_is_that_of_the_mass_matrix
    jacobians_differ_by_a_change_of_frame
}
