//! What functions should return at a few states, for whoever tests the file that they are written to.
//!
//! In: a description, its chain, the functions. Out: for each of them arguments, results and how far these may be
//! off. Results are made of the description by dense matrices of 106 bits, and where they are solved for by
//! elimination in the same: of a program nothing is taken but how far rounding can take it at that very state.

use super::{robot, states};
use crate::accuracy::Means;
use crate::chain::Chain;
use crate::dense::{Approximate, Dense, State};
use crate::description::Description;
use crate::expression::{Double, Input};
use crate::function::{Function, Given, Truth};
use crate::list::Id;
use crate::print::{Listed, Vector};
use crate::real::Real;
use crate::request::Request;
use crate::schedule::Program;
use crate::schedule::bound::{self, Conditions, Value};
use crate::space::{FrameId, Variable};

/// Results of so many numbers are told at two states, longer ones at one.
const SHORT: usize = 100;

/// Which part of the largest result one may be off by where no bound is known, times the square root of the
/// roundoff.
const UNBOUNDED: f64 = 16.0;

/// The same of what may depend on the part of the whole that counts as nothing.
const CERTAIN: f64 = 2.0;

/// How many units of roundoff a pivot may be off by.
const ROUNDINGS: f64 = 16.0;

/// Those of all functions, one state after the other.
pub fn vectors(
    description: &Description,
    request: &Request,
    chain: &Chain,
    (functions, means): (&[Listed], Means),
) -> Vec<Vector> {
    let scalar = means.scalar;
    let at = |state: &State| {
        let robot = robot::robot(description, request, chain, &state.fields)?;
        Ok(Dense::of(robot, state.clone()))
    };
    let mut vectors = Vec::new();
    for (index, state) in states::states(chain, request, 2).iter().enumerate() {
        // A robot that contradicts its chain has been refused before.
        let Ok(open) = at(&rounded(state, chain, scalar)) else {
            continue;
        };
        let closed = states::closed(chain, request, index, at).ok().flatten();
        let mut closed = closed.and_then(|state| at(&in_type_as_it_is(&state, scalar)).ok());
        for (function, listed) in functions.iter().enumerate() {
            if index > 0 && listed.program.results.len() > SHORT {
                continue;
            }
            // Accelerations under loops are determined where these are closed.
            let is_constrained = listed
                .functions
                .iter()
                .any(|function| function.is_constrained());
            let dense = match &mut closed {
                Some(closed) if is_constrained => {
                    if is_uncertain(closed, &listed.functions, scalar) {
                        continue;
                    }
                    closed
                }
                _ => &open,
            };
            let named = |name: &String| chain.frames.find(|of| of.name == *name);
            let frame = listed
                .frame
                .as_ref()
                .and_then(named)
                .unwrap_or(FrameId::FIRST);
            let expected = listed.functions.iter();
            let expected = expected.map(|&function| truth(dense, function, (frame, scalar)));
            let Some(expected) = expected.collect::<Option<Vec<_>>>() else {
                continue;
            };
            let expected = expected.concat();
            let tolerances = tolerances(&dense.state, &listed.program, &expected, means);
            let arguments = listed.arguments(chain.spaces()).into_iter();
            let arguments = arguments.map(|argument| (argument, numbers(&dense.state, argument)));
            vectors.push(Vector {
                function,
                arguments: arguments.collect(),
                fields: dense.state.fields.to_vec(),
                expected: expected
                    .iter()
                    .map(|entry| in_type(entry.to_f64(), scalar))
                    .collect(),
                tolerances,
            });
        }
    }
    vectors
}

