//! Robots and states that are hard on arithmetic, computed in each formulation.
//!
//! In: the labels of the hard robots of the tests. Out: for each of them and each formulation the worst
//! error in units of rounding, in relation to the magnitudes that [`crate::truth`] has. Programs are
//! run as they stand, in `f64` or `f32`, without fusing; the tests hold the same cases to limits against
//! 256 bits.

use homogen_codegen::chain::{self, Chain};
use homogen_codegen::expand::program_as;
use homogen_codegen::expression::{Arithmetic, Evaluation, Expr, Input, Term};
use homogen_codegen::formulation::{Formulation, Forward, Frame, Parameters};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Way;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::FrameId;
use homogen_codegen::{Function, Real};
use homogen_plot::heat::Map;
use homogen_random::Random;
use homogen_tests::subjects::subject;

use crate::truth::{Exact, exact};
use Function::{ForwardDynamics, Gravity, InverseDynamics};

/// A robot, a function of it, and what is hard about its states.
struct Case {
    title: &'static str,
    label: &'static str,
    function: Function,
    /// Changes a number in [−1, 1) into a coordinate.
    angle: fn(f64) -> f64,
    /// The same for a rate.
    rate: fn(f64) -> f64,
}

impl Case {
    const fn new(title: &'static str, label: &'static str, function: Function) -> Self {
        Self {
            title,
            label,
            function,
            angle: |x| 4.0 * x,
            rate: |x| 2.0 * x,
        }
    }
}

fn cases() -> Vec<Case> {
    let straight = |case| Case {
        angle: |x| x / 1024.0,
        ..case
    };
    vec![
        Case::new("arm at its base", "panda_class/0", InverseDynamics),
        Case::new("arm 100 m away", "panda_class/100", InverseDynamics),
        Case::new("arm 10 km away", "panda_class/1e4", InverseDynamics),
        Case::new("8 joints, nothing zero", "spatial/8", InverseDynamics),
        Case::new("payload of 1 t", "payload/1e3", InverseDynamics),
        Case {
            angle: |x| (1e5 * x).round() * std::f64::consts::FRAC_PI_2,
            ..Case::new("angles to 10⁵ rad", "panda_class/0", InverseDynamics)
        },
        Case {
            rate: |x| 8192.0 * x,
            ..Case::new("rates to 10⁴ rad/s", "panda_class/0", InverseDynamics)
        },
        Case {
            angle: |x| std::f64::consts::FRAC_PI_2 + x / 1024.0,
            ..Case::new("nearly balanced", "planar/6", Gravity)
        },
        Case::new("arm at its base", "panda_class/0", ForwardDynamics),
        Case::new("8 rods", "planar/8", ForwardDynamics),
        straight(Case::new("8 rods, straight", "planar/8", ForwardDynamics)),
        straight(Case::new("16 rods, straight", "planar/16", ForwardDynamics)),
        Case::new("tip of 1 t", "heavy_tip/1e3", ForwardDynamics),
        Case::new("tip of 1000 t", "heavy_tip/1e6", ForwardDynamics),
        Case::new("base of 1000 t", "heavy_base/1e6", ForwardDynamics),
        Case::new("shrinking rods", "shrinking/8", ForwardDynamics),
        Case::new("growing rods", "growing/8", ForwardDynamics),
        Case::new("a rod of 0.1 mm", "short_link/1e-4", ForwardDynamics),
        Case::new("thin rods", "thin_rod/0", ForwardDynamics),
    ]
}

/// The columns: a title, a formulation, a type.
fn formulations() -> Vec<(&'static str, Formulation, Real)> {
    let default = Formulation::default();
    let forward = |forward| Formulation {
        forward: Some(forward),
        ..default
    };
    let refined = |refinements| forward(Forward::MassMatrix { refinements });
    let frame_0 = Formulation {
        frame: Frame::Base,
        ..default
    };
    let raw = Formulation {
        parameters: Parameters::Raw,
        ..default
    };
    vec![
        ("default", default, Real::F64),
        ("frame 0", frame_0, Real::F64),
        ("raw", raw, Real::F64),
        ("not refined", refined(0), Real::F64),
        ("refined once", refined(1), Real::F64),
        ("refined twice", refined(2), Real::F64),
        (
            "articulated bodies",
            forward(Forward::Articulated),
            Real::F64,
        ),
        ("default f32", default, Real::F32),
    ]
}

