//! Every name in generated code, compared with the value that it names.
//!
//! In: robots, functions, layouts and algorithms. Out: a failed assertion if the value of a named step is not the entry
//! of the matrix that its name states. Results are compared by other tests.

use std::array::from_fn;
use std::collections::BTreeSet;

use homogen::Direction;
use homogen_codegen::Function;
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::read_text;
use homogen_codegen::error::Errors;
use homogen_codegen::expression::{Block, Label};
use homogen_codegen::layout::Layout;
use homogen_codegen::model::{Algorithm, Carried};
use homogen_codegen::plan::program_by;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Operand, Program, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_robots::shipped::PandaClass;
use homogen_tests::arguments::{self, Arguments};
use homogen_tests::states::Random;
use homogen_tests::subjects::subject;

use crate::names::matrices::Matrices;

/// The states to which H of a function may belong: functions may set rates to zero, or compute q̈ themselves after
/// forces at q̈ = 0.
fn states_of(function: Function, chain: &Chain, state: &Arguments) -> Vec<Arguments> {
    let rest = vec![0.0; state[Variable::Q].len()];
    let mut state = state.clone();
    match function {
        Function::Gravity | Function::GravityDerivative => {
            state[Variable::Qd].clone_from(&rest);
            state[Variable::Qdd] = rest;
        }
        Function::AccelerationBias
        | Function::Bias
        | Function::CentroidalMomentumBias
        | Function::CoriolisMatrix
        | Function::ForwardDynamics => state[Variable::Qdd] = rest,
        Function::ForwardDynamicsDerivatives
        | Function::ForwardDynamicsVjp
        | Function::ForwardDynamicsJvp
        | Function::ForwardDynamicsHessian
        | Function::ForwardDynamicsParameterDerivatives => {
            let solved = [Function::ForwardDynamics];
            let program = program_by(
                chain,
                &solved,
                FrameId::FIRST,
                Layout::DESCRIBED,
                Algorithm::PLAIN,
            );
            let found = run(&program, |input| arguments::at(&state, input));
            let states = [rest, found].map(|qdd| {
                let mut state = state.clone();
                state[Variable::Qdd] = qdd;
                state
            });
            return states.to_vec();
        }
        _ => {}
    }
    vec![state]
}

/// Runs a program and compares every name in it with the matrices. Returns the blocks of the names.
fn hold(
    what: &str,
    program: &Program,
    matrices: &[Matrices],
    state: &Arguments,
) -> BTreeSet<Block> {
    let labelled: Vec<(u32, Label)> = (0..)
        .zip(&program.steps)
        .filter_map(|(k, step)| Some((k, step.label?)))
        .collect();
    let probe = Program {
        results: labelled.iter().map(|(k, _)| Operand::Step(*k)).collect(),
        ..program.clone()
    };
    let found = run(&probe, |input| arguments::at(state, input));
    let mut met = BTreeSet::new();
    for ((_, label), found) in labelled.into_iter().zip(found) {
        let known: Vec<f64> = matrices.iter().flat_map(|at| at.of(label)).collect();
        // Pivots and factors of the mass matrix are not matrices of the paper.
        if known.is_empty() {
            continue;
        }
        let fits = known
            .iter()
            .any(|known| (found - known).abs() <= 1e-11 * known.abs().max(1.0));
        assert!(fits, "{what}: `{label}` is {found}, not one of {known:?}");
        met.insert(label.quantity.block);
    }
    met
}

/// Oblique axes, with a prismatic and a screw joint.
const OBLIQUE: &str = "convention modified
joint kind      pitch a    alpha d    theta mass cx   cy   cz   ixx  ixy   ixz   iyy  iyz   izz
one   revolute  -     0    0.3   0.2  0.4   1.5  0.1  0.2  0.1  0.03 0.001 0.002 0.04 0.003 0.05
two   prismatic -     0.3  1.1   0.1  -0.7  0.8  0.1  -0.1 0.3  0.02 0.001 0.002 0.03 0.001 0.02
three screw     0.05  -0.2 -0.6  0    1.9   0.6  -0.1 0.1  0.2  0.01 0.001 0.001 0.02 0.001 0.02
four  revolute  -     0.1  0.9   -0.3 0.2   0.4  0.05 0.02 0.03 0.01 0.001 0.001 0.01 0.001 0.01
hand  fixed     -     0.1  0.4   0.2  0.1   -    -    -    -    -    -     -     -    -     -
";

