//! The error that stands in the doc comment of each function, against the one that is measured.
//!
//! In: every robot that ships, and random states of the range that its bounds are for, ends of the
//! range among them. Out: that no error is beyond its bound, and no bound far beyond the errors.
//! Programs run as the generated code does, on a target that fuses products with sums and on one that
//! does not; the truth is the same function in the frames of the description, with 106 bits.

use std::fmt::Write;

use homogen_codegen::accuracy::mobility::mobility;
use homogen_codegen::accuracy::range::Range;
use homogen_codegen::accuracy::{self, Accuracy, Bound, Means};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Description, Name, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::{expand, program_as};
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::formulation::{Angles, Formulation, Forward, Frame, Parameters};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Way;
use homogen_codegen::request::{Parameter, Request, Target};
use homogen_codegen::schedule::{Operand, Program, run};
use homogen_codegen::space::Variable;
use homogen_codegen::{Function, Real};
use homogen_tests::states::Random;
use homogen_tests::subjects::{Subject, subject};
use homogen_tests::tested::{F32, F64, Fused32, Fused64, Tested};
use quote::format_ident;

/// How many states are tried, for each robot and type.
const STATES: usize = 1000;

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

/// A robot, and how it is asked for.
#[derive(Clone, Copy)]
struct Asked {
    robot: &'static str,
    tip: &'static str,
    formulation: Formulation,
    /// Links whose masses are fields.
    loads: &'static [&'static str],
    /// How many times the worst error that was measured a bound may be.
    farthest: f64,
}

/// As a robot is asked for without options. The farthest bound is 129 times the worst error, of the
/// bias of the seven-joint arm: rounding errors of opposite signs cancel, which a bound cannot count
/// on.
fn asked(robot: &'static str, tip: &'static str) -> Asked {
    Asked {
        robot,
        tip,
        formulation: Formulation::default(),
        loads: &[],
        farthest: 150.0,
    }
}

/// A robot that ships, by its name, or one made to be hard, by its label.
fn described(asked: Asked) -> (Description, Request) {
    if asked.robot.contains('/') {
        let Subject {
            description,
            request,
        } = subject(asked.robot);
        let formulation = asked.formulation;
        return (
            description,
            Request {
                formulation,
                ..request
            },
        );
    }
    let path = format!(
        "{}/../robots/{}.urdf",
        env!("CARGO_MANIFEST_DIR"),
        asked.robot
    );
    let mut errors = Errors::new();
    let description = read_file(path.as_ref(), None, &mut errors).expect("it is a robot");
    let loads = asked.loads.iter().map(|&link| Parameter {
        field: format_ident!("{link}"),
        target: Target::MassOf(Name::from(link)),
        range: None,
    });
    let request = Request {
        tip: Some(Name::from(asked.tip)),
        parameters: loads.collect(),
        formulation: asked.formulation,
        ..Request::default()
    };
    (description, request)
}

