//! Time steps of a robot's motion, with their derivatives.
//!
//! In: a robot with forward dynamics, its state q, q̇, torques and forces τ that are constant during the step, and the
//! duration Δt \[s\]. Out: the state after the step, and its derivatives by q, q̇ and τ: the matrices A and B of a
//! discrete-time controller.
//!
//! Configurations move by [`manifold`](crate::robot::manifold), so that quaternions keep their length, and derivatives
//! by q, and of q, are along velocities, as those of [`ForwardDynamicsDerivatives`] are. Nothing allocates; derivatives
//! keep some thirty matrices of N × N numbers on the stack.
//!
//! ```
//! # #[cfg(feature = "derive")] {
//! use homogen::step::{Integrator, Step};
//!
//! #[derive(homogen::Robot)]
//! #[robot(urdf = "../robots/two_link.urdf", generate(forward_dynamics, forward_dynamics_derivatives))]
//! struct Arm;
//!
//! let (q, qd, tau) = ([0.3, -0.5], [0.0, 0.2], [1.0, 0.0]);
//! let next = Arm.step(Integrator::Rk4, &q, &qd, &tau, 0.01);
//! let by = Arm.step_derivatives(Integrator::Rk4, &q, &qd, &tau, 0.01);
//! // To first order, a change of τ changes q̇ after the step by B.
//! let other = Arm.step(Integrator::Rk4, &q, &qd, &[1.001, 0.0], 0.01);
//! let off: f64 = other.qd[0] - next.qd[0] - 0.001 * by.qd_by_tau[0][0];
//! assert!(off.abs() < 1e-9);
//! # }
//! ```

mod carried;
mod midpoint;
mod tangent;

use crate::robot::described::Robot;
use crate::robot::joint::Motion;
use crate::robot::{ForwardDynamics, ForwardDynamicsDerivatives};
use crate::scalar::Scalar;
use carried::{Blocks, Configuration, Derivatives, Vector};

pub use midpoint::{ImplicitMidpoint, MidpointDerivatives};

/// A rule of numerical integration, with constant τ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Integrator {
    /// q̇ first, then q at the new velocities: q̇⁺ = q̇ + Δt q̈, q⁺ = q ⊕ Δt q̇⁺. Order 1, and symplectic where the mass
    /// matrix is constant: the energy then swings and does not drift. One evaluation of q̈.
    #[default]
    SemiImplicit,
    /// Both at the old velocities: q̇⁺ = q̇ + Δt q̈, q⁺ = q ⊕ Δt q̇. Order 1. One evaluation of q̈.
    Euler,
    /// Order 4, by four evaluations of q̈. The classical rule of Runge and Kutta where coordinates are added; for
    /// quaternions and planar joints its extension by five motions along constant screws (Celledoni, Marthinsen and
    /// Owren, Future Generation Computer Systems 19, 2003, table 4).
    Rk4,
}

/// The state after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NextState<const N: usize, T = f64, const Q: usize = N> {
    /// q [rad or m].
    pub q: [T; Q],
    /// q̇ [rad/s or m/s].
    pub qd: [T; N],
}

/// The derivatives of the state after a step by that before it and by τ, a row for each entry of the state after it.
///
/// With δq along velocities, A = \[`q_by_q`, `q_by_qd`; `qd_by_q`, `qd_by_qd`\] and B = \[`q_by_tau`; `qd_by_tau`\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepDerivatives<const N: usize, T = f64> {
    /// ∂q⁺/∂q [1, m, 1/m].
    pub q_by_q: [[T; N]; N],
    /// ∂q⁺/∂q̇ [s, s m, s/m].
    pub q_by_qd: [[T; N]; N],
    /// ∂q⁺/∂τ [rad/(N m), m/N, rad/N].
    pub q_by_tau: [[T; N]; N],
    /// ∂q̇⁺/∂q [1/s, m/s, 1/(s m)].
    pub qd_by_q: [[T; N]; N],
    /// ∂q̇⁺/∂q̇ [1, m, 1/m].
    pub qd_by_qd: [[T; N]; N],
    /// ∂q̇⁺/∂τ [rad/(s N m), m/(s N), rad/(s N)].
    pub qd_by_tau: [[T; N]; N],
}

/// The motion of a robot over a time step.
///
/// Every robot that describes itself and has [`ForwardDynamics`] implements it; derivatives need
/// [`ForwardDynamicsDerivatives`] too. `N` is the number of degrees of freedom, `Q` the number of coordinates.
pub trait Step<const N: usize, T = f64, const Q: usize = N>:
    Robot<N, Q> + ForwardDynamics<N, T, Q>
{
    /// The state after `dt` \[s\] under constant τ, without external wrenches. Closed loops are not kept: forward dynamics
    /// is that of the open tree.
    #[must_use]
    fn step(
        &self,
        integrator: Integrator,
        q: &[T; Q],
        qd: &[T; N],
        tau: &[T; N],
        dt: T,
    ) -> NextState<N, T, Q>
    where
        T: Scalar,
    {
        step(Self::MOTIONS, integrator, (q, qd), dt, |q, qd| {
            self.forward_dynamics(q, qd, tau)
        })
    }

    /// The derivatives of [`step`](Self::step) by q, q̇ and τ.
    #[must_use]
    fn step_derivatives(
        &self,
        integrator: Integrator,
        q: &[T; Q],
        qd: &[T; N],
        tau: &[T; N],
        dt: T,
    ) -> StepDerivatives<N, T>
    where
        T: Scalar,
        Self: ForwardDynamicsDerivatives<N, T, Q>,
    {
        let start = State {
            q: Configuration {
                q: *q,
                by: Blocks::of_q(),
            },
            qd: Vector {
                value: *qd,
                by: Blocks::of_qd(),
            },
        };
        let end = over(Self::MOTIONS, integrator, &start, dt, |at| Vector {
            value: self.forward_dynamics(&at.q.q, &at.qd.value, tau),
            by: Blocks::of_accelerations(
                &self.forward_dynamics_derivatives(&at.q.q, &at.qd.value, tau),
                [&at.q.by, &at.qd.by],
            ),
        });
        let (q, qd) = (end.q.by, end.qd.by);
        StepDerivatives {
            q_by_q: q.q,
            q_by_qd: q.qd,
            q_by_tau: q.tau,
            qd_by_q: qd.q,
            qd_by_qd: qd.qd,
            qd_by_tau: qd.tau,
        }
    }
}