fn robots() -> Vec<(&'static str, Chain)> {
    let mut errors = Errors::new();
    let oblique = read_text(OBLIQUE, "oblique.dh", None, &mut errors).expect("a table");
    let oblique = chain::build(&oblique, &Request::default())
        .unwrap_or_else(|e| panic!("{e}"))
        .identified();
    let shipped = [
        "panda_class/0",
        "scara/0",
        "stanford_general/0",
        "quadruped/0",
    ];
    let shipped = shipped.map(|label| (label, subject(label).chain()));
    shipped.into_iter().chain([("oblique", oblique)]).collect()
}

#[test]
fn names_are_those_of_appendix_b() {
    let mut random = Random::new(31);
    let mut met = BTreeSet::new();
    let normals = Layout {
        normals: true,
        ..Layout::DESCRIBED
    };
    let regrouped = Layout {
        regroup: true,
        ..normals
    };
    for (label, chain) in robots() {
        let state = arguments::random(chain.joints.len(), &mut random);
        for function in Function::ALL {
            let outwards = Algorithm {
                pose: Carried::Outwards,
                ..Algorithm::PLAIN
            };
            for (frames, algorithm) in [
                ("link", Algorithm::PLAIN),
                ("outwards", outwards),
                ("0", Algorithm::IN_FRAME_0),
            ] {
                for layout in [Layout::DESCRIBED, normals, regrouped] {
                    let what = format!("{label}, {}, frames {frames}, {layout:?}", function.name());
                    let program =
                        program_by(&chain, &[function], FrameId::FIRST, layout, algorithm);
                    let states = states_of(function, &chain, &state).into_iter();
                    let matrices: Vec<_> = states
                        .map(|state| Matrices::at(&chain, layout, &state))
                        .collect();
                    met.append(&mut hold(&what, &program, &matrices, &state));
                }
            }
        }
    }
    // Every block occurs, so no check passed without names. Directions of screws in frame 0 are axes of M, and keep
    // that name.
    let all = [
        Block::Axis(0),
        Block::Axis(1),
        Block::Axis(2),
        Block::Origin,
        Block::AngularVelocity,
        Block::LinearVelocity,
        Block::AngularAcceleration,
        Block::LinearAcceleration,
        Block::Moment,
        Block::Inertia,
        Block::MassCenter,
        Block::Couple,
        Block::Force,
    ];
    assert_eq!(met, BTreeSet::from(all));
}

/// In the layout of the description, frame k is the frame of the link, as in a drawing of the robot.
#[test]
fn described_frames_are_those_of_the_links() {
    let mut random = Random::new(32);

    let chain = subject("panda_class/0").chain();
    let state = arguments::random(7, &mut random);
    let matrices = Matrices::at(&chain, Layout::DESCRIBED, &state);
    let at = |of: &[f64]| -> [f64; 7] { from_fn(|k| of[k]) };
    let (q, qd, qdd) = (
        at(&state[Variable::Q]),
        at(&state[Variable::Qd]),
        at(&state[Variable::Qdd]),
    );
    let known = homogen::open_chain::motions(&PandaClass::chain(), &q, &qd, &qdd);
    for (k, known) in known.iter().enumerate() {
        let frame = known.pose.to_matrix();
        let same = |a: [[f64; 4]; 4], b: [[f64; 4]; 4]| {
            let pairs = a.as_flattened().iter().zip(b.as_flattened());
            assert!(
                pairs.clone().all(|(a, b)| (a - b).abs() < 1e-11),
                "{k}: {a:?} {b:?}"
            );
        };
        same(matrices.m[k].to_matrix(), frame);
        same(matrices.w[k].to_matrix(), known.velocity.to_matrix());
        same(matrices.h[0][k].to_matrix(), known.acceleration.to_matrix());
    }
    assert!(known[6].pose * Direction([0.0, 0.0, 1.0]) != Direction([0.0, 0.0, 1.0]));
}
