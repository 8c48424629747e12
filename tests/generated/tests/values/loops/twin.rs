//! Every function of loops, compared with the generic recursions, which read the robot as data: loops of every type
//! between two arms, and the robots of the other tests.

use std::array::from_fn;

use homogen::loop_closure::{ClosureOutcome, project};
use homogen::{ClosedLoopRobot, generic, robot};
use homogen_tests::states::{Random, State};

use super::four_bar::FourBar;
use super::leg::FreeLeg;
use super::{difference, largest};

/// Two arms on one trunk, with joints of many types and axes in general directions.
macro_rules! arms {
    ($($head:tt)*) => {
        homogen::chain! {
            $($head)*
            link base;
            joint trunk: revolute([0.6, 0.0, 0.8]) { at: xyz(0.1, 0.2, 0.3) rpy(0.1, -0.2, 0.3) }
            link trunk { mass: 2.0, com: [0.1, 0.0, 0.2], inertia: [0.04, 0.05, 0.06] }
            joint left_1: universal(x, [0.0, 0.8, 0.6]) { at: xyz(0.2, 0.1, 0.0) rpy(0.0, 0.5, 0.0) }
            link left_1 { mass: 1.0, com: [0.1, 0.02, 0.0], inertia: [0.01, 0.01, 0.02] }
            joint left_2: prismatic([0.0, 0.6, -0.8]) { at: xyz(0.3, 0.0, 0.1) }
            link left_2 { mass: 0.7, com: [0.0, 0.1, 0.05], inertia: [0.01, 0.02, 0.01] }
            joint left_3: spherical { at: xyz(0.0, 0.2, 0.1) rpy(0.2, 0.1, 0.0) }
            link left_3 { mass: 0.5, com: [0.05, 0.0, 0.1], inertia: [0.004, 0.003, 0.002] }
            joint right_1: planar([0.0, 0.6, 0.8]) { from: trunk, at: xyz(-0.2, 0.1, 0.1) }
            link right_1 { mass: 0.9, com: [0.0, 0.1, 0.0], inertia: [0.01, 0.02, 0.02] }
            joint right_2: screw(y, pitch: 0.05) { at: xyz(0.1, 0.1, 0.0) rpy(0.3, 0.0, 0.1) }
            link right_2 { mass: 0.4, com: [0.1, 0.0, 0.02], inertia: [0.003, 0.002, 0.004] }
        }
    };
}

arms! {
    /// Arms with connected hands.
    struct Hands {
        actuated(trunk, left_1),
        generate(
            constraint, constraint_jacobian, constraint_bias, constrained_forward_dynamics,
            actuated_inverse_dynamics,
        )
    }
    loop hands: fixed { from: left_3, to: right_2, at: xyz(0.1, 0.0, 0.1) rpy(0.1, 0.2, 0.3), to_at: rpy(0.3, 0.0, 0.0) }
    loop stay: rod(0.4) { from: base, to: left_2, to_at: xyz(0.0, 0.1, 0.0) }
}

arms! {
    /// Loops of rotations.
    struct Rotations { generate(constraint, constraint_jacobian, constraint_bias) }
    loop pin: revolute([0.0, 0.6, 0.8]) { from: left_3, to: right_2, at: xyz(0.1, 0.0, 0.1), to_at: xyz(0.0, 0.1, 0.0) }
    loop cross: universal([0.6, 0.8, 0.0], z) { from: base, to: right_1, at: xyz(0.1, 0.2, 0.0) }
    loop ball: spherical { from: left_2, to: base, at: xyz(0.1, 0.2, 0.0) rpy(0.4, 0.2, 0.1) }
    loop axle: cylindrical(-x) { from: right_2, to: left_1, to_at: xyz(0.1, 0.2, 0.0) }
}

arms! {
    /// Loops of translations.
    struct Translations { generate(constraint, constraint_jacobian, constraint_bias) }
    loop slot: prismatic([0.0, 0.6, 0.8]) { from: left_3, to: right_2, at: xyz(0.1, 0.0, 0.1) }
    loop face: planar(y) { from: base, to: right_1, at: xyz(0.1, 0.2, 0.0) rpy(0.4, 0.2, 0.1) }
    loop table: translation { from: left_2, to: base, to_at: rpy(0.2, 0.3, 0.1) }
}

