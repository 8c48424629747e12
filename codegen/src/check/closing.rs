//! Configurations with closed loops, and velocities that keep them closed.
//!
//! In: a state, and the matrices of the robot in any state. Out: a state near it whose loops are closed as far as its
//! numbers allow, by the method of Levenberg and Marquardt. There the equations of the loops have a solution even if
//! some of them depend on others; elsewhere those of an over-constrained linkage have none.

use super::robot::Contradiction;
use crate::chain::{Chain, Position};
use crate::dense::{Approximate, Dense, State};
use crate::expression::Double;
use crate::joint::Manifold;
use crate::list::Id;
use crate::quaternion::normalize;
use crate::real::Real;
use crate::space::{Variable, VelocityId};

/// The largest number of steps.
const STEPS: usize = 60;

/// The residual [m, 1] of a closed loop.
const CLOSED: f64 = 1e-15;

/// The residual [m, 1] of a loop that is closed but for the digits of its description.
const NEARLY: f64 = 1e-4;

/// The damping of directions in which residuals hardly change, relative to the others.
const DAMPING: f64 = Real::F64.zero_pivot();

/// The first of some states that closes within the limits of the joints; or else the first that closes, or the
/// nearest to closing.
///
/// # Errors
/// Those of `at`.
pub(super) fn closed(
    states: Vec<State>,
    chain: &Chain,
    at: impl Fn(&State) -> Result<Dense, Contradiction>,
) -> Result<Option<State>, Contradiction> {
    let mut nearest: Option<(f64, State)> = None;
    for state in states {
        let (left, state) = closed_from(state, chain, &at)?;
        let is_within = left < NEARLY && is_within_limits(&state, chain);
        if is_within {
            nearest = Some((left, state));
            break;
        }
        let is_nearer = |(least, _): &(f64, State)| *least >= NEARLY && left < *least;
        if nearest.as_ref().is_none_or(is_nearer) {
            nearest = Some((left, state));
        }
    }
    let Some((_, mut state)) = nearest else {
        return Ok(None);
    };
    keep_closed(&mut state, &at)?;
    Ok(Some(state))
}

/// A state, and the largest of its residuals.
fn closed_from(
    mut state: State,
    chain: &Chain,
    at: &impl Fn(&State) -> Result<Dense, Contradiction>,
) -> Result<(f64, State), Contradiction> {
    let mut system = System::of(&at(&state)?);
    let mut damping = 1.0;
    for _ in 0..STEPS {
        if largest(&system.residuals) < CLOSED {
            break;
        }
        let before = squares(&system.residuals);
        let step = system.step(&system.residuals, damping * before.min(1.0));
        let tried = moved(&state, chain, &step);
        let next = System::of(&at(&tried)?);
        if squares(&next.residuals) < before {
            (state, system) = (tried, next);
            damping *= 0.25;
        } else {
            damping *= 8.0;
        }
    }
    Ok((largest(&system.residuals), state))
}

/// Removes the part of the velocities that opens the loops.
fn keep_closed(
    state: &mut State,
    at: &impl Fn(&State) -> Result<Dense, Contradiction>,
) -> Result<(), Contradiction> {
    const TIMES: usize = 4;
    let system = System::of(&at(state)?);
    for _ in 0..TIMES {
        let velocities = &mut state.arguments[Variable::Qd];
        let now: Vec<f64> = velocities.iter().map(|entry| entry.to_f64()).collect();
        let opening: Vec<f64> = system.rows.iter().map(|row| dot(row, &now)).collect();
        let steps = system.step(&opening, 0.0).into_iter();
        let then = now.iter().zip(steps).map(|(now, step)| now + step);
        *velocities = then.map(Double::from).collect();
    }
    Ok(())
}

fn is_within_limits(state: &State, chain: &Chain) -> bool {
    let entries = chain.spaces().coordinates.iter();
    let mut pairs = state.arguments[Variable::Q].iter().zip(entries);
    pairs.all(|(q, entry)| {
        let [least, most] = entry.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        (least..=most).contains(&q.to_f64())
    })
}

/// The residuals, and their derivatives by velocities.
struct System {
    residuals: Vec<f64>,
    rows: Vec<Vec<f64>>,
}

impl System {
    fn of(dense: &Dense) -> Self {
        let numbers = |of: &[Approximate]| of.iter().map(|entry| entry.to_f64()).collect();
        Self {
            residuals: numbers(&dense.residuals()),
            rows: dense
                .residual_rates()
                .iter()
                .map(|row| numbers(row))
                .collect(),
        }
    }

