//! Test vectors: expected results of functions at a few states, for tests of a generated file.
//!
//! In: a description, its chain, the functions. Out: for each of them arguments, results and tolerances. Results are
//! computed by dense matrices of the description in 106 bits, and solutions by elimination there; programs give only
//! the bound of their rounding errors at that state.
//!
//! Quaternions have length 1, next to which the scalar type has a number; angles are small enough for the bounds of
//! sines; constrained accelerations are given in configurations with closed loops.

use std::mem;

use super::{robot, states};
use crate::accuracy::RoundingModel;
use crate::chain::Chain;
use crate::dense::{Approximate, Dense, State};
use crate::expression::{Double, Input};
use crate::function::{Function, Given, Truth};
use crate::list::{self, Id, List};
use crate::module::{GeneratedFunction, TestVector};
use crate::quaternion::{normalize, of_length_1};
use crate::real::Real;
use crate::schedule::Program;
use crate::schedule::bound::{self, Conditions, Reason, ResultBound, Value};
use crate::space::{Arguments, FrameId, Kind, Variable, VelocityId};

/// Largest number of results for which there are two states; longer ones have one.
const SHORT: usize = 100;

/// Tolerance relative to the largest result without a bound, times the square root of the roundoff.
const UNBOUNDED: f64 = 16.0;

/// The same for results that may depend on the threshold of zero pivots.
const CERTAIN: f64 = 2.0;

/// Error of a pivot, in units of roundoff.
const ROUNDINGS: f64 = 16.0;

/// Largest number of times that a state is moved nearer to zero until the sines of its angles have bounds.
const NEARER: usize = 8;

/// Factor of one such step.
const BY: f64 = 8.0;

/// The test vectors of all functions, one state after the other.
pub fn vectors(
    chain: &Chain,
    (functions, model): (&[GeneratedFunction], RoundingModel),
) -> Vec<TestVector> {
    let (scalar, generated) = (model.scalar, functions.iter().enumerate());
    let at = |state: State| {
        let robot = robot::robot(chain, &state.fields)?;
        Ok(Dense::of(robot, state))
    };
    let is_constrained = |(_, generated): &(usize, &GeneratedFunction)| {
        generated.functions.iter().any(|of| of.is_constrained())
    };
    let (constrained, free): (Vec<_>, Vec<_>) = generated.partition(is_constrained);
    let mut vectors = Vec::new();
    for (index, drawn) in states::states(chain, 2).iter().enumerate() {
        let is_wanted = |(_, generated): &&(usize, &GeneratedFunction)| {
            index == 0 || generated.program.results.len() <= SHORT
        };
        let mut wanted: Vec<_> = free.iter().filter(is_wanted).collect();
        let mut state = rounded(drawn, chain, (index, scalar));
        for _ in 0..=NEARER {
            // A robot that contradicts its chain has been refused before.
            let Ok(dense) = at(state) else { break };
            wanted.retain(|(function, generated)| {
                let found = rounding(&dense.state, &generated.program, model);
                if found
                    .iter()
                    .any(|found| found.reason == Some(Reason::Angle))
                {
                    return true;
                }
                let of = (*function, *generated);
                vectors.extend(vector(&dense, chain, of, (&found, scalar)));
                false
            });
            if wanted.is_empty() {
                break;
            }
            state = nearer(&dense.state, chain, (index, scalar));
        }
        let mut wanted = constrained.iter().filter(is_wanted).peekable();
        if wanted.peek().is_none() {
            continue;
        }
        let closed = states::closed(chain, index, |state| at(state.clone()));
        let closed = closed.ok().flatten();
        let closed = closed.and_then(|state| at(as_it_is(&state, chain, scalar)).ok());
        let Some(mut closed) = closed else { continue };
        for &(function, generated) in wanted {
            if !is_uncertain(&mut closed, &generated.functions, scalar) {
                let found = rounding(&closed.state, &generated.program, model);
                vectors.extend(vector(
                    &closed,
                    chain,
                    (function, generated),
                    (&found, scalar),
                ));
            }
        }
    }
    vectors
}

/// The test vector of a function at a state; `None` if an equation has no solution.
fn vector(
    dense: &Dense,
    chain: &Chain,
    (function, generated): (usize, &GeneratedFunction),
    (found, scalar): (&[ResultBound], Real),
) -> Option<TestVector> {
    let named = |name: &String| chain.frames.find(|of| of.name == *name);
    let frame = generated.frame.as_ref().and_then(named);
    let frame = frame.unwrap_or(FrameId::FIRST);
    let expected = generated.functions.iter();
    let expected = expected.map(|&function| truth(dense, function, (frame, scalar)));
    let expected = expected.collect::<Option<Vec<_>>>()?.concat();
    let arguments = generated.arguments(chain.spaces()).into_iter();
    let arguments = arguments.map(|argument| (argument, numbers(&dense.state, (argument, scalar))));
    let written = expected.iter();
    Some(TestVector {
        function,
        arguments: arguments.collect(),
        fields: dense.state.fields.to_vec(),
        expected: written
            .map(|entry| in_type(entry.to_f64(), scalar))
            .collect(),
        tolerances: tolerances(found, &expected, scalar),
    })
}

