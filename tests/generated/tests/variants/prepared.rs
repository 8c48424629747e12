//! Prepared robots: all that depends on fields alone is computed once, and functions give the same bits.

use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives, MassMatrixInverse, Regressor};
use homogen::{Payload, Robot, Scalar};
use homogen_robots::with_every_function;
use homogen_tests::effort::effort;
use homogen_tests::functions::{EveryFunction, evaluate};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(20, 50)
}

/// Derives an arm with the functions that are compared.
macro_rules! panda {
    ([$($function:ident),*] $($struct:tt)*) => {
        #[derive(Robot)]
        #[robot(urdf = "../../robots/panda_class.urdf", tip = "link8", prepare)]
        #[robot(generate(
            $($function,)*
            forward_dynamics, mass_matrix_inverse, forward_dynamics_derivatives, regressor
        ))]
        $($struct)*
    };
}

with_every_function! { panda!
    /// An arm with many fields.
    struct Panda {
        #[robot(mass_of = "link5")]
        mass: f64,
        #[robot(com_of = "link5")]
        center: [f64; 3],
        #[robot(inertia_of = "link6")]
        inertia: [f64; 6],
        #[robot(payload_on = "link8")]
        tool: Payload,
        #[robot(origin_of = "joint4")]
        origin: [f64; 3],
        #[robot(base_position)]
        base: [f64; 3],
        #[robot(placement_of = "joint6")]
        wrist: [f64; 6],
        #[robot(gravity)]
        gravity: [f64; 3],
    }
}

const PANDA: Panda = Panda {
    mass: 2.75,
    center: [0.03, -0.07, 0.11],
    inertia: [0.021, 0.003, -0.002, 0.018, 0.001, 0.015],
    tool: Payload {
        mass: 0.75,
        center: [0.02, -0.05, 0.08],
        inertia: [0.004, 0.0002, -0.0003, 0.005, 0.0001, 0.003],
    },
    origin: [0.09, 0.01, -0.02],
    base: [0.4, -1.1, 0.7],
    wrist: [0.01, 0.02, -0.03, 1.5, 0.1, -0.2],
    gravity: [1.0, -2.0, 3.0],
};

/// Results of these functions, one number after the other.
fn all<T: Scalar, R, const P: usize>(robot: &R, state: &State<T, 7>) -> Vec<T>
where
    R: EveryFunction<7, T>
        + ForwardDynamics<7, T>
        + MassMatrixInverse<7, T>
        + ForwardDynamicsDerivatives<7, T>
        + Regressor<7, P, T>,
{
    let State { q, qd, qdd } = state;
    let blocks = evaluate(robot, state).into_iter();
    let mut numbers: Vec<T> = blocks.flat_map(|block| block.entries).collect();
    numbers.extend(robot.forward_dynamics(q, qd, qdd));
    numbers.extend(robot.mass_matrix_inverse(q).as_flattened());
    let by = robot.forward_dynamics_derivatives(q, qd, qdd);
    let parts = [by.dq, by.dqd, by.dtau];
    numbers.extend(parts.as_flattened().as_flattened());
    numbers.extend(robot.regressor(q, qd, qdd).as_flattened());
    numbers
}

#[test]
fn every_function_keeps_its_bits_in_both_precisions() {
    let (double, single) = (PANDA.prepare::<f64>(), PANDA.prepare::<f32>());
    let mut random = Random::new(1);
    for _ in 0..count() {
        let state: State<f64, 7> = State::random(&mut random);
        let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(all(&double, &state)), bits(all(&PANDA, &state)));
        let state = state.to::<f32>();
        let bits = |numbers: Vec<f32>| numbers.into_iter().map(f32::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(all(&single, &state)), bits(all(&PANDA, &state)));
    }
}

#[test]
fn a_prepared_robot_keeps_the_values_of_its_fields() {
    let mut panda = PANDA;
    let before = panda.prepare();
    let q = [0.25; 7];
    panda.tool.mass = 3.0;
    let (loaded, kept): ([f64; 7], [f64; 7]) = (panda.gravity(&q), before.gravity(&q));
    assert_eq!(kept, PANDA.gravity(&q));
    assert!((loaded[1] - kept[1]).abs() > 0.5, "{loaded:?} {kept:?}");
    assert_eq!(panda.prepare().gravity(&q), loaded);
}

/// A struct with a type parameter, fields for actuators, functions generated together and a further frame, in single
/// precision.
#[derive(Robot)]
#[robot(
    urdf = "../../robots/two_link.urdf",
    tip = "tip",
    frames("fore"),
    scalar = f32,
    prepare,
    generate(all_of(mass_matrix, bias), forward_kinematics)
)]
struct Loaded<T: Copy>
where
    f64: From<T>,
{
    #[robot(mass_of = "fore")]
    mass: T,
    #[robot(origin_of = "elbow")]
    reach: [T; 3],
    #[robot(armature_of = "elbow")]
    armature: T,
    #[robot(damping_of = "shoulder")]
    damping: T,
    #[robot(friction_of = "shoulder")]
    friction: T,
}

#[test]
fn functions_generated_together_and_further_frames_are_prepared() {
    let arm = Loaded {
        mass: 1.75_f32,
        reach: [0.5, 0.1, -0.2],
        armature: 0.125,
        damping: 0.5,
        friction: 0.25,
    };
    let prepared = arm.prepare();
    let (q, qd) = ([0.3, -0.8], [1.5, 0.4]);
    assert_eq!(
        prepared.mass_matrix_and_bias(&q, &qd),
        arm.mass_matrix_and_bias(&q, &qd)
    );
    assert_eq!(prepared.forward_kinematics(&q), arm.forward_kinematics(&q));
    assert_eq!(
        prepared.forward_kinematics_of_fore(&q),
        arm.forward_kinematics_of_fore(&q)
    );
}

/// A floating base with an external wrench.
#[derive(Robot)]
#[robot(
    floating,
    prepare,
    external("body"),
    generate(inverse_dynamics, forward_dynamics),
    link body { mass: 1.5, inertia: [0.03, 0.03, 0.05] },
    link pole { mass: 0.2, com: [0.0, 0.0, 0.3], inertia: [0.01, 0.01, 0.001] },
    joint hinge: revolute(x) { from: body, to: pole, at: xyz(0.0, 0.0, 0.1) }
)]
struct Drone {
    #[robot(payload_on = "pole")]
    load: Payload,
}

#[test]
fn a_floating_robot_is_prepared_with_its_integration_and_external_wrenches() {
    let drone = Drone {
        load: Payload::of_point(0.5, [0.0, 0.01, 0.6]),
    };
    let prepared = drone.prepare();
    let q = prepared.integrate(&prepared.neutral(), &[0.1, -0.2, 0.3, 0.4, 0.5, -0.6, 0.7]);
    let (qd, tau) = ([0.25; 7], [0.0, 0.0, 20.0, 0.0, 0.1, 0.0, 0.0]);
    let actions = [homogen::Action::new([0.1, 0.2, 0.3], [1.0, 2.0, 3.0])];
    let qdd: [f64; 7] = drone.forward_dynamics(&q, &qd, &tau, &actions);
    assert_eq!(prepared.forward_dynamics(&q, &qd, &tau, &actions), qdd);
    assert_eq!(
        prepared.inverse_dynamics(&q, &qd, &qdd, &actions),
        drone.inverse_dynamics(&q, &qd, &qdd, &actions)
    );
}
