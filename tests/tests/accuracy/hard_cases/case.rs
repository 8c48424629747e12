//! Measurement of hard cases.
//!
//! In: a case, a robot, states. Out: a table of errors; a failed test if an error exceeds its limit.

use homogen_codegen::chain::Chain;
use homogen_codegen::expression::Evaluation;
use homogen_codegen::formulation::Forward;
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::program_by;
use homogen_codegen::schedule::Program;
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};
use homogen_tests::arguments::{self, Arguments};
use homogen_tests::big::Big;
use homogen_tests::metrics::{self, Distribution};
use homogen_tests::oracle::robot::Robot;
use homogen_tests::oracle::{frame_0, link_frames};
use homogen_tests::programs::program;
use homogen_tests::subjects::subject;
use homogen_tests::tested::{F32, F64, Flushed, Fused32, Fused64, Tested};

/// A quantity to measure, and its limit.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The name of the hard case, and of a part of it.
    pub name: &'static str,
    pub function: Function,
    pub variant: Variant,
    pub metric: Metric,
    /// The largest allowed error [u] in double and in single precision, for every type of it; `None` if the case is not
    /// for this precision.
    pub limits: [Option<f64>; 2],
    /// The factor of the limits.
    pub growth: Growth,
}

/// The algorithm and layout of a function.
#[derive(Clone, Copy, Debug)]
pub enum Variant {
    /// The generator's choice.
    Generated,
    /// The default algorithm in a layout.
    WithLayout(Layout),
    /// The factored mass matrix, with so many refinements.
    Refined(usize),
    /// The articulated-body algorithm.
    Articulated,
}

/// The size that an error is relative to.
#[derive(Clone, Copy, Debug)]
pub enum Metric {
    /// S of each result.
    Scaled,
    /// For each torque, the sum of the sizes of its bodies' terms.
    Carried,
    /// 1 for rotations, the sum of all lengths for translations.
    Reach,
    /// The largest result.
    Relative,
    /// Backward: S of each torque that the accelerations need.
    Backward,
}

/// Growth of a limit with the number of joints.
#[derive(Clone, Copy, Debug)]
pub enum Growth {
    Constant,
    /// Proportional to it.
    Joints,
    /// Proportional to its square root, as independent errors add up.
    Root,
}

impl Case {
    /// Scaled errors of a function as generated.
    pub const fn scaled(name: &'static str, function: Function, limit: f64) -> Self {
        Self {
            name,
            function,
            variant: Variant::Generated,
            metric: Metric::Scaled,
            limits: [Some(limit); 2],
            growth: Growth::Constant,
        }
    }

    /// Relative errors of forward dynamics by an algorithm, in double precision.
    pub const fn solved(name: &'static str, variant: Variant, limit: f64) -> Self {
        Self {
            name,
            function: Function::ForwardDynamics,
            variant,
            metric: Metric::Relative,
            limits: [Some(limit), None],
            growth: Growth::Constant,
        }
    }

    /// Adds a limit in single precision.
    pub const fn in_single(self, limit: f64) -> Self {
        let [double, _] = self.limits;
        Self {
            limits: [double, Some(limit)],
            ..self
        }
    }

    pub const fn measured_by(self, metric: Metric) -> Self {
        Self { metric, ..self }
    }

    pub const fn growing(self, growth: Growth) -> Self {
        Self { growth, ..self }
    }

    /// The limit in a type, for a number of joints.
    pub fn limit<T: Tested>(&self, joints: usize) -> Option<f64> {
        let [double, single] = self.limits;
        let limit = match T::REAL {
            Real::F32 => single,
            Real::F64 | Real::Generic => double,
        };
        let joints = f64::from(u32::try_from(joints).expect("few joints"));
        let growth = match self.growth {
            Growth::Constant => 1.0,
            Growth::Joints => joints,
            Growth::Root => joints.sqrt(),
        };
        limit.map(|limit| growth * limit)
    }

    fn program(&self, chain: &Chain, scalar: Real) -> Program {
        let functions = [self.function];
        let algorithm = |forward| Algorithm {
            forward,
            ..Algorithm::PLAIN
        };
        let by =
            |layout, algorithm| program_by(chain, &functions, FrameId::FIRST, layout, algorithm);
        match self.variant {
            Variant::Generated => program(chain, &functions, FrameId::FIRST, scalar)
                .unwrap_or_else(|errors| panic!("{}: {errors}", self.name)),
            Variant::WithLayout(layout) => by(layout, Algorithm::PLAIN),
            Variant::Refined(refinements) => by(
                Layout::DESCRIBED,
                algorithm(Forward::MassMatrix { refinements }),
            ),
            Variant::Articulated => by(Layout::DESCRIBED, algorithm(Forward::Articulated)),
        }
    }
}

/// Arguments, with the true values of the function.
pub struct State {
    arguments: Arguments,
    truth: Vec<Big>,
    /// The sizes for [`Metric::Carried`].
    carried: Vec<f64>,
}

/// A robot with the true values of one of its functions.
pub struct Bench {
    label: String,
    pub chain: Chain,
    robot: Robot,
    function: Function,
    truth: Evaluation<Big>,
    /// Inverse dynamics and a program for its S, if the function is forward dynamics.
    torques: Option<(Evaluation<Big>, Program)>,
}

