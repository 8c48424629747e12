//! Accelerations and multipliers, compared with the solution of the system [M −Jᵗ; J 0] of q̈ and λ in dense matrices
//! of frame 0, in 256 bits.

use std::path::Path;

use homogen_codegen::chain;
use homogen_codegen::description::{Description, inline};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::list::Id;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::{FrameId, Space, Variable};
use homogen_codegen::{Function, Real};
use homogen_random::Random;
use homogen_tests::arguments::{Arguments, at};
use homogen_tests::big::Big;
use homogen_tests::oracle::frame_0;
use homogen_tests::oracle::robot::Robot;
use homogen_tests::programs::program;

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

fn described(text: &str) -> (Description, Request) {
    let mut errors = Errors::new();
    let tokens = text.parse().expect("tokens");
    let item = inline::read(tokens, Path::new("nowhere"), &mut errors);
    assert!(errors.is_empty(), "{errors}");
    let item = item.expect("a robot");
    (
        item.description.expect("an inline description"),
        item.request,
    )
}

/// The worst difference from 256 bits over random states in a type, relative to the largest entry.
fn worst(description: &Description, request: &Request, scalar: Real) -> [f64; 2] {
    let robot = Robot::of(description, request);
    let chain = understand(description, request).unwrap_or_else(|errors| panic!("{errors}"));
    let all = chain::build(description, request).unwrap_or_else(|errors| panic!("{errors}"));
    let spaces = chain.spaces();
    let n = spaces.len(Space::Velocities);
    // The oracle has all residuals, the engine those that are not constant.
    let kept: Vec<usize> = (spaces.names(Space::Constraints))
        .map(|name| {
            let place = all
                .spaces()
                .names(Space::Constraints)
                .position(|other| other == name);
            n + place.expect("a residual of the description")
        })
        .collect();
    let function = Function::ConstrainedForwardDynamics;
    let program = program(&chain, &[function], FrameId::FIRST, scalar);
    let program = program.unwrap_or_else(|errors| panic!("{errors}"));
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
            q[first.index()..][..4].copy_from_slice(&[0.5, -0.5, 0.5, 0.5]);
        }
        let mut arguments = Arguments::default();
        arguments[Variable::Q] = q;
        arguments[Variable::Qd] = list(n);
        arguments[Variable::Qdd] = vec![0.0; n];
        arguments[Variable::Tau] = list(n);
        let at = |input| at(&arguments, input);
        let found: Vec<f64> = match scalar {
            Real::F32 => {
                #[expect(clippy::cast_possible_truncation, reason = "exact in both")]
                let found = run(&program, |input| at(input) as f32);
                found.into_iter().map(f64::from).collect()
            }
            _ => run(&program, at),
        };
        let solution = frame_0::evaluate(&robot, function, 0, &arguments);
        let solution: Vec<f64> = solution.iter().map(Big::to_f64).collect();
        let multipliers: Vec<f64> = kept.iter().map(|&k| solution[k]).collect();
        let pairs = [(&found[..n], &solution[..n]), (&found[n..], &multipliers)];
        for (worst, (found, expected)) in worst.iter_mut().zip(pairs) {
            let size = super::largest(expected);
            *worst = worst.max(super::difference(found, expected) / size);
        }
    }
    worst
}

#[test]
fn accelerations_and_multipliers_solve_the_system_of_equations() {
    for (name, text) in [
        ("leg", STANDING),
        ("leg on a free body", FREE),
        ("five bars", PENTAGON),
    ] {
        let (description, request) = described(text);
        let double = worst(&description, &request, Real::F64);
        let single = worst(&description, &request, Real::F32);
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
