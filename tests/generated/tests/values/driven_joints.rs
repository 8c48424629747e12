//! Armature, damping and friction of every type of joint, a mimic joint included, with external wrenches on links: the
//! balance of power, and derivatives.
//!
//! Derivatives are compared with generated code on dual numbers along an integrated motion. The power lost by friction
//! is computed here once more, velocity by velocity.

use std::array::from_fn;

use homogen::{Action, Chain, Scalar, generic};
use homogen_tests::dual::Dual;
use homogen_tests::effort::effort;
use homogen_tests::functions::Block;
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(30, 100)
}

/// The numbers of velocities and coordinates.
const N: usize = 17;
const Q: usize = 19;

/// Both sides are sums of some hundred terms; the worst is 26 u.
const LIMIT: f64 = 128.0;

macro_rules! robot_with_actuators {
    ($name:ident, $external:tt) => {
        homogen::chain! {
            /// Joints with several velocities, a screw, and a gear that mimics a hinge.
            struct $name {
                external $external,
                generate(
                    inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
                    inverse_dynamics_derivatives, forward_dynamics_derivatives
                )
            }
            link world;
            joint puck: planar([0.0, 0.6, 0.8]) {
                from: world, to: puck, at: xyz(0.2, 0.0, 0.1) rpy(0.1, 0.2, 0.3),
                armature: [0.25, 0.5, 0.125], damping: [1.5, 2.0, 0.5], friction: 0.25
            }
            link puck { mass: 3.0, com: [0.05, 0.02, 0.1], inertia: [0.04, 0.001, 0.002, 0.05, -0.003, 0.06] }
            joint ball: spherical {
                from: puck, to: upper, at: xyz(0.1, -0.2, 0.3) rpy(0.5, -0.4, 0.3),
                armature: 0.0625, damping: [0.25, 0.5, 0.75], friction: [0.0, 0.125, 0.25]
            }
            link upper { mass: 2.0, com: [0.0, 0.1, 0.2], inertia: [0.03, 0.001, -0.002, 0.025, 0.001, 0.02] }
            joint hinge: revolute(y) {
                from: upper, to: fore, at: xyz(0.0, 0.05, 0.4) rpy(0.2, 0.0, 0.0),
                armature: 0.03125, damping: 0.75, friction: 0.5
            }
            link fore { mass: 1.0, com: [0.02, 0.0, 0.15], inertia: [0.01, 0.01, 0.003] }
            joint quill: cylindrical(z) {
                from: fore, to: quill, at: xyz(0.0, 0.02, 0.1) rpy(0.0, 0.3, 0.0),
                armature: [0.0, 0.5], damping: [0.125, 4.0], friction: [0.125, 1.0]
            }
            link quill { mass: 0.3, com: [0.01, 0.0, 0.03], inertia: [0.001, 0.001, 0.0005] }
            joint thread: screw([0.0, 0.28, 0.96], pitch: 0.02) {
                from: quill, to: tool, at: xyz(0.01, 0.0, 0.1), damping: 0.25, friction: 0.125
            }
            link tool { mass: 0.2, com: [0.0, 0.005, 0.02], inertia: [0.0004, 0.0004, 0.0002] }
            joint gear: revolute(x) {
                from: upper, to: gear, at: xyz(0.05, 0.0, 0.0), mimic: hinge, multiplier: -3.0, offset: 0.2,
                rotor: 1e-4, ratio: 10, damping: 0.5, friction: 0.25
            }
            link gear { mass: 0.2, com: [0.0, 0.01, 0.01], inertia: [0.0005, 0.0004, 0.0003] }
            joint tether: floating {
                from: puck, to: drone, at: xyz(0.0, 0.0, 1.0) rpy(0.0, 0.2, 0.0),
                armature: [0.5, 0.5, 0.5, 0.0, 0.125, 0.0], damping: 0.5, friction: [0.0, 0.25, 0.0, 0.125, 0.0, 0.0]
            }
            link drone { mass: 1.2, com: [0.0, 0.01, 0.02], inertia: [0.01, 0.0, 0.001, 0.012, 0.0, 0.02] }
            joint lift: prismatic([0.0, 0.6, 0.8]) {
                from: drone, to: pod, at: xyz(0.0, 0.0, -0.1), armature: 0.25, damping: 2.0, friction: 0.5
            }
            link pod { mass: 0.3, com: [0.0, 0.0, -0.05], inertia: [0.001, 0.001, 0.0008] }
        }
    };
}

robot_with_actuators!(WithActuators, (tool, gear, pod));
robot_with_actuators!(FromFrame0, (tool, gear, pod, frame = 0));

const LINKS: [&str; 3] = ["tool", "gear", "pod"];

