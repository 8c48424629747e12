//! The results of the host for the firmware to compare with.
//!
//! In: the controller, compiled for the host. Out: a file of Rust with the bits of its results.

use std::fmt::Write;

use controller::{
    STATES, State, computed_torque, forward_dynamics, forward_kinematics, geometric_jacobian,
    gravity, inverse_dynamics, mass_matrix, states,
};

/// The file.
pub fn text() -> String {
    let mut text =
        "// Written by `run.sh`: what the host computed for each state, as bits of f32.\n"
            .to_owned();
    table(&mut text, "FORWARD_KINEMATICS", |state| {
        forward_kinematics(&state.q).concat()
    });
    table(&mut text, "GEOMETRIC_JACOBIAN", |state| {
        geometric_jacobian(&state.q).concat()
    });
    table(&mut text, "GRAVITY", |state| gravity(&state.q).to_vec());
    table(&mut text, "INVERSE_DYNAMICS", |state| {
        inverse_dynamics(&state.q, &state.qd, &state.qdd).to_vec()
    });
    table(&mut text, "COMPUTED_TORQUE", |state| {
        computed_torque(state).to_vec()
    });
    table(&mut text, "MASS_MATRIX", |state| {
        mass_matrix(&state.q).concat()
    });
    table(&mut text, "FORWARD_DYNAMICS", |state| {
        forward_dynamics(&state.q, &state.qd, &state.tau).to_vec()
    });
    text
}

fn table(text: &mut String, name: &str, function: impl Fn(&State) -> Vec<f32>) {
    let rows = states().map(|state| function(&state));
    let words = rows[0].len();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n#[rustfmt::skip]\npub static {name}: [[u32; {words}]; {STATES}] = ["
    );
    for row in rows {
        let bits: Vec<_> = row.into_iter().map(bits).collect();
        let _ = writeln!(text, "    [{}],", bits.join(", "));
    }
    text.push_str("];\n");
}

/// The bits of a number; one pattern for every NaN, because the patterns of processors differ.
fn bits(number: f32) -> String {
    let bits = if number.is_nan() {
        0x7fc0_0000
    } else {
        number.to_bits()
    };
    format!("{bits:#010x}")
}
