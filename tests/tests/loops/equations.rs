//! Accelerations and multipliers against the whole system of equations, [M −Jᵗ; J 0] of q̈ and λ, solved in
//! 256 bits with pivoting: what generated code loses is told in units of rounding.

use std::path::Path;

use homogen_codegen::chain::Chain;
use homogen_codegen::description::inline;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::{program_for, understand};
use homogen_codegen::expression::Input;
use homogen_codegen::schedule::run;
use homogen_codegen::space::{Space, Variable};
use homogen_codegen::{Formulation, Function, Processor, Real};
use homogen_random::Random;
use homogen_tests::big::Big;
use homogen_tests::oracle::link_frames;
use homogen_tests::oracle::solve::solve;

use super::leg::{FREE, STANDING};

const PENTAGON: &str = "
struct Pentagon { gravity: [0.0, -9.81, 0.0] }
link ground;
joint a: revolute(z);
link one { mass: 0.5, com: [0.05, 0.01, 0.0], inertia: [1e-4, 4e-4, 5e-4] }
joint b: revolute(z) { at: xyz(0.1, 0.0, 0.0) }
link two { mass: 0.8, com: [0.15, 0.0, 0.0], inertia: [1e-4, 6e-3, 6e-3] }
joint c: revolute(z) { from: ground, at: xyz(0.35, 0.0, 0.0) }
link three { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
joint d: revolute(z) { at: xyz(0.2, 0.0, 0.0) }
link four { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
loop pin: revolute(z) { from: two, to: four, at: xyz(0.3, 0.0, 0.0), to_at: xyz(0.25, 0.0, 0.0) }
";

fn chain(text: &str) -> Chain {
    let mut errors = Errors::new();
    let tokens = text.parse().expect("tokens");
    let item = inline::read(tokens, Path::new("nowhere"), &mut errors);
    assert!(errors.is_empty(), "{errors}");
    let item = item.expect("a robot");
    let description = item.description.expect("it is in place");
    understand(&description, &item.request).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The worst difference from 256 bits, beside the largest entry, over random states in a type of number.
fn worst(chain: &Chain, scalar: Real) -> [f64; 2] {
    let spaces = chain.spaces();
    let n = spaces.len(Space::Velocities);
    let c = spaces.len(Space::Constraints);
    let function = Function::ConstrainedForwardDynamics;
    let (processor, way) = (Processor::Portable, Formulation::default());
    let program = program_for(processor, way, chain, &[function], 0, scalar);
    let program = program.unwrap_or_else(|errors| panic!("{errors}"));
    let truth = [
        Function::MassMatrix,
        Function::Bias,
        Function::ConstraintJacobian,
        Function::ConstraintBias,
    ]
    .map(|function| link_frames::truth(chain, function, 0));
    let mut random = Random::new(7);
    let mut worst = [0.0_f64; 2];
    for _ in 0..50 {
        let mut list = |count: usize| -> Vec<f64> {
            // Exact in both types.
            (0..count)
                .map(|_| (random.odd() * 4096.0).round() / 2048.0)
                .collect()
        };
        let mut q = list(spaces.len(Space::Coordinates));
        for first in spaces.quaternions() {
            q[first..first + 4].copy_from_slice(&[0.5, -0.5, 0.5, 0.5]);
        }
        let (qd, tau) = (list(n), list(n));
        let at = |input: Input| match input {
            Input::Variable(Variable::Q, k) => q[usize::from(k)],
            Input::Variable(Variable::Qd, k) => qd[usize::from(k)],
            Input::Variable(Variable::Tau, k) => tau[usize::from(k)],
            _ => 0.0,
        };
        let [m, h, j, gamma] = truth
            .each_ref()
            .map(|truth| truth.at(|input| Big::new(at(input))));
        let zero = Big::zero();
        let mut a = vec![vec![zero.clone(); n + c]; n + c];
        let mut b = Vec::new();
        for row in 0..n {
            for column in 0..n {
                a[row][column] = m[row * n + column].clone();
            }
            for k in 0..c {
                a[row][n + k] = &zero - &j[k * n + row];
                a[n + k][row] = j[k * n + row].clone();
            }
            b.push(vec![&Big::new(tau[row]) - &h[row]]);
        }
        b.extend(gamma.iter().map(|gamma| vec![&zero - gamma]));
        let solution: Vec<f64> = solve(a, b).iter().map(|row| row[0].to_f64()).collect();
        let found: Vec<f64> = match scalar {
            Real::F32 => {
                #[expect(clippy::cast_possible_truncation, reason = "exact in both")]
                let found = run(&program, |input| at(input) as f32);
                found.into_iter().map(f64::from).collect()
            }
            _ => run(&program, at),
        };
        let pairs = [
            (&found[..n], &solution[..n]),
            (&found[n..], &solution[n..]),
        ];
        for (worst, (found, expected)) in worst.iter_mut().zip(pairs) {
            let size = super::largest(expected);
            *worst = worst.max(super::difference(found, expected) / size);
        }
    }
    worst
}

#[test]
fn accelerations_and_multipliers_solve_the_whole_system() {
    for (name, text) in [
        ("leg", STANDING),
        ("leg on a free body", FREE),
        ("five bars", PENTAGON),
    ] {
        let chain = chain(text);
        let double = worst(&chain, Real::F64);
        let single = worst(&chain, Real::F32);
        println!(
            "{name}: q̈ {:.1e} and λ {:.1e} in f64, {:.1e} and {:.1e} in f32",
            double[0], double[1], single[0], single[1]
        );
        assert!(
            double.iter().all(|error| *error < 1e-11),
            "{name}: {double:?}"
        );
        assert!(
            single.iter().all(|error| *error < 1e-2),
            "{name}: {single:?}"
        );
    }
}