impl Bench {
    pub fn new(label: &str, function: Function) -> Self {
        let subject = subject(label);
        let chain = subject.chain();
        let torques = || {
            let torques = Function::InverseDynamics;
            let sizes = program_by(
                &chain,
                &[torques],
                FrameId::FIRST,
                Layout::DESCRIBED,
                Algorithm::PLAIN,
            );
            (link_frames::truth(&chain, torques, FrameId::FIRST), sizes)
        };
        Self {
            label: label.to_owned(),
            robot: Robot::of(&subject.description, &subject.request),
            truth: link_frames::truth(&chain, function, FrameId::FIRST),
            torques: (function == Function::ForwardDynamics).then(torques),
            chain,
            function,
        }
    }

    /// The number of joints that move.
    pub fn joints(&self) -> usize {
        self.chain.joints.len()
    }

    /// The sum of the lengths of all links \[m\].
    fn reach(&self) -> f64 {
        let lengths = self.robot.bodies.iter().map(|body| {
            let squares = body.placement.column().map(|x| x.to_f64().powi(2));
            squares.iter().sum::<f64>().sqrt()
        });
        lengths.sum()
    }

    pub fn truth(&self, arguments: &Arguments) -> Vec<Big> {
        link_frames::evaluate(&self.truth, arguments)
    }

    /// Computes the true values and sizes that a case needs at a state.
    pub fn prepare(&self, case: &Case, arguments: Arguments) -> State {
        let carried = match case.metric {
            Metric::Carried => frame_0::torque_sizes(&self.robot, &arguments),
            _ => Vec::new(),
        };
        State {
            truth: self.truth(&arguments),
            carried,
            arguments,
        }
    }

    fn error<T: Tested>(
        &self,
        case: &Case,
        program: &Program,
        State {
            arguments,
            truth,
            carried,
        }: &State,
    ) -> f64 {
        let found = metrics::results::<T>(program, arguments);
        match case.metric {
            Metric::Scaled => {
                let sizes = metrics::sizes::<T>(program, arguments);
                metrics::largest(metrics::scaled::<T>(&found, truth, &sizes))
            }
            Metric::Carried => metrics::largest(metrics::scaled::<T>(&found, truth, carried)),
            Metric::Reach => {
                let sizes: Vec<f64> = (0..12)
                    .map(|entry| if entry % 4 == 3 { self.reach() } else { 1.0 })
                    .collect();
                metrics::largest(metrics::scaled::<T>(&found, truth, &sizes))
            }
            Metric::Relative => metrics::relative::<T>(&found, truth),
            Metric::Backward => {
                if !found.iter().all(|x| x.is_finite()) {
                    return f64::INFINITY;
                }
                let given = arguments;
                let mut arguments = arguments.clone();
                arguments[Variable::Qdd] = found;
                let (torques, sizes) = self.torques.as_ref().expect("made for forward dynamics");
                let needed = link_frames::evaluate(torques, &arguments);
                let sizes = metrics::sizes::<T>(sizes, &arguments);
                metrics::largest(metrics::backward::<T>(
                    &given[Variable::Tau],
                    &needed,
                    &sizes,
                ))
            }
        }
    }

    /// The program of a case in a type.
    pub fn program<T: Tested>(&self, case: &Case) -> Program {
        assert_eq!(self.function, case.function);
        case.program(&self.chain, T::REAL)
    }

    /// The errors of a case at several states.
    pub fn measure<T: Tested>(
        &self,
        case: &Case,
        program: &Program,
        states: &[State],
    ) -> Distribution {
        let mut errors = Distribution::default();
        for state in states {
            let error = self.error::<T>(case, program, state);
            errors.note(error, &state.arguments);
        }
        errors
    }
}

/// Measures cases of one function and one metric, at states of a robot, in all types.
pub fn judge(cases: &[&Case], label: &str, states: impl Fn(&Chain) -> Vec<Arguments>) {
    let bench = Bench::new(label, cases[0].function);
    let states: Vec<State> = states(&bench.chain)
        .into_iter()
        .map(|arguments| bench.prepare(cases[0], arguments))
        .collect();
    let mut beyond = String::new();
    for case in cases {
        let [double, single] = case.limits;
        if double.is_some() {
            let program = bench.program::<F64>(case);
            beyond += &judge_in::<F64>(case, &bench, &program, &states);
            beyond += &judge_in::<Fused64>(case, &bench, &program, &states);
        }
        if single.is_some() {
            let program = bench.program::<F32>(case);
            beyond += &judge_in::<F32>(case, &bench, &program, &states);
            beyond += &judge_in::<Flushed>(case, &bench, &program, &states);
            beyond += &judge_in::<Fused32>(case, &bench, &program, &states);
        }
    }
    assert!(beyond.is_empty(), "beyond the limit:\n{beyond}");
}

/// Measures in one type. Returns the worst input as a line of the table of worst inputs if it exceeds the limit.
fn judge_in<T: Tested>(case: &Case, bench: &Bench, program: &Program, states: &[State]) -> String {
    let Some(limit) = case.limit::<T>(bench.joints()) else {
        return String::new();
    };
    let errors = bench.measure::<T>(case, program, states);
    let (worst, arguments) = errors.worst();
    let (name, label, of) = (case.name, &bench.label, T::NAME);
    println!(
        "{name:32} {label:20} {of:9} median {:8.2e}  99 % {:8.2e}  worst {worst:8.2e}  limit {limit:8.2e} u",
        errors.quantile(0.5),
        errors.quantile(0.99),
    );
    let line = format!("{name} {label} {of} {}", arguments::line(arguments));
    println!("> {worst:e} {line}");
    if worst <= limit {
        String::new()
    } else {
        format!("{worst:e} u of {limit:e}: {line}\n")
    }
}
