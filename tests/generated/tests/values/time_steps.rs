//! Time steps and their derivatives.
//!
//! In: robots whose coordinates are added, and one with quaternions, a planar and a mimic joint. Out: agreement with
//! the classical rule over the generic recursions, orders of convergence, conserved quantities, and derivatives by dual
//! numbers.

use std::array::from_fn;

use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives};
use homogen::step::{ImplicitMidpoint, Integrator, NextState, Step, StepDerivatives, step};
use homogen::{Robot, Scalar, chain, generic};
use homogen_robots::jointed::Brick;
use homogen_robots::shipped::PandaClass;
use homogen_tests::dual::Dual;
use homogen_tests::effort::effort;
use homogen_tests::rounding::DOUBLE;
use homogen_tests::states::Random;
use nalgebra::{SMatrix, SVector};

chain! {
    /// A floating base with every other type of joint that has coordinates of its own, and a mimic joint.
    struct Walker {
        floating,
        generate(
            inverse_dynamics, inverse_dynamics_derivatives, mass_matrix, forward_dynamics,
            forward_dynamics_derivatives
        )
    }
    link trunk { mass: 3.0, com: [0.05, 0.02, 0.1], inertia: [0.04, 0.001, 0.002, 0.05, -0.003, 0.06] }
    joint puck: planar([0.0, 0.6, 0.8]) { from: trunk, to: puck, at: xyz(0.2, 0.0, 0.1) rpy(0.1, 0.2, 0.3) }
    link puck { mass: 3.0, com: [0.05, 0.02, 0.1], inertia: [0.04, 0.001, 0.002, 0.05, -0.003, 0.06] }
    joint ball: spherical { from: puck, to: upper, at: xyz(0.1, -0.2, 0.3) rpy(0.5, -0.4, 0.3) }
    link upper { mass: 2.0, com: [0.0, 0.1, 0.2], inertia: [0.03, 0.001, -0.002, 0.025, 0.001, 0.02] }
    joint hinge: revolute(y) { from: upper, to: fore, at: xyz(0.0, 0.05, 0.4) rpy(0.2, 0.0, 0.0) }
    link fore { mass: 1.0, com: [0.02, 0.0, 0.15], inertia: [0.01, 0.01, 0.003] }
    joint copy: revolute(x) { from: fore, to: hand, at: xyz(0.0, 0.05, 0.4), mimic: hinge, multiplier: 0.5 }
    link hand { mass: 0.5, com: [0.0, 0.01, 0.05], inertia: [0.002, 0.002, 0.001] }
}

const N: usize = Walker::NV;
const Q: usize = Walker::NQ;

const EVERY: [Integrator; 3] = [Integrator::SemiImplicit, Integrator::Euler, Integrator::Rk4];

/// A state of the walker, and torques.
fn walking(random: &mut Random) -> ([f64; Q], [f64; N], [f64; N]) {
    let q = Walker.normalize(&from_fn(|_| random.unit()));
    let qd = from_fn(|_| 2.0 * random.unit());
    (q, qd, from_fn(|_| 5.0 * random.unit()))
}

/// The largest entry of a vector.
fn largest(entries: impl IntoIterator<Item = f64>) -> f64 {
    entries.into_iter().fold(0.0, |most, x| x.abs().max(most))
}

/// The distance of two states, along velocities.
fn distance(a: &NextState<N, f64, Q>, b: &NextState<N, f64, Q>) -> f64 {
    let rates = a.qd.iter().zip(b.qd).map(|(a, b)| a - b);
    largest(Walker.difference(&a.q, &b.q).into_iter().chain(rates))
}

