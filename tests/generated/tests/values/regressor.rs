//! Regressors of every robot that ships: generated code compared with the generic recursions, and both with torques and
//! energies, which are linear in the inertial parameters; derivatives of accelerations by the parameters.
//!
//! Errors are in units of rounding times the largest entry in any state.

use homogen::{Chain, Inertia, JointActuator, Robot, generic, robot};
use homogen_robots::shipped::{
    PandaClass, Puma560, Puma560General, Quadruped, Scara, Stanford, StanfordGeneral, TwoLink,
    Ur5Class,
};
use homogen_tests::effort::effort;
use homogen_tests::functions::Block;
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(50, 200)
}

/// As for other functions.
const LIMIT: f64 = 64.0;

/// For torques as sums of up to 120 terms that cancel.
const LIMIT_OF_TORQUES: f64 = 400.0;

/// For products with M⁻¹.
const LIMIT_OF_ACCELERATIONS: f64 = 2e3;

/// A robot with regressors and what is linear in its parameters.
trait Regressed<const N: usize, const P: usize, const B: usize>:
    robot::Regressor<N, P>
    + robot::BaseRegressor<N, B>
    + robot::InverseDynamics<N>
    + robot::KineticEnergyRegressor<N, P>
    + robot::KineticEnergy<N>
    + robot::PotentialEnergyRegressor<N, P>
    + robot::PotentialEnergy<N>
{
}

impl<R, const N: usize, const P: usize, const B: usize> Regressed<N, P, B> for R where
    R: robot::Regressor<N, P>
        + robot::BaseRegressor<N, B>
        + robot::InverseDynamics<N>
        + robot::KineticEnergyRegressor<N, P>
        + robot::KineticEnergy<N>
        + robot::PotentialEnergyRegressor<N, P>
        + robot::PotentialEnergy<N>
{
}

/// m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz of each body; then armature, damping and friction of each
/// joint, for regressors that have columns for them.
fn parameters<const N: usize, const F: usize>(chain: &Chain<N, F>) -> Vec<f64> {
    let bodies = chain.joints.iter().flat_map(|joint| {
        let [
            [xx, xy, xz, qx],
            [_, yy, yz, qy],
            [_, _, zz, qz],
            [_, _, _, m],
        ] = joint.inertia.to_matrix();
        [m, qx, qy, qz, xx, xy, xz, yy, yz, zz]
    });
    let actuators = chain.joints.iter().flat_map(|joint| {
        let JointActuator {
            armature,
            damping,
            friction,
        } = joint.actuators[0];
        [armature, damping, friction]
    });
    bodies.chain(actuators).collect()
}

fn times<const P: usize>(rows: &[[f64; P]], parameters: &[f64]) -> Vec<f64> {
    let rows = rows.iter();
    rows.map(|row| row.iter().zip(parameters).map(|(y, x)| y * x).sum())
        .collect()
}

fn hold<R, const N: usize, const P: usize, const B: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    base_parameters: &[f64; B],
) where
    R: Regressed<N, P, B>,
{
    let described = parameters(chain);
    let mut random = Random::new(7);
    let mut entries = Worst::in_units_of(DOUBLE);
    let mut torques = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let State { q, qd, qdd } = State::<f64, N>::random(&mut random);
        let generated: [[f64; P]; N] = robot.regressor(&q, &qd, &qdd);
        let generic: [[f64; P]; N] = robot::Regressor::regressor(chain, &q, &qd, &qdd);
        let block = |name, entries: Vec<f64>| [Block::new(name, entries)];
        entries.note(
            &block("Y", generated.as_flattened().to_vec()),
            &block("Y", generic.as_flattened().to_vec()),
        );
        let kinetic: [[f64; P]; 2] = [
            robot.kinetic_energy_regressor(&q, &qd),
            robot::KineticEnergyRegressor::kinetic_energy_regressor(chain, &q, &qd),
        ];
        let potential: [[f64; P]; 2] = [
            robot.potential_energy_regressor(&q),
            robot::PotentialEnergyRegressor::potential_energy_regressor(chain, &q),
        ];
        for (name, [generated, generic]) in [("T", kinetic), ("U", potential)] {
            entries.note(
                &block(name, generated.to_vec()),
                &block(name, generic.to_vec()),
            );
        }
        let energies = [robot.kinetic_energy(&q, &qd), robot.potential_energy(&q)];
        let of_parameters = [kinetic, potential].map(|[row, _]| times(&[row], &described)[0]);
        let names = ["y π = T", "y π = U"].into_iter();
        for (name, (found, energy)) in names.zip(of_parameters.into_iter().zip(energies)) {
            torques.note(&block(name, vec![found]), &block(name, vec![energy]));
        }
        let tau = robot.inverse_dynamics(&q, &qd, &qdd).to_vec();
        let base: [[f64; B]; N] = robot.base_regressor(&q, &qd, &qdd);
        torques.note(
            &block("Y π = τ", times(&generated, &described)),
            &block("Y π = τ", tau.clone()),
        );
        torques.note(
            &block("Y π = τ of base parameters", times(&base, base_parameters)),
            &block("Y π = τ of base parameters", tau),
        );
    }
    println!("{entries}{torques}");
    entries.assert_within(LIMIT);
    torques.assert_within(LIMIT_OF_TORQUES);
}

