//! Every function of closed loops, at run time (feature `nalgebra`).
//!
//! In: a [`ClosedLoopRobot`] and a state. Out: the results of generated code, by independent code. With A and B the
//! poses of the two frames of a loop in frame 0, the residuals are entries of M = A⁻¹ B. Then
//! Ṁ = A⁻¹ (W_B − W_A) B, and M̈ = A⁻¹ (H_B − H_A − 2 W_A (W_B − W_A)) B, because H = Ẇ + W² of each.

use super::dense::inverse;
use super::generic::{bias, inverse_dynamics, mass_matrix};
use super::motion::{Motion, Positions};
use crate::robot;
use crate::robot::chain::Frame;
use crate::robot::closed_loops::{ClosedLoopRobot, Residual, ResidualKind};
use crate::robot::constrained::ConstrainedAccelerations;
use core::array::from_fn;
use nalgebra::{Cholesky, Matrix4, RealField, SMatrix, SVector};

/// The residuals of the loops [m, 1].
#[must_use]
pub fn constraint<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize,
    const B: usize,
>(
    robot: &ClosedLoopRobot<N, F, C, Q, B>,
    q: &[T; Q],
) -> [T; C] {
    let positions = Positions::at(&robot.chain, q);
    robot.residuals.map(|residual| {
        let [a, b] = residual.frames.map(|frame| positions.pose_of(&frame));
        let m = inverse(&a) * b;
        match residual.row {
            ResidualKind::Along(k) => entry(&m, k, 3),
            ResidualKind::Product(i, j) => entry(&m, i, j),
            ResidualKind::Inclined(cosine) => m[(2, 2)] - number(cosine),
            ResidualKind::Distance(length) => {
                let length: T = number(length);
                (square(&m) - length * length) / (length + length)
            }
        }
    })
}

/// J, a row for each residual: its rate is J q̇.
#[must_use]
pub fn constraint_jacobian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize,
    const B: usize,
>(
    robot: &ClosedLoopRobot<N, F, C, Q, B>,
    q: &[T; Q],
) -> [[T; N]; C] {
    let chain = &robot.chain;
    let positions = Positions::at(chain, q);
    robot.residuals.map(|residual| {
        let [a, b] = residual.frames.map(|frame| positions.pose_of(&frame));
        let back = inverse(&a);
        let m = back * b;
        let mut row = [T::zero(); N];
        for dof in positions.degrees_of_freedom() {
            let moves = |frame: Frame| chain.carries(dof.body, frame.body);
            let l = match residual.frames.map(moves) {
                [true, false] => -dof.l,
                [false, true] => dof.l,
                _ => continue,
            };
            if let Some(entry) = row.get_mut(dof.velocity) {
                *entry += changed(residual.row, &m, &(back * l * b));
            }
        }
        row
    })
}

/// γ, the second rate of each residual at q̈ = 0 [m/s², 1/s²].
#[must_use]
pub fn constraint_bias<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize,
    const B: usize,