#[test]
fn an_arm_moves_by_the_classical_rules() {
    let chain = PandaClass::chain();
    let mut random = Random::new(1);
    let dt = 0.01;
    for _ in 0..20 {
        let mut vector = |size: f64| -> [f64; 7] { from_fn(|_| size * random.unit()) };
        let (q, qd, tau) = (vector(2.0), vector(1.0), vector(5.0));
        let rate = |q: &[f64; 7], qd: &[f64; 7]| generic::forward_dynamics(&chain, q, qd, &tau);
        let plus =
            |a: &[f64; 7], s: f64, b: &[f64; 7]| -> [f64; 7] { from_fn(|k| a[k] + s * b[k]) };
        let same = |integrator, q1: [f64; 7], qd1: [f64; 7]| {
            let found = PandaClass.step(integrator, &q, &qd, &tau, dt);
            let pairs = found.q.iter().zip(q1).chain(found.qd.iter().zip(qd1));
            let off = largest(pairs.map(|(a, b)| a - b));
            assert!(off < 1e-12, "{integrator:?}: {off:e}");
        };
        let k1 = rate(&q, &qd);
        let faster = plus(&qd, dt, &k1);
        same(Integrator::SemiImplicit, plus(&q, dt, &faster), faster);
        same(Integrator::Euler, plus(&q, dt, &qd), faster);
        let v2 = plus(&qd, dt / 2.0, &k1);
        let k2 = rate(&plus(&q, dt / 2.0, &qd), &v2);
        let v3 = plus(&qd, dt / 2.0, &k2);
        let k3 = rate(&plus(&q, dt / 2.0, &v2), &v3);
        let v4 = plus(&qd, dt, &k3);
        let k4 = rate(&plus(&q, dt, &v3), &v4);
        let mean = |a: &[f64; 7], b: &[f64; 7], c: &[f64; 7], d: &[f64; 7]| -> [f64; 7] {
            from_fn(|k| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0)
        };
        same(
            Integrator::Rk4,
            plus(&q, dt, &mean(&qd, &v2, &v3, &v4)),
            plus(&qd, dt, &mean(&k1, &k2, &k3, &k4)),
        );
    }
}

#[test]
fn steps_have_their_orders_of_convergence() {
    let mut random = Random::new(2);
    let (q, _, tau) = walking(&mut random);
    let qd = from_fn(|_| random.unit());
    let after = |integrator, steps: u32| {
        let mut state = NextState { q, qd };
        for _ in 0..steps {
            state = Walker.step(
                integrator,
                &state.q,
                &state.qd,
                &tau,
                0.2 / f64::from(steps),
            );
        }
        state
    };
    let exact = after(Integrator::Rk4, 1000);
    for (integrator, order) in EVERY.into_iter().zip([1.0, 1.0, 4.0]) {
        let [coarse, fine] = [32, 64].map(|steps| distance(&after(integrator, steps), &exact));
        let found = (coarse / fine).log2();
        assert!((found - order).abs() < 0.2, "{integrator:?}: {found}");
    }
}

/// The step of the midpoint rule by Newton's method.
fn by_midpoint((q, qd): (&[f64; Q], &[f64; N]), tau: &[f64; N], dt: f64) -> NextState<N, f64, Q> {
    let mut next = *qd;
    for _ in 0..8 {
        let residual = Walker.midpoint_residual((q, qd), &next, tau, dt);
        let by = Walker.midpoint_derivatives((q, qd), &next, dt).next_qd;
        let by = SMatrix::<f64, N, N>::from_fn(|row, column| by[row][column]);
        let step = by
            .lu()
            .solve(&SVector::from(residual))
            .expect("a regular equation");
        next = from_fn(|k| next[k] - step[k]);
    }
    let residual = Walker.midpoint_residual((q, qd), &next, tau, dt);
    assert!(largest(residual) < 1e-9, "{residual:?}");
    let q = Walker.midpoint_configuration((q, qd), &next, dt);
    NextState { q, qd: next }
}

