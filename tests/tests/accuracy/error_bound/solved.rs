//! Solutions with the mass matrix: backward error bounds.
//!
//! In: a robot, a scalar type. Out: a failed assertion if the torques that computed accelerations need differ from the
//! given ones by more than their bound, or if M⁻¹ has a larger error than its bound allows.

use homogen_codegen::accuracy::mobility::mobility;
use homogen_codegen::accuracy::{Accuracy, Bound};
use homogen_codegen::chain::Chain;
use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Algorithm;
use homogen_codegen::range::Range;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};
use homogen_tests::states::Random;
use homogen_tests::tested::{F64, Tested};

use crate::error_bound::asked::{Asked, chain_of, described};
use crate::error_bound::bounds::{holds, number};
use crate::error_bound::states::{state, trials};

/// The program of a solution, and its backward bounds, if there are any.
fn solved(asked: Asked, function: Function, scalar: Real) -> Option<(Program, Vec<Bound>)> {
    let (program, bounds) = all_solved(asked, &[function], scalar);
    let mut bounds = bounds.into_iter();
    let found = bounds.next().expect("one accuracy");
    assert!(bounds.next().is_none(), "{function:?} is one solution");
    found.map(|bounds| (program, bounds))
}

/// The same for functions with several solutions: the bounds of each, if there are any.
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
            Accuracy::Backward(_, bound) | Accuracy::BesideDiagonal(bound) => Some(bound.bounds),
            Accuracy::Unknown(_) => None,
            other @ Accuracy::Within(_) => panic!("{other:?}"),
        });
    (generated.program, bounds.collect())
}

/// A function in 106 bits, in the frames of the description.
fn exactly(chain: &Chain, function: Function) -> Evaluation<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function
        .build(&graph, &bodies, FrameId::FIRST, Algorithm::PLAIN)
        .into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}

/// An input of the state with these accelerations.
fn moving(state: &impl Fn(Input) -> f64, qdd: impl Fn(usize) -> f64, input: Input) -> Double {
    Double::from(match input {
        Input::Variable(Variable::Qdd, k) => qdd(usize::from(k)),
        _ => state(input),
    })
}

/// The torques of a state's accelerations, and the program's result for them. Accelerations are scaled by 0.9, so that
/// results are within the range too.
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

/// Checks forward dynamics: the difference of the torques that its result needs from the given ones. Returns true if
/// there are bounds.
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
    for _ in 0..trials() {
        let state = state::<T>(&chain, &range, &mut random);
        let (tau, found) = of_needed::<T>(&program, &needed, &state);
        let needed = needed.at(|input| moving(&state, |k| found[k].to_f64(), input));
        for ((worst, needed), tau) in worst.iter_mut().zip(needed).zip(&tau) {
            let error = (needed - Double::from(tau.to_f64())).to_f64().abs();
            assert!(
                error.is_finite(),
                "{}: accelerations are not finite",
                asked.robot
            );
            *worst = worst.max(error);
        }
    }

    let mut table = format!("{} in {}\n", asked.robot, T::NAME);
    // Twice the ratio of other bounds: 163, for the seven-joint arm in f32.
    let farthest = 2.0 * asked.farthest;
    let holds = holds(&chain, function, &bounds, &worst, farthest, &mut table);
    println!("{table}");
    assert!(holds, "{table}");
    true
}

/// A column of the derivatives of accelerations at a state.
struct Column<'a> {
    /// The matrix of the equations, by rows.
    matrix: &'a [Double],
    found: Vec<f64>,
    /// ∂τ of inverse dynamics at the computed accelerations, and the bound of its error.
    changes: Vec<Double>,
    bounds: Vec<f64>,
}

impl Column<'_> {
    fn row(&self, row: usize) -> &[Double] {
        let count = self.found.len();
        &self.matrix[row * count..][..count]
    }
}

/// Checks derivatives of accelerations: M times each column plus ∂τ of inverse dynamics is within the sum of the bounds
/// of both.
pub fn check_derivatives<T: Tested>(asked: Asked) {
    let of_mass = |column: &Column<'_>, row: usize, lost: &[f64]| {
        let terms = column.row(row).iter().zip(&column.found);
        let residual = terms.fold(column.changes[row], |sum, (m, x)| {
            sum + *m * Double::from(*x)
        });
        let lost = &lost[row * column.found.len()..];
        let terms = lost.iter().zip(&column.found);
        let most = terms.fold(column.bounds[row], |most, (lost, x)| most + lost * x.abs());
        (residual, most)
    };
    let farthest = 8.0 * asked.farthest;
    let found = check_columns::<T>(asked, Function::MassMatrix, farthest, of_mass);
    assert!(found, "{}: M is provably regular", asked.robot);
}

/// Factor of the allowed ratio of bound to error for the articulated inverse: up to 54000 for seven joints in a row,
/// where the losses of all inertias would have to take energy from the same motion.
const BY_BODIES: f64 = 40.0;

/// Checks derivatives of accelerations by the articulated inverse: each column plus M⁻¹ ∂τ is within the sum of the
/// bounds of both. Returns true if there are bounds.
pub fn check_articulated_derivatives<T: Tested>(asked: Asked) -> bool {
    let of_inverse = |column: &Column<'_>, row: usize, shares: &[f64]| {
        let (inverse, count) = (column.row(row), column.found.len());
        let terms = inverse.iter().zip(&column.changes);
        let found = Double::from(column.found[row]);
        let residual = terms.fold(found, |sum, (entry, change)| sum + *entry * *change);
        let most = (0..count).map(|k| {
            let diagonals = inverse[row].to_f64() * column.row(k)[k].to_f64();
            let lost = shares[row * count + k] * diagonals.sqrt();
            let change = column.changes[k].to_f64().abs() + column.bounds[k];
            inverse[k].to_f64().abs() * column.bounds[k] + lost * change
        });
        (residual, most.sum())
    };
    let farthest = BY_BODIES * asked.farthest;
    check_columns::<T>(asked, Function::MassMatrixInverse, farthest, of_inverse)
}