/// A state with few digits in the scalar type; the index selects which entries of quaternions are small.
fn rounded(state: &State, chain: &Chain, (index, scalar): (usize, Real)) -> State {
    let short = |value: &f64| in_type(shortened(*value), scalar);
    let ranges = chain.spaces().coordinates.iter();
    let q = state.arguments[Variable::Q]
        .iter()
        .zip(ranges)
        .map(|(q, entry)| {
            let q = q.to_f64();
            let within = |value: &f64| {
                let [least, most] = entry.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                (least..=most).contains(value)
            };
            // Limits may be closer than digits.
            let found = Some(short(&q)).filter(within);
            Double::from(found.unwrap_or_else(|| in_type(q, scalar)))
        });
    let mut q: Vec<Double> = q.collect();
    for (k, quaternion) in chain.spaces().quaternions().enumerate() {
        let entries = quaternion.index()..quaternion.index() + 4;
        let direction = std::array::from_fn(|k| {
            state.arguments[Variable::Q][quaternion.plus(k).index()].to_f64()
        });
        // A zero scalar part would make a rotation its own inverse.
        let written = of_length_1(direction, (k + index) % 3, scalar);
        q[entries.clone()].copy_from_slice(&written.map(Double::from));
        // The written numbers differ from this by less than a rounding.
        normalize(&mut q[entries]);
    }
    with_coordinates(state, q, |_, value| short(value))
}

/// A state with other coordinates, and with a change of each number of another argument or of a field, which has no
/// variable.
fn with_coordinates(
    state: &State,
    mut q: Vec<Double>,
    change: impl Fn(Option<Variable>, &f64) -> f64,
) -> State {
    State {
        arguments: Arguments::of(|variable| match variable {
            Variable::Q => mem::take(&mut q),
            _ => (state.arguments[variable].iter())
                .map(|entry| change(Some(variable), &entry.to_f64()).into())
                .collect(),
        }),
        fields: (state.fields).map(|field| field.iter().map(|value| change(None, value)).collect()),
    }
}

/// True if constrained results depend on the threshold of zero pivots, or on the rounding of a pivot.
fn is_uncertain(dense: &mut Dense, functions: &[Function], scalar: Real) -> bool {
    let limits = (scalar.zero_pivot(), ROUNDINGS * scalar.roundoff());
    functions.iter().any(|function| match function.truth() {
        Truth::Constrained(value) => {
            dense.sensitivity(value, limits) > CERTAIN * scalar.roundoff().sqrt()
        }
        _ => false,
    })
}

/// The same state in numbers of the type. Fewer digits would open the closed loops.
fn as_it_is(state: &State, chain: &Chain, scalar: Real) -> State {
    let exact = |value: &f64| in_type(*value, scalar);
    let short = |value: &f64| in_type(shortened(*value), scalar);
    let q = state.arguments[Variable::Q].iter();
    let mut q: Vec<Double> = q.map(|q| in_type(q.to_f64(), scalar).into()).collect();
    for quaternion in chain.spaces().quaternions() {
        normalize(&mut q[quaternion.index()..][..4]);
    }
    with_coordinates(state, q, |variable, value| match variable {
        Some(Variable::Qd) | None => exact(value),
        _ => short(value),
    })
}

/// The same state with angles nearer to zero, as far as limits allow.
fn nearer(state: &State, chain: &Chain, (index, scalar): (usize, Real)) -> State {
    let coordinates = chain.spaces().coordinates.iter();
    let q = state.arguments[Variable::Q]
        .iter()
        .zip(coordinates)
        .map(|(q, entry)| {
            let [least, most] = entry.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
            match entry.kind {
                Kind::Rotation => (q.to_f64() / BY).max(least).min(most).into(),
                _ => *q,
            }
        });
    let mut nearer = state.clone();
    nearer.arguments[Variable::Q] = q.collect();
    rounded(&nearer, chain, (index, scalar))
}

/// The nearest number of four digits, the same on every platform.
fn shortened(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the type is the purpose"
)]
fn in_type(value: f64, scalar: Real) -> f64 {
    match scalar {
        Real::F32 => f64::from(value as f32),
        Real::F64 | Real::Generic => value,
    }
}