/// The worst differences of residuals, their Jacobian and their bias, each relative to the largest entry.
fn agree<R, const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>(
    robot: &R,
    closed_loops: &ClosedLoopRobot<N, F, C, Q, B>,
) -> [f64; 3]
where
    R: robot::Constraint<N, C, f64, Q>
        + robot::ConstraintJacobian<N, C, f64, Q>
        + robot::ConstraintBias<N, C, f64, Q>,
{
    let mut random = Random::new(3);
    let mut worst = [0.0_f64; 3];
    for _ in 0..50 {
        let State { q, qd, .. } = State::<f64, N, Q>::of(&closed_loops.chain, &mut random);
        let pairs: [[Vec<f64>; 2]; 3] = [
            [
                robot.constraint(&q).to_vec(),
                generic::constraint(closed_loops, &q).to_vec(),
            ],
            [
                robot.constraint_jacobian(&q).concat(),
                generic::constraint_jacobian(closed_loops, &q).concat(),
            ],
            [
                robot.constraint_bias(&q, &qd).to_vec(),
                generic::constraint_bias(closed_loops, &q, &qd).to_vec(),
            ],
        ];
        for (worst, [found, expected]) in worst.iter_mut().zip(pairs) {
            *worst = worst.max(difference(&found, &expected) / largest(&expected));
        }
    }
    worst
}

#[test]
fn loops_of_every_type_agree_with_the_recursions() {
    let worst = [
        agree(&Hands, &Hands::closed_loops()),
        agree(&Rotations, &Rotations::closed_loops()),
        agree(&Translations, &Translations::closed_loops()),
    ];
    println!("{worst:?}");
    let largest = worst
        .iter()
        .flatten()
        .fold(0.0, |most: f64, x| most.max(*x));
    assert!(largest < 1e-13, "{worst:?}");
}

#[test]
fn connected_arms_agree_with_the_recursions() {
    let closed_loops = Hands::closed_loops();
    let mut random = Random::new(5);
    let (mut motion, mut torques) = (0.0_f64, 0.0_f64);
    for _ in 0..50 {
        let State { q, qd, qdd } = State::of(&closed_loops.chain, &mut random);
        let tau = from_fn(|_| 4.0 * random.unit());
        let found = Hands.constrained_forward_dynamics(&q, &qd, &tau);
        let expected = generic::constrained_forward_dynamics(&closed_loops, &q, &qd, &tau);
        for (found, expected) in [
            (&found.qdd[..], &expected.qdd[..]),
            (&found.multipliers, &expected.multipliers),
        ] {
            motion = motion.max(difference(found, expected) / largest(expected));
        }
        let found = Hands.actuated_inverse_dynamics(&q, &qd, &qdd);
        let expected = generic::actuated_inverse_dynamics(&closed_loops, &q, &qd, &qdd);
        torques = torques.max(difference(&found, &expected) / largest(&expected));
        let joints = closed_loops.actuated.iter().zip(found);
        assert!(
            joints
                .clone()
                .any(|(actuated, tau)| *actuated && tau != 0.0)
        );
        for (actuated, tau) in joints {
            assert!(*actuated || tau == 0.0);
        }
    }
    println!("motion {motion:.1e}, torques {torques:.1e}");
    // Four of the states are nearly singular, with accelerations of 1e5 rad/s²; of all others the worst is 1e-11.
    assert!(motion < 1e-8 && torques < 1e-9, "{motion} {torques}");
}

#[test]
fn a_leg_on_a_floating_base_agrees_with_the_recursions() {
    let closed_loops = FreeLeg::closed_loops();
    let mut random = Random::new(9);
    for _ in 0..20 {
        let State { q, qd, .. } = State::of(&closed_loops.chain, &mut random);
        let tau = from_fn(|_| 4.0 * random.unit());
        let found = FreeLeg.constrained_forward_dynamics(&q, &qd, &tau);
        let expected = generic::constrained_forward_dynamics(&closed_loops, &q, &qd, &tau);
        let off = difference(&found.qdd, &expected.qdd) / largest(&expected.qdd);
        assert!(off < 1e-9, "{off}");
    }
}

#[test]
fn projection_by_data_agrees_with_generated_code() {
    let closed_loops = FourBar::closed_loops();
    let start = [1.0, 0.2, 1.7];
    let [generated, data] = [
        project(&FourBar, &start, 1e-14),
        project(&closed_loops, &start, 1e-14),
    ];
    assert_eq!(generated.outcome, ClosureOutcome::Closed);
    assert_eq!(data.outcome, ClosureOutcome::Closed);
    assert!(
        difference(&generated.q, &data.q) < 1e-12,
        "{generated:?} {data:?}"
    );
    let names = closed_loops.residuals.map(|residual| residual.name);
    assert_eq!(names, ["pin.x", "pin.y"]);
    let moved: [f64; 3] = from_fn(|k| data.q[k] - start[k]);
    assert!(largest(&moved) > 1e-3, "the start was closed");
}
