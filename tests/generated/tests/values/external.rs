//! External wrenches as an argument: compared with the generic recursions, and by their power.

use std::array::from_fn;

use homogen::robot::InverseDynamics;
use homogen::{Action, Robot, Scalar, generic};
use homogen_tests::dual::Dual;
use homogen_tests::effort::effort;
use homogen_tests::functions::Block;
use homogen_tests::rounding::{DOUBLE, SINGLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(50, 200)
}

/// An arm with external wrenches on its hand and its elbow, and friction at one joint.
macro_rules! panda {
    ($name:ident, $external:tt, $formulation:tt) => {
        #[derive(Robot)]
        #[robot(
            urdf = "../../robots/panda_class.urdf",
            tip = "link8",
            friction(joint4 = 0.5)
        )]
        #[robot(external $external, formulation $formulation)]
        #[robot(generate(inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy))]
        struct $name;
    };
}

panda!(Panda, ("link8", link3), ());
panda!(Bodies, (link8, link3), (articulated));
panda!(InFrame0, (link8, link3), (frame_0, raw, refined = 1));
panda!(FromFrame0, (link8, link3, frame = 0), ());
panda!(
    Everything0,
    (link8, link3, frame = 0),
    (frame_0, raw, refined = 1)
);

/// Wrenches of up to 8 N m and 8 N.
fn actions(random: &mut Random) -> [Action<f64>; 2] {
    let mut vector = || from_fn(|_| 8.0 * random.unit());
    [(); 2].map(|()| Action::new(vector(), vector()))
}

/// τ of a state under wrenches in the frames of the links.
fn expected(state: &State<f64, 7>, actions: &[Action<f64>; 2]) -> [f64; 7] {
    let chain = Panda::chain();
    let State { q, qd, qdd } = state;
    let mut tau = generic::inverse_dynamics(&chain, q, qd, qdd);
    for (link, action) in ["link8", "link3"].into_iter().zip(actions) {
        let frame = chain
            .frame(link)
            .expect("links with external wrenches are frames of the chain");
        let of_action = generic::torques_of_wrench(&chain, &frame, q, action);
        tau = from_fn(|k| tau[k] - of_action[k]);
    }
    tau
}

/// The same wrenches in frame 0: M Φ Mᵗ.
fn in_frame_0(q: &[f64; 7], actions: &[Action<f64>; 2]) -> [Action<f64>; 2] {
    let chain = Panda::chain();
    let links = ["link8", "link3"];
    from_fn(|k| {
        let frame = chain.frame(links[k]).expect("a frame");
        let pose = generic::forward_kinematics(&chain, &frame, q);
        let rotated = |v: [f64; 3]| {
            pose.rotation()
                .map(|row| row.iter().zip(v).map(|(r, x)| r * x).sum::<f64>())
        };
        let (c, f) = (rotated(actions[k].c()), rotated(actions[k].f()));
        Action::new(c, f) + Action::of_force(f, pose.translation()) - Action::new([0.0; 3], f)
    })
}

#[test]
fn external_wrenches_reduce_the_torques() {
    let mut random = Random::new(7);
    let mut worst = Worst::in_units_of(DOUBLE);
    let mut single = Worst::in_units_of(SINGLE);
    for _ in 0..count() {
        let (state, actions) = (State::random(&mut random), actions(&mut random));
        let State { q, qd, qdd } = &state;
        let tau = [Block::new("τ", expected(&state, &actions))];
        let outer = in_frame_0(q, &actions);
        for found in [
            Panda.inverse_dynamics(q, qd, qdd, &actions),
            InFrame0.inverse_dynamics(q, qd, qdd, &actions),
            FromFrame0.inverse_dynamics(q, qd, qdd, &outer),
            Everything0.inverse_dynamics(q, qd, qdd, &outer),
        ] {
            worst.note(&[Block::new("τ", found)], &tau);
        }
        let narrow = state.to::<f32>();
        let in_f32 = actions.map(|action| {
            let narrow = |v: [f64; 3]| v.map(f32::constant);
            Action::new(narrow(action.c()), narrow(action.f()))
        });
        let found = Panda.inverse_dynamics(&narrow.q, &narrow.qd, &narrow.qdd, &in_f32);
        single.note(&[Block::new("τ", found.map(f64::from))], &tau);
    }
    println!("{worst}{single}");
    worst.assert_within(64.0);
    single.assert_within(16.0);
}

#[test]
fn forward_dynamics_inverts_inverse_dynamics() {
    let mut random = Random::new(8);
    for _ in 0..count() {
        let (state, actions) = (State::random(&mut random), actions(&mut random));
        let State { q, qd, qdd } = &state;
        let tau = expected(&state, &actions);
        let outer = in_frame_0(q, &actions);
        for found in [
            Panda.forward_dynamics(q, qd, &tau, &actions),
            Bodies.forward_dynamics(q, qd, &tau, &actions),
            InFrame0.forward_dynamics(q, qd, &tau, &actions),
            FromFrame0.forward_dynamics(q, qd, &tau, &outer),
            Everything0.forward_dynamics(q, qd, &tau, &outer),
        ] {
            for (found, given) in found.into_iter().zip(qdd) {
                assert!((found - given).abs() < 1e-8, "{found} {given}");
            }
        }
    }
}

/// A controller that is generic over robots has no external wrenches.
#[test]
fn the_trait_method_has_no_external_wrenches() {
    fn torques<R: InverseDynamics<7, f64>>(robot: &R, state: &State<f64, 7>) -> [f64; 7] {
        robot.inverse_dynamics(&state.q, &state.qd, &state.qdd)
    }
    let state = State::random(&mut Random::new(9));
    let State { q, qd, qdd } = &state;
    let without = Panda.inverse_dynamics(q, qd, qdd, &[Action::zero(); 2]);
    assert_eq!(torques(&Panda, &state), without);
}

/// The power of torques and external wrenches is the rate of energy plus the power lost by friction.
#[test]
fn power_is_conserved() {
    let chain = Panda::chain();
    let mut random = Random::new(10);
    for _ in 0..count() {
        let (state, actions) = (State::random(&mut random), actions(&mut random));
        let State { q, qd, qdd } = &state;
        let moving = Dual::pairs(q, qd);
        let energy =
            Panda.kinetic_energy(&moving, &Dual::pairs(qd, qdd)) + Panda.potential_energy(&moving);
        let tau = Panda.inverse_dynamics(q, qd, qdd, &actions);
        let mut power: f64 = tau.iter().zip(qd).map(|(tau, qd)| tau * qd).sum();
        power -= 0.5 * qd[3].abs();
        for (link, action) in ["link8", "link3"].into_iter().zip(in_frame_0(q, &actions)) {
            let frame = chain.frame(link).expect("a frame");
            let w = generic::velocity(&chain, &frame, q, qd);
            let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            power += dot(w.omega(), action.c()) + dot(w.v(), action.f());
        }
        let scale = power.abs() + 1000.0;
        assert!(
            (energy.slope - power).abs() < 1e-13 * scale,
            "{} {power}",
            energy.slope
        );
    }
}