impl<R, T, const N: usize, const Q: usize> Step<N, T, Q> for R where
    R: Robot<N, Q> + ForwardDynamics<N, T, Q>
{
}

/// The state after `dt` \[s\] with the accelerations of `q̈(q, q̇)`: for motions with external wrenches, contacts or a
/// controller, which [`Step::step`] does not have. `motions` are [`Robot::MOTIONS`].
#[must_use]
pub fn step<T: Scalar, const N: usize, const Q: usize>(
    motions: &[Motion],
    integrator: Integrator,
    (q, qd): (&[T; Q], &[T; N]),
    dt: T,
    accelerations: impl Fn(&[T; Q], &[T; N]) -> [T; N],
) -> NextState<N, T, Q> {
    let start = State {
        q: Configuration { q: *q, by: () },
        qd: Vector { value: *qd, by: () },
    };
    let end = over(motions, integrator, &start, dt, |at| Vector {
        value: accelerations(&at.q.q, &at.qd.value),
        by: (),
    });
    NextState {
        q: end.q.q,
        qd: end.qd.value,
    }
}

/// A state with its derivatives by that at the start, if `D` has them.
#[derive(Clone, Copy)]
struct State<const N: usize, const Q: usize, T, D> {
    q: Configuration<Q, T, D>,
    qd: Vector<N, T, D>,
}

/// The state after a step.
fn over<T, D, const N: usize, const Q: usize>(
    motions: &[Motion],
    integrator: Integrator,
    start: &State<N, Q, T, D>,
    dt: T,
    accelerations: impl Fn(&State<N, Q, T, D>) -> Vector<N, T, D>,
) -> State<N, Q, T, D>
where
    T: Scalar,
    D: Derivatives<N, T>,
{
    let State { q, qd } = start;
    match integrator {
        Integrator::SemiImplicit => {
            let qd = qd.plus(dt, &accelerations(start));
            let q = q.moved(motions, &qd.times(dt));
            State { q, qd }
        }
        Integrator::Euler => State {
            q: q.moved(motions, &qd.times(dt)),
            qd: qd.plus(dt, &accelerations(start)),
        },
        Integrator::Rk4 => {
            let share = |share: f64| T::constant(share) * dt;
            let half = share(0.5);
            let at = |q: &Configuration<Q, T, D>, step: Vector<N, T, D>, qd: Vector<N, T, D>| {
                let q = q.moved(motions, &step);
                State { q, qd }
            };
            let a1 = accelerations(start);
            let second = at(q, qd.times(half), qd.plus(half, &a1));
            let a2 = accelerations(&second);
            let third = at(q, second.qd.times(half), qd.plus(half, &a2));
            let a3 = accelerations(&third);
            // From the second state, so that both motions together are of the order of the rule.
            let onwards = third.qd.times(dt).plus(-half, qd);
            let fourth = at(&second.q, onwards, qd.plus(dt, &a3));
            let a4 = accelerations(&fourth);
            let rates = [*qd, second.qd, third.qd, fourth.qd];
            let weighted = |weights: [f64; 4]| {
                let [first, others @ ..] = weights.map(|weight| share(weight / 12.0));
                let others = others.into_iter().zip(&rates[1..]);
                others.fold(rates[0].times(first), |sum, (weight, rate)| {
                    sum.plus(weight, rate)
                })
            };
            let middle = q.moved(motions, &weighted([3.0, 2.0, 2.0, -1.0]));
            let qd = qd.plus(share(1.0 / 6.0), &a1);
            let qd = qd.plus(share(1.0 / 3.0), &a2);
            let qd = qd.plus(share(1.0 / 3.0), &a3);
            State {
                q: middle.moved(motions, &weighted([-1.0, 2.0, 2.0, 3.0])),
                qd: qd.plus(share(1.0 / 6.0), &a4),
            }
        }
    }
}

impl<const N: usize, T: Scalar> StepDerivatives<N, T> {
    /// The derivatives of this step followed by another: A = A₂ A₁, B = A₂ B₁ + B₂, with the same τ in both.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let rows = |by_q: &[[T; N]; N], by_qd: &[[T; N]; N]| {
            let of = |q: &[[T; N]; N], qd: &[[T; N]; N]| {
                let (a, b) = (carried::product(by_q, q), carried::product(by_qd, qd));
                carried::sum(&a, &b)
            };
            [
                of(&self.q_by_q, &self.qd_by_q),
                of(&self.q_by_qd, &self.qd_by_qd),
                of(&self.q_by_tau, &self.qd_by_tau),
            ]
        };
        let [q_by_q, q_by_qd, q_by_tau] = rows(&next.q_by_q, &next.q_by_qd);
        let [qd_by_q, qd_by_qd, qd_by_tau] = rows(&next.qd_by_q, &next.qd_by_qd);
        Self {
            q_by_q,
            q_by_qd,
            q_by_tau: carried::sum(&q_by_tau, &next.q_by_tau),
            qd_by_q,
            qd_by_qd,
            qd_by_tau: carried::sum(&qd_by_tau, &next.qd_by_tau),
        }
    }
}