#[test]
fn the_midpoint_rule_is_symmetric_and_of_order_2() {
    let mut random = Random::new(8);
    let (q, _, tau) = walking(&mut random);
    let qd = from_fn(|_| random.unit());
    let after = |steps: u32| {
        let mut state = NextState { q, qd };
        for _ in 0..steps {
            state = by_midpoint((&state.q, &state.qd), &tau, 0.2 / f64::from(steps));
        }
        state
    };
    let mut exact = NextState { q, qd };
    for _ in 0..1000 {
        exact = Walker.step(Integrator::Rk4, &exact.q, &exact.qd, &tau, 2e-4);
    }
    let [coarse, fine] = [32, 64].map(|steps| distance(&after(steps), &exact));
    let order = (coarse / fine).log2();
    assert!((order - 2.0).abs() < 0.1, "{order}");
    let there = by_midpoint((&q, &qd), &tau, 0.01);
    let back = by_midpoint((&there.q, &there.qd), &tau, -0.01);
    let off = distance(&back, &NextState { q, qd });
    assert!(off < 1e-10, "{off:e}");
}

#[test]
fn derivatives_of_the_midpoint_rule_are_those_of_dual_numbers() {
    let mut random = Random::new(9);
    for dt in [1e-3, 0.05, 2.0] {
        let (q, qd, tau) = walking(&mut random);
        let next: [f64; N] = from_fn(|k| qd[k] + dt * random.unit());
        let by = Walker.midpoint_derivatives((&q, &qd), &next, dt);
        let none = [0.0; N];
        for k in 0..N {
            let unit: [f64; N] = from_fn(|i| if i == k { 1.0 } else { 0.0 });
            let directions = [
                (&by.q, [&unit, &none, &none]),
                (&by.qd, [&none, &unit, &none]),
                (&by.next_qd, [&none, &none, &unit]),
            ];
            for (block, [of_q, of_qd, of_next]) in directions {
                let moved = Walker.integrate(
                    &q.map(|x| Dual::new(x, 0.0)),
                    &of_q.map(|slope| Dual::new(0.0, slope)),
                );
                let residual = Walker.midpoint_residual(
                    (&moved, &Dual::pairs(&qd, of_qd)),
                    &Dual::pairs(&next, of_next),
                    &Dual::pairs(&tau, &none),
                    Dual::new(dt, 0.0),
                );
                let size = largest(block.as_flattened().iter().copied());
                let pairs = block.iter().zip(residual);
                let off = largest(pairs.map(|(row, dual)| row[k] - dual.slope)) / size;
                assert!(off < 1e-11, "{dt} s, {k}: {off:e}");
            }
        }
    }
}

#[test]
fn quaternions_keep_their_length() {
    let mut random = Random::new(3);
    let (mut q, mut qd, tau) = walking(&mut random);
    for _ in 0..1000 {
        NextState { q, qd } = Walker.step(Integrator::Rk4, &q, &qd, &tau.map(|x| 0.1 * x), 1e-3);
    }
    for first in [3, 10] {
        let length = q[first..first + 4].iter().map(|x| x * x).sum::<f64>();
        assert!((length - 1.0).abs() < 8.0 * DOUBLE, "{length}");
    }
}

chain! {
    /// A pendulum, whose mass matrix is constant.
    struct Pendulum { generate(forward_dynamics, kinetic_energy, potential_energy) }
    link base;
    joint pivot: revolute(y);
    link rod { mass: 1.0, com: [0.5, 0.0, 0.0], inertia: [0.001, 0.02, 0.02] }
}

/// The rule is symplectic where M is constant: the energy swings and does not drift.
#[test]
fn the_energy_of_a_pendulum_stays_bounded() {
    let energy = |state: &NextState<1>| {
        Pendulum.kinetic_energy(&state.q, &state.qd) + Pendulum.potential_energy(&state.q)
    };
    let mut state = NextState {
        q: [0.4],
        qd: [0.0],
    };
    let start = energy(&state);
    let steps = effort(100_000, 1_000_000);
    let mut worst = [0.0_f64; 2];
    for k in 0..steps {
        state = Pendulum.step(Integrator::SemiImplicit, &state.q, &state.qd, &[0.0], 1e-3);
        let late = usize::from(k >= steps / 2);
        worst[late] = worst[late].max((energy(&state) - start).abs());
    }
    let [early, late] = worst;
    assert!(early < 0.05, "{early} J");
    assert!(late < 1.01 * early, "{early} J, then {late} J");
}

