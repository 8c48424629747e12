//! Functions that solve something: what is bounded is by how much what they were given is another.
//!
//! In: a robot, a type of number. Out: nothing but a failed assertion where the τ that accelerations need
//! misses the given τ by more than its bound, or the inverse of M what its bound lets it be off by.

use homogen_codegen::accuracy::mobility::mobility;
use homogen_codegen::accuracy::range::Range;
use homogen_codegen::accuracy::{Accuracy, Bound};
use homogen_codegen::chain::{BodyId, Chain};
use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::list::Id;
use homogen_codegen::model::Way;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};
use homogen_tests::states::Random;
use homogen_tests::tested::Tested;

use crate::asked::{Asked, chain_of, described};
use crate::bounds::{holds, number};
use crate::states::{STATES, state};

/// The program of a function that solves something, and the bounds of what was given, if there are any.
fn solved(asked: Asked, function: Function, scalar: Real) -> Option<(Program, Vec<Bound>)> {
    let (description, request) = described(asked);
    let external = request.external.iter().filter(|_| function.takes_actions());
    let request = Request {
        external: external.cloned().collect(),
        functions: vec![vec![function]],
        scalar,
        ..request
    };
    let listing = expand(&description, &request);
    let listing = listing.unwrap_or_else(|errors| panic!("{errors}"));
    let listed = listing.functions.into_iter().next();
    let listed = listed.expect("one function was asked for");
    match &*listed.accuracy {
        [Accuracy::Backward(_, promise)] => Some((listed.program, promise.bounds.clone())),
        [Accuracy::Unknown(_)] => None,
        other => panic!("{other:?}"),
    }
}

/// What a function computes, with 106 bits.
fn exactly(chain: &Chain, function: Function) -> Evaluation<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function
        .build(&graph, &bodies, FrameId::FIRST, Way::PLAIN)
        .into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}

/// Forward dynamics of τ that the inverse of a state needs, and by how much the τ that its result
/// needs is another; whether there are bounds.
pub fn check_accelerations<T: Tested>(asked: Asked) -> bool {
    let Some((program, bounds)) = solved(asked, Function::ForwardDynamics, T::REAL) else {
        return false;
    };
    let chain = chain_of(asked);
    let function = Function::InverseDynamics;
    let needed = exactly(&chain, function);
    let range = Range::of(&chain);
    let mut random = Random::new(37);
    let mut worst = vec![0.0_f64; chain.joints.len()];
    for _ in 0..STATES {
        let state = state::<T>(&range, &mut random);
        let needs = |qdd: &dyn Fn(u16) -> f64| {
            needed.at(|input| match input {
                Input::Variable(Variable::Qdd, k) => Double::from(qdd(k)),
                _ => Double::from(state(input)),
            })
        };
        // What is found may be somewhat larger, and is to be within the range.
        let tau: Vec<T> = (needs(&|k| 0.9 * state(Input::Variable(Variable::Qdd, k))).into_iter())
            .map(|tau| T::literal(tau.to_f64()))
            .collect();
        let found = run(&program, |input| match input {
            Input::Variable(Variable::Tau, k) => tau[usize::from(k)],
            _ => T::literal(state(input)),
        });
        let needed = needs(&|k| found[usize::from(k)].to_f64());
        for ((worst, needed), tau) in worst.iter_mut().zip(needed).zip(&tau) {
            let error = (needed - Double::from(tau.to_f64())).to_f64().abs();
            assert!(
                error.is_finite(),
                "{}: accelerations that are no number",
                asked.robot
            );
            *worst = worst.max(error);
        }
    }

    let mut table = format!("{} in {}\n", asked.robot, T::NAME);
    // Twice as far as other bounds: 163 times, of the seven-joint arm in f32.
    let farthest = 2.0 * asked.farthest;
    let holds = holds(&chain, function, &bounds, &worst, farthest, &mut table);
    println!("{table}");
    assert!(holds, "{table}");
    true
}

/// The inverse of the mass matrix. Where each column solves a matrix that is off by up to B, its
/// entries are off by up to |M⁻¹| B |M⁻¹|, to first order.
pub fn check_inverse<T: Tested>(asked: Asked) {
    let found = solved(asked, Function::MassMatrixInverse, T::REAL);
    let (program, bounds) = found.expect("M is provably regular");
    let chain = chain_of(asked);
    let count = chain.joints.len();
    // Of each row, by unit.
    let units = Function::MassMatrix
        .result()
        .units(chain.spaces())
        .into_iter();
    let lost: Vec<f64> = (units.enumerate())
        .map(|(k, unit)| {
            let joint = &chain.joints[BodyId::new(k / count)].name;
            let of = |bound: &&Bound| bound.unit == unit && bound.joint.as_ref() == Some(joint);
            bounds.iter().find(of).map(number)
        })
        .map(|bound| bound.expect("each row and unit of the mass matrix has a bound in the type"))
        .collect();
    let inverse = exactly(&chain, Function::MassMatrixInverse);
    let range = Range::of(&chain);
    let most = mobility(&chain, Layout::DESCRIBED, &range).expect("bodies have inertias");
    let mut random = Random::new(41);
    let mut worst = 0.0_f64;
    for _ in 0..STATES {
        let state = state::<T>(&range, &mut random);
        let exact = inverse.at(|input| Double::from(state(input)));
        let found = run(&program, |input| T::literal(state(input)));
        let size = |row: usize, column: usize| exact[row * count + column].to_f64().abs();
        for (k, (found, exact)) in found.iter().zip(&exact).enumerate() {
            let error = (Double::from(found.to_f64()) - *exact).to_f64().abs();
            let (row, column) = (k / count, k % count);
            let pairs = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
            let most: f64 = pairs
                .map(|(i, j)| size(row, i) * lost[i * count + j] * size(j, column))
                .sum();
            worst = worst.max(error / most);
        }
        for (k, most) in most.joints.iter().enumerate() {
            assert!(size(k, k) <= *most, "{} {k} {most:e}", asked.robot);
        }
    }
    println!(
        "{} {}: {worst:.1e} of what M may be off by",
        asked.robot,
        T::NAME
    );
    // Eight times as far as other bounds: it is one number for entries of all sizes. 590 times by
    // default, of the seven-joint arm.
    let farthest = 8.0 * asked.farthest;
    assert!(worst <= 1.0 && farthest * worst >= 1.0, "{worst:e}");
}