/// The velocity of the hinge, and the ratio of the gear's velocity to it.
const HINGE: usize = 6;
const MULTIPLIER: f64 = -3.0;

/// Damping and friction of each velocity, as above.
const RESISTANCES: [[f64; 2]; N] = [
    [1.5, 0.25],
    [2.0, 0.25],
    [0.5, 0.25],
    [0.25, 0.0],
    [0.5, 0.125],
    [0.75, 0.25],
    [0.75, 0.5],
    [0.125, 0.125],
    [4.0, 1.0],
    [0.25, 0.125],
    [0.5, 0.0],
    [0.5, 0.25],
    [0.5, 0.0],
    [0.5, 0.125],
    [0.5, 0.0],
    [0.5, 0.0],
    [2.0, 0.5],
];

/// Wrenches of up to 8 N m and 8 N.
fn actions(random: &mut Random) -> [Action<f64>; 3] {
    let mut vector = || from_fn(|_| 8.0 * random.unit());
    [(); 3].map(|()| Action::new(vector(), vector()))
}

fn as_scalar<T: Scalar>(actions: &[Action<f64>; 3]) -> [Action<T>; 3] {
    actions.map(|action| Action::new(action.c().map(T::constant), action.f().map(T::constant)))
}

fn dot<const M: usize>(a: &[f64; M], b: &[f64; M]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// q that moves by `v`, with its derivative.
fn moving<const F: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    q: &[f64; Q],
    v: &[f64; N],
) -> [Dual; Q] {
    chain.integrate(&Dual::pairs(q, &[0.0; Q]), &Dual::pairs(&[0.0; N], v))
}

/// The power lost by damping q̇² + friction |q̇| of each joint at its own rate.
fn lost(qd: &[f64; N]) -> f64 {
    let power = |[damping, friction]: [f64; 2], rate: f64| {
        (damping * rate + friction * rate.signum()) * rate
    };
    let own = RESISTANCES.iter().zip(qd);
    let own: f64 = own
        .map(|(resistance, rate)| power(*resistance, *rate))
        .sum();
    own + power([0.5, 0.25], MULTIPLIER * qd[HINGE])
}

macro_rules! tests {
    ($module:ident, $robot:ident, $power:expr) => {
        mod $module {
            use super::*;

            /// The power of torques and external wrenches is the rate of energy plus the power lost by friction; in f32
            /// too.
            #[test]
            fn power_is_conserved() {
                let chain = $robot::chain();
                let mut random = Random::new(11);
                for _ in 0..count() {
                    let (state, actions) = (
                        State::<f64, N, Q>::of(&chain, &mut random),
                        actions(&mut random),
                    );
                    let State { q, qd, qdd } = &state;
                    let along = moving(&chain, q, qd);
                    let energy = $robot.kinetic_energy(&along, &Dual::pairs(qd, qdd))
                        + $robot.potential_energy(&along);
                    let external: f64 = (LINKS.iter().zip(&actions))
                        .map(|(link, action)| {
                            let frame = chain
                                .frame(link)
                                .expect("links with external wrenches are frames of the chain");
                            $power(&chain, &frame, q, qd, action)
                        })
                        .sum();
                    let narrow = state.to::<f32>();
                    let in_f32 = $robot.inverse_dynamics(
                        &narrow.q,
                        &narrow.qd,
                        &narrow.qdd,
                        &as_scalar::<f32>(&actions),
                    );
                    for (tau, tolerance) in [
                        ($robot.inverse_dynamics(q, qd, qdd, &actions), 1e-13),
                        (in_f32.map(f64::from), 1e-5),
                    ] {
                        let power = dot(&tau, qd) + external - lost(qd);
                        let scale = dot(&tau.map(f64::abs), &qd.map(f64::abs)) + 100.0;
                        assert!(
                            (energy.slope - power).abs() < tolerance * scale,
                            "{} {power}",
                            energy.slope
                        );
                    }
                    assert!(lost(qd) > 0.0);
                }
            }

            #[test]
            fn forward_dynamics_inverts_inverse_dynamics() {
                let chain = $robot::chain();
                let mut random = Random::new(12);
                let mut worst = Worst::in_units_of(DOUBLE);
                for _ in 0..count() {
                    let actions = actions(&mut random);
                    let State { q, qd, qdd } = State::<f64, N, Q>::of(&chain, &mut random);
                    let tau = $robot.inverse_dynamics(&q, &qd, &qdd, &actions);
                    let found = $robot.forward_dynamics(&q, &qd, &tau, &actions);
                    worst.note(&[Block::new("q̈", found)], &[Block::new("q̈", qdd)]);
                }
                println!("{worst}");
                // Entries of M are from 0.001 to 6: the worst is 73,000 u, or 3e-11 rad/s².
                worst.assert_within(3e5);
            }

            #[test]
            fn derivatives_are_those_of_dual_numbers() {
                let chain = $robot::chain();
                let mut random = Random::new(13);
                let mut worst = Worst::in_units_of(DOUBLE);
                let unit = |k: usize| from_fn(|i| if i == k { 1.0 } else { 0.0 });
                for _ in 0..count() / 10 {
                    let actions = actions(&mut random);
                    let State { q, qd, qdd } = State::<f64, N, Q>::of(&chain, &mut random);
                    let tau: [f64; N] = from_fn(|k| 3.0 * qdd[N - 1 - k]);
                    let by = $robot.inverse_dynamics_derivatives(&q, &qd, &qdd, &actions);
                    let solved = $robot.forward_dynamics_derivatives(&q, &qd, &tau, &actions);
                    let still = Dual::pairs(&q, &[0.0; Q]);
                    let [velocity, acceleration, torque] =
                        [&qd, &qdd, &tau].map(|list| Dual::pairs(list, &[0.0; N]));
                    let pushed = as_scalar::<Dual>(&actions);
                    for k in 0..N {
                        let along = moving(&chain, &q, &unit(k));
                        let faster = Dual::pairs(&qd, &unit(k));
                        let column = |rows: &[[f64; N]; N]| rows.map(|row| row[k]);
                        for (name, found, expected) in [
                            (
                                "∂τ/∂q",
                                column(&by.dq),
                                $robot.inverse_dynamics(&along, &velocity, &acceleration, &pushed),
                            ),
                            (
                                "∂τ/∂q̇",
                                column(&by.dqd),
                                $robot.inverse_dynamics(&still, &faster, &acceleration, &pushed),
                            ),
                            (
                                "∂q̈/∂q",
                                column(&solved.dq),
                                $robot.forward_dynamics(&along, &velocity, &torque, &pushed),
                            ),
                            (
                                "∂q̈/∂q̇",
                                column(&solved.dqd),
                                $robot.forward_dynamics(&still, &faster, &torque, &pushed),
                            ),
                        ] {
                            worst.note(
                                &[Block::new(name, found)],
                                &[Block::new(name, expected.map(|dual| dual.slope))],
                            );
                        }
                    }
                }
                println!("{worst}");
                worst.assert_within(LIMIT);
            }
        }
    };
}

