//! Configurations and vectors over velocities that carry their derivatives along, or none.
//!
//! In: values, and as `D` either [`Blocks`], the derivatives by q, q̇ and τ of the start, or `()`. Out: sums, and
//! configurations moved by steps of velocities. An integrator is written once and computes both.

use core::array::from_fn;

use super::tangent;
use crate::robot::derivatives::AccelerationDerivatives;
use crate::robot::joint::Motion;
use crate::robot::step::integrate;
use crate::scalar::Scalar;

/// A vector over velocities.
#[derive(Clone, Copy)]
pub(super) struct Vector<const N: usize, T, D> {
    pub value: [T; N],
    pub by: D,
}

/// A configuration, with derivatives along its velocities.
#[derive(Clone, Copy)]
pub(super) struct Configuration<const Q: usize, T, D> {
    pub q: [T; Q],
    pub by: D,
}

/// Derivatives of a vector over velocities; none if there is nothing to compute.
pub(super) trait Derivatives<const N: usize, T>: Copy {
    /// These times a factor.
    fn times(&self, factor: T) -> Self;

    /// The sum of these and others times a factor.
    fn plus(&self, factor: T, other: &Self) -> Self;

    /// The derivatives of a configuration that is moved by a step with the derivatives `by`.
    fn moved(&self, motions: &[Motion], step: &[T; N], by: &Self) -> Self;
}

impl<const N: usize, T: Scalar, D: Derivatives<N, T>> Vector<N, T, D> {
    pub fn times(&self, factor: T) -> Self {
        Self {
            value: self.value.map(|entry| factor * entry),
            by: self.by.times(factor),
        }
    }

    pub fn plus(&self, factor: T, other: &Self) -> Self {
        Self {
            value: from_fn(|k| self.value[k] + factor * other.value[k]),
            by: self.by.plus(factor, &other.by),
        }
    }
}

impl<const Q: usize, T: Scalar, D> Configuration<Q, T, D> {
    /// The configuration after a step q̇ Δt.
    pub fn moved<const N: usize>(&self, motions: &[Motion], step: &Vector<N, T, D>) -> Self
    where
        D: Derivatives<N, T>,
    {
        Self {
            q: integrate(motions.iter().copied(), &self.q, &step.value),
            by: self.by.moved(motions, &step.value, &step.by),
        }
    }
}

impl<const N: usize, T> Derivatives<N, T> for () {
    fn times(&self, _: T) -> Self {}

    fn plus(&self, _: T, (): &Self) -> Self {}

    fn moved(&self, _: &[Motion], _: &[T; N], (): &Self) -> Self {}
}

/// Derivatives by q, q̇ and τ of the start, a row for each velocity.
#[derive(Clone, Copy)]
pub(super) struct Blocks<const N: usize, T> {
    pub q: [[T; N]; N],
    pub qd: [[T; N]; N],
    pub tau: [[T; N]; N],
}

impl<const N: usize, T: Scalar> Blocks<N, T> {
    const fn new([q, qd, tau]: [[[T; N]; N]; 3]) -> Self {
        Self { q, qd, tau }
    }

    const fn each(&self) -> [&[[T; N]; N]; 3] {
        [&self.q, &self.qd, &self.tau]
    }

    /// Those of q.
    pub fn of_q() -> Self {
        Self::new([diagonal(1.0), diagonal(0.0), diagonal(0.0)])
    }

    /// Those of q̇.
    pub fn of_qd() -> Self {
        Self::new([diagonal(0.0), diagonal(1.0), diagonal(0.0)])
    }

    /// Those of q̈ at a state with the derivatives of q and q̇ there.
    pub fn of_accelerations(by: &AccelerationDerivatives<N, T>, [q, qd]: [&Self; 2]) -> Self {
        let chained = |k: usize| {
            sum(
                &product(&by.dq, q.each()[k]),
                &product(&by.dqd, qd.each()[k]),
            )
        };
        let [by_q, by_qd, by_tau] = [0, 1, 2].map(chained);
        Self::new([by_q, by_qd, sum(&by_tau, &by.dtau)])
    }
}

impl<const N: usize, T: Scalar> Derivatives<N, T> for Blocks<N, T> {
    fn times(&self, factor: T) -> Self {
        Self::new(
            self.each()
                .map(|block| block.map(|row| row.map(|x| factor * x))),
        )
    }

    fn plus(&self, factor: T, other: &Self) -> Self {
        let [a, b] = [self.each(), other.each()];
        let block = |k: usize| {
            let entry = |row: usize, column: usize| a[k][row][column] + factor * b[k][row][column];
            from_fn(|row| from_fn(|column| entry(row, column)))
        };
        Self::new([0, 1, 2].map(block))
    }

    fn moved(&self, motions: &[Motion], step: &[T; N], by: &Self) -> Self {
        let mut moved = *self;
        let blocks = [&mut moved.q, &mut moved.qd, &mut moved.tau];
        tangent::moved(motions, step, blocks, by.each());
        moved
    }
}

fn diagonal<const N: usize, T: Scalar>(value: f64) -> [[T; N]; N] {
    let entry = |row, column| T::constant(if row == column { value } else { 0.0 });
    from_fn(|row| from_fn(|column| entry(row, column)))
}

/// The product of matrices.
pub(super) fn product<const N: usize, T: Scalar>(a: &[[T; N]; N], b: &[[T; N]; N]) -> [[T; N]; N] {
    a.map(|row| {
        let mut sums = [T::constant(0.0); N];
        for (factor, other) in row.iter().zip(b) {
            for (sum, &entry) in sums.iter_mut().zip(other) {
                *sum = factor.mul_add(entry, *sum);
            }
        }
        sums
    })
}

/// The sum of matrices.
pub(super) fn sum<const N: usize, T: Scalar>(a: &[[T; N]; N], b: &[[T; N]; N]) -> [[T; N]; N] {
    from_fn(|row| from_fn(|column| a[row][column] + b[row][column]))
}
