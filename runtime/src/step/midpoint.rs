//! The implicit midpoint rule, as an equation for the velocities after a step.
//!
//! In: a state, velocities after the step, and τ. Out: what remains of the equation of motion at the middle of the step,
//! and its derivatives, for a solver of one step or of a whole trajectory. Inverse dynamics suffices: no equation with M
//! is solved.

use core::array::from_fn;

use super::carried::{Blocks, Configuration, Vector, product};
use crate::robot::described::Robot;
use crate::robot::{InverseDynamics, InverseDynamicsDerivatives, MassMatrix};
use crate::scalar::Scalar;

/// The derivatives of the residual of [`ImplicitMidpoint`], a row for each torque or force; that by τ is −1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MidpointDerivatives<const N: usize, T = f64> {
    /// By q, along velocities [N m, N, N/m].
    pub q: [[T; N]; N],
    /// By q̇ [N m s, N s, N s/m].
    pub qd: [[T; N]; N],
    /// By q̇⁺ [N m s, N s, N s/m].
    pub next_qd: [[T; N]; N],
}

/// The implicit midpoint rule: q⁺ = q ⊕ Δt w with w = (q̇ + q̇⁺)/2, and q̇⁺ such that inverse dynamics at q ⊕ Δt w/2, w and
/// (q̇⁺ − q̇)/Δt needs τ.
///
/// Order 2, and symmetric: a step back from the end returns to the start, so that the energy of most motions without
/// friction swings and does not drift. `N` is the number of degrees of freedom, `Q` the number of coordinates.
pub trait ImplicitMidpoint<const N: usize, T = f64, const Q: usize = N>:
    Robot<N, Q> + InverseDynamics<N, T, Q>
{
    /// The torques and forces that velocities `next_qd` after `dt` \[s\] need, less `tau` [N m, N]: zero for those of the
    /// rule.
    #[must_use]
    fn midpoint_residual(
        &self,
        (q, qd): (&[T; Q], &[T; N]),
        next_qd: &[T; N],
        tau: &[T; N],
        dt: T,
    ) -> [T; N]
    where
        T: Scalar,
    {
        let (mean, second) = rates(qd, next_qd, dt);
        let start = Configuration { q: *q, by: () };
        let mean = Vector {
            value: mean,
            by: (),
        };
        let half = T::constant(0.5) * dt;
        let middle = start.moved(Self::MOTIONS, &mean.times(half));
        let needed = self.inverse_dynamics(&middle.q, &mean.value, &second);
        from_fn(|k| needed[k] - tau[k])
    }

    /// The derivatives of [`midpoint_residual`](Self::midpoint_residual).
    #[must_use]
    fn midpoint_derivatives(
        &self,
        (q, qd): (&[T; Q], &[T; N]),
        next_qd: &[T; N],
        dt: T,
    ) -> MidpointDerivatives<N, T>
    where
        T: Scalar,
        Self: InverseDynamicsDerivatives<N, T, Q> + MassMatrix<N, T, Q>,
    {
        let (mean, second) = rates(qd, next_qd, dt);
        let start = Configuration {
            q: *q,
            by: Blocks::of_q(),
        };
        // The derivatives by q̇ are those by w here.
        let mean = Vector {
            value: mean,
            by: Blocks::of_qd(),
        };
        let one_half = T::constant(0.5);
        let middle = start.moved(Self::MOTIONS, &mean.times(one_half * dt));
        let needed = self.inverse_dynamics_derivatives(&middle.q, &mean.value, &second);
        let inertia = self.mass_matrix(&middle.q);
        let by_mean = product(&needed.dq, &middle.by.qd);
        let of_rates = |sign: T| {
            from_fn(|row| {
                from_fn(|column| {
                    let of_mean = by_mean[row][column] + needed.dqd[row][column];
                    one_half * of_mean + sign * inertia[row][column] / dt
                })
            })
        };
        MidpointDerivatives {
            q: product(&needed.dq, &middle.by.q),
            qd: of_rates(T::constant(-1.0)),
            next_qd: of_rates(T::constant(1.0)),
        }
    }

    /// The configuration after the step, q ⊕ Δt w.
    #[must_use]
    fn midpoint_configuration(&self, (q, qd): (&[T; Q], &[T; N]), next_qd: &[T; N], dt: T) -> [T; Q]
    where
        T: Scalar,
    {
        let (mean, _) = rates(qd, next_qd, dt);
        let step = Vector {
            value: mean,
            by: (),
        };
        Configuration { q: *q, by: () }
            .moved(Self::MOTIONS, &step.times(dt))
            .q
    }
}

impl<R, T, const N: usize, const Q: usize> ImplicitMidpoint<N, T, Q> for R where
    R: Robot<N, Q> + InverseDynamics<N, T, Q>
{
}

/// (q̇ + q̇⁺)/2 and (q̇⁺ − q̇)/Δt.
fn rates<T: Scalar, const N: usize>(qd: &[T; N], next_qd: &[T; N], dt: T) -> ([T; N], [T; N]) {
    let half = T::constant(0.5);
    let mean = from_fn(|k| half * (qd[k] + next_qd[k]));
    (mean, from_fn(|k| (next_qd[k] - qd[k]) / dt))
}