type Frame = homogen::Frame;

/// The power of a wrench in the link's frame, by its torques on the joints.
fn power_in_link_frame<const F: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[f64; Q],
    qd: &[f64; N],
    action: &Action<f64>,
) -> f64 {
    dot(&generic::torques_of_wrench(chain, frame, q, action), qd)
}

/// The power of a wrench in frame 0: W ⊗ Φ.
fn power_in_frame_0<const F: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[f64; Q],
    qd: &[f64; N],
    action: &Action<f64>,
) -> f64 {
    let w = generic::velocity(chain, frame, q, qd);
    dot(&w.omega(), &action.c()) + dot(&w.v(), &action.f())
}

tests!(in_the_frames_of_links, WithActuators, power_in_link_frame);
tests!(in_frame_0, FromFrame0, power_in_frame_0);

/// The generic recursions read armature, damping and friction as data.
#[test]
fn the_generic_recursions_give_the_same() {
    let chain = WithActuators::chain();
    let mut random = Random::new(14);
    let mut worst = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let State { q, qd, qdd } = State::<f64, N, Q>::of(&chain, &mut random);
        let nothing = [Action::zero(); 3];
        let by = WithActuators.inverse_dynamics_derivatives(&q, &qd, &qdd, &nothing);
        let expected = generic::inverse_dynamics_derivatives(&chain, &q, &qd, &qdd);
        let tau = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        let found = [
            Block::new("τ", WithActuators.inverse_dynamics(&q, &qd, &qdd, &nothing)),
            Block::new("∂τ/∂q", by.dq.as_flattened().to_vec()),
            Block::new("∂τ/∂q̇", by.dqd.as_flattened().to_vec()),
            Block::new("energy", [WithActuators.kinetic_energy(&q, &qd)]),
        ];
        let expected = [
            Block::new("τ", tau),
            Block::new("∂τ/∂q", expected.dq.as_flattened().to_vec()),
            Block::new("∂τ/∂q̇", expected.dqd.as_flattened().to_vec()),
            Block::new("energy", [generic::kinetic_energy(&chain, &q, &qd)]),
        ];
        worst.note(&found, &expected);
    }
    println!("{worst}");
    worst.assert_within(LIMIT);
}
