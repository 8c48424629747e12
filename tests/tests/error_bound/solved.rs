//! Functions that solve something: what is bounded is by how much what they were given is another.
//!
//! In: a robot, a type of number. Out: nothing but a failed assertion where the τ that accelerations need
//! misses the given τ by more than its bound, or the inverse of M what its bound lets it be off by.

use homogen_codegen::accuracy::mobility::mobility;
use homogen_codegen::accuracy::{Accuracy, Bound};
use homogen_codegen::chain::Chain;
use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Way;
use homogen_codegen::range::Range;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};
use homogen_tests::states::Random;
use homogen_tests::tested::{F64, Tested};

use crate::asked::{Asked, chain_of, described};
use crate::bounds::{holds, number};
use crate::states::{STATES, state};

/// The program of a function that solves something, and the bounds of what was given, if there are any.
fn solved(asked: Asked, function: Function, scalar: Real) -> Option<(Program, Vec<Bound>)> {
    let (program, bounds) = all_solved(asked, &[function], scalar);
    let mut bounds = bounds.into_iter();
    let found = bounds.next().expect("something is said");
    assert!(bounds.next().is_none(), "{function:?} is one solution");
    found.map(|bounds| (program, bounds))
}

/// The same of functions that solve several things: for each the bounds, if there are any.
fn all_solved(
    asked: Asked,
    functions: &[Function],
    scalar: Real,
) -> (Program, Vec<Option<Vec<Bound>>>) {
    let (description, request) = described(asked);
    let takes_actions = functions.iter().any(|function| function.takes_actions());
    let external = request.external.iter().filter(|_| takes_actions);
    let request = Request {
        external: external.cloned().collect(),
        functions: vec![functions.to_vec()],
        scalar,
        ..request
    };
    let module = expand(&description, &request);
    let module = module.unwrap_or_else(|errors| panic!("{errors}"));
    let generated = module.functions.into_iter().next();
    let generated = generated.expect("one item was asked for");
    let bounds = generated
        .accuracy
        .into_iter()
        .map(|accuracy| match accuracy {
            Accuracy::Backward(_, promise) | Accuracy::BesideDiagonal(promise) => {
                Some(promise.bounds)
            }
            Accuracy::Unknown(_) => None,
            other @ Accuracy::Within(_) => panic!("{other:?}"),
        });
    (generated.program, bounds.collect())
}

/// What a function computes, with 106 bits.
fn exactly(chain: &Chain, function: Function) -> Evaluation<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function
        .build(&graph, &bodies, FrameId::FIRST, Way::PLAIN)
        .into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}

/// An input of a state that has these accelerations.
fn moving(state: &impl Fn(Input) -> f64, qdd: impl Fn(usize) -> f64, input: Input) -> Double {
    Double::from(match input {
        Input::Variable(Variable::Qdd, k) => qdd(usize::from(k)),
        _ => state(input),
    })
}

/// τ that accelerations of a state need, as inverse dynamics has them, and what a program makes of it. What it finds
/// may be somewhat larger, and is to be within the range: nine tenths are wanted.
fn of_needed<T: Tested>(
    program: &Program,
    needed: &Evaluation<Double>,
    state: &impl Fn(Input) -> f64,
) -> (Vec<T>, Vec<T>) {
    let tau = needed.at(|input| match input {
        Input::Variable(Variable::Qdd, _) => Double::from(0.9 * state(input)),
        _ => Double::from(state(input)),
    });
    let tau: Vec<T> = tau.iter().map(|tau| T::literal(tau.to_f64())).collect();
    let found = run(program, |input| match input {
        Input::Variable(Variable::Tau, k) => tau[usize::from(k)],
        _ => T::literal(state(input)),
    });
    (tau, found)
}

