//! Functions with bounds of their results.
//!
//! In: a robot, a scalar type. Out: a failed assertion if the difference of a result from its value in 106 bits exceeds
//! its bound, or if a bound is far above the worst error.

use homogen_codegen::Function;
use homogen_codegen::accuracy::{self, Accuracy, RoundingModel};
use homogen_codegen::chain::Chain;
use homogen_codegen::expression::{Double, Evaluation, Expr, Term};
use homogen_codegen::formulation::Frame;
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Algorithm;
use homogen_codegen::range::Range;
use homogen_codegen::schedule::{Operand, Program, run};
use homogen_codegen::space::FrameId;
use homogen_tests::programs::program_as;
use homogen_tests::states::Random;
use homogen_tests::tested::Tested;

use crate::error_bound::asked::{Asked, chain_of};
use crate::error_bound::bounds::holds;
use crate::error_bound::states::{state, trials};

/// The functions of a robot with a bound of their results.
fn functions(chain: &Chain) -> Vec<Function> {
    // A derivative of a distance has none where two centres may coincide.
    let of_spheres = [Function::SphereCenters, Function::Distances].into_iter();
    let of_spheres = of_spheres.filter(|_| !chain.spheres.is_empty());
    let all = Function::ALL.into_iter().chain(of_spheres);
    all.filter(|function| !(function.solves() || function.is_constrained()))
        .collect()
}

/// The largest allowed ratio of a bound to the worst error. It is larger where more terms cancel: in results from
/// screws and their rates, and in those with a column for each parameter; 770 for the centroidal momentum bias.
fn farthest(asked: Asked, function: Function) -> f64 {
    use Function::{
        Bias, BodyJacobian, ForwardKinematics, GeometricJacobian, Gravity, InverseDynamics,
        InverseDynamicsHessian, MassMatrix, SpatialJacobian, TipAcceleration, TipVelocity,
    };
    match function {
        ForwardKinematics | SpatialJacobian | BodyJacobian | GeometricJacobian | TipVelocity
        | TipAcceleration | InverseDynamics | Gravity | Bias | MassMatrix => asked.farthest,
        // In frame 0 the terms of second derivatives cancel at each joint, and bounds do not see it.
        InverseDynamicsHessian if asked.formulation.frame == Frame::Base => 1e6,
        _ if asked.floating => 500.0,
        _ => 6.0 * asked.farthest,
    }
}

/// The worst error of each result of several programs; `exact` has all their exact results, one after the other.
fn measure<T: Tested>(
    programs: &[Program],
    exact: &Evaluation<Double>,
    chain: &Chain,
) -> Vec<Vec<f64>> {
    let none = |program: &Program| vec![0.0_f64; program.results.len()];
    let mut worst: Vec<Vec<f64>> = programs.iter().map(none).collect();
    let (range, mut random) = (Range::of(chain), Random::new(31));
    for _ in 0..trials() {
        let state = state::<T>(chain, &range, &mut random);
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

/// Checks every function of a robot in one type.
pub fn check<T: Tested>(asked: Asked) {
    let chain = chain_of(asked);
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
    let functions = functions(&chain);
    let exact: Vec<Expr> = (functions.iter())
        .flat_map(|&function| function.build(&graph, &bodies, FrameId::FIRST, Algorithm::PLAIN))
        .map(Term::expr)
        .collect();
    let exact = Evaluation::of(&graph, &exact);
    let programs = functions.iter().map(|&function| {
        let program = program_as(
            asked.formulation,
            &chain,
            &[function],
            FrameId::FIRST,
            T::REAL,
        );
        program.unwrap_or_else(|errors| panic!("{errors}"))
    });
    let programs: Vec<Program> = programs.collect();
    let mut measured = measure::<T>(&programs, &exact, &chain);
    // The bound of an exact literal is that of a rounded one.
    for (program, measured) in programs.iter().zip(&mut measured) {
        for (result, error) in program.results.iter().zip(measured) {
            if matches!(result, Operand::Literal(_)) {
                *error = 0.0;
            }
        }
    }

    let mut table = format!("{} in {}\n", asked.robot, T::NAME);
    let mut all = true;
    for ((function, program), measured) in functions.iter().zip(&programs).zip(&measured) {
        let rounding = RoundingModel {
            scalar: T::REAL,
            ..RoundingModel::default()
        };
        let accuracy = accuracy::of(&chain, &[*function], program, rounding);
        let Some(Accuracy::Within(bound)) = accuracy else {
            panic!("{function:?}: {accuracy:?}");
        };
        let (bounds, farthest) = (&bound.bounds, farthest(asked, *function));
        all &= holds(&chain, *function, bounds, measured, farthest, &mut table);
    }
    println!("{table}");
    assert!(all, "{table}");
}
