//! The implicit midpoint rule in C, compared with that of the runtime.

use homogen::Robot;
use homogen::step::ImplicitMidpoint;
use homogen_codegen::request::Integrator;
use homogen_codegen::{Builder, Function};

use crate::c99::compilers::{C, Folder};
use crate::c99::states;

/// The arm as a derive.
#[derive(Robot)]
#[robot(
    urdf = "../../robots/panda_class.urdf",
    tip = "link8",
    generate(inverse_dynamics, inverse_dynamics_derivatives, mass_matrix)
)]
struct Panda;

const FUNCTIONS: [Function; 3] = [
    Function::InverseDynamics,
    Function::InverseDynamicsDerivatives,
    Function::MassMatrix,
];

/// Reads q, q̇, q̇⁺, τ and Δt of states, and writes the residual, q⁺ and the derivatives.
const MAIN: &str = r#"#include <stdio.h>
#include "arm.h"
int main(void)
{
    double in[4][7], dt, residual[7], next_q[7], by[3][7][7];
    while (fread(in, sizeof in, 1, stdin) == 1 && fread(&dt, sizeof dt, 1, stdin) == 1) {
        arm_midpoint_residual(in[0], in[1], in[2], in[3], dt, residual);
        arm_midpoint_configuration(in[0], in[1], in[2], dt, next_q);
        arm_midpoint_derivatives(in[0], in[1], in[2], dt, by[0], by[1], by[2]);
        fwrite(residual, sizeof residual, 1, stdout);
        fwrite(next_q, sizeof next_q, 1, stdout);
        fwrite(by, sizeof by, 1, stdout);
    }
    return 0;
}
"#;

/// Numbers of a state: four vectors and a duration.
const INPUTS: usize = 4 * 7 + 1;

#[test]
fn the_midpoint_rule_gives_the_numbers_of_the_runtime() {
    let builder = Builder::from_urdf("../../robots/panda_class.urdf").tip("link8");
    let builder = builder.generate(FUNCTIONS).extern_c("arm_");
    let source = builder.steps(Integrator::ImplicitMidpoint).to_c("arm.h");
    let source = source.unwrap_or_else(|errors| panic!("{errors}"));
    let folder = Folder::new("midpoint");
    folder.write("arm.h", &source.header);
    folder.write("arm.c", &source.text);
    folder.write("main.c", MAIN);
    let mut given = states::everyday(INPUTS, 50);
    for state in given.chunks_exact_mut(INPUTS) {
        state[INPUTS - 1] = 0.01;
    }
    let expected: Vec<f64> = given.chunks_exact(INPUTS).flat_map(of_runtime).collect();
    let largest = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for compiler in C::that_run() {
        let object = compiler.object(&folder, "arm.c", &[]);
        let bytes = states::bytes(&given, homogen_codegen::Real::F64);
        let found = states::numbers(&compiler.program(&folder, &object).run(&bytes));
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            let off = (found - expected).abs();
            assert!(off <= 1e-14 * largest, "{found}, not {expected}");
        }
    }
}

/// The results of a state in the order of the program.
fn of_runtime(state: &[f64]) -> Vec<f64> {
    let (vectors, dt) = (state.as_chunks::<7>().0, state[INPUTS - 1]);
    let [q, qd, next, tau] = vectors else {
        panic!("{} vectors", vectors.len());
    };
    let by = Panda.midpoint_derivatives((q, qd), next, dt);
    let rows = [by.q, by.qd, by.next_qd];
    let mut all = Panda.midpoint_residual((q, qd), next, tau, dt).to_vec();
    all.extend(Panda.midpoint_configuration((q, qd), next, dt));
    all.extend(rows.as_flattened().as_flattened());
    all
}
