//! Projection of the state of a generated robot onto its closed loops.
//!
//! In: a robot with `constraint` and `constraint_jacobian`, and coordinates or rates. Out: coordinates nearby
//! that close its loops, by Gauss–Newton steps of least norm with Levenberg–Marquardt damping; rates that
//! keep them closed; singular values of the closure. No allocation; the [`ClosureOutcome`] states failure and NaN.

use crate::paper::singular_values::values;
use crate::robot::{Constraint, ConstraintJacobian};
use crate::scalar::Real;
use core::array::from_fn;

/// The largest number of steps; five are usual.
const STEPS: usize = 500;

/// The largest step of a coordinate \[rad or m\].
const LONGEST: f64 = 0.5;

/// The result of a projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<T, const Q: usize> {
    /// The coordinates.
    pub q: [T; Q],
    /// The largest magnitude of a residual there [m, 1].
    pub residual: T,
    /// Number of steps.
    pub steps: usize,
    /// The end of the projection.
    pub outcome: ClosureOutcome,
}

/// The end of a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClosureOutcome {
    /// All residuals are within the tolerance.
    Closed,
    /// A local minimum of the residuals: no coordinates nearby close the loops.
    OutOfReach,
    /// Stopped early: at NaN or infinity, or after 500 steps.
    Stalled,
}

/// The singular values of a closure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regularity<T, const C: usize> {
    /// Number of independent residuals: of singular values above 64 ε times the largest.
    pub rank: usize,
    /// The singular values of J, the largest first. If more of them are near zero than at neighbouring
    /// configurations, the robot is at a dead centre or at a branch. A residual that always depends on others
    /// adds a zero everywhere.
    pub singular_values: [T; C],
}

impl<T: Copy, const C: usize> Regularity<T, C> {
    /// The smallest singular value that the rank counts; `None` at rank 0.
    #[must_use]
    pub fn least(&self) -> Option<T> {
        let last = self.rank.checked_sub(1)?;
        self.singular_values.get(last).copied()
    }
}

/// Coordinates near `q` that close the loops to within `tolerance` [m, 1], for a robot whose velocities are
/// the rates of its coordinates.
#[must_use]
pub fn project<T: Real, const N: usize, const C: usize, R>(
    robot: &R,
    q: &[T; N],
    tolerance: T,
) -> Projection<T, N>
where
    R: Constraint<N, C, T> + ConstraintJacobian<N, C, T>,
{
    project_by(robot, q, tolerance, |q, v| from_fn(|k| q[k] + v[k]))
}

/// The same for any robot; `integrate` returns the coordinates after a step q̇ Δt.
#[must_use]
pub fn project_by<T: Real, const Q: usize, const N: usize, const C: usize, R>(
    robot: &R,
    q: &[T; Q],
    tolerance: T,
    integrate: impl Fn(&[T; Q], &[T; N]) -> [T; Q],
) -> Projection<T, Q>
where
    R: Constraint<N, C, T, Q> + ConstraintJacobian<N, C, T, Q>,
{
    let zero = T::constant(0.0);
    let mut q = *q;
    let mut residual = robot.constraint(&q);
    let mut square = dot(&residual, &residual);
    let mut damping = T::EPSILON;
    let mut outcome = ClosureOutcome::Stalled;
    let mut steps = 0;
    let mut closed = largest(&residual) <= tolerance;
    while steps < STEPS {
        let jacobian = robot.constraint_jacobian(&q);
        let size = jacobian.iter().fold(zero, |sum, row| sum + dot(row, row));
        if !(size.is_finite() && square.is_finite()) {
            break;
        }
        let step = limited(least(&jacobian, &residual, damping * size));
        if largest(&step) <= T::EPSILON {
            outcome = ClosureOutcome::OutOfReach;
            break;
        }
        steps += 1;
        let next = integrate(&q, &step);
        let left = robot.constraint(&next);
        let less = dot(&left, &left);
        // Once closed, steps continue while each at least halves the residuals.
        let needed = if closed {
            T::constant(0.25)
        } else {
            T::constant(1.0)
        };
        if less < needed * square {
            (q, residual, square) = (next, left, less);
            closed = largest(&residual) <= tolerance;
            damping = (damping * T::constant(0.1)).max(T::EPSILON);
        } else if closed {
            break;
        } else {
            damping = damping.max(T::constant(1e-6)) * T::constant(10.0);
        }
    }
    if closed {
        outcome = ClosureOutcome::Closed;
    }
    Projection {
        q,
        residual: largest(&residual),
        steps,
        outcome,
    }
}

