//! Functions whose results are bounded themselves.
//!
//! In: a robot, a type of number. Out: nothing but a failed assertion where a result of any of them is
//! farther from 106 bits than its bound, or a bound far from the worst.

use homogen_codegen::Function;
use homogen_codegen::accuracy::range::Range;
use homogen_codegen::accuracy::{self, Accuracy, Means};
use homogen_codegen::expand::program_as;
use homogen_codegen::expression::{Double, Evaluation, Expr, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Way;
use homogen_codegen::schedule::{Operand, Program, run};
use homogen_codegen::space::FrameId;
use homogen_tests::states::Random;
use homogen_tests::tested::Tested;

use crate::asked::{Asked, chain_of};
use crate::bounds::holds;
use crate::states::{STATES, state};

/// The functions that have a bound.
const FUNCTIONS: [Function; 10] = [
    Function::ForwardKinematics,
    Function::SpatialJacobian,
    Function::BodyJacobian,
    Function::GeometricJacobian,
    Function::Velocity,
    Function::Acceleration,
    Function::InverseDynamics,
    Function::Gravity,
    Function::Bias,
    Function::MassMatrix,
];

/// The worst error of each result of some programs, whose exact results are given one after the
/// other.
fn measure<T: Tested>(
    programs: &[Program],
    exact: &Evaluation<Double>,
    range: &Range,
) -> Vec<Vec<f64>> {
    let none = |program: &Program| vec![0.0_f64; program.results.len()];
    let mut worst: Vec<Vec<f64>> = programs.iter().map(none).collect();
    let mut random = Random::new(31);
    for _ in 0..STATES {
        let state = state::<T>(range, &mut random);
        let mut expected = exact.at(|input| Double::from(state(input))).into_iter();
        for (program, worst) in programs.iter().zip(&mut worst) {
            let found = run(program, |input| T::literal(state(input)));
            for (found, worst) in found.into_iter().zip(worst) {
                let expected = expected.next().expect("as many results");
                let error = (Double::from(found.to_f64()) - expected).to_f64().abs();
                assert!(error.is_finite());
                *worst = worst.max(error);
            }
        }
    }
    worst
}

/// Every function of a robot in one type.
pub fn check<T: Tested>(asked: Asked) {
    let chain = chain_of(asked);
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
    let exact: Vec<Expr> = (FUNCTIONS.iter())
        .flat_map(|&function| function.build(&graph, &bodies, FrameId::FIRST, Way::PLAIN))
        .map(Term::expr)
        .collect();
    let exact = Evaluation::of(&graph, &exact);
    let programs = FUNCTIONS.map(|function| {
        program_as(
            asked.formulation,
            &chain,
            &[function],
            FrameId::FIRST,
            T::REAL,
        )
        .unwrap_or_else(|errors| panic!("{errors}"))
    });
    let mut measured = measure::<T>(&programs, &exact, &Range::of(&chain));
    // A number that the type has is bounded as if it had to be rounded.
    for (program, measured) in programs.iter().zip(&mut measured) {
        for (result, error) in program.results.iter().zip(measured) {
            if matches!(result, Operand::Literal(_)) {
                *error = 0.0;
            }
        }
    }

    let mut table = format!("{} in {}\n", asked.robot, T::NAME);
    let mut all = true;
    for ((function, program), measured) in FUNCTIONS.iter().zip(&programs).zip(&measured) {
        let means = Means {
            scalar: T::REAL,
            ..Means::default()
        };
        let accuracy = accuracy::of(&chain, &[*function], program, means);
        let Some(Accuracy::Within(promise)) = accuracy else {
            panic!("{function:?}: {accuracy:?}");
        };
        let (bounds, farthest) = (&promise.bounds, asked.farthest);
        all &= holds(&chain, *function, bounds, measured, farthest, &mut table);
    }
    println!("{table}");
    assert!(all, "{table}");
}
