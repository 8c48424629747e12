//! Formulations other than the default: generated code computes the same, and each word of a formulation has its
//! effect.

use std::path::Path;

use homogen::robot::{ForwardDynamics, MassMatrixInverse};
use homogen::{Robot, generic};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Name, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::Input;
use homogen_codegen::formulation::{Formulation, Forward, Frame, Parameters};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{OperationCount, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};
use homogen_robots::with_every_function;
use homogen_tests::effort::effort;
use homogen_tests::functions::{EveryFunction, evaluate};
use homogen_tests::programs::program_as;
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};
use homogen_tests::subjects::subject;

/// States of each robot.
fn count() -> usize {
    effort(50, 200)
}

/// Derives a robot in a formulation, with some functions and those that solve for accelerations.
macro_rules! robot {
    (
        [$($function:ident),*] $(#[$about:meta])*
        $name:ident, $urdf:literal, $tip:literal: $($words:tt)*
    ) => {
        $(#[$about])*
        #[derive(Robot)]
        #[robot(urdf = $urdf, tip = $tip, generate($($function,)* forward_dynamics, mass_matrix_inverse))]
        #[robot(formulation($($words)*))]
        struct $name;
    };
}

with_every_function! { robot!
    /// Every operation is rounded separately, as by `run`.
    Plain, "../../robots/panda_class.urdf", "link8": unfused, platform_sines
}
with_every_function! { robot!
    /// In frame 0, as in the paper.
    InFrame0, "../../robots/panda_class.urdf", "link8": frame_0, raw, unfused, platform_sines
}
with_every_function! { robot!
    /// Three parallel axes with merged angles.
    Merged, "../../robots/ur5_class.urdf", "tool0": merged
}

robot! {
    []
    /// Accelerations by the articulated-body algorithm.
    Articulated, "../../robots/panda_class.urdf", "link8": articulated
}
robot! {
    []
    /// Accelerations refined twice.
    Refined, "../../robots/panda_class.urdf", "link8": refined = 2
}
robot! {
    [gravity]
    /// Separate angles, by name.
    Apart, "../../robots/ur5_class.urdf", "tool0": apart
}

/// Compares every function that solves nothing with the dense recursions, in units of rounding.
fn agree<R, const N: usize>(robot: &R, chain: &homogen::Chain<N, 1>, limit: f64)
where
    R: EveryFunction<N, f64>,
{
    let mut random = Random::new(8);
    let mut worst = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let state: State<f64, N> = State::random(&mut random);
        worst.note(&evaluate(robot, &state), &evaluate(chain, &state));
    }
    println!("{worst}");
    worst.assert_within(limit);
}

/// Forward dynamics inverts inverse dynamics, and the inverse of the mass matrix is that of the dense recursions.
fn solve<R, const N: usize>(robot: &R, chain: &homogen::Chain<N, 1>)
where
    R: ForwardDynamics<N, f64> + MassMatrixInverse<N, f64>,
{
    let mut random = Random::new(8);
    let mut furthest: f64 = 0.0;
    let mut inverted: f64 = 0.0;
    for _ in 0..count() {
        let state: State<f64, N> = State::random(&mut random);
        let tau = generic::inverse_dynamics(chain, &state.q, &state.qd, &state.qdd);
        let found = robot.forward_dynamics(&state.q, &state.qd, &tau);
        let differences = found.iter().zip(state.qdd).map(|(x, y)| (x - y).abs());
        furthest = differences.fold(furthest, f64::max);
        let (found, exact) = (
            robot.mass_matrix_inverse(&state.q),
            generic::mass_matrix_inverse(chain, &state.q),
        );
        let [found, exact] = [&found, &exact].map(|rows| rows.as_flattened());
        let size = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let differences = found.iter().zip(exact).map(|(x, y)| (x - y).abs() / size);
        inverted = differences.fold(inverted, f64::max);
    }
    println!("q̈ {furthest:.1e}, M⁻¹ {inverted:.1e}");
    // The dense recursions have most of that error.
    assert!(inverted < 1e-12, "{inverted:e} of the largest entry");
    assert!(furthest < 1e-9, "{furthest:e} rad/s²");
}

#[test]
fn unfused_code_computes_the_same() {
    agree(&Plain, &Plain::chain(), 64.0);
    solve(&Plain, &Plain::chain());
}

#[test]
fn code_in_frame_0_computes_the_same() {
    agree(&InFrame0, &InFrame0::chain(), 64.0);
    solve(&InFrame0, &InFrame0::chain());
}

#[test]
fn every_algorithm_of_forward_dynamics_computes_the_same() {
    solve(&Articulated, &Articulated::chain());
    solve(&Refined, &Refined::chain());
}

#[test]
fn merged_angles_compute_the_same() {
    agree(&Merged, &Merged::chain(), 64.0);
    solve(&Merged, &Merged::chain());
    solve(&Apart, &Apart::chain());
}

/// After many full turns of a joint, rounding the sum with the next angle loses digits.
#[test]
fn merged_large_angles_lose_the_documented_digits() {
    let turns = 1e6;
    let q = [0.3, turns, 1.0 / 3.0, 0.1, 0.4, -0.5];
    let found = |tau: [f64; 6], expected: [f64; 6]| {
        let differences = tau.iter().zip(expected).map(|(x, y)| (x - y).abs());
        let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        differences.fold(0.0, f64::max) / largest
    };
    let expected = generic::gravity(&Apart::chain(), &q);
    let apart = found(Apart.gravity(&q), expected);
    let merged = found(Merged.gravity(&q), expected);
    assert!(apart <= 16.0 * DOUBLE, "{apart:e}");
    assert!(merged <= 4.0 * turns * DOUBLE, "{merged:e}");
    assert!(
        merged > 16.0 * DOUBLE,
        "{merged:e}: merging has no error to document"
    );
}

/// Inverse dynamics by the engine's own program.
fn interpreted(formulation: Formulation, state: &State<f64, 7>) -> Vec<f64> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/panda_class.urdf");
    let mut errors = Errors::new();
    let description = read_file(Path::new(file), None, &mut errors).expect("a robot");
    let tip = Name {
        text: "link8".to_owned(),
        ..Name::default()
    };
    let request = Request {
        tip: Some(tip),
        ..Request::default()
    };
    let chain = chain::build(&description, &request)
        .unwrap_or_else(|errors| panic!("{errors}"))
        .identified();
    let functions = [Function::InverseDynamics];
    let program = program_as(formulation, &chain, &functions, FrameId::FIRST, Real::F64);
    let program = program.unwrap_or_else(|errors| panic!("{errors}"));
    run(&program, |input| match input {
        Input::Variable(Variable::Q, k) => state.q[usize::from(k)],
        Input::Variable(Variable::Qd, k) => state.qd[usize::from(k)],
        Input::Variable(Variable::Qdd, k) => state.qdd[usize::from(k)],
        other => panic!("inverse dynamics reads {other:?}"),
    })
}