    /// The damped least-squares step against some residuals.
    fn step(&self, residuals: &[f64], damping: f64) -> Vec<f64> {
        let count = self.rows.first().map_or(0, Vec::len);
        let column = |k: usize| self.rows.iter().map(move |row| row[k]);
        let product =
            |i: usize, k: usize| column(i).zip(column(k)).map(|(a, b)| a * b).sum::<f64>();
        let mut matrix: Vec<Vec<f64>> = (0..count)
            .map(|i| (0..count).map(|k| product(i, k)).collect())
            .collect();
        let most = (0..count).map(|k| matrix[k][k]).fold(0.0, f64::max);
        for (k, row) in matrix.iter_mut().enumerate() {
            row[k] += most * damping.max(DAMPING);
        }
        let right = (0..count).map(|k| -column(k).zip(residuals).map(|(a, b)| a * b).sum::<f64>());
        solved(matrix, right.collect())
    }
}

/// x of A x = y for positive definite A; zeros where A is zero.
fn solved(mut a: Vec<Vec<f64>>, mut y: Vec<f64>) -> Vec<f64> {
    let count = y.len();
    let reciprocal = |pivot: f64| if pivot > 0.0 { 1.0 / pivot } else { 0.0 };
    for k in 0..count {
        for i in k + 1..count {
            let factor = a[i][k] * reciprocal(a[k][k]);
            let (above, below) = a.split_at_mut(i);
            for (entry, of_pivot) in below[0].iter_mut().zip(&above[k]).skip(k) {
                *entry -= factor * of_pivot;
            }
            y[i] -= factor * y[k];
        }
    }
    for k in (0..count).rev() {
        let later = (k + 1..count).map(|j| a[k][j] * y[j]).sum::<f64>();
        y[k] = (y[k] - later) * reciprocal(a[k][k]);
    }
    y
}

/// The state after a unit of time at some velocities, to first order.
fn moved(state: &State, chain: &Chain, velocities: &[f64]) -> State {
    let mut moved = state.clone();
    let by = |velocity: VelocityId, k: usize| Double::from(velocities[velocity.index() + k]);
    for velocity in chain.spaces().velocities.ids() {
        let joint = &chain.joints[chain.mover(velocity)];
        match joint.position {
            Position::Along { coordinate, .. } => {
                let entry = &mut moved.arguments[Variable::Q][coordinate.index()];
                *entry = *entry + by(velocity, 0);
            }
            Position::Manifold(manifold, first) => {
                let entries = &mut moved.arguments[Variable::Q][first.index()..];
                displace(entries, manifold, |k| by(velocity, k));
            }
            Position::Taken => {}
        }
    }
    moved
}

/// Moves a body by velocities in its own axes.
fn displace(entries: &mut [Double], manifold: Manifold, by: impl Fn(usize) -> Double) {
    match manifold {
        Manifold::Planar => {
            let (sine, cosine) = entries[2].sin_cos();
            entries[0] = entries[0] + cosine * by(0) - sine * by(1);
            entries[1] = entries[1] + sine * by(0) + cosine * by(1);
            entries[2] = entries[2] + by(2);
        }
        Manifold::Spherical => rotate(&mut entries[..4], [by(0), by(1), by(2)]),
        Manifold::Floating => {
            let shift = rotated(&entries[3..7], [by(0), by(1), by(2)]);
            for (entry, shift) in entries.iter_mut().zip(shift) {
                *entry = *entry + shift;
            }
            rotate(&mut entries[3..7], [by(3), by(4), by(5)]);
        }
    }
}

/// Rotates a quaternion by small angles about axes of its body.
fn rotate(quaternion: &mut [Double], [x, y, z]: [Double; 3]) {
    let half = Double::from(0.5);
    let [a, b, c, w] = [0, 1, 2, 3].map(|k| quaternion[k]);
    let rates = [
        w * x + b * z - c * y,
        w * y + c * x - a * z,
        w * z + a * y - b * x,
        -(a * x + b * y + c * z),
    ];
    for (entry, rate) in quaternion.iter_mut().zip(rates) {
        *entry = *entry + half * rate;
    }
    normalize(quaternion);
}

/// A vector in a body's axes, rotated by its quaternion: v + 2 w (u × v) + 2 u × (u × v).
fn rotated(quaternion: &[Double], v: [Double; 3]) -> [Double; 3] {
    let u = [quaternion[0], quaternion[1], quaternion[2]];
    let two = Double::from(2.0);
    let cross = |a: [Double; 3], b: [Double; 3]| {
        [(1, 2), (2, 0), (0, 1)].map(|(i, k)| a[i] * b[k] - a[k] * b[i])
    };
    let once = cross(u, v).map(|entry| two * entry);
    let twice = cross(u, once);
    [0, 1, 2].map(|k| v[k] + quaternion[3] * once[k] + twice[k])
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn squares(numbers: &[f64]) -> f64 {
    dot(numbers, numbers)
}

fn largest(numbers: &[f64]) -> f64 {
    numbers
        .iter()
        .fold(0.0, |most, number| most.max(number.abs()))
}
