//! Forward dynamics and the inverse of the mass matrix, compared with inverse dynamics, the mass matrix, the generic
//! recursions, and Pinocchio.

use std::array::from_fn;

use homogen::generic;
use homogen::robot::{ForwardDynamics, InverseDynamics, MassMatrix, MassMatrixInverse};
use homogen_robots::for_every_robot;
use homogen_robots::shipped::{
    PandaClass, Puma560, Puma560General, Quadruped, Scara, Stanford, StanfordGeneral, TwoLink,
    Ur5Class,
};
use homogen_tests::effort::effort;
use homogen_tests::rounding::DOUBLE;
use homogen_tests::states::{Random, State};
use serde_json::Value;

/// Random states of each robot.
fn count() -> usize {
    effort(200, 1000)
}

/// The largest difference of two lists.
fn difference(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len());
    x.iter()
        .zip(y)
        .fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Torques of the accelerations' size, so that q̈ is not only a difference of large numbers.
fn torques<const N: usize>(state: &State<f64, N>) -> [f64; N] {
    from_fn(|k| 3.0 * state.qdd[N - 1 - k])
}

/// The worst backward error over random states, in u: the difference of the torques that the computed accelerations
/// need from the given ones, relative to the size of M q̈ and τ.
fn backward_error<R, const N: usize>(robot: &R) -> f64
where
    R: InverseDynamics<N> + MassMatrix<N> + ForwardDynamics<N>,
{
    let mut random = Random::new(12);
    (0..count()).fold(0.0, |worst: f64, _| {
        let state: State<f64, N> = State::random(&mut random);
        let tau = torques(&state);
        let found = robot.forward_dynamics(&state.q, &state.qd, &tau);
        let needed = robot.inverse_dynamics(&state.q, &state.qd, &found);
        let mass = robot.mass_matrix(&state.q);
        let inertia = mass
            .as_flattened()
            .iter()
            .fold(0.0, |most: f64, m| most.max(m.abs()));
        let size = inertia * largest(&found) + largest(&tau);
        worst.max(difference(&needed, &tau) / size / DOUBLE)
    })
}

/// The worst entry of M M⁻¹ − 1 over random states, relative to |M| |M⁻¹|, in u.
fn inversion_error<R, const N: usize>(robot: &R) -> f64
where
    R: MassMatrix<N> + MassMatrixInverse<N>,
{
    let mut random = Random::new(13);
    (0..count()).fold(0.0, |worst: f64, _| {
        let state: State<f64, N> = State::random(&mut random);
        let (mass, inverse) = (
            robot.mass_matrix(&state.q),
            robot.mass_matrix_inverse(&state.q),
        );
        let mut found: f64 = 0.0;
        let mut size: f64 = 0.0;
        for (i, row) in mass.iter().enumerate() {
            // The inverse is symmetric: its rows are its columns.
            for (k, column) in inverse.iter().enumerate() {
                let unit = f64::from(u8::from(i == k));
                let terms = row.iter().zip(column).map(|(m, n)| m * n);
                size = size.max(terms.clone().map(f64::abs).sum());
                found = found.max((terms.sum::<f64>() - unit).abs());
                assert_eq!(
                    column[i].to_bits(),
                    inverse[i][k].to_bits(),
                    "not symmetric"
                );
            }
        }
        worst.max(found / size / DOUBLE)
    })
}

/// The worst relative difference from the generic recursions, in u times the condition number of the mass matrix.
fn distance_from_generic<R, const N: usize, const F: usize>(
    robot: &R,
    chain: &homogen::Chain<N, F>,
) -> f64
where
    R: ForwardDynamics<N>,
{
    let mut random = Random::new(14);
    (0..count()).fold(0.0, |worst: f64, _| {
        let state: State<f64, N> = State::random(&mut random);
        let tau = torques(&state);
        let found = robot.forward_dynamics(&state.q, &state.qd, &tau);
        let expected = generic::forward_dynamics(chain, &state.q, &state.qd, &tau);
        let mass = generic::mass_matrix(chain, &state.q);
        let inverse = generic::mass_matrix_inverse(chain, &state.q);
        let condition = largest(mass.as_flattened()) * largest(inverse.as_flattened());
        let size = largest(&expected) * condition;
        worst.max(difference(&found, &expected) / size / DOUBLE)
    })
}

/// A vector of a state in the file of a robot.
fn vector<const N: usize>(state: &Value, field: &str) -> [f64; N] {
    from_fn(|k| state[field][k].as_f64().expect("a number"))
}

macro_rules! check {
    ($name:ident, $robot:ident) => {
        #[test]
        fn $name() {
            let backward = backward_error(&$robot);
            assert!(backward <= 8.0, "{backward} u of backward error");
            let inversion = inversion_error(&$robot);
            assert!(inversion <= 16.0, "{inversion} u of M M⁻¹");
            let distance = distance_from_generic(&$robot, &$robot::chain());
            assert!(distance <= 32.0, "{distance} u of the generic runtime's q̈");

            let text = include_str!(concat!("../../../reference/", stringify!($name), ".json"));
            let file: Value = serde_json::from_str(text).expect("JSON");
            for state in file["states"].as_array().expect("states") {
                let found = $robot.forward_dynamics(
                    &vector(state, "q"),
                    &vector(state, "v"),
                    &vector(state, "torque"),
                );
                let expected: Vec<f64> = state["ddq"]
                    .as_array()
                    .expect("an array")
                    .iter()
                    .map(|entry| entry.as_f64().expect("a number"))
                    .collect();
                let error = difference(&found, &expected) / largest(&expected);
                assert!(error <= 1e-11, "{error:e} from Pinocchio's q̈");
            }
        }
    };
}

for_every_robot!(check);