/// Forward dynamics of τ that the inverse of a state needs, and by how much the τ that its result
/// needs is another; whether there are bounds.
pub fn check_accelerations<T: Tested>(asked: Asked) -> bool {
    let Some((program, bounds)) = solved(asked, Function::ForwardDynamics, T::REAL) else {
        return false;
    };
    let chain = chain_of(asked);
    let function = Function::InverseDynamics;
    let needed = exactly(&chain, function);
    let range = Range::of(&chain);
    let mut random = Random::new(37);
    let mut worst = vec![0.0_f64; chain.spaces().velocities.len()];
    for _ in 0..STATES {
        let state = state::<T>(&chain, &range, &mut random);
        let (tau, found) = of_needed::<T>(&program, &needed, &state);
        let needed = needed.at(|input| moving(&state, |k| found[k].to_f64(), input));
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

/// A column of the derivatives of accelerations, in a state.
struct Column<'a> {
    /// What it is solved with, by rows.
    matrix: &'a [Double],
    found: Vec<f64>,
    /// What changes of q or q̇ do to the torques that produce the accelerations found, and what that may be off by.
    changes: Vec<Double>,
    off: Vec<f64>,
}

impl Column<'_> {
    fn row(&self, row: usize) -> &[Double] {
        let count = self.found.len();
        &self.matrix[row * count..][..count]
    }
}

/// Derivatives of accelerations of τ that the inverse of a state needs: by how much M times each column misses what
/// changes of q and q̇ do to the torques that produce the accelerations found, beside what both may be off by.
pub fn check_derivatives<T: Tested>(asked: Asked) {
    let of_mass = |column: &Column<'_>, row: usize, lost: &[f64]| {
        let terms = column.row(row).iter().zip(&column.found);
        let missed = terms.fold(column.changes[row], |sum, (m, x)| {
            sum + *m * Double::from(*x)
        });
        let lost = &lost[row * column.found.len()..];
        let terms = lost.iter().zip(&column.found);
        let most = terms.fold(column.off[row], |most, (lost, x)| most + lost * x.abs());
        (missed, most)
    };
    let farthest = 8.0 * asked.farthest;
    let found = check_columns::<T>(asked, Function::MassMatrix, farthest, of_mass);
    assert!(found, "{}: M is provably regular", asked.robot);
}

/// So many times as far as other bounds is that of an inverse made of articulated bodies from the worst error: up to
/// 54000 times of seven joints in a row, where what each inertia loses would have to take energy from the same motion.
const BY_BODIES: f64 = 40.0;

/// The same where the inverse of M is made of articulated bodies: by how much each column misses M⁻¹ times these
/// changes, beside what both may be off by; whether there are bounds.
pub fn check_articulated_derivatives<T: Tested>(asked: Asked) -> bool {
    let of_inverse = |column: &Column<'_>, row: usize, shares: &[f64]| {
        let (inverse, count) = (column.row(row), column.found.len());
        let terms = inverse.iter().zip(&column.changes);
        let found = Double::from(column.found[row]);
        let missed = terms.fold(found, |sum, (entry, change)| sum + *entry * *change);
        let most = (0..count).map(|k| {
            let diagonals = inverse[row].to_f64() * column.row(k)[k].to_f64();
            let lost = shares[row * count + k] * diagonals.sqrt();
            let change = column.changes[k].to_f64().abs() + column.off[k];
            inverse[k].to_f64().abs() * column.off[k] + lost * change
        });
        (missed, most.sum())
    };
    let farthest = BY_BODIES * asked.farthest;
    check_columns::<T>(asked, Function::MassMatrixInverse, farthest, of_inverse)
}