/// An argument as it is written.
fn numbers(state: &State, (argument, scalar): (Variable, Real)) -> Vec<f64> {
    let entries = state.arguments[argument].iter();
    entries
        .map(|entry| in_type(entry.to_f64(), scalar))
        .collect()
}

/// The value of a function by the description; `None` if an equation has no solution.
fn truth(
    dense: &Dense,
    function: Function,
    (frame, scalar): (FrameId, Real),
) -> Option<Vec<Approximate>> {
    let acceleration = || -> Option<Vec<Approximate>> {
        let right_side = dense.unbalanced_torques().into_iter();
        let right_side = right_side.map(|torque| vec![torque]);
        Some(dense.eliminated(right_side.collect())?.concat())
    };
    match function.truth() {
        Truth::Value(value) | Truth::OfMass(value) => Some(value(dense, frame)),
        Truth::Directional(value) => {
            Some(rows_of(dense.state.velocities(), |unit| value(dense, unit)))
        }
        Truth::Constrained(value) => Some(value(dense, scalar.zero_pivot())),
        Truth::Solution(Given::Torques) => acceleration(),
        Truth::Solution(Given::MassMatrix) => Some(dense.inverse_mass_matrix()?.concat()),
        Truth::Solution(Given::TorqueDerivatives) => {
            let mut found = Vec::new();
            for of in dense.torque_derivatives_of(acceleration()?.into()) {
                let rows = of.rows();
                let rows = rows.map(|row| row.iter().map(|&entry| -entry).collect());
                found.extend(dense.eliminated(rows.collect())?.concat());
            }
            found.extend(dense.inverse_mass_matrix()?.concat());
            Some(found)
        }
        Truth::Solution(Given::Regressor) => dense.accelerations_by_parameters(),
        Truth::Solution(Given::Gradient) => Some(dense.with_accelerations()?.gradient()),
        Truth::Solution(Given::Change) => Some(dense.with_accelerations()?.change()),
        Truth::Solution(Given::Hessian) => {
            let solved = dense.with_accelerations()?;
            Some(rows_of(dense.state.velocities(), |unit| {
                solved.hessian(unit)
            }))
        }
    }
}

/// Some square matrices, by rows, from their products with a row from the left, one after the other.
fn rows_of(
    count: usize,
    product: impl Fn(&List<VelocityId, Approximate>) -> Vec<Approximate>,
) -> Vec<Approximate> {
    let unit = |row: VelocityId| {
        let mut unit = List::filled(Approximate::exact(0.0), count);
        unit[row] = Approximate::exact(1.0);
        product(&unit)
    };
    let rows: Vec<Vec<Approximate>> = list::ids(count).map(unit).collect();
    let matrices = 0..rows.first().map_or(0, |row| row.len() / count);
    let entries = matrices.flat_map(|k| {
        let rows = rows.iter();
        rows.flat_map(move |row| row[k * count..][..count].to_vec())
    });
    entries.collect()
}

/// Bounds of the rounding errors of a program's results at a state.
fn rounding(state: &State, program: &Program, model: RoundingModel) -> Vec<ResultBound> {
    let scalar = model.scalar;
    let range = |input: Input| {
        let meant = state.get(input);
        let (exact, written) = (meant.to_f64(), in_type(meant.to_f64(), scalar));
        Value {
            error: (meant - written.into()).to_f64().abs(),
            ..Value::between(exact.min(written), exact.max(written))
        }
    };
    let conditions = Conditions {
        scalar,
        angles: model.trigonometry.reach(scalar),
        range: &range,
        quaternions: &[],
    };
    bound::results(program, &conditions)
}

/// Tolerances of results: their rounding errors, and those of the expected results.
fn tolerances(found: &[ResultBound], expected: &[Approximate], scalar: Real) -> Vec<f64> {
    let largest = expected
        .iter()
        .map(|entry| entry.size())
        .fold(0.0, f64::max);
    let pairs = found.iter().zip(expected);
    let tolerances = pairs.map(|(found, expected)| {
        let bound = found.value.error;
        let unbounded = || UNBOUNDED * scalar.roundoff().sqrt() * largest;
        let bound = if bound.is_finite() {
            bound
        } else {
            unbounded()
        };
        // Rounding when the file is read, and the uncertainty of the description's numbers.
        let written = 2.0 * scalar.roundoff() * expected.size() + scalar.smallest();
        let most = bound + written + expected.noise();
        if most.is_finite() { most } else { unbounded() }
    });
    tolerances.map(upwards).collect()
}

/// Two digits, rounded up.
fn upwards(value: f64) -> f64 {
    format!("{:.1e}", value * 1.05).parse().unwrap_or(value)
}

#[cfg(all(test, feature = "files"))]
mod tests {
    use crate::Builder;
    use crate::expression::{Arithmetic, Input};
    use crate::function::Function;
    use crate::module::{Module, TestVector};
    use crate::real::{Real, Trigonometry};
    use crate::schedule::{Operand, Operation, run};
    use crate::space::{Kind, Variable};

