//! The error that stands in the doc comment of each function, against the one that is measured.
//!
//! In: every robot that ships, and random states of the range that its bounds are for, ends of the
//! range among them. Out: that no error is beyond its bound, and no bound far beyond the errors.
//! Programs run as the generated code does on a target that does not fuse; the reference is the same
//! function in the frames of the description, with 106 bits.

use std::fmt::Write;

use homogen_codegen::accuracy::{self, Accuracy};
use homogen_codegen::chain::frames::{Layout, arrange};
use homogen_codegen::chain::range::Range;
use homogen_codegen::chain::{self, Chain, Motion};
use homogen_codegen::description::{Name, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::program;
use homogen_codegen::expression::{Arithmetic, Double, Evaluation, Expr, Input, Term};
use homogen_codegen::model::{self, Way};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::{Function, Real};
use homogen_tests::states::Random;

/// How many states are tried, for each robot and type.
const STATES: usize = 1000;

/// How far a bound may be from the worst error that was measured. The farthest is 129, of the bias
/// of the seven-joint arm: rounding errors of opposite signs cancel, which a bound cannot count on.
const FARTHEST: f64 = 150.0;

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

fn chain_of(robot: &str, tip: &str) -> Chain {
    let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
    let mut errors = Errors::new();
    let description = read_file(path.as_ref(), None, &mut errors).expect("it is a robot");
    let request = Request {
        tip: Some(Name::from(tip)),
        ..Request::default()
    };
    chain::build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A type of number under test.
trait Tested: Arithmetic + Copy + Into<f64> {
    const REAL: Real;
    /// A number of the type, within a range and near another.
    fn within(x: f64, range: [f64; 2]) -> Self;
}

impl Tested for f64 {
    const REAL: Real = Real::F64;

    fn within(x: f64, [lo, hi]: [f64; 2]) -> Self {
        x.clamp(lo, hi)
    }
}

impl Tested for f32 {
    const REAL: Real = Real::F32;

    #[expect(clippy::cast_possible_truncation, reason = "it is the type under test")]
    fn within(x: f64, [lo, hi]: [f64; 2]) -> Self {
        let near = x as Self;
        if f64::from(near) > hi {
            near.next_down()
        } else if f64::from(near) < lo {
            near.next_up()
        } else {
            near
        }
    }
}

/// Every input somewhere in its range, one in three at an end of it.
fn state<T: Tested>(range: &Range, random: &mut Random) -> impl Fn(Input) -> T + use<T> {
    let mut any = |ranges: &[[f64; 2]]| -> Vec<T> {
        let mut one = |[lo, hi]: [f64; 2]| match random.below(6) {
            0 => lo,
            1 => hi,
            // Three numbers, so that it has all its digits.
            _ => {
                let mut more = |less: f64| (0..3).fold(0.0, |x, _| random.unit() + less * x);
                lo + (hi - lo) * 0.5 * (1.0 + more(2.0_f64.powi(-24)))
            }
        };
        let numbers = ranges.iter().map(|&range| T::within(one(range), range));
        numbers.collect()
    };
    let [q, qd, qdd] = [any(&range.q), any(&range.qd), any(&range.qdd)];
    move |input| match input {
        Input::Q(k) => q[usize::from(k)],
        Input::Qd(k) => qd[usize::from(k)],
        Input::Qdd(k) => qdd[usize::from(k)],
        Input::Tau(_) | Input::Parameter(..) => unreachable!("no function here reads it"),
    }
}

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
        let mut expected = exact
            .at(|input| Double::from(state(input).into()))
            .into_iter();
        for (program, worst) in programs.iter().zip(&mut worst) {
            for (found, worst) in run(program, &state).into_iter().zip(worst) {
                let expected = expected.next().expect("as many results");
                let error = (Double::from(found.into()) - expected).to_f64().abs();
                assert!(error.is_finite());
                *worst = worst.max(error);
            }
        }
    }
    worst
}

fn check<T: Tested>(robot: &str, tip: &str) {
    let chain = chain_of(robot, tip);
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
    let exact: Vec<Expr> = (FUNCTIONS.iter())
        .flat_map(|&function| model::build(&graph, &bodies, function, 0, Way::PLAIN))
        .map(Term::expr)
        .collect();
    let exact = Evaluation::of(&graph, &exact);
    let programs = FUNCTIONS.map(|function| {
        program(&chain, &[function], 0, T::REAL).unwrap_or_else(|errors| panic!("{errors}"))
    });
    let measured = measure::<T>(&programs, &exact, &Range::of(&chain));

    let slides = |joint: &chain::Joint| matches!(joint.motion, Motion::Prismatic);
    let slides: Vec<bool> = chain.joints.iter().map(slides).collect();
    let mut table = String::new();
    let mut holds = true;
    for ((function, program), measured) in FUNCTIONS.iter().zip(&programs).zip(&measured) {
        let accuracy = accuracy::of(&chain, &[*function], program, T::REAL);
        let Accuracy::Within { bounds, .. } = accuracy else {
            panic!("{function:?}: {accuracy}");
        };
        let units = function.units(&slides);
        for bound in bounds {
            let (name, unit) = (function.name(), bound.unit);
            let most = bound.double.or(bound.single).expect("it is of one type");
            let of_unit = units.iter().zip(measured).filter(|(of, _)| **of == unit);
            let worst = of_unit.fold(0.0_f64, |most, (_, &error)| most.max(error));
            // What is exact may have been bounded as if its numbers were not.
            holds &= worst <= most && (most <= FARTHEST * worst || worst == 0.0);
            writeln!(table, "{name:20} {unit:6} {worst:9.1e} of {most:9.1e}")
                .expect("a string takes everything");
        }
    }
    println!("{robot}, worst error of bound\n{table}");
    assert!(holds, "{robot}\n{table}");
}

macro_rules! robot {
    ($name:ident, $tip:literal) => {
        #[test]
        fn $name() {
            check::<f64>(stringify!($name), $tip);
            check::<f32>(stringify!($name), $tip);
        }
    };
}

robot!(two_link, "tip");
robot!(scara, "tool");
robot!(stanford, "tool");
robot!(stanford_general, "tool");
robot!(puma560, "tool");
robot!(puma560_general, "tool");
robot!(ur5_class, "tool0");
robot!(panda_class, "link8");
robot!(quadruped, "hr_foot");