/// A state that the type of number has, of few digits.
fn rounded(state: &State, chain: &Chain, scalar: Real) -> State {
    let short = |value: &f64| in_type(shortened(*value), scalar);
    let ranges = chain.spaces().coordinates.iter();
    let q = state.q.iter().zip(ranges).map(|(q, entry)| {
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
    for quaternion in chain.spaces().quaternions() {
        // Few digits have no length 1.
        let exact = state.q.iter().zip(&mut q).skip(quaternion.index());
        for (exact, entry) in exact.take(4) {
            *entry = in_type(exact.to_f64(), scalar).into();
        }
    }
    State {
        q: q.into(),
        qd: state.qd.map(short),
        qdd: state.qdd.map(short),
        tau: state.tau.map(short),
        actions: state.actions.iter().map(short).collect(),
        fields: (state.fields).map(|field| field.iter().map(short).collect()),
    }
}

/// Whether results under loops depend on which part of the whole counts as nothing, or on the rounding of a pivot.
fn is_uncertain(dense: &mut Dense, functions: &[Function], scalar: Real) -> bool {
    let limits = (scalar.vanishing(), ROUNDINGS * scalar.roundoff());
    functions.iter().any(|function| match function.truth() {
        Truth::Constrained(value) => {
            dense.sensitivity(value, limits) > CERTAIN * scalar.roundoff().sqrt()
        }
        _ => false,
    })
}

/// The same state in numbers of the type: with fewer digits, loops that are closed would be open.
fn in_type_as_it_is(state: &State, scalar: Real) -> State {
    let rounded = |value: &f64| in_type(*value, scalar);
    let short = |value: &f64| in_type(shortened(*value), scalar);
    State {
        q: (state.q.iter())
            .map(|q| Double::from(in_type(q.to_f64(), scalar)))
            .collect(),
        qd: state.qd.map(rounded),
        qdd: state.qdd.map(short),
        tau: state.tau.map(short),
        actions: state.actions.iter().map(short).collect(),
        fields: (state.fields).map(|field| field.iter().map(rounded).collect()),
    }
}

/// The number of four digits that is nearest, the same on every machine.
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

fn numbers(state: &State, argument: Variable) -> Vec<f64> {
    match argument {
        Variable::Q => state.q.iter().map(|q| q.to_f64()).collect(),
        Variable::Qd => state.qd.to_vec(),
        Variable::Qdd => state.qdd.to_vec(),
        Variable::Tau => state.tau.to_vec(),
        Variable::Actions => state.actions.clone(),
    }
}

/// What the description says that a function is; none where an equation has no solution.
fn truth(
    dense: &Dense,
    function: Function,
    (frame, scalar): (FrameId, Real),
) -> Option<Vec<Approximate>> {
    let acceleration = || -> Option<Vec<Approximate>> {
        let bias = dense.coasting_torques();
        let lacking = bias.iter().zip(&dense.state.tau);
        let lacking = lacking.map(|(bias, tau)| vec![Approximate::exact(*tau) - *bias]);
        Some(solved(dense, lacking.collect())?.concat())
    };
    let count = dense.state.qd.len();
    let inverse = || {
        let unit = |row: usize| (0..count).map(move |k| if k == row { 1.0 } else { 0.0 });
        let rows = (0..count).map(|row| unit(row).map(Approximate::exact).collect());
        solved(dense, rows.collect())
    };
    match function.truth() {
        Truth::Value(value) | Truth::OfMass(value) => Some(value(dense, frame)),
        Truth::Constrained(value) => Some(value(dense, scalar.vanishing())),
        Truth::Solution(Given::Torques) => acceleration(),
        Truth::Solution(Given::MassMatrix) => Some(inverse()?.concat()),
        Truth::Solution(Given::TorqueDerivatives) => {
            let mut found = Vec::new();
            for of in dense.torque_derivatives_of(acceleration()?.into()) {
                let rows = of.rows();
                let rows = rows.map(|row| row.iter().map(|&entry| -entry).collect());
                found.extend(solved(dense, rows.collect())?.concat());
            }
            found.extend(inverse()?.concat());
            Some(found)
        }
    }
}

/// X of M X = B, row by row, by elimination with the largest pivot.
fn solved(dense: &Dense, mut right: Vec<Vec<Approximate>>) -> Option<Vec<Vec<Approximate>>> {
    let rows = dense.mass_matrix().rows();
    let mut left: Vec<Vec<Approximate>> = rows.map(Vec::from).collect();
    let count = left.len();
    for k in 0..count {
        let size = |row: &usize| left[*row][k].size();
        let pivot = (k..count).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        left.swap(k, pivot);
        right.swap(k, pivot);
        if left[k][k].size() == 0.0 {
            return None;
        }
        let (pivot, above) = (left[k].clone(), right[k].clone());
        for row in (0..count).filter(|row| *row != k) {
            let factor = left[row][k] / pivot[k];
            let less = |row: &mut Vec<Approximate>, pivot: &[Approximate]| {
                for (entry, pivot) in row.iter_mut().zip(pivot) {
                    *entry = *entry - factor * *pivot;
                }
            };
            less(&mut left[row], &pivot);
            less(&mut right[row], &above);
        }
    }
    let rows = right.into_iter().enumerate();
    let rows = rows.map(|(k, row)| row.into_iter().map(|x| x / left[k][k]).collect());
    Some(rows.collect())
}

/// How far the results of a program may be off at a state: by rounding, and by that of what they are held against.
fn tolerances(
    state: &State,
    program: &Program,
    expected: &[Approximate],
    means: Means,
) -> Vec<f64> {
    let scalar = means.scalar;
    let range = |input: Input| {
        let value = state.get(input).to_f64();
        Value::between(value, value)
    };
    let conditions = Conditions {
        scalar,
        angles: means.trigonometry.reach(scalar),
        range: &range,
    };
    let found = bound::results(program, &conditions);
    let largest = expected
        .iter()
        .map(|entry| entry.size())
        .fold(0.0, f64::max);
    let pairs = found.iter().zip(expected);
    let tolerances = pairs.map(|(found, expected)| {
        let bound = found.value.error;
        let unbounded = || UNBOUNDED * scalar.roundoff().sqrt() * largest;
        // What a reader of the file rounds, and what numbers of the description are known to.
        let written = 2.0 * scalar.roundoff() * expected.size() + scalar.smallest();
        let most = bound + written + expected.noise();
        if most.is_finite() { most } else { unbounded() }
    });
    tolerances.map(upwards).collect()
}

/// Two digits, never less.
fn upwards(value: f64) -> f64 {
    format!("{:.1e}", value * 1.05).parse().unwrap_or(value)
}

#[cfg(all(test, feature = "pretty"))]
mod tests {
    use crate::Builder;
    use crate::expression::{Arithmetic, Input};
    use crate::print::{Listing, Vector};
    use crate::real::Real;
    use crate::schedule::{Operand, Operation, run};

    /// How many results of all vectors are not what they should be, in an arithmetic.
    fn failures<T: Arithmetic + Into<f64>>(listing: &Listing) -> usize {
        let review = listing.review.as_ref().expect("it becomes a file");
        let wrong = review.vectors.iter().map(|vector| {
            let found = run(&listing.functions[vector.function].program, |input| {
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

    fn number(vector: &Vector, input: Input) -> f64 {
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
    fn programs_pass_in_either_type_and_no_other_literal_does() {
        for (file, tip) in [
            ("two_link", "tip"),
            ("scara", "tool"),
            ("stanford", "link_6"),
            ("quadruped", "hr_foot"),
        ] {
            let builder = Builder::from_urdf(format!("../robots/{file}.urdf")).tip(tip);
            let listings = [Real::F64, Real::F32].map(|real| {
                builder
                    .clone()
                    .scalar(real)
                    .file_listing()
                    .expect("a robot that ships")
            });
            let [double, single] = &listings;
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
                .find(|listed| listed.name() == "inverse_dynamics")
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
}