/// The rates nearest to `qd` that keep the loops closed: J q̇ = 0, with J the Jacobian of the residuals.
#[must_use]
pub fn project_rates<T: Real, const N: usize, const C: usize>(
    jacobian: &[[T; N]; C],
    qd: &[T; N],
) -> [T; N] {
    let zero = T::constant(0.0);
    let size = jacobian.iter().fold(zero, |sum, row| sum + dot(row, row));
    let mut qd = *qd;
    // The second iteration removes the error of rounding and damping in the first.
    for _ in 0..2 {
        let rates: [T; C] = from_fn(|i| dot(&jacobian[i], &qd));
        let step = least(jacobian, &rates, T::EPSILON * size);
        qd = from_fn(|k| qd[k] + step[k]);
    }
    qd
}

/// Rank and singular values of the Jacobian of the residuals.
#[must_use]
pub fn regularity<T: Real, const N: usize, const C: usize>(
    jacobian: &[[T; N]; C],
) -> Regularity<T, C> {
    let (singular_values, rank) = values(&mut jacobian.clone());
    Regularity {
        rank,
        singular_values,
    }
}

/// −Jᵗ (J Jᵗ + μ)⁻¹ r, the step of least norm; zero if a pivot is not positive.
fn least<T: Real, const N: usize, const C: usize>(
    jacobian: &[[T; N]; C],
    residual: &[T; C],
    damping: T,
) -> [T; N] {
    let zero = T::constant(0.0);
    let mut a: [[T; C]; C] = from_fn(|i| from_fn(|j| dot(&jacobian[i], &jacobian[j])));
    let mut y = *residual;
    for (k, row) in a.iter_mut().enumerate() {
        row[k] = row[k] + damping;
    }
    for k in 0..C {
        // A pivot below the damping is rounding error.
        let pivot = a[k][k].max(damping);
        if pivot <= zero {
            return [zero; N];
        }
        a[k][k] = pivot;
        for i in k + 1..C {
            let factor = a[i][k] / pivot;
            let above = a[k];
            a[i] = from_fn(|j| a[i][j] - factor * above[j]);
            y[i] = y[i] - factor * y[k];
        }
    }
    for k in (0..C).rev() {
        let known = (k + 1..C).fold(y[k], |left, j| left - a[k][j] * y[j]);
        y[k] = known / a[k][k];
    }
    from_fn(|column| {
        let terms = jacobian.iter().zip(&y);
        terms.fold(zero, |sum, (row, y)| sum - row[column] * *y)
    })
}

/// A step, scaled to at most [`LONGEST`].
fn limited<T: Real, const N: usize>(step: [T; N]) -> [T; N] {
    let (longest, limit) = (largest(&step), T::constant(LONGEST));
    if longest > limit {
        step.map(|entry| entry * (limit / longest))
    } else {
        step
    }
}

fn largest<T: Real, const K: usize>(numbers: &[T; K]) -> T {
    let zero = T::constant(0.0);
    numbers.iter().fold(zero, |most, number| {
        if number.is_finite() {
            most.max(number.abs())
        } else {
            *number * *number
        }
    })
}

fn dot<T: Real, const K: usize>(a: &[T; K], b: &[T; K]) -> T {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.fold(T::constant(0.0), |sum, product| sum + product)
}
