//! The two-link arm against the closed form that textbooks print.
//!
//! In: the numbers at the head of `two_link.urdf`. The generated function that the guide shows must give the same
//! torques.

use homogen::Robot;
use homogen_examples::states::{State, random};

#[derive(Robot)]
#[robot(urdf = "../robots/two_link.urdf", generate(inverse_dynamics))]
struct TwoLink;

/// Masses, lengths, distances of the centres of mass and moments about the joints; kg, m, kg m².
const M: [f64; 2] = [2.0, 1.0];
const L_1: f64 = 0.4;
const R: [f64; 2] = [0.2, 0.15];
const I: [f64; 2] = [0.11, 0.0325];
const G: f64 = 9.81;

/// M(q) q̈ + C(q, q̇) + g(q), as Lagrange's equations give them.
fn lagrange(state: &State<f64, 2>) -> [f64; 2] {
    let ([q_1, q_2], [qd_1, qd_2], [qdd_1, qdd_2]) = (state.q, state.qd, state.qdd);
    let coupling = M[1] * L_1 * R[1];
    let inertia = [
        [
            I[0] + I[1] + M[1] * L_1 * L_1 + 2.0 * coupling * q_2.cos(),
            I[1] + coupling * q_2.cos(),
        ],
        [I[1] + coupling * q_2.cos(), I[1]],
    ];
    let swing = coupling * q_2.sin();
    let fore = M[1] * R[1] * G * (q_1 + q_2).cos();
    let upper = (M[0] * R[0] + M[1] * L_1) * G * q_1.cos();
    [
        inertia[0][0] * qdd_1 + inertia[0][1] * qdd_2 - swing * qd_2 * (2.0 * qd_1 + qd_2)
            + upper
            + fore,
        inertia[1][0] * qdd_1 + inertia[1][1] * qdd_2 + swing * qd_1 * qd_1 + fore,
    ]
}

#[test]
fn the_expansion_is_the_closed_form() {
    for state in random::<2>(1000, 2) {
        let state = state.widen();
        let expanded = TwoLink.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        for (expanded, known) in expanded.into_iter().zip(lagrange(&state)) {
            // Terms of up to 10 N m, a dozen operations.
            assert!(
                (expanded - known).abs() < 2e-14,
                "{expanded} {known} at {state:?}"
            );
        }
    }
}