/// That no column misses its changes by more than it may, as `compared` has both for a row from what its matrix may be
/// off by, and not by far less; whether there are bounds.
fn check_columns<T: Tested>(
    asked: Asked,
    matrix: Function,
    farthest: f64,
    compared: impl Fn(&Column<'_>, usize, &[f64]) -> (Double, f64),
) -> bool {
    let functions = [
        Function::ForwardDynamics,
        Function::ForwardDynamicsDerivatives,
    ];
    let (program, bounds) = all_solved(asked, &functions, T::REAL);
    let [Some(_), Some(changes_off), Some(lost)] = &*bounds else {
        return false;
    };
    let chain = chain_of(asked);
    let function = Function::InverseDynamicsDerivatives;
    let [needed, exact, changes] =
        [Function::InverseDynamics, matrix, function].map(|f| exactly(&chain, f));
    let count = chain.spaces().velocities.len();
    let range = Range::of(&chain);
    let mut random = Random::new(43);
    let changes_off = of_entries(&chain, function, changes_off);
    let lost = of_entries(&chain, matrix, lost);
    let mut worst = 0.0_f64;
    for _ in 0..STATES / 4 {
        let state = state::<T>(&chain, &range, &mut random);
        let (_, found) = of_needed::<T>(&program, &needed, &state);
        let (qdd, found) = found.split_at(count);
        let [changes, exact] = [&changes, &exact]
            .map(|exactly| exactly.at(|input| moving(&state, |k| qdd[k].to_f64(), input)));
        let squares = changes
            .chunks(count * count)
            .zip(changes_off.chunks(count * count));
        for ((changes, off), found) in squares.zip(found.chunks(count * count)) {
            for column in 0..count {
                let entries = (column..count * count).step_by(count);
                let column = Column {
                    matrix: &exact,
                    found: entries.clone().map(|k| found[k].to_f64()).collect(),
                    changes: entries.clone().map(|k| changes[k]).collect(),
                    off: entries.map(|k| off[k]).collect(),
                };
                for row in 0..count {
                    let (missed, most) = compared(&column, row, &lost);
                    let share = missed.to_f64().abs() / most;
                    assert!(
                        share.is_finite(),
                        "{}: derivatives that are no number",
                        asked.robot
                    );
                    worst = worst.max(share);
                }
            }
        }
    }
    let (robot, name) = (asked.robot, T::NAME);
    println!("{robot} {name}: derivatives {worst:.1e} of what they may be off by");
    assert!(worst <= 1.0 && farthest * worst >= 1.0, "{worst:e}");
    true
}

/// For each result of a function the bound that holds of it.
fn of_entries(chain: &Chain, function: Function, bounds: &[Bound]) -> Vec<f64> {
    let (result, spaces) = (function.result(), chain.spaces());
    let units = result.units(spaces).into_iter().enumerate();
    let of_entry = units.map(|(k, unit)| {
        let owner = result.owner(spaces, k);
        let joint = owner.map(|(space, entry)| &spaces.entries(space)[entry].name);
        // A bound in relation to others is of any unit.
        let of =
            |bound: &&Bound| ["1", unit].contains(&bound.unit) && bound.joint.as_ref() == joint;
        let bound = bounds.iter().find(of).map(number);
        bound.expect("each row and unit has a bound in the type")
    });
    of_entry.collect()
}

/// That no velocity is faster than its bound for the energy that the robot has: diagonal entries of the inverse of
/// the mass matrix.
pub fn check_mobility(asked: Asked) {
    let chain = chain_of(asked);
    let count = chain.spaces().velocities.len();
    let inverse = exactly(&chain, Function::MassMatrixInverse);
    let range = Range::of(&chain);
    let most = mobility(&chain, Layout::DESCRIBED, &range).expect("bodies have inertias");
    let mut random = Random::new(53);
    for _ in 0..STATES {
        let state = state::<F64>(&chain, &range, &mut random);
        let inverse = inverse.at(|input| Double::from(state(input)));
        for (k, most) in most.joints.iter().enumerate() {
            let found = inverse[k * (count + 1)].to_f64();
            assert!(found <= *most, "{} {k}: {found:e} of {most:e}", asked.robot);
        }
    }
}

/// The inverse of the mass matrix. Where each column solves a matrix that is off by up to B, its
/// entries are off by up to |M⁻¹| B |M⁻¹|, to first order.
pub fn check_inverse<T: Tested>(asked: Asked) {
    let found = solved(asked, Function::MassMatrixInverse, T::REAL);
    let (program, bounds) = found.expect("M is provably regular");
    let chain = chain_of(asked);
    let count = chain.spaces().velocities.len();
    let lost = of_entries(&chain, Function::MassMatrix, &bounds);
    // 590 times by default, of the seven-joint arm.
    // Eight times as far as other bounds: it is one number for entries of all sizes.
    let farthest = 8.0 * asked.farthest;
    check_entries::<T>(
        &chain,
        &program,
        (41, asked.robot, farthest),
        |size, row, column| {
            let pairs = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
            pairs
                .map(|(i, j)| size(row, i) * lost[i * count + j] * size(j, column))
                .sum()
        },
    );
}

/// The inverse of the mass matrix where it is refined: each column is that of a unit force which is off by up to B,
/// so that its entries down to the diagonal are off by up to |M⁻¹| B; whether there are bounds.
pub fn check_refined_inverse<T: Tested>(asked: Asked) -> bool {
    let Some((program, bounds)) = solved(asked, Function::MassMatrixInverse, T::REAL) else {
        return false;
    };
    let chain = chain_of(asked);
    let lost = of_entries(&chain, Function::InverseDynamics, &bounds);
    let farthest = 8.0 * asked.farthest;
    check_entries::<T>(
        &chain,
        &program,
        (47, asked.robot, farthest),
        |size, row, column| {
            // What stands below the diagonal is of the column that it stands above it in.
            let row = row.min(column);
            let terms = lost.iter().enumerate();
            terms.map(|(k, lost)| size(row, k) * lost).sum()
        },
    );
    true
}

/// The inverse of the mass matrix by articulated bodies: entries are off by so much of the roots of the diagonal ones
/// of their rows and columns; whether there are bounds.
pub fn check_articulated_inverse<T: Tested>(asked: Asked) -> bool {
    let Some((program, bounds)) = solved(asked, Function::MassMatrixInverse, T::REAL) else {
        return false;
    };
    let chain = chain_of(asked);
    let count = chain.spaces().velocities.len();
    let shares = of_entries(&chain, Function::MassMatrixInverse, &bounds);
    let farthest = BY_BODIES * asked.farthest;
    check_entries::<T>(
        &chain,
        &program,
        (59, asked.robot, farthest),
        |size, row, column| {
            shares[row * count + column] * (size(row, row) * size(column, column)).sqrt()
        },
    );
    true
}

/// That entries of M⁻¹ are off by no more than `most` says, from the sizes of all, and not far less.
fn check_entries<T: Tested>(
    chain: &Chain,
    program: &Program,
    (seed, robot, farthest): (u64, &str, f64),
    most: impl Fn(&dyn Fn(usize, usize) -> f64, usize, usize) -> f64,
) {
    let count = chain.spaces().velocities.len();
    let inverse = exactly(chain, Function::MassMatrixInverse);
    let range = Range::of(chain);
    let mut random = Random::new(seed);
    let mut worst = 0.0_f64;
    for _ in 0..STATES {
        let state = state::<T>(chain, &range, &mut random);
        let exact = inverse.at(|input| Double::from(state(input)));
        let found = run(program, |input| T::literal(state(input)));
        let size = |row: usize, column: usize| exact[row * count + column].to_f64().abs();
        for (k, (found, exact)) in found.iter().zip(&exact).enumerate() {
            let error = (Double::from(found.to_f64()) - *exact).to_f64().abs();
            worst = worst.max(error / most(&size, k / count, k % count));
        }
    }
    let name = T::NAME;
    println!("{robot} {name}: {worst:.1e} of what the inverse may be off by");
    assert!(worst <= 1.0 && farthest * worst >= 1.0, "{worst:e}");
}
