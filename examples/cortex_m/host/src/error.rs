//! Rounding errors of results.
//!
//! In: results in single precision; the generic recursions of the runtime in double precision, which share no code
//! with generated code; and the magnitudes that errors are relative to. Out: for each function the worst error over the
//! realistic states, in units of rounding of f32 (2⁻²⁴).

use controller::{
    JOINTS, State, TRUSTED, forward_dynamics, forward_kinematics, geometric_jacobian, gravity,
    inverse_dynamics, mass_matrix, states,
};
use homogen::{Pose, Screw, generic};
use homogen_magnitude::Magnitude;

use crate::arm::Arm;

/// The unit of rounding of single precision.
const U: f64 = 1.0 / 16_777_216.0;

/// The functions whose errors are measured.
pub const FUNCTIONS: [&str; 6] = [
    "forward_kinematics",
    "geometric_jacobian",
    "gravity",
    "inverse_dynamics",
    "mass_matrix",
    "forward_dynamics",
];

/// The results of the controller; empty for a function that is not in the table.
pub fn controller(function: &str, state: &State) -> Vec<f32> {
    let State {
        q, qd, qdd, tau, ..
    } = state;
    match function {
        "forward_kinematics" => forward_kinematics(q).concat(),
        "geometric_jacobian" => geometric_jacobian(q).concat(),
        "gravity" => gravity(q).to_vec(),
        "inverse_dynamics" => inverse_dynamics(q, qd, qdd).to_vec(),
        "mass_matrix" => mass_matrix(q).concat(),
        "forward_dynamics" => forward_dynamics(q, qd, tau).to_vec(),
        _ => Vec::new(),
    }
}

/// The worst error of `function`, with its results for the trusted states by `found`; NaN if there are none.
pub fn worst(function: &str, found: impl Fn(usize, &State) -> Vec<f32>) -> f64 {
    let states = states();
    let states = states.iter().take(TRUSTED).enumerate();
    let errors = states.map(|(index, state)| error(function, state, &found(index, state)));
    largest(errors)
}

fn error(function: &str, state: &State, found: &[f32]) -> f64 {
    if function == "forward_dynamics" {
        return backward(state, found);
    }
    let (truth, size) = truth(function, state);
    if found.len() != truth.len() {
        return f64::NAN;
    }
    let most = largest(size.iter().map(|size| size.size()));
    let entries = found.iter().zip(&truth).zip(&size);
    largest(entries.map(|((found, truth), size)| {
        let error = (f64::from(*found) - truth).abs();
        // An entry that is zero by construction has no terms: it has the size of the others.
        let size = if size.size() < 1e-6 * most {
            most
        } else {
            size.size()
        };
        error / size / U
    }))
}

/// The exact results, with the magnitudes of their terms.
fn truth(function: &str, state: &State) -> (Vec<f64>, Vec<Magnitude<f64>>) {
    let chain = Arm::chain();
    let tip = chain.tip();
    let [q, qd, qdd, _] = exact(state);
    let [a, b, c] = [q, qd, qdd].map(|row| row.map(Magnitude::<f64>::given));
    match function {
        "forward_kinematics" => (
            of_pose(&generic::forward_kinematics(&chain, &tip, &q)),
            of_pose(&Arm.forward_kinematics(&a)),
        ),
        "geometric_jacobian" => (
            of_screws(&generic::geometric_jacobian(&chain, &tip, &q)),
            of_screws(&Arm.geometric_jacobian(&a)),
        ),
        "gravity" => (
            generic::gravity(&chain, &q).to_vec(),
            Arm.gravity(&a).to_vec(),
        ),
        "inverse_dynamics" => (
            generic::inverse_dynamics(&chain, &q, &qd, &qdd).to_vec(),
            Arm.inverse_dynamics(&a, &b, &c).to_vec(),
        ),
        _ => (
            generic::mass_matrix(&chain, &q).concat(),
            Arm.mass_matrix(&a).concat(),
        ),
    }
}

/// The backward error of accelerations: the error of the torques that produce them, relative to the magnitudes of the
/// terms of each torque. The error of the accelerations is this times the condition number of the mass matrix.
fn backward(state: &State, found: &[f32]) -> f64 {
    let [q, qd, _, tau] = exact(state);
    let Ok(found) = <[f32; JOINTS]>::try_from(found) else {
        return f64::NAN;
    };
    let found = found.map(f64::from);
    let torques = generic::inverse_dynamics(&Arm::chain(), &q, &qd, &found);
    let [a, b, c] = [q, qd, found].map(|row| row.map(Magnitude::<f64>::given));
    let size = Arm.inverse_dynamics(&a, &b, &c);
    largest((0..JOINTS).map(|i| (torques[i] - tau[i]).abs() / (size[i].size() + tau[i].abs()) / U))
}

/// The largest, or NaN if there is one, which `f64::max` ignores.
fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    let larger = |worst: f64, error| {
        if worst.is_nan() || error <= worst {
            worst
        } else {
            error
        }
    };
    errors.fold(0.0, larger)
}

fn exact(state: &State) -> [[f64; JOINTS]; 4] {
    [state.q, state.qd, state.qdd, state.tau].map(|row| row.map(f64::from))
}

fn of_pose<T: Copy>(pose: &Pose<T>) -> Vec<T> {
    let rows = pose.rotation().iter().zip(pose.translation());
    rows.flat_map(|(row, t)| [row[0], row[1], row[2], t])
        .collect()
}

fn of_screws<T: Copy>(screws: &[Screw<T>]) -> Vec<T> {
    let entries = screws.iter().map(|screw| [screw.u(), screw.b()].concat());
    entries.flatten().collect()
}