    /// Number of results of all vectors that are wrong, in an arithmetic.
    fn failures<T: Arithmetic + Into<f64>>(module: &Module) -> usize {
        let review = module.review.as_ref().expect("it becomes a file");
        let wrong = review.vectors.iter().map(|vector| {
            let found = run(&module.functions[vector.function].program, |input| {
                T::literal(number(vector, input))
            });
            let expected = vector.expected.iter().zip(&vector.tolerances);
            let pairs = found.into_iter().map(Into::into).zip(expected);
            pairs
                .filter(|(found, (expected, most))| (found - **expected).abs() > **most)
                .count()
        });
        wrong.sum()
    }

    fn number(vector: &TestVector, input: Input) -> f64 {
        match input {
            Input::Variable(of, k) => {
                let mut arguments = vector.arguments.iter();
                let argument = arguments.find(|(argument, _)| *argument == of);
                argument.expect("what a program reads is an argument").1[usize::from(k)]
            }
            Input::Parameter(field, k) => vector.fields[usize::from(field)][usize::from(k)],
        }
    }

    #[test]
    fn programs_pass_in_either_type_and_with_no_other_literal() {
        for (file, tip) in [
            ("two_link", "tip"),
            ("scara", "tool"),
            ("stanford", "link_6"),
            ("quadruped", "hr_foot"),
        ] {
            let builder = Builder::from_urdf(format!("../robots/{file}.urdf")).tip(tip);
            let modules = [Real::F64, Real::F32].map(|real| {
                builder
                    .clone()
                    .scalar(real)
                    .file_module()
                    .expect("a robot that ships")
            });
            let [double, single] = &modules;
            let functions = double.functions.len();
            let tested = |k: usize| {
                let vectors = &double.review.as_ref().expect("it becomes a file").vectors;
                vectors.iter().any(|vector| vector.function == k)
            };
            assert!((0..functions).all(tested), "{file}");
            assert_eq!(
                (failures::<f64>(double), failures::<f32>(single)),
                (0, 0),
                "{file}"
            );
            let mut wrong = double.clone();
            let program = &mut wrong
                .functions
                .iter_mut()
                .find(|generated| generated.name() == "inverse_dynamics")
                .expect("it is asked for")
                .program;
            let changed = program
                .steps
                .iter_mut()
                .find_map(|step| match &mut step.operation {
                    Operation::Mul(Operand::Literal(literal), _)
                    | Operation::Mul(_, Operand::Literal(literal)) => Some(literal),
                    _ => None,
                });
            *changed.expect("a literal") *= 1.0 + 1e-9;
            assert!(failures::<f64>(&wrong) > 0, "{file}");
        }
    }

    /// Quaternions do not have length 1 to the last digit in any type, and limits go beyond the bounds of sines.
    #[test]
    fn programs_of_every_joint_pass_on_either_base() {
        for is_free in [false, true] {
            let builder = Builder::from_urdf("../tests/robots/every_joint.urdf")
                .tip("link_geared")
                .generate([
                    Function::ForwardKinematics,
                    Function::BodyJacobian,
                    Function::BodyJacobianRate,
                    Function::InverseDynamics,
                    Function::MassMatrix,
                    Function::CoriolisMatrix,
                    Function::GravityDerivative,
                    Function::BaseRegressor,
                ]);
            let builder = if is_free { builder.floating() } else { builder };
            let [double, single] = [Real::F64, Real::F32].map(|real| {
                let module = builder.clone().scalar(real).file_module();
                let module = module.expect("a robot");
                check_angles(&module, real);
                module
            });
            assert_eq!((failures::<f64>(&double), failures::<f32>(&single)), (0, 0));
        }
    }

    fn check_angles(module: &Module, real: Real) {
        let reach = Trigonometry::Own.reach(real);
        let vectors = &module.review.as_ref().expect("it becomes a file").vectors;
        for (function, generated) in module.functions.iter().enumerate() {
            let of = |vector: &&TestVector| vector.function == function;
            assert!(
                vectors.iter().any(|vector| of(&vector)),
                "{}",
                generated.name()
            );
            for vector in vectors.iter().filter(of) {
                let mut arguments = vector.arguments.iter();
                let q = arguments.find(|(argument, _)| *argument == Variable::Q);
                let entries = q.map_or(&[][..], |(_, q)| q).iter();
                let entries = entries.zip(&module.spaces.coordinates);
                let mut turns = entries.filter(|(_, entry)| entry.kind == Kind::Rotation);
                assert!(turns.all(|(q, _)| q.abs() <= reach), "{}", generated.name());
            }
        }
    }
}
