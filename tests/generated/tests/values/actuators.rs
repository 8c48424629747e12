//! Armature, rotors behind gears, viscous and Coulomb friction in generated code, compared with the generic recursions,
//! Pinocchio's numbers, and the power lost by friction; with every key for them, and with every algorithm of forward
//! dynamics.

use homogen::robot::{ForwardDynamics, MassMatrixInverse};
use homogen::{Chain, JointActuator, Real, Robot, generic};
use homogen_robots::with_every_function;
use homogen_tests::dual::Dual;
use homogen_tests::effort::effort;
use homogen_tests::functions::{Block, EveryFunction, evaluate};
use homogen_tests::rounding::{DOUBLE, SINGLE, Worst};
use homogen_tests::states::{Random, State};
use serde_json::Value;

/// States of each robot.
fn count() -> usize {
    effort(15, 200)
}

/// The Stanford arm without a zero among its inertial parameters, with the armature and friction of reference/make.py;
/// the armature of joint 2 as a rotor behind a gear.
macro_rules! stanford {
    ([$($function:ident),*] $name:ident $(, $more:tt)*) => {
        #[derive(Robot)]
        #[robot(urdf = "../../robots/stanford_general.urdf", tip = "tool")]
        #[robot(generate($($function,)* forward_dynamics, mass_matrix_inverse))]
        #[robot(armature(joint_1 = 0.95, joint_3 = 0.78, joint_4 = 0.11, joint_5 = 0.1, joint_6 = 0.02))]
        #[robot(rotor(joint_2 = 2.2e-4), ratio(joint_2 = 100))]
        #[robot(damping(joint_1 = 3.5, joint_2 = 2.0, joint_3 = 6.25, joint_4 = 0.5, joint_6 = 0.25))]
        #[robot(friction(joint_1 = 1.25, joint_3 = 4.5, joint_4 = 0.75, "joint_5" = [0.5], joint_6 = 0.125))]
        $(#[robot $more])*
        struct $name;
    };
}

with_every_function!(stanford! Stanford);
with_every_function!(stanford! InFrame0, (formulation(frame_0, raw)));
stanford!([] Refined, (formulation(refined = 1)));
stanford!([] Bodies, (formulation(articulated)));

/// The same, with three of the numbers as struct fields.
macro_rules! with_fields {
    ([$($function:ident),*]) => {
        #[derive(Robot)]
        #[robot(urdf = "../../robots/stanford_general.urdf", tip = "tool")]
        #[robot(generate($($function,)* forward_dynamics, mass_matrix_inverse))]
        #[robot(armature(joint_1 = 0.95, joint_3 = 0.78, joint_4 = 0.11, joint_5 = 0.1, joint_6 = 0.02))]
        #[robot(damping(joint_1 = 3.5, joint_2 = 2.0, joint_4 = 0.5, joint_6 = 0.25))]
        #[robot(friction(joint_1 = 1.25, joint_3 = 4.5, joint_4 = 0.75, joint_6 = 0.125))]
        struct Fields {
            #[robot(armature_of = "joint_2", range = 4.0)]
            shoulder: f64,
            #[robot(damping_of = "joint_3")]
            rail: f64,
            #[robot(friction_of = "joint_5", range = 0.0..=1.0)]
            wrist: f64,
        }
    };
}
with_every_function!(with_fields!);

const FIELDS: Fields = Fields {
    shoulder: 2.2,
    rail: 6.25,
    wrist: 0.5,
};

homogen::chain! {
    /// A quill with different actuators for its two velocities, on an arm.
    struct Quill { generate(inverse_dynamics, bias, gravity, mass_matrix, forward_dynamics, mass_matrix_inverse, kinetic_energy) }
    link base;
    joint arm: revolute(y) { armature: 0.2, damping: 0.5, friction: 0.125 }
    link upper { mass: 2.0, com: [0.1, 0.02, 0.0], inertia: [0.02, 0.03, 0.04] }
    joint quill: cylindrical(z) { at: xyz(0.3, 0.0, 0.1), rotor: [1e-4, 2e-4], ratio: [10, 100], damping: [0.25, 8.0], friction: 0.5 }
    link tool { mass: 0.5, com: [0.03, 0.0, 0.1], inertia: [0.002, 0.003, 0.004] }
}

homogen::chain! {
    /// A massless arm: its inertia is that of its armatures.
    struct Massless { generate(forward_dynamics, inverse_dynamics) }
    link base;
    joint shoulder: revolute(y) { armature: 1e-6 }
    link upper { mass: 0.0, inertia: [0.0, 0.0, 0.0] }
    joint elbow: revolute(z) { at: xyz(0.3, 0.0, 0.0), armature: 1e-6 }
    link fore { mass: 0.0, inertia: [0.0, 0.0, 0.0] }
}

/// A random state in which every third joint is at rest.
fn state<const N: usize>(random: &mut Random, number: usize) -> State<f64, N> {
    let mut state = State::random(random);
    for (k, rate) in state.qd.iter_mut().enumerate() {
        if (number + k).is_multiple_of(3) {
            *rate = if number.is_multiple_of(2) { 0.0 } else { -0.0 };
        }
    }
    state
}

fn agree<R, T: Real, const N: usize, const F: usize>(robot: &R, chain: &Chain<N, F>, unit: f64)
where
    R: EveryFunction<N, T>,
{
    let mut random = Random::new(3);
    let mut worst = Worst::in_units_of(unit);
    for number in 0..count() {
        let state = state(&mut random, number);
        let found = evaluate(robot, &state.to::<T>());
        let found: Vec<Block<f64>> = found.iter().map(|block| block.map(T::to_f64)).collect();
        worst.note(&found, &evaluate(chain, &state));
    }
    println!("{worst}");
    // The worst is 12 u, mostly of the dense products.
    worst.assert_within(64.0);
}

#[test]
fn generated_code_agrees_with_the_generic_recursions() {
    let chain = Stanford::chain();
    agree::<_, f64, 6, 1>(&Stanford, &chain, DOUBLE);
    agree::<_, f32, 6, 1>(&Stanford, &chain, SINGLE);
    agree::<_, f64, 6, 1>(&InFrame0, &chain, DOUBLE);
    agree::<_, f64, 6, 1>(&FIELDS, &FIELDS.chain(), DOUBLE);
    agree::<_, f64, 6, 1>(&FIELDS, &chain, DOUBLE);
}

/// Compares q̈ of the torques that it needs, and M⁻¹ with that of the generic recursions.
fn inverts<R, const N: usize, const F: usize>(robot: &R, chain: &Chain<N, F>, tolerance: f64)
where
    R: ForwardDynamics<N, f64> + MassMatrixInverse<N, f64>,
{
    let mut random = Random::new(4);
    for number in 0..count() {
        let State { q, qd, qdd } = state(&mut random, number);
        let tau = generic::inverse_dynamics(chain, &q, &qd, &qdd);
        let found = robot.forward_dynamics(&q, &qd, &tau);
        for (found, given) in found.into_iter().zip(qdd) {
            assert!((found - given).abs() <= tolerance, "{found} {given}");
        }
        let inverse = generic::mass_matrix_inverse(chain, &q);
        let found = robot.mass_matrix_inverse(&q);
        for (found, exact) in found.as_flattened().iter().zip(inverse.as_flattened()) {
            assert!((found - exact).abs() <= tolerance, "{found} {exact}");
        }
    }
}

#[test]
fn every_algorithm_of_forward_dynamics_inverts_inverse_dynamics() {
    let chain = Stanford::chain();
    inverts(&Stanford, &chain, 1e-10);
    inverts(&Refined, &chain, 1e-10);
    inverts(&Bodies, &chain, 1e-10);
    inverts(&InFrame0, &chain, 1e-10);
    inverts(&FIELDS, &chain, 1e-10);
    inverts(&Quill, &Quill::chain(), 1e-10);
}

#[test]
fn each_velocity_of_a_joint_has_its_own_actuator() {
    let actuators = Quill::chain().joints.map(|joint| {
        [
            joint.actuators[0].armature,
            joint.actuators[0].damping,
            joint.actuators[0].friction,
        ]
        .map(|number| (number * 1e6).round() / 1e6)
    });
    assert_eq!(
        actuators,
        [[0.2, 0.5, 0.125], [0.01, 0.25, 0.5], [2.0, 8.0, 0.5]]
    );
    let (q, qd) = ([0.3, 0.2, 0.1], [0.0, -2.0, 4.0]);
    let [rest, moving] = [&[0.0; 3], &qd].map(|qd| Quill.bias(&q, qd));
    let without = Chain {
        joints: Quill::chain()
            .joints
            .map(|joint| joint.with_actuator(0, JointActuator::NONE)),
        ..Quill::chain()
    };
    let bodies = generic::bias(&without, &q, &qd);
    for (k, torque) in [0.0, -1.0, 32.5].into_iter().enumerate() {
        assert!((moving[k] - bodies[k] - torque).abs() < 1e-13, "joint {k}");
    }
    for (rest, gravity) in rest.into_iter().zip(Quill.gravity(&q)) {
        assert!((rest - gravity).abs() < 1e-14, "friction at rest");
    }
}

/// The power of torques is the rate of energy plus the power lost by friction.
#[test]
fn power_is_conserved() {
    let mut random = Random::new(5);
    let joints = Stanford::chain().joints;
    for number in 0..count() {
        let State { q, qd, qdd } = state::<6>(&mut random, number);
        let moving = Dual::pairs(&q, &qd);
        let energy = Stanford.kinetic_energy(&moving, &Dual::pairs(&qd, &qdd))
            + Stanford.potential_energy(&moving);
        let tau = Stanford.inverse_dynamics(&q, &qd, &qdd);
        let power: f64 = tau.iter().zip(&qd).map(|(tau, qd)| tau * qd).sum();
        let lost = joints.iter().zip(&qd);
        let lost = lost.map(|(joint, qd)| {
            joint.actuators[0].damping * qd * qd + joint.actuators[0].friction * qd.abs()
        });
        let lost: f64 = lost.sum();
        assert!(lost > 0.0);
        let scale = power.abs() + lost + 100.0;
        assert!(
            (energy.slope - power + lost).abs() < 1e-13 * scale,
            "{number}"
        );
    }
}

/// Armature alone makes M regular and determines the accelerations.
#[test]
fn a_massless_arm_accelerates_by_its_armature() {
    let found = Massless.forward_dynamics(&[0.3, 0.2], &[0.1, -0.2], &[1e-6, -2e-6]);
    for (found, exact) in found.into_iter().zip([1.0, -2.0]) {
        assert!((found - exact).abs() < 1e-14, "{found}");
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|number| number.as_f64().expect("a number"))
        .collect()
}

/// Armatures are Pinocchio's own; friction is added to its results.
#[test]
fn generated_code_agrees_with_pinocchio() {
    let text = include_str!("../../../reference/stanford_general_driven.json");
    let reference: Value = serde_json::from_str(text).expect("JSON");
    let chain = Stanford::chain();
    let armatures: Vec<f64> = chain
        .joints
        .iter()
        .map(|joint| joint.actuators[0].armature)
        .collect();
    assert_eq!(armatures, numbers(&reference["armature"]));
    let mut worst = Worst::in_units_of(DOUBLE);
    for state in reference["states"].as_array().expect("states") {
        let vector = |field: &str| -> [f64; 6] {
            numbers(&state[field])
                .try_into()
                .expect("as many numbers as joints")
        };
        let [q, qd, qdd, torque] = ["q", "v", "a", "torque"].map(vector);
        let mass = Stanford.mass_matrix(&q);
        let upper = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
        let upper = upper.map(|(i, j)| mass[i][j]);
        let found = [
            Block::new("tau", Stanford.inverse_dynamics(&q, &qd, &qdd)),
            Block::new("bias", Stanford.bias(&q, &qd)),
            Block::new("gravity_torque", Stanford.gravity(&q)),
            Block::new("M_upper", upper),
            Block::new("ddq", Stanford.forward_dynamics(&q, &qd, &torque)),
            Block::new("ddq", Bodies.forward_dynamics(&q, &qd, &torque)),
            Block::new("ddq", Refined.forward_dynamics(&q, &qd, &torque)),
            Block::new("kinetic_energy", [Stanford.kinetic_energy(&q, &qd)]),
        ];
        let expected = found.each_ref().map(|block| match &state[&block.name] {
            number @ Value::Number(_) => Block::new(&block.name, number.as_f64()),
            list => Block::new(&block.name, numbers(list)),
        });
        worst.note(&found, &expected);
    }
    println!("{worst}");
    // The worst is 40 u, of q̈.
    worst.assert_within(300.0);
}