>(
    robot: &ClosedLoopRobot<N, F, C, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> [T; C] {
    let motion = Motion::at(&robot.chain, q, qd, &[T::zero(); N]);
    robot.residuals.map(|residual| {
        let frames = residual.frames;
        let [a, b] = frames.map(|frame| motion.positions.pose_of(&frame));
        let [w_a, w_b] = frames.map(|frame| motion.velocity_of(frame.body));
        let [h_a, h_b] = frames.map(|frame| motion.acceleration_of(frame.body));
        let back = inverse(&a);
        let w = w_b - w_a;
        let h = h_b - h_a - w_a * w * number::<T>(2.0);
        let [m, first, second] = [Matrix4::identity(), w, h].map(|middle| back * middle * b);
        let second = changed(residual.row, &m, &second);
        match residual.row {
            ResidualKind::Distance(length) => second + square(&first) / number(length),
            _ => second,
        }
    })
}

/// q̈ and λ of M q̈ + bias = τ + Jᵗ λ and J q̈ + γ = 0, by the mass matrix and J M⁻¹ Jᵗ. Rows that depend on
/// those before them are left out; their λ is zero.
///
/// NaN if M is not positive definite.
#[must_use]
pub fn constrained_forward_dynamics<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize,
    const B: usize,
>(
    robot: &ClosedLoopRobot<N, F, C, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
) -> ConstrainedAccelerations<N, C, T> {
    let chain = &robot.chain;
    let (m, bias) = (mass_matrix(chain, q), bias(chain, q, qd));
    let jacobian = constraint_jacobian(robot, q);
    let jacobian: SMatrix<T, C, N> = SMatrix::from_fn(|i, k| jacobian[i][k]);
    let gamma = constraint_bias(robot, q, qd);
    let net_torque: SVector<T, N> = SVector::from_fn(|i, _| tau[i] - bias[i]);
    let Some(factors) = Cholesky::new(SMatrix::from_fn(|i, k| m[i][k])) else {
        let nan = || T::zero() / T::zero();
        return ConstrainedAccelerations {
            qdd: from_fn(|_| nan()),
            multipliers: from_fn(|_| nan()),
        };
    };
    let (unconstrained, response) = (
        factors.solve(&net_torque),
        factors.solve(&jacobian.transpose()),
    );
    let right = -(jacobian * unconstrained + SVector::from(gamma));
    let multipliers = eliminated(&robot.residuals, jacobian * response, right);
    let qdd = unconstrained + response * multipliers;
    ConstrainedAccelerations {
        qdd: qdd.into(),
        multipliers: multipliers.into(),
    }
}

/// τ that produces q̈ with closed loops [N m, N], zero for velocities without actuator: constraint forces balance
/// the torques of those, in the sense of least squares.
#[must_use]
pub fn actuated_inverse_dynamics<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize,
    const B: usize,
>(
    robot: &ClosedLoopRobot<N, F, C, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
) -> [T; N] {
    let needed = SVector::from(inverse_dynamics(&robot.chain, q, qd, qdd));
    let jacobian = constraint_jacobian(robot, q);
    let actuated = &robot.actuated;
    let only = |wanted: bool| -> SMatrix<T, C, N> {
        SMatrix::from_fn(|i, k| {
            if actuated[k] == wanted {
                jacobian[i][k]
            } else {
                T::zero()
            }
        })
    };
    let passive = only(false);
    let held = passive * passive.transpose();
    let multipliers = eliminated(&robot.residuals, held, passive * needed);
    let torques = needed - only(true).transpose() * multipliers;
    from_fn(|k| if actuated[k] { torques[k] } else { T::zero() })
}

/// λ of S λ = y by elimination, loop by loop. Rows with a negligible pivot are left out: negligible relative to the sum
/// of the diagonal entries of the same loop and the same unit. A row comes after those of its loop that are described
/// after it if their pivots are far larger, relative to that sum.
fn eliminated<T: RealField + Copy, const C: usize>(
    residuals: &[Residual; C],
    mut s: SMatrix<T, C, C>,
    mut y: SVector<T, C>,
) -> SVector<T, C> {
    let negligible = T::default_epsilon().sqrt() * number(0.1);
    let far_more: T = number(64.0);
    let alike = |i: usize, k: usize| {
        let [one, other] = [residuals[i], residuals[k]];
        one.frames == other.frames && one.row.is_length() == other.row.is_length()
    };
    let scales: [T; C] = from_fn(|k| {
        let same = (0..C).filter(|&i| alike(i, k));
        same.fold(T::zero(), |sum, i| sum + s[(i, i)])
    });
    let mut kept = [false; C];
    let mut order: [usize; C] = from_fn(|k| k);
    for place in 0..C {
        let share = |k: usize| s[(k, k)] / scales[k];
        let first = order[place];
        let is_open = |&(_, k): &(usize, usize)| residuals[k].frames == residuals[first].frames;
        let open = || (place..C).map(|p| (p, order[p])).filter(is_open);
        let most = open().fold(T::zero(), |most, (_, k)| most.max(share(k)));
        let next = open().find(|&(_, k)| share(k) * far_more >= most);
        let (taken, k) = next.unwrap_or((place, first));
        order[place..=taken].rotate_right(1);
        kept[k] = s[(k, k)] > negligible * scales[k];
        if !kept[k] {
            continue;
        }
        for &i in &order[place + 1..] {
            let factor = s[(i, k)] / s[(k, k)];
            for &j in &order[place..] {
                s[(i, j)] = s[(i, j)] - factor * s[(k, j)];
            }
            y[i] = y[i] - factor * y[k];
        }
    }
    let mut found = SVector::zeros();
    for (place, &k) in order.iter().enumerate().rev().filter(|(_, k)| kept[**k]) {
        let later = order[place + 1..].iter();
        let known = later.fold(y[k], |left, &j| left - s[(k, j)] * found[j]);
        found[k] = known / s[(k, k)];
    }
    found
}

/// The change of a residual due to a change `by` of M.
fn changed<T: RealField + Copy>(row: ResidualKind, m: &Matrix4<T>, by: &Matrix4<T>) -> T {
    match row {
        ResidualKind::Along(k) => entry(by, k, 3),
        ResidualKind::Product(i, j) => entry(by, i, j),
        ResidualKind::Inclined(_) => by[(2, 2)],
        ResidualKind::Distance(length) => {
            let along = (0..3).fold(T::zero(), |sum, k| sum + m[(k, 3)] * by[(k, 3)]);
            along / number(length)
        }
    }
}

/// The square of the length of the last column.
fn square<T: RealField + Copy>(m: &Matrix4<T>) -> T {
    (0..3).fold(T::zero(), |sum, k| sum + m[(k, 3)] * m[(k, 3)])
}

/// An entry; zero if there is none, as for an axis index above 2.
fn entry<T: RealField + Copy>(m: &Matrix4<T>, row: usize, column: usize) -> T {
    m.get((row, column)).copied().unwrap_or(T::zero())
}

fn number<T: RealField>(value: f64) -> T {
    nalgebra::convert(value)
}

impl<T, const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    robot::Constraint<N, C, T, Q> for ClosedLoopRobot<N, F, C, Q, B>
where
    T: RealField + Copy,
{
    fn constraint(&self, q: &[T; Q]) -> [T; C] {
        constraint(self, q)
    }
}

impl<T, const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    robot::ConstraintJacobian<N, C, T, Q> for ClosedLoopRobot<N, F, C, Q, B>
where
    T: RealField + Copy,
{
    fn constraint_jacobian(&self, q: &[T; Q]) -> [[T; N]; C] {
        constraint_jacobian(self, q)
    }
}

impl<T, const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    robot::ConstraintBias<N, C, T, Q> for ClosedLoopRobot<N, F, C, Q, B>
where
    T: RealField + Copy,
{
    fn constraint_bias(&self, q: &[T; Q], qd: &[T; N]) -> [T; C] {
        constraint_bias(self, q, qd)
    }
}

impl<T, const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    robot::ConstrainedForwardDynamics<N, C, T, Q> for ClosedLoopRobot<N, F, C, Q, B>
where
    T: RealField + Copy,
{
    fn constrained_forward_dynamics(
        &self,
        q: &[T; Q],
        qd: &[T; N],
        tau: &[T; N],
    ) -> ConstrainedAccelerations<N, C, T> {
        constrained_forward_dynamics(self, q, qd, tau)
    }
}

impl<T, const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    robot::ActuatedInverseDynamics<N, T, Q> for ClosedLoopRobot<N, F, C, Q, B>
where
    T: RealField + Copy,
{
    fn actuated_inverse_dynamics(&self, q: &[T; Q], qd: &[T; N], qdd: &[T; N]) -> [T; N] {
        actuated_inverse_dynamics(self, q, qd, qdd)
    }
}
