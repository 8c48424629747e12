//! Generated code in formulations other than the default: what it computes is the same, and each
//! word of a formulation reaches it.

use std::path::Path;

use homogen::robot::{ForwardDynamics, MassMatrixInverse};
use homogen::{Robot, generic};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Name, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::Input;
use homogen_codegen::formulation::{Formulation, Forward, Frame, Parameters};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Price, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};
use homogen_tests::functions::{EveryFunction, evaluate};
use homogen_tests::programs::program_as;
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};
use homogen_tests::subjects::subject;

const STATES: usize = 200;

/// Derives a robot in a formulation.
macro_rules! robot {
    ($(#[$about:meta])* $name:ident, $urdf:literal, $tip:literal: $($words:tt)*) => {
        $(#[$about])*
        #[derive(Robot)]
        #[robot(urdf = $urdf, tip = $tip, generate(all))]
        #[robot(formulation($($words)*))]
        struct $name;
    };
}

robot! {
    /// Every operation rounded for itself, as `run` does it.
    Plain, "../robots/panda_class.urdf", "link8": unfused, platform_sines
}
robot! {
    /// As the paper writes it.
    InFrame0, "../robots/panda_class.urdf", "link8": frame_0, raw, unfused, platform_sines
}
robot! {
    /// Accelerations by articulated bodies.
    Articulated, "../robots/panda_class.urdf", "link8": articulated
}
robot! {
    /// Accelerations refined twice, for no need.
    Refined, "../robots/panda_class.urdf", "link8": refined = 2
}

robot! {
    /// Three parallel axes, whose angles are summed.
    Merged, "../robots/ur5_class.urdf", "tool0": merged
}
robot! {
    /// The same arm with each angle by itself.
    Apart, "../robots/ur5_class.urdf", "tool0": apart
}

/// Every function against the dense recursions, in units of rounding.
fn agree<R, const N: usize>(robot: &R, chain: &homogen::Chain<N, 1>, limit: f64)
where
    R: EveryFunction<N, f64> + ForwardDynamics<N, f64> + MassMatrixInverse<N, f64>,
{
    let mut random = Random::new(8);
    let mut worst = Worst::in_units_of(DOUBLE);
    let mut furthest: f64 = 0.0;
    let mut inverted: f64 = 0.0;
    for _ in 0..STATES {
        let state: State<f64, N> = State::random(&mut random);
        worst.note(&evaluate(robot, &state), &evaluate(chain, &state));
        // The torques of a motion give the motion back.
        let tau = generic::inverse_dynamics(chain, &state.q, &state.qd, &state.qdd);
        let found = robot.forward_dynamics(&state.q, &state.qd, &tau);
        let missed = found.iter().zip(state.qdd).map(|(x, y)| (x - y).abs());
        furthest = missed.fold(furthest, f64::max);
        let (found, exact) = (
            robot.mass_matrix_inverse(&state.q),
            generic::mass_matrix_inverse(chain, &state.q),
        );
        let [found, exact] = [&found, &exact].map(|rows| rows.as_flattened());
        let size = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let missed = found.iter().zip(exact).map(|(x, y)| (x - y).abs() / size);
        inverted = missed.fold(inverted, f64::max);
    }
    println!("{worst}q̈ {furthest:.1e}, M⁻¹ {inverted:.1e}");
    // The dense recursions have most of that error.
    assert!(inverted < 1e-12, "{inverted:e} of the largest entry");
    worst.assert_within(limit);
    assert!(furthest < 1e-9, "{furthest:e} rad/s²");
}

#[test]
fn unfused_code_computes_the_same() {
    agree(&Plain, &Plain::chain(), 64.0);
}

#[test]
fn code_in_frame_0_computes_the_same() {
    agree(&InFrame0, &InFrame0::chain(), 64.0);
}

#[test]
fn every_form_of_forward_dynamics_computes_the_same() {
    agree(&Articulated, &Articulated::chain(), 64.0);
    agree(&Refined, &Refined::chain(), 64.0);
}

#[test]
fn summed_angles_compute_the_same() {
    agree(&Merged, &Merged::chain(), 64.0);
    agree(&Apart, &Apart::chain(), 64.0);
}

/// After many turns of a joint, the sum with the next one's angle has no room for all its digits.
#[test]
fn the_sum_of_large_angles_costs_what_is_said() {
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
        "{merged:e}: the sum is no dearer than it is cheap"
    );
}

/// Inverse dynamics of the engine's own program, run as it stands.
fn interpreted(formulation: Formulation, state: &State<f64, 7>) -> Vec<f64> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/panda_class.urdf");
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
fn unfused_code_is_the_program_bit_for_bit() {
    let state: State<f64, 7> = State::random(&mut Random::new(9));
    let State { q, qd, qdd } = &state;
    let plain = interpreted(Formulation::default(), &state);
    assert_eq!(bits(Plain.inverse_dynamics(q, qd, qdd)), bits(plain));
    let in_frame_0 = Formulation {
        frame: Frame::Base,
        parameters: Parameters::Raw,
        ..Formulation::default()
    };
    let in_frame_0 = interpreted(in_frame_0, &state);
    assert_eq!(
        bits(InFrame0.inverse_dynamics(q, qd, qdd)),
        bits(in_frame_0)
    );
}

/// Factors cost ever more for each further joint, articulated bodies the same; refinements cost more than
/// either. Which are accurate enough, 100 u in a thousand states, the hard cases tell.
#[test]
fn the_cheapest_form_is_taken_of_those_that_are_accurate_enough() {
    const FACTORS: Forward = Forward::UNREFINED;
    const REFINED: Forward = Forward::MassMatrix { refinements: 1 };
    let weight = |chain: &Chain, function, forward| {
        let formulation = Formulation {
            forward,
            ..Formulation::default()
        };
        let program = program_as(formulation, chain, &[function], FrameId::FIRST, Real::F64);
        let price = Price::of(&program.unwrap_or_else(|errors| panic!("{errors}")));
        price.mul + price.add
    };
    let of_robots = [
        ("panda_class/0", FACTORS, FACTORS),
        ("quadruped/0", FACTORS, FACTORS),
        ("shrinking/12", Forward::Articulated, Forward::Articulated),
        ("planar/8", Forward::Articulated, Forward::Articulated),
        ("spatial/8", Forward::Articulated, Forward::Articulated),
        ("heavy_tip/1e3", REFINED, REFINED),
        ("waist_with_arm/0", REFINED, REFINED),
    ];
    for (label, of_dynamics, of_inverse) in of_robots {
        let chain = subject(label).chain();
        for (function, form) in [
            (Function::ForwardDynamics, of_dynamics),
            (Function::MassMatrixInverse, of_inverse),
        ] {
            let taken = weight(&chain, function, None);
            let forms = [FACTORS, Forward::Articulated, REFINED];
            let weights = forms.map(|form| (form, weight(&chain, function, Some(form))));
            println!("{label}, {}: {taken} of {weights:?}", function.name());
            assert!(weights.contains(&(form, taken)), "{label}, {function:?}");
        }
    }
}