/// Compares the residual of each column with its bound, both from `compared` for a row and the bounds of the matrix's
/// entries. The worst ratio must be at least 1 / `farthest`. Returns true if there are bounds.
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
    let [Some(_), Some(change_bounds), Some(lost)] = &*bounds else {
        return false;
    };
    let chain = chain_of(asked);
    let function = Function::InverseDynamicsDerivatives;
    let [needed, exact, changes] =
        [Function::InverseDynamics, matrix, function].map(|f| exactly(&chain, f));
    let count = chain.spaces().velocities.len();
    let range = Range::of(&chain);
    let mut random = Random::new(43);
    let change_bounds = of_entries(&chain, function, change_bounds);
    let lost = of_entries(&chain, matrix, lost);
    let mut worst = 0.0_f64;
    for _ in 0..trials() / 4 {
        let state = state::<T>(&chain, &range, &mut random);
        let (_, found) = of_needed::<T>(&program, &needed, &state);
        let (qdd, found) = found.split_at(count);
        let [changes, exact] = [&changes, &exact]
            .map(|exactly| exactly.at(|input| moving(&state, |k| qdd[k].to_f64(), input)));
        let squares = changes
            .chunks(count * count)
            .zip(change_bounds.chunks(count * count));
        for ((changes, bounds), found) in squares.zip(found.chunks(count * count)) {
            for column in 0..count {
                let entries = (column..count * count).step_by(count);
                let column = Column {
                    matrix: &exact,
                    found: entries.clone().map(|k| found[k].to_f64()).collect(),
                    changes: entries.clone().map(|k| changes[k]).collect(),
                    bounds: entries.map(|k| bounds[k]).collect(),
                };
                for row in 0..count {
                    let (residual, most) = compared(&column, row, &lost);
                    let share = residual.to_f64().abs() / most;
                    assert!(
                        share.is_finite(),
                        "{}: derivatives are not finite",
                        asked.robot
                    );
                    worst = worst.max(share);
                }
            }
        }
    }
    let (robot, name) = (asked.robot, T::NAME);
    println!("{robot} {name}: derivatives {worst:.1e} of their bound");
    assert!(worst <= 1.0 && farthest * worst >= 1.0, "{worst:e}");
    true
}

/// The bound of each result of a function.
fn of_entries(chain: &Chain, function: Function, bounds: &[Bound]) -> Vec<f64> {
    let (result, spaces) = (function.result(), chain.spaces());
    let units = result.units(spaces).into_iter().enumerate();
    let of_entry = units.map(|(k, unit)| {
        let owner = result.owner(spaces, k);
        let joint = owner.map(|(space, entry)| &spaces.entries(space)[entry].name);
        // A relative bound has unit 1.
        let of =
            |bound: &&Bound| ["1", unit].contains(&bound.unit) && bound.joint.as_ref() == joint;
        let bound = bounds.iter().find(of).map(number);
        bound.expect("each row and unit has a bound in the type")
    });
    of_entry.collect()
}

/// Checks the bounds of velocities by the kinetic energy: the diagonal entries of M⁻¹.
pub fn check_mobility(asked: Asked) {
    let chain = chain_of(asked);
    let count = chain.spaces().velocities.len();
    let inverse = exactly(&chain, Function::MassMatrixInverse);
    let range = Range::of(&chain);
    let most = mobility(&chain, Layout::DESCRIBED, &range).expect("bodies have inertias");
    let mut random = Random::new(53);
    for _ in 0..trials() {
        let state = state::<F64>(&chain, &range, &mut random);
        let inverse = inverse.at(|input| Double::from(state(input)));
        for (k, most) in most.joints.iter().enumerate() {
            let found = inverse[k * (count + 1)].to_f64();
            assert!(found <= *most, "{} {k}: {found:e} of {most:e}", asked.robot);
        }
    }
}

/// Checks M⁻¹. If each column solves a matrix with an error up to B, entries have errors up to |M⁻¹| B |M⁻¹|, to first
/// order.
pub fn check_inverse<T: Tested>(asked: Asked) {
    let found = solved(asked, Function::MassMatrixInverse, T::REAL);
    let (program, bounds) = found.expect("M is provably regular");
    let chain = chain_of(asked);
    let count = chain.spaces().velocities.len();
    let lost = of_entries(&chain, Function::MassMatrix, &bounds);
    // Eight times the ratio of other bounds, since one number bounds entries of all sizes: 590 with default options,
    // for the seven-joint arm.
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

/// Checks the refined M⁻¹: each column is exact for a unit force with an error up to B, so its entries down to the
/// diagonal have errors up to |M⁻¹| B. Returns true if there are bounds.
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
            // An entry below the diagonal is the one above it in the other column.
            let row = row.min(column);
            let terms = lost.iter().enumerate();
            terms.map(|(k, lost)| size(row, k) * lost).sum()
        },
    );
    true
}

/// Checks M⁻¹ by the articulated-body algorithm: errors are a share of the roots of the diagonal entries of row and
/// column. Returns true if there are bounds.
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

/// Compares errors of M⁻¹ with the bound `most`. The worst ratio must be at least 1 / `farthest`.
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
    for _ in 0..trials() {
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
    println!("{robot} {name}: {worst:.1e} of the bound of the inverse");
    assert!(worst <= 1.0 && farthest * worst >= 1.0, "{worst:e}");
}
