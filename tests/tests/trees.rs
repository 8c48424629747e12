//! Random trees through the generator, run as programs, against the generic recursions on a chain
//! in which nothing was merged, locked or dropped.
//!
//! Every kind of joint, branches anywhere, offset axes, struct fields, any gravity, and whatever a
//! request can combine. Lengths are about 1 m, masses about 1 kg, rates up to 4 rad/s; sums of
//! products of seven such numbers are right to 1e-12 of the largest result; the worst of 3,000 trees is
//! 9e-14.

use homogen_codegen::chain::frames::Layout;
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::expand::{program, program_by};
use homogen_codegen::formulation::{Angles, Frame};
use homogen_codegen::model::Way;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::{Function, Real};
use homogen_tests::states::{Random, State};
use homogen_tests::trees::{JOINTS, Tree};

const TOLERANCE: f64 = 1e-12;

/// Compares a program with what the tree should return, and gives back the relative error.
fn compare(
    tree: &Tree,
    chain: &Chain,
    program: &Program,
    (function, frame): (Function, usize),
    states: &[State<f64, JOINTS>],
) -> f64 {
    let mut error: f64 = 0.0;
    let mut magnitude: f64 = 1.0;
    for state in states {
        let results = run(program, |input| tree.input(chain, state, input));
        let expected = tree.expected(chain, function, frame, state);
        assert_eq!(results.len(), expected.len(), "{function:?}");
        for (x, y) in results.iter().zip(expected) {
            error = error.max((x - y).abs());
            magnitude = magnitude.max(y.abs());
            assert!(x.is_finite(), "{function:?}");
        }
    }
    error / magnitude
}

fn build(tree: &Tree) -> Chain {
    chain::build(&tree.description, &tree.request).unwrap_or_else(|errors| panic!("{errors}{tree}"))
}

/// What can be asked of any chain: functions of each of its frames, and of the whole, but for those
/// that solve with the mass matrix, which may be singular.
fn wanted(chain: &Chain) -> Vec<(Function, usize)> {
    let frames_of = |function: Function| {
        if function.of_a_frame() {
            chain.frames.len()
        } else {
            1
        }
    };
    let functions = Function::ALL.into_iter().filter(|function| {
        !matches!(
            function,
            Function::ForwardDynamics | Function::MassMatrixInverse
        )
    });
    functions
        .flat_map(|function| (0..frames_of(function)).map(move |frame| (function, frame)))
        .collect()
}

#[test]
fn every_layout_of_200_trees() {
    let mut random = Random::new(200);
    let mut worst: f64 = 0.0;
    for number in 0..200 {
        let tree = Tree::random(&mut random);
        let chain = build(&tree);
        let states = [0; 2].map(|_| tree.state(&mut random));
        for of in wanted(&chain) {
            let mut layouts = if of.0.of_a_frame() {
                Layout::for_kinematics(&chain)
            } else {
                Layout::for_dynamics(&chain)
            };
            layouts.push(Layout::DESCRIBED);
            let layout = *random.choose(&layouts);
            let way = Way {
                frame: *random.choose(&[Frame::Link, Frame::Base]),
                angles: *random.choose(&[Angles::Apart, Angles::Merged]),
                ..*random.choose(&Way::all(of.0))
            };
            let program = program_by(&chain, &[of.0], of.1, layout, way);
            let error = compare(&tree, &chain, &program, of, &states);
            assert!(
                error < TOLERANCE,
                "tree {number}, {of:?} by {layout:?} and {way:?}: {error:.1e}\n{tree}",
            );
            worst = worst.max(error);
        }
    }
    println!("worst error {worst:.1e}");
}

#[test]
fn functions_made_together_are_those_made_alone() {
    let functions = [
        Function::MassMatrix,
        Function::InverseDynamics,
        Function::Gravity,
        Function::Bias,
    ];
    let mut random = Random::new(20);
    for number in 0..20 {
        let tree = Tree::random(&mut random);
        let chain = build(&tree);
        let program = program(&chain, &functions, 0, Real::Generic);
        let program = program.unwrap_or_else(|errors| panic!("{errors}"));
        let state = tree.state(&mut random);
        let results = run(&program, |input| tree.input(&chain, &state, input));
        let mut results = results.as_slice();
        for function in functions {
            let (these, rest) = results.split_at(function.shape().len(chain.joints.len()));
            let expected = tree.expected(&chain, function, 0, &state);
            let magnitude = expected.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
            for (x, y) in these.iter().zip(expected) {
                let error = (x - y).abs() / magnitude;
                assert!(
                    error < TOLERANCE,
                    "tree {number}, {function:?}: {error:.1e}\n{tree}"
                );
            }
            results = rest;
        }
        assert!(results.is_empty());
    }
}