#[test]
fn the_momentum_of_a_free_body_is_conserved() {
    let mut state = NextState {
        q: [0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0],
        qd: [0.3, -0.2, 0.1, 0.5, -0.4, 0.6],
    };
    let momentum = |state: &NextState<6, f64, 7>| {
        let momentum = Brick.momentum(&state.q, &state.qd);
        [momentum.gamma(), momentum.rho()].concat()
    };
    let start = momentum(&state);
    for _ in 0..1000 {
        state = Brick.step(Integrator::Rk4, &state.q, &state.qd, &[0.0; 6], 1e-3);
    }
    let drift = largest(momentum(&state).iter().zip(&start).map(|(a, b)| a - b));
    assert!(
        drift < 1e-12 * largest(start.clone()),
        "{drift:e} of {start:?}"
    );
}

/// The derivatives of the walker's step along one direction of q, q̇ and τ, by dual numbers.
fn along(
    integrator: Integrator,
    (q, qd, tau): &([f64; Q], [f64; N], [f64; N]),
    dt: f64,
    [by_q, by_qd, by_tau]: [&[f64; N]; 3],
) -> [[f64; N]; 2] {
    let zero = Dual::new(0.0, 0.0);
    let q = Walker.integrate(
        &q.map(|x| Dual::new(x, 0.0)),
        &by_q.map(|slope| Dual::new(0.0, slope)),
    );
    let next = Walker.step(
        integrator,
        &q,
        &Dual::pairs(qd, by_qd),
        &Dual::pairs(tau, by_tau),
        Dual::new(dt, 0.0) + zero,
    );
    let constant = next.q.map(|entry| Dual::new(entry.value, 0.0));
    let change = Walker.difference(&constant, &next.q);
    [change, next.qd].map(|duals| duals.map(|dual| dual.slope))
}

