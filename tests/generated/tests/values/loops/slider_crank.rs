//! The slider-crank, compared with the closed form of Part II.

use homogen::loop_closure::{ClosureOutcome, project, project_rates, regularity};
use homogen::worked_examples::slider_crank::{SliderCrank, State};

use super::{difference, largest};

const LENGTHS: SliderCrank = SliderCrank {
    crank: 0.12,
    rod: 0.35,
};

homogen::chain! {
    /// A crank and a slider on the ground, and a rod on the crank.
    pub struct ClosedLoopRobot {
        gravity: [0.0, -9.81, 0.0],
        generate(
            constraint, constraint_jacobian, constraint_bias, constrained_forward_dynamics,
            inverse_dynamics,
        )
    }
    link ground;
    joint alpha: continuous(z);
    link crank { mass: 0.9, com: [0.05, 0.01, 0.0], inertia: [1e-4, 1e-3, 1.1e-3] }
    joint beta: continuous(z) { at: xyz(0.12, 0.0, 0.0) }
    link rod { mass: 0.4, com: [0.17, 0.0, 0.0], inertia: [1e-5, 4e-3, 4e-3] }
    joint slide: prismatic(x) { from: ground }
    link slider { mass: 1.3, com: [0.02, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
    loop pin: revolute(z) { from: rod, to: slider, at: xyz(0.35, 0.0, 0.0) }
}

/// The angle of the crank, of the rod from it, and the position of the slider, from the paper's four joints.
fn of([alpha, beta, _, x]: [f64; 4]) -> [f64; 3] {
    [alpha, beta, x]
}

fn angles() -> impl Iterator<Item = f64> {
    (0..100).map(|k| -3.1 + 0.0625 * f64::from(k))
}

#[test]
fn residuals_rates_and_accelerations_of_the_closed_form_are_zero() {
    for alpha in angles() {
        let State { q, qd, qdd } = LENGTHS.state(alpha, 2.5, -7.0);
        let [q, qd, qdd] = [q, qd, qdd].map(of);
        assert!(largest(&ClosedLoopRobot.constraint(&q)) < 2e-16, "{alpha}");
        let jacobian = ClosedLoopRobot.constraint_jacobian(&q);
        let bias = ClosedLoopRobot.constraint_bias(&q, &qd);
        for (row, bias) in jacobian.iter().zip(bias) {
            let product = |x: &[f64; 3]| row.iter().zip(x).map(|(j, x)| j * x).sum::<f64>();
            assert!(product(&qd).abs() < 1e-15, "{alpha}");
            assert!((product(&qdd) + bias).abs() < 2e-14, "{alpha}");
        }
    }
}

#[test]
fn accelerations_are_those_of_the_closed_form() {
    for alpha in angles() {
        let State { q, qd, .. } = LENGTHS.state(alpha, 4.0, 0.0);
        let (q, qd) = (of(q), of(qd));
        let tau = [0.7, 0.0, 3.0];
        let found = ClosedLoopRobot
            .constrained_forward_dynamics(&q, &qd, &tau)
            .qdd;
        let expected = of(LENGTHS.state(alpha, 4.0, found[0]).qdd);
        let size = largest(&found);
        assert!(
            difference(&found, &expected) < 1e-14 * size,
            "{found:?} {expected:?}"
        );
        // The power of all bodies, as in an open tree, is that of the torques.
        let torques = ClosedLoopRobot.inverse_dynamics(&q, &qd, &expected);
        let power: f64 = torques.iter().zip(&qd).map(|(tau, qd)| tau * qd).sum();
        let input: f64 = tau.iter().zip(&qd).map(|(tau, qd)| tau * qd).sum();
        assert!((power - input).abs() < 1e-13 * size, "{power} {input}");
    }
}

#[test]
fn a_force_on_the_slider_balances_a_torque_of_the_crank() {
    // At rest, the torque of the crank that balances a force depends on the rod's angle.
    let State { q, .. } = LENGTHS.state(0.9, 0.0, 0.0);
    let q = of(q);
    let gravity = ClosedLoopRobot.inverse_dynamics(&q, &[0.0; 3], &[0.0; 3]);
    let j = ClosedLoopRobot.constraint_jacobian(&q);
    // First with the gravity torques at all joints: the pin transmits no force.
    let lambda = ClosedLoopRobot.constrained_forward_dynamics(&q, &[0.0; 3], &gravity);
    let lambda = lambda.multipliers;
    assert!(
        largest(&lambda) < 1e-14,
        "in balance by the joints: {lambda:?}"
    );
    let (sine, cosine) = (-(0.12 * 0.9_f64.sin() / 0.35), 0.0_f64);
    let along = (1.0 - sine * sine).sqrt() + cosine;
    // The derivative of the slider's position by the angle of the crank, as in the paper.
    let x_by_alpha = -0.12 * 0.9_f64.sin() - 0.12 * 0.9_f64.cos() * (-sine / along);
    let tau = [gravity[0] + 5.0 * x_by_alpha, gravity[1], gravity[2] - 5.0];
    let found = ClosedLoopRobot.constrained_forward_dynamics(&q, &[0.0; 3], &tau);
    assert!(largest(&found.qdd) < 1e-12, "in balance: {found:?}");
    let lambda = found.multipliers;
    let by_pin: Vec<f64> = (0..3)
        .map(|k| j[0][k] * lambda[0] + j[1][k] * lambda[1])
        .collect();
    let missing: Vec<f64> = (0..3).map(|k| gravity[k] - tau[k]).collect();
    assert!(
        difference(&by_pin, &missing) < 1e-13,
        "{by_pin:?} {missing:?}"
    );
}

#[test]
fn states_are_projected_onto_the_loop() {
    for alpha in angles() {
        let expected = of(LENGTHS.state(alpha, 1.0, 0.0).q);
        let start = [alpha, expected[1] + 0.2, expected[2] - 0.05];
        let found = project(&ClosedLoopRobot, &start, 1e-14);
        assert_eq!(found.outcome, ClosureOutcome::Closed, "{alpha}: {found:?}");
        assert!(found.steps < 12, "{found:?}");
        let closed = of(LENGTHS.state(found.q[0], 0.0, 0.0).q);
        assert!(
            difference(&found.q, &closed) < 1e-13,
            "{found:?} {closed:?}"
        );
        let jacobian = ClosedLoopRobot.constraint_jacobian(&found.q);
        let qd = project_rates(&jacobian, &[1.0, -0.3, 0.2]);
        let expected = of(LENGTHS.state(found.q[0], qd[0], 0.0).qd);
        assert!(difference(&qd, &expected) < 1e-14, "{qd:?} {expected:?}");
    }
}

homogen::chain! {
    /// The same with a rod that is shorter than the distance of the crank from the slider's axis.
    pub struct TooShort { generate(constraint, constraint_jacobian) }
    link ground;
    joint alpha: continuous(z) { at: xyz(0.0, 1.0, 0.0) }
    link crank { mass: 0.9, com: [0.05, 0.01, 0.0], inertia: [1e-4, 1e-3, 1.1e-3] }
    joint slide: prismatic(x) { from: ground }
    link slider { mass: 1.3, com: [0.02, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
    loop bar: rod(0.35) { from: crank, to: slider, at: xyz(0.12, 0.0, 0.0) }
}

#[test]
fn loops_that_cannot_close_are_out_of_reach() {
    for start in [[0.3, 0.4], [-1.2, -0.7], [2.0, 0.1]] {
        let found = project(&TooShort, &start, 1e-12);
        assert_eq!(found.outcome, ClosureOutcome::OutOfReach, "{found:?}");
        // They are nearest with the crank down and the slider below.
        let left: f64 = (0.88 * 0.88 - 0.35 * 0.35) / 0.7;
        assert!((found.residual - left).abs() < 1e-7, "{found:?} {left}");
    }
    let found = project(&TooShort, &[f64::NAN, 0.0], 1e-12);
    assert_eq!(found.outcome, ClosureOutcome::Stalled);
}

#[test]
fn singular_configurations_are_reported() {
    let q = of(LENGTHS.state(0.7, 0.0, 0.0).q);
    let regular = regularity(&ClosedLoopRobot.constraint_jacobian(&q));
    assert_eq!(regular.rank, 2);
    // Crank and rod of one length, upright: the paper's rank is one less.
    let folded =
        Folded.constraint_jacobian(&[std::f64::consts::FRAC_PI_2, std::f64::consts::PI, 0.0]);
    let singular = regularity(&folded);
    assert_eq!(singular.rank, 1, "{singular:?}");
    // Folded, with the end of the rod on the axis of the crank, the two bars rotate together.
    let dead = Held.constraint_jacobian(&[0.0, std::f64::consts::PI]);
    let dead = regularity(&dead);
    assert_eq!(dead.rank, 1, "{dead:?}");
    assert!(dead.singular_values[1] < 1e-15, "{dead:?}");
    let found =
        Held.constrained_forward_dynamics(&[0.0, std::f64::consts::PI], &[1.0, -2.0], &[1.0, 0.0]);
    let mut numbers = found.qdd.iter().chain(&found.multipliers);
    assert!(numbers.all(|x: &f64| x.is_finite()), "{found:?}");
}

homogen::chain! {
    /// Crank and rod of one length.
    pub struct Folded { gravity: none, generate(constraint_jacobian) }
    link ground;
    joint alpha: continuous(z);
    link crank { mass: 0.9, com: [0.05, 0.01, 0.0], inertia: [1e-4, 1e-3, 1.1e-3] }
    joint beta: continuous(z) { at: xyz(0.12, 0.0, 0.0) }
    link rod { mass: 0.4, com: [0.17, 0.0, 0.0], inertia: [1e-5, 4e-3, 4e-3] }
    joint slide: prismatic(x) { from: ground }
    link slider { mass: 1.3, com: [0.02, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
    loop pin: revolute(z) { from: rod, to: slider, at: xyz(0.12, 0.0, 0.0) }
}

#[expect(
    deprecated,
    reason = "the robot cannot move, as the warning says, and the test is about that"
)]
mod held {
    homogen::chain! {
        /// Crank and rod of one length, with the end of the rod on the axis of the crank.
        pub struct Held { gravity: none, generate(constraint_jacobian, constrained_forward_dynamics) }
        link ground;
        joint alpha: continuous(z);
        link crank { mass: 0.9, com: [0.05, 0.01, 0.0], inertia: [1e-4, 1e-3, 1.1e-3] }
        joint beta: continuous(z) { at: xyz(0.12, 0.0, 0.0) }
        link rod { mass: 0.4, com: [0.06, 0.0, 0.0], inertia: [1e-5, 4e-3, 4e-3] }
        loop pin: revolute(z) { from: rod, to: ground, at: xyz(0.12, 0.0, 0.0) }
    }
}
use held::Held;
