//! How far the controller's results are from the truth.
//!
//! In: the controller in single precision; the generic recursions of the runtime in double, which
//! share nothing with generated code; and the sizes that rounding errors are measured by. Out: for
//! each function the worst error over the trusted states, in units of rounding of f32 (2⁻²⁴).

use controller::{
    JOINTS, State, TRUSTED, forward_dynamics, forward_kinematics, geometric_jacobian, gravity,
    inverse_dynamics, mass_matrix, states,
};
use homogen::{Chain, Pose, Screw, generic};

use crate::arm::Arm;
use crate::magnitude::Magnitude;

/// The unit of rounding of single precision.
const U: f64 = 1.0 / 16_777_216.0;

/// The worst errors, by function.
pub fn worst() -> Vec<(&'static str, f64)> {
    let chain = Arm::chain();
    let tip = chain.tip();
    vec![
        (
            "forward_kinematics",
            over(|state| {
                let [q, ..] = exact(state);
                let pose = generic::forward_kinematics(&chain, &tip, &q);
                let size = Arm.forward_kinematics(&q.map(Magnitude::given));
                compare(
                    &forward_kinematics(&state.q).concat(),
                    &of_pose(&pose),
                    &sizes(&of_pose(&size)),
                )
            }),
        ),
        (
            "geometric_jacobian",
            over(|state| {
                let [q, ..] = exact(state);
                let screws = generic::geometric_jacobian(&chain, &tip, &q);
                let size = Arm.geometric_jacobian(&q.map(Magnitude::given));
                compare(
                    &geometric_jacobian(&state.q).concat(),
                    &of_screws(&screws),
                    &sizes(&of_screws(&size)),
                )
            }),
        ),
        (
            "gravity",
            over(|state| {
                let [q, ..] = exact(state);
                let size = Arm.gravity(&q.map(Magnitude::given));
                compare(
                    &gravity(&state.q),
                    &generic::gravity(&chain, &q),
                    &sizes(&size),
                )
            }),
        ),
        (
            "inverse_dynamics",
            over(|state| {
                let [q, qd, qdd, _] = exact(state);
                let [a, b, c] = [q, qd, qdd].map(|row| row.map(Magnitude::given));
                let torques = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
                compare(
                    &inverse_dynamics(&state.q, &state.qd, &state.qdd),
                    &torques,
                    &sizes(&Arm.inverse_dynamics(&a, &b, &c)),
                )
            }),
        ),
        (
            "mass_matrix",
            over(|state| {
                let [q, ..] = exact(state);
                let size = Arm.mass_matrix(&q.map(Magnitude::given)).concat();
                compare(
                    &mass_matrix(&state.q).concat(),
                    &generic::mass_matrix(&chain, &q).concat(),
                    &sizes(&size),
                )
            }),
        ),
        ("forward_dynamics", over(|state| backward(&chain, state))),
    ]
}

/// Of accelerations: by how much the torques that produce them are off, in units of what each
/// torque is the sum of. The error of the accelerations themselves is that times the condition of
/// the mass matrix, which is the arm's.
fn backward<const F: usize>(chain: &Chain<JOINTS, F>, state: &State) -> f64 {
    let [q, qd, _, tau] = exact(state);
    let found = forward_dynamics(&state.q, &state.qd, &state.tau).map(f64::from);
    let torques = generic::inverse_dynamics(chain, &q, &qd, &found);
    let [a, b, c] = [q, qd, found].map(|row| row.map(Magnitude::given));
    let size = Arm.inverse_dynamics(&a, &b, &c);
    let errors = (0..JOINTS).map(|i| (torques[i] - tau[i]).abs() / (size[i].size + tau[i].abs()));
    errors.fold(0.0, f64::max) / U
}

/// The largest over the trusted states.
fn over(error: impl Fn(&State) -> f64) -> f64 {
    let states = states();
    let errors = states.iter().take(TRUSTED).map(error);
    // Not `f64::max`, which overlooks NaN.
    errors.fold(
        0.0,
        |worst, error| if error <= worst { worst } else { error },
    )
}

/// The worst entry, in units of rounding of its size.
fn compare(found: &[f32], truth: &[f64], sizes: &[f64]) -> f64 {
    let entries = found.iter().zip(truth).zip(sizes);
    let errors = entries.map(|((found, truth), size)| {
        let error = (f64::from(*found) - truth).abs();
        // What is zero by construction may differ by what the reference itself loses.
        error / size.max(1e-6) / U
    });
    errors.fold(
        0.0,
        |worst, error| if error <= worst { worst } else { error },
    )
}

fn exact(state: &State) -> [[f64; JOINTS]; 4] {
    [state.q, state.qd, state.qdd, state.tau].map(|row| row.map(f64::from))
}

fn sizes(numbers: &[Magnitude]) -> Vec<f64> {
    numbers.iter().map(|number| number.size).collect()
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