fn chain_of(asked: Asked) -> Chain {
    let (description, request) = described(asked);
    chain::build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A number of the type, within a range and near another.
fn within<T: Tested>(x: f64, [lo, hi]: [f64; 2]) -> f64 {
    let near = T::literal(x).to_f64();
    let step = 2.0 * T::ROUNDOFF * near.abs();
    let back = if near > hi { near - step } else { near };
    T::literal(if back < lo { back + step } else { back }).to_f64()
}

/// Every input somewhere in its range, one in three at an end of it. Fields are of `f64`; all others
/// are numbers of the type.
fn state<T: Tested>(range: &Range, random: &mut Random) -> impl Fn(Input) -> f64 + use<T> {
    let mut any = |[lo, hi]: [f64; 2]| match random.below(6) {
        0 => lo,
        1 => hi,
        // Three numbers, so that it has all its digits.
        _ => {
            let mut more = |less: f64| (0..3).fold(0.0, |x, _| random.unit() + less * x);
            lo + (hi - lo) * 0.5 * (1.0 + more(2.0_f64.powi(-24)))
        }
    };
    let mut rounded = |ranges: &[[f64; 2]]| -> Vec<f64> {
        let ranges = ranges.iter();
        ranges
            .map(|&range| within::<T>(any(range), range))
            .collect()
    };
    let [q, qd, qdd] = [&range.q, &range.qd, &range.qdd].map(|ranges| rounded(ranges));
    let fields = range.fields.iter();
    let fields: Vec<Vec<f64>> = fields
        .map(|field| field.iter().map(|&range| any(range)).collect())
        .collect();
    move |input| match input {
        Input::Variable(Variable::Q, k) => q[usize::from(k)],
        Input::Variable(Variable::Qd, k) => qd[usize::from(k)],
        Input::Variable(Variable::Qdd, k) => qdd[usize::from(k)],
        Input::Parameter(field, k) => fields[usize::from(field)][usize::from(k)],
        Input::Variable(..) => unreachable!("no function here reads it"),
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

/// The worst of the errors of a function's results that a bound is of.
fn worst_of(chain: &Chain, function: Function, bound: &Bound, errors: &[f64]) -> f64 {
    let (result, spaces) = (function.result(), chain.spaces());
    let name = |k: usize| {
        let owner = result.owner(&spaces, k)?;
        Some(&spaces.entries(result.over[0])[owner].name)
    };
    let units = result.units(&spaces).into_iter();
    let own = units.zip(errors).enumerate();
    let own = own.filter(|(k, (unit, _))| *unit == bound.unit && name(*k) == bound.joint.as_ref());
    own.fold(0.0, |most, (_, (_, &error))| most.max(error))
}

/// The number of a bound that is of one type.
fn number(bound: &Bound) -> f64 {
    let number = bound.double.or(bound.single);
    number.expect("it is of one type")
}

/// Whether no joint's error is beyond its bound, and the worst bound of each unit no farther from the
/// worst error than that; in a table.
fn holds(
    chain: &Chain,
    function: Function,
    bounds: &[Bound],
    errors: &[f64],
    farthest: f64,
    table: &mut String,
) -> bool {
    let mut units: Vec<&str> = bounds.iter().map(|bound| bound.unit).collect();
    units.sort_unstable();
    units.dedup();
    let mut holds = true;
    for unit in units {
        let (mut most, mut worst) = (0.0_f64, 0.0_f64);
        for bound in bounds.iter().filter(|bound| bound.unit == unit) {
            let (promised, found) = (number(bound), worst_of(chain, function, bound, errors));
            holds &= found <= promised;
            if found > promised {
                writeln!(table, "{bound:?}: {found:.1e}").expect("a string takes everything");
            }
            (most, worst) = (most.max(promised), worst.max(found));
        }
        // What is exact may have been bounded as if its numbers were not.
        holds &= most <= farthest * worst || worst == 0.0;
        let name = function.name();
        writeln!(table, "{name:20} {unit:6} {worst:9.1e} of {most:9.1e}")
            .expect("a string takes everything");
    }
    holds
}

fn check<T: Tested>(asked: Asked) {
    let chain = chain_of(asked);
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
    let exact: Vec<Expr> = (FUNCTIONS.iter())
        .flat_map(|&function| function.build(&graph, &bodies, 0, Way::PLAIN))
        .map(Term::expr)
        .collect();
    let exact = Evaluation::of(&graph, &exact);
    let programs = FUNCTIONS.map(|function| {
        program_as(asked.formulation, &chain, &[function], 0, T::REAL)
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

/// The program of a function that solves something, and the bounds of what was given, if there are any.
fn solved(asked: Asked, function: Function, scalar: Real) -> Option<(Program, Vec<Bound>)> {
    let (description, request) = described(asked);
    let request = Request {
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
    let results = function.build(&graph, &bodies, 0, Way::PLAIN).into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}

/// Forward dynamics of τ that the inverse of a state needs, and by how much the τ that its result
/// needs is another; whether there are bounds.
fn check_accelerations<T: Tested>(asked: Asked) -> bool {
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
fn check_inverse<T: Tested>(asked: Asked) {
    let found = solved(asked, Function::MassMatrixInverse, T::REAL);
    let (program, bounds) = found.expect("M is provably regular");
    let chain = chain_of(asked);
    let count = chain.joints.len();
    // Of each row, by unit.
    let units = Function::MassMatrix
        .result()
        .units(&chain.spaces())
        .into_iter();
    let lost: Vec<f64> = (units.enumerate())
        .map(|(k, unit)| {
            let joint = &chain.joints[k / count].name;
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

fn check_solved<T: Tested>(asked: Asked) {
    assert!(check_accelerations::<T>(asked), "{}", asked.robot);
    check_inverse::<T>(asked);
}

fn check_both(asked: Asked) {
    check::<F64>(asked);
    check::<F32>(asked);
    check::<Fused64>(asked);
    check::<Fused32>(asked);
    check_solved::<F64>(asked);
    check_solved::<F32>(asked);
    check_solved::<Fused64>(asked);
    check_solved::<Fused32>(asked);
}

macro_rules! robot {
    ($robot:ident, $tip:literal) => {
        #[test]
        fn $robot() {
            check_both(asked(stringify!($robot), $tip));
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

fn panda() -> Asked {
    asked("panda_class", "link8")
}

/// Differences of large sums are not bounded as well as they come out: 5300 times the worst error where
/// products are fused; what is lost of M is then too much in single precision for a solution.
#[test]
fn in_frame_0() {
    let asked = Asked {
        formulation: Formulation {
            frame: Frame::Base,
            ..Formulation::default()
        },
        farthest: 6500.0,
        ..panda()
    };
    check::<F64>(asked);
    check::<F32>(asked);
    check::<Fused64>(asked);
    check::<Fused32>(asked);
    check_solved::<F64>(asked);
    check_solved::<Fused64>(asked);
    assert!(!check_accelerations::<F32>(asked));
}

#[test]
fn with_the_angles_of_parallel_axes_merged() {
    let formulation = Formulation {
        angles: Angles::Merged,
        ..Formulation::default()
    };
    for (robot, tip) in [("ur5_class", "tool0"), ("puma560_general", "tool")] {
        check_both(Asked {
            formulation,
            ..asked(robot, tip)
        });
    }
}

#[test]
fn with_the_parameters_of_the_description() {
    check_both(Asked {
        formulation: Formulation {
            parameters: Parameters::Raw,
            ..Formulation::default()
        },
        farthest: 250.0,
        ..panda()
    });
}

/// Of most robots in double precision alone: what the inertias of two bodies tell of a correction
/// is too little for single precision.
#[test]
fn refined() {
    let refined = |refinements, robot, tip| Asked {
        formulation: Formulation {
            forward: Some(Forward::MassMatrix { refinements }),
            ..Formulation::default()
        },
        ..asked(robot, tip)
    };
    for refinements in [1, 2] {
        let double = [
            ("panda_class", "link8"),
            ("stanford", "tool"),
            ("quadruped", "hr_foot"),
        ];
        for (robot, tip) in double {
            assert!(check_accelerations::<F64>(refined(refinements, robot, tip)));
        }
        let single = refined(refinements, "puma560_general", "tool");
        assert!(check_accelerations::<F32>(single));
    }
}

/// What articulated inertias are is not followed entry by entry: up to 1840 times the worst error; of 16
/// joints in a row, which would all have to be fastest and err the same way, 130000 times.
#[test]
fn by_articulated_bodies() {
    let (in_both, in_double, nowhere) = ([true; 2], [true, false], [false; 2]);
    for (robot, tip, farthest, bounded) in [
        ("two_link", "tip", 1000.0, in_both),
        ("scara", "tool", 1500.0, in_both),
        ("stanford_general", "tool", 1000.0, in_both),
        ("puma560_general", "tool", 1000.0, in_both),
        ("panda_class", "link8", 1500.0, in_double),
        ("quadruped", "hr_foot", 1000.0, in_both),
        // What slides has no mass of its own.
        ("lift/6", "", 1000.0, nowhere),
        ("spatial/16", "", 2e5, in_double),
        ("heavy_tip/1e6", "", 1000.0, in_double),
        ("heavy_base/1e6", "", 1000.0, in_double),
    ] {
        let asked = Asked {
            formulation: Formulation {
                forward: Some(Forward::Articulated),
                ..Formulation::default()
            },
            farthest,
            ..asked(robot, tip)
        };
        let found = [
            check_accelerations::<F64>(asked),
            check_accelerations::<F32>(asked),
        ];
        assert_eq!(found, bounded, "{robot}");
        let fused = [
            check_accelerations::<Fused64>(asked),
            check_accelerations::<Fused32>(asked),
        ];
        assert_eq!(fused, bounded, "{robot}");
    }
}

#[test]
fn with_masses_that_are_known_at_run_time() {
    check_both(Asked {
        loads: &["link3", "link8"],
        ..panda()
    });
}