/// Columns of actuators are behind those of links; armatures of joints 1 and 2 are grouped with moments of their links.
#[derive(Robot)]
#[robot(urdf = "../../robots/puma560_general.urdf")]
#[robot(armature(
    joint_1 = 1.14,
    joint_2 = 4.71,
    joint_3 = 0.83,
    joint_4 = 0.2,
    joint_5 = 0.18,
    joint_6 = 0.19
))]
#[robot(
    damping(joint_1 = 4.9, joint_3 = 3.2, joint_6 = 0.6),
    friction(joint_2 = 6.5, joint_4 = 0.8)
)]
#[robot(generate(
    inverse_dynamics,
    kinetic_energy,
    potential_energy,
    regressor,
    base_regressor,
    kinetic_energy_regressor,
    potential_energy_regressor,
    forward_dynamics,
    forward_dynamics_parameter_derivatives
))]
struct WithActuators;

/// ∂q̈/∂π beside the generic recursions, and beside a difference of q̈ at parameters that differ.
#[test]
fn accelerations_change_with_the_parameters() {
    let chain = WithActuators::chain();
    let mut random = Random::new(11);
    let mut entries = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let State { q, qd, qdd: tau } = State::<f64, 6>::random(&mut random);
        let tau = tau.map(|entry| 10.0 * entry);
        let generated: [[f64; 78]; 6] =
            WithActuators.forward_dynamics_parameter_derivatives(&q, &qd, &tau);
        let generic: [[f64; 78]; 6] =
            generic::forward_dynamics_parameter_derivatives(&chain, &q, &qd, &tau);
        let block =
            |entries: [[f64; 78]; 6]| [Block::new("∂q̈/∂π", entries.as_flattened().to_vec())];
        entries.note(&block(generated), &block(generic));

        let qdd = WithActuators.forward_dynamics(&q, &qd, &tau);
        let mut heavier = WithActuators::chain();
        let step = 1e-5;
        heavier.joints[4].inertia =
            heavier.joints[4].inertia + Inertia::of_particle(step, [0.0; 3]);
        let faster: [f64; 6] = generic::forward_dynamics(&heavier, &q, &qd, &tau);
        for (row, (after, before)) in faster.iter().zip(qdd).enumerate() {
            let (slope, derivative) = ((after - before) / step, generated[row][40]);
            let size = 1.0 + derivative.abs();
            assert!(
                (slope - derivative).abs() < 1e-3 * size,
                "{slope} {derivative}"
            );
        }
    }
    println!("{entries}");
    entries.assert_within(LIMIT_OF_ACCELERATIONS);
}

macro_rules! regressors {
    ($($name:ident: $robot:ident, $joints:literal, $parameters:literal, $base:literal;)*) => {$(
        #[test]
        fn $name() {
            hold::<_, $joints, { $parameters * $joints }, $base, _>(
                &$robot,
                &$robot::chain(),
                &$robot::BASE_PARAMETERS,
            );
        }
    )*};
}

// The numbers of base parameters are the ranks of the regressors.
regressors! {
    two_link: TwoLink, 2, 10, 6;
    scara: Scara, 4, 10, 8;
    stanford: Stanford, 6, 10, 33;
    stanford_general: StanfordGeneral, 6, 10, 33;
    puma560: Puma560, 6, 10, 36;
    puma560_general: Puma560General, 6, 10, 36;
    ur5_class: Ur5Class, 6, 10, 36;
    panda_class: PandaClass, 7, 10, 43;
    quadruped: Quadruped, 12, 10, 68;
    with_actuators: WithActuators, 6, 13, 52;
}