/// How many states each error is the worst of.
const STATES: usize = 200;

/// Measures all of them.
pub fn map() -> Map {
    let formulations = formulations();
    let rows = cases().into_iter().map(|case| {
        let of = match case.function {
            ForwardDynamics => "forward",
            Gravity => "gravity",
            _ => "inverse",
        };
        (format!("{of}: {}", case.title), row(&case, &formulations))
    });
    Map {
        title: "Hard cases: worst error of dynamics by formulation".into(),
        unit: "units of rounding".into(),
        columns: formulations
            .iter()
            .map(|(title, ..)| (*title).to_owned())
            .collect(),
        rows: rows.collect(),
        scale: [0.0, 8.0],
    }
}

fn row(case: &Case, formulations: &[(&str, Formulation, Real)]) -> Vec<Option<f64>> {
    let subject = subject(case.label);
    let chain = chain::build(&subject.description, &subject.request).expect("no mistakes");
    let states = states(case, chain.joints.len());
    let truth = truth(&chain, case.function, &states);
    let cell = |(_, formulation, scalar): &(&str, Formulation, Real)| {
        let solves = case.function == ForwardDynamics;
        if formulation.forward.is_some() && !solves {
            return None;
        }
        let program = program_as(
            *formulation,
            &chain,
            &[case.function],
            FrameId::FIRST,
            *scalar,
        )
        .ok()?;
        Some(match scalar {
            Real::F32 => worst::<f32>(&program, &states, &truth) / 2_f64.powi(-24),
            _ => worst::<f64>(&program, &states, &truth) / 2_f64.powi(-53),
        })
    };
    formulations.iter().map(cell).collect()
}

/// q, q̇, q̈ and τ, exact in single precision.
fn states(case: &Case, joints: usize) -> Vec<Vec<f64>> {
    let mut random = Random::new(1);
    let changes: [fn(f64) -> f64; 4] = [case.angle, case.rate, |x| 8.0 * x, |x| 16.0 * x];
    let mut state = || {
        let numbers = changes
            .iter()
            .flat_map(|change| std::iter::repeat_n(change, joints));
        numbers
            .map(|change| single(change(f64::from(random.coarse()))))
            .collect()
    };
    (0..STATES).map(|_| state()).collect()
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding is what is asked for"
)]
fn single(number: f64) -> f64 {
    f64::from(number as f32)
}

fn truth(chain: &Chain, function: Function, states: &[Vec<f64>]) -> Vec<Vec<[f64; 3]>> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function.build(&graph, &bodies, FrameId::FIRST, Way::PLAIN);
    let results: Vec<Expr> = results.into_iter().map(Term::expr).collect();
    let evaluation: Evaluation<Exact> = Evaluation::of(&graph, &results);
    let states = states.iter();
    states
        .map(|state| exact(&evaluation, function, state.len() / 4, state))
        .collect()
}

fn worst<T: Arithmetic + Into<f64>>(
    program: &Program,
    states: &[Vec<f64>],
    truth: &[Vec<[f64; 3]>],
) -> f64 {
    let error = |(state, exact): (&Vec<f64>, &Vec<[f64; 3]>)| {
        let joints = state.len() / 4;
        let found = run(program, |input| {
            T::literal(match input {
                // A state lists them in this order.
                Input::Variable(variable, k) => state[variable as usize * joints + usize::from(k)],
                Input::Parameter(..) => unreachable!("no number was left open"),
            })
        });
        let errors = found
            .into_iter()
            .zip(exact)
            .map(|(found, [high, low, magnitude])| {
                let found: f64 = found.into();
                (found - high - low).abs() / magnitude
            });
        errors.fold(0.0, worse)
    };
    states.iter().zip(truth).map(error).fold(0.0, worse)
}

/// The larger; what is no number counts as infinite.
fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}