#[test]
fn derivatives_are_those_of_dual_numbers() {
    let mut random = Random::new(4);
    let (none, unit) = ([0.0; N], |k| from_fn(|i| if i == k { 1.0 } else { 0.0 }));
    for integrator in EVERY {
        // Beyond a whole turn in one step, too; stages of such a step would be far out of any use.
        let turn = (integrator == Integrator::Euler).then_some(2.0);
        for dt in [1e-6, 1e-3, 0.05].into_iter().chain(turn) {
            let state = walking(&mut random);
            let (q, qd, tau) = &state;
            let by = Walker.step_derivatives(integrator, q, qd, tau, dt);
            let blocks = [
                [&by.q_by_q, &by.qd_by_q],
                [&by.q_by_qd, &by.qd_by_qd],
                [&by.q_by_tau, &by.qd_by_tau],
            ];
            for (which, blocks) in blocks.iter().enumerate() {
                for k in 0..N {
                    let mut directions = [&none; 3];
                    let unit = unit(k);
                    directions[which] = &unit;
                    let expected = along(integrator, &state, dt, directions);
                    for (block, expected) in blocks.iter().zip(expected) {
                        let size = largest(block.as_flattened().iter().copied()).max(1e-12);
                        let pairs = block.iter().zip(expected);
                        let off = largest(pairs.map(|(row, x)| row[k] - x)) / size;
                        assert!(off < 1e-10, "{integrator:?}, {dt} s, {which}, {k}: {off:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn derivatives_of_two_steps_are_products() {
    let mut random = Random::new(5);
    let state = walking(&mut random);
    let (q, qd, tau) = &state;
    let first = Walker.step(Integrator::Rk4, q, qd, tau, 0.01);
    let by = |q, qd| Walker.step_derivatives(Integrator::Rk4, q, qd, tau, 0.01);
    let both = by(q, qd).then(&by(&first.q, &first.qd));
    let second = (first.q, first.qd, *tau);
    let none = [0.0; N];
    for k in 0..N {
        let unit: [f64; N] = from_fn(|i| if i == k { 1.0 } else { 0.0 });
        let column = |block: &[[f64; N]; N]| block.map(|row| row[k]);
        for (direction, found) in [
            ([&unit, &none, &none], [&both.q_by_q, &both.qd_by_q]),
            ([&none, &unit, &none], [&both.q_by_qd, &both.qd_by_qd]),
            ([&none, &none, &unit], [&both.q_by_tau, &both.qd_by_tau]),
        ] {
            let [change, faster] = along(Integrator::Rk4, &state, 0.01, direction);
            let expected = along(
                Integrator::Rk4,
                &second,
                0.01,
                [&change, &faster, direction[2]],
            );
            for (found, expected) in found.iter().zip(expected) {
                let pairs = column(found).into_iter().zip(expected);
                let off = largest(pairs.map(|(a, b)| a - b));
                assert!(off < 1e-11, "{k}: {off:e}");
            }
        }
    }
}

/// At rest the Jacobian of a rotation is the identity, to the last digit.
#[test]
fn derivatives_hold_at_rest() {
    let (q, none) = (Walker.neutral(), [0.0; N]);
    let tau = none;
    let by: StepDerivatives<N> = Walker.step_derivatives(Integrator::Euler, &q, &none, &tau, 0.01);
    for row in 0..N {
        for column in 0..N {
            let one = if row == column { 1.0 } else { 0.0 };
            assert!(
                (by.q_by_q[row][column] - one).abs() < DOUBLE,
                "{row}, {column}"
            );
            let step = by.q_by_qd[row][column] - 0.01 * one;
            assert!(step.abs() < DOUBLE, "{row}, {column}");
        }
    }
}

#[test]
fn single_precision_is_close() {
    let mut random = Random::new(6);
    let (q, qd, tau) = walking(&mut random);
    let [single_qd, single_tau] = [qd, tau].map(|of| of.map(f32::constant));
    for integrator in EVERY {
        let exact = Walker.step(integrator, &q, &qd, &tau, 0.01);
        let found = Walker.step(
            integrator,
            &q.map(f32::constant),
            &single_qd,
            &single_tau,
            0.01,
        );
        let found = NextState {
            q: Walker.normalize(&found.q.map(f64::from)),
            qd: found.qd.map(f64::from),
        };
        let off = distance(&found, &exact);
        assert!(off < 1e-3, "{integrator:?}: {off:e}");
    }
}

/// Steps that the robot's trait makes, with accelerations of one's own.
#[test]
fn accelerations_may_be_of_any_origin() {
    let mut random = Random::new(7);
    let (q, qd, tau) = walking(&mut random);
    for integrator in EVERY {
        let motions = <Walker as Robot<N, Q>>::MOTIONS;
        let own = step(motions, integrator, (&q, &qd), 0.01, |q, qd| {
            Walker.forward_dynamics(q, qd, &tau)
        });
        assert_eq!(own, Walker.step(integrator, &q, &qd, &tau, 0.01));
    }
}

/// Compiles: any robot with the two functions has steps.
#[test]
fn a_controller_needs_two_bounds() {
    fn gain<R, const N: usize>(robot: &R, q: &[f64; N]) -> f64
    where
        R: Robot<N> + ForwardDynamics<N> + ForwardDynamicsDerivatives<N>,
    {
        let none = [0.0; N];
        robot
            .step_derivatives(Integrator::default(), q, &none, &none, 0.01)
            .qd_by_tau[0][0]
    }
    assert!(gain(&PandaClass, &[0.1; 7]) > 0.0);
}
