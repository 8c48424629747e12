//! The state nearest to a given one that closes the loops of a generated robot.
//!
//! In: a robot with `constraint` and `constraint_jacobian`, and coordinates or rates. Out: coordinates that
//! close its loops, by steps of least norm (Gauss and Newton, damped as by Levenberg and Marquardt), or as
//! far as there are any; rates that keep them closed; and how far the closure is from a singular one. It
//! allocates nothing, never fails and never returns what is not a number without saying so.

use crate::paper::singular_values::values;
use crate::robot::{Constraint, ConstraintJacobian};
use crate::scalar::Real;
use core::array::from_fn;

/// At most so many steps are taken; five are usual.
const STEPS: usize = 500;

/// No step turns a joint by more \[rad\], or shifts it by more \[m\].
const LONGEST: f64 = 0.5;

/// How far the loops of a robot are closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<T, const Q: usize> {
    /// The coordinates that were found.
    pub q: [T; Q],
    /// The largest magnitude of a residual there [m, 1].
    pub residual: T,
    /// How many steps were taken.
    pub steps: usize,
    /// What became of it.
    pub outcome: Outcome,
}

/// What became of a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All residuals are within the tolerance.
    Closed,
    /// No step down the slope makes the residuals smaller, however short: nothing near closes the loops.
    OutOfReach,
    /// Steps came to an end before: at a number that is none, or after 500 of them.
    Stalled,
}

/// How far a closure is from a singular one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regularity<T, const C: usize> {
    /// How many of the residuals are independent: singular values above 64 ε times the largest.
    pub rank: usize,
    /// The singular values of J, the largest first: where one beyond those of neighbouring postures is near
    /// zero, the mechanism is at a dead centre or can branch. A residual that always depends on others leaves
    /// a zero everywhere.
    pub singular_values: [T; C],
}

impl<T: Copy, const C: usize> Regularity<T, C> {
    /// The least singular value of those that the rank counts; none where it counts none.
    #[must_use]
    pub fn least(&self) -> Option<T> {
        let last = self.rank.checked_sub(1)?;
        self.singular_values.get(last).copied()
    }
}

/// Coordinates near `q` that close the loops to within `tolerance` [m, 1], of a robot whose velocities are
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

/// The same of any robot; `integrate` moves coordinates by velocities that last for a second.
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
    let mut outcome = Outcome::Stalled;
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
            outcome = Outcome::OutOfReach;
            break;
        }
        steps += 1;
        let next = integrate(&q, &step);
        let left = robot.constraint(&next);
        let less = dot(&left, &left);
        // Once closed, steps go on only while each is worth it.
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
        outcome = Outcome::Closed;
    }
    Projection {
        q,
        residual: largest(&residual),
        steps,
        outcome,
    }
}

/// The rates nearest to `qd` that keep loops closed, by the Jacobian of their residuals: J q̇ = 0, as far as
/// its rank allows.
#[must_use]
pub fn project_rates<T: Real, const N: usize, const C: usize>(
    jacobian: &[[T; N]; C],
    qd: &[T; N],
) -> [T; N] {
    let zero = T::constant(0.0);
    let size = jacobian.iter().fold(zero, |sum, row| sum + dot(row, row));
    let mut qd = *qd;
    // The second time takes away what rounding and damping left of the first.
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

/// −Jᵗ (J Jᵗ + μ)⁻¹ r; nothing where that is nothing.
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
        // Rounding may leave less of a pivot than was added to it.
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

/// A step, shortened where it is too long.
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