fn bits(numbers: impl IntoIterator<Item = f64>) -> Vec<u64> {
    numbers.into_iter().map(f64::to_bits).collect()
}

#[test]
fn unfused_code_gives_the_bits_of_the_program() {
    let state: State<f64, 7> = State::random(&mut Random::new(9));
    let State { q, qd, qdd } = &state;
    let plain = interpreted(Formulation::default(), &state);
    assert_eq!(bits(Plain.inverse_dynamics(q, qd, qdd)), bits(plain));
    let in_frame_0 = Formulation::default()
        .with_frame(Frame::Base)
        .with_parameters(Parameters::Raw);
    let in_frame_0 = interpreted(in_frame_0, &state);
    assert_eq!(
        bits(InFrame0.inverse_dynamics(q, qd, qdd)),
        bits(in_frame_0)
    );
}

/// The cost of factors per joint grows with the number of joints, that of articulated bodies does not; refinements cost
/// most. Algorithms are accurate enough up to 100 u in a thousand states, which the hard cases test.
#[test]
fn the_cheapest_algorithm_is_chosen_of_those_that_are_accurate_enough() {
    const FACTORS: Forward = Forward::UNREFINED;
    const REFINED: Forward = Forward::MassMatrix { refinements: 1 };
    let cost = |chain: &Chain, function, forward| {
        let formulation = Formulation::default().with_forward(forward);
        let program = program_as(formulation, chain, &[function], FrameId::FIRST, Real::F64);
        let operation_count =
            OperationCount::of(&program.unwrap_or_else(|errors| panic!("{errors}")));
        operation_count.mul + operation_count.add
    };
    let of_robots = [
        ("panda_class/0", FACTORS, FACTORS),
        ("quadruped/0", FACTORS, FACTORS),
        ("shrinking/12", Forward::Articulated, Forward::Articulated),
        ("planar/8", Forward::Articulated, Forward::Articulated),
        ("spatial/8", Forward::Articulated, Forward::Articulated),
        ("heavy_tip/1e3", REFINED, REFINED),
    ];
    for (label, of_dynamics, of_inverse) in of_robots {
        let chain = subject(label).chain();
        for (function, algorithm) in [
            (Function::ForwardDynamics, of_dynamics),
            (Function::MassMatrixInverse, of_inverse),
        ] {
            let chosen = cost(&chain, function, None);
            let algorithms = [FACTORS, Forward::Articulated, REFINED];
            let costs = algorithms.map(|forward| (forward, cost(&chain, function, Some(forward))));
            println!("{label}, {}: {chosen} of {costs:?}", function.name());
            assert!(
                costs.contains(&(algorithm, chosen)),
                "{label}, {function:?}"
            );
        }
    }
    // Articulated bodies that rotate inertias in full cost a little more, and less than a refinement.
    let chain = subject("waist_with_arm/0").chain();
    for function in [Function::ForwardDynamics, Function::MassMatrixInverse] {
        let [sparing, refined] =
            [Forward::Articulated, REFINED].map(|by| cost(&chain, function, Some(by)));
        let chosen = cost(&chain, function, None);
        let costs = [sparing, chosen, refined];
        assert!(
            costs.is_sorted() && sparing < chosen,
            "{function:?}: {costs:?}"
        );
    }
}
