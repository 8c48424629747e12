//! Optimal motions by differential dynamic programming (Mayne, "A second-order gradient method for determining optimal
//! trajectories of non-linear discrete-time systems", 1966) and by the iterative linear-quadratic regulator (Li and
//! Todorov, "Iterative linear quadratic regulator design for nonlinear biological movement systems", 2004), for any
//! robot with derivatives of forward dynamics.
//!
//! In: a robot, its start at rest, and a point that its end effector shall reach, at rest. Out: torques over time with
//! their motion, and the cost after each iteration. The motion is that of semi-implicit steps.

use std::array::from_fn;

use homogen::Robot;
use homogen::robot::{
    ForwardDynamics, ForwardDynamicsDerivatives, ForwardDynamicsHessian, ForwardKinematics,
    ForwardKinematicsHessian, GeometricJacobian,
};
use homogen::step::{Integrator, Step};
use nalgebra::{Cholesky, DMatrix, DVector};

/// A robot with the functions that a solution calls.
pub trait Plannable<const N: usize>:
    Robot<N>
    + ForwardKinematics<N>
    + GeometricJacobian<N>
    + ForwardKinematicsHessian<N>
    + ForwardDynamics<N>
    + ForwardDynamicsDerivatives<N>
    + ForwardDynamicsHessian<N>
{
}

impl<R, const N: usize> Plannable<N> for R where
    R: Robot<N>
        + ForwardKinematics<N>
        + GeometricJacobian<N>
        + ForwardKinematicsHessian<N>
        + ForwardDynamics<N>
        + ForwardDynamicsDerivatives<N>
        + ForwardDynamicsHessian<N>
{
}

/// Second derivatives in the backward pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Those of the squares of linearised residuals: the iterative linear-quadratic regulator.
    GaussNewton,
    /// All, of the dynamics and of the end effector's position too: differential dynamic programming. Far from an optimum
    /// they are often indefinite: where a step then has no minimum, or the full step does not decrease the cost, the
    /// iteration is Gauss and Newton's.
    Exact,
}

/// An optimal control problem.
#[derive(Clone, Copy, Debug)]
pub struct Problem<const N: usize> {
    /// Start, at rest \[rad\].
    pub from: [f64; N],
    /// The point that the origin of the end effector shall reach \[m\].
    pub goal: [f64; 3],
    /// Number of steps.
    pub steps: usize,
    /// Duration of a step \[s\].
    pub period: f64,
    /// Weight of the squared torques beyond the holding ones, per second [1/((N m)² s)].
    pub effort: f64,
    /// Weight of the squared rates, per second [s/rad²].
    pub haste: f64,
    /// Weights of the squared errors at the end: of the position [1/m²] and of rates [s²/rad²].
    pub miss: [f64; 2],
}

/// A motion.
#[derive(Clone, Debug)]
pub struct Plan<const N: usize> {
    /// q and q̇ at the beginning of each step, and at the end.
    pub states: Vec<[[f64; N]; 2]>,
    /// τ in each step \[N m\].
    pub torques: Vec<[f64; N]>,
    /// The cost at the beginning, and after each iteration.
    pub costs: Vec<f64>,
}

/// The correction of the torques of a step: a constant part, and a feedback gain.
struct Correction {
    shift: DVector<f64>,
    gain: DMatrix<f64>,
}

/// Gradient and Hessian of the cost from a state on.
struct Value {
    gradient: DVector<f64>,
    hessian: DMatrix<f64>,
}

/// A and B, the derivatives of the next state by this state and by the torques.
type Linear = (DMatrix<f64>, DMatrix<f64>);

impl<const N: usize> Problem<N> {
    /// The best motion found from constant torques `hold`, in at most `iterations` iterations.
    ///
    /// # Panics
    /// If the weight of torques is zero, or a number is NaN.
    pub fn solve<R: Plannable<N>>(
        &self,
        robot: &R,
        method: Method,
        hold: &[f64; N],
        iterations: usize,
    ) -> Plan<N> {
        let torques = vec![*hold; self.steps];
        let mut plan = self.simulate(robot, &torques, |_, _| [0.0; N]);
        plan.costs = vec![self.cost(robot, &plan, hold)];
        for _ in 0..iterations {
            let cost = plan.costs[plan.costs.len() - 1];
            let steps = plan.states.iter().zip(&plan.torques);
            let linear: Vec<Linear> = steps
                .map(|(state, tau)| self.linear(robot, state, tau))
                .collect();
            let improve = |method| self.improve(robot, method, &plan, &linear, hold);
            let better = |corrections: &[Correction], share| {
                let next = self.corrected(robot, &plan, corrections, share);
                let less = self.cost(robot, &next, hold);
                (less < cost).then_some((less, next))
            };
            let exact = if method == Method::Exact {
                improve(Method::Exact).and_then(|corrections| better(&corrections, 1.0))
            } else {
                None
            };
            let found = exact.or_else(|| {
                let corrections = improve(Method::GaussNewton).expect("torques have a weight");
                // Line search: halve the step until the cost decreases.
                (0..10).find_map(|halvings| better(&corrections, 0.5_f64.powi(halvings)))
            });
            let Some((less, next)) = found else { break };
            let costs = [plan.costs, vec![less]].concat();
            plan = Plan { costs, ..next };
            if cost - less < 1e-13 * cost {
                break;
            }
        }
        plan
    }

    /// The motion with a share of the constant corrections, and the feedback in full.
    fn corrected<R: Plannable<N>>(
        &self,
        robot: &R,
        plan: &Plan<N>,
        corrections: &[Correction],
        share: f64,
    ) -> Plan<N> {
        self.simulate(robot, &plan.torques, |k, [q, qd]| {
            let Correction { shift, gain } = &corrections[k];
            let [q_0, qd_0] = &plan.states[k];
            let off = stacked::<N>(from_fn(|i| q[i] - q_0[i]), from_fn(|i| qd[i] - qd_0[i]));
            let change = shift * share + gain * off;
            from_fn(|i| change[i])
        })
    }

    /// The motion of torques plus a change that depends on step and state.
    fn simulate<R: Plannable<N>>(
        &self,
        robot: &R,
        torques: &[[f64; N]],
        change: impl Fn(usize, &[[f64; N]; 2]) -> [f64; N],
    ) -> Plan<N> {
        let mut states = vec![[self.from, [0.0; N]]];
        let mut changed = Vec::new();
        for (k, tau) in torques.iter().enumerate() {
            let [q, qd] = states[k];
            let change = change(k, &states[k]);
            let tau = from_fn(|i| tau[i] + change[i]);
            let next = robot.step(Integrator::SemiImplicit, &q, &qd, &tau, self.period);
            states.push([next.q, next.qd]);
            changed.push(tau);
        }
        Plan {
            states,
            torques: changed,
            costs: Vec::new(),
        }
    }

    /// The end effector's position minus the goal \[m\].
    pub fn error<R: ForwardKinematics<N>>(&self, robot: &R, q: &[f64; N]) -> [f64; 3] {
        let position = robot.forward_kinematics(q).translation();
        from_fn(|i| position[i] - self.goal[i])
    }

    fn cost<R: Plannable<N>>(&self, robot: &R, plan: &Plan<N>, hold: &[f64; N]) -> f64 {
        let efforts = plan.torques.iter().flatten().zip(hold.iter().cycle());
        let efforts: f64 = efforts.map(|(tau, hold)| (tau - hold).powi(2)).sum();
        let [q, qd] = plan.states[self.steps];
        let missed = square(&self.error(robot, &q));
        let hurried: f64 = plan.states.iter().map(|[_, qd]| square(qd)).sum();
        let [place, rest] = self.miss;
        let running = self.period * (self.effort * efforts + self.haste * hurried);
        0.5 * (running + place * missed + rest * square(&qd))
    }

    /// The corrections of all steps, by the backward pass; `None` if a step has no minimum.
    fn improve<R: Plannable<N>>(
        &self,
        robot: &R,
        method: Method,
        plan: &Plan<N>,
        linear: &[Linear],
        hold: &[f64; N],
    ) -> Option<Vec<Correction>> {
        let mut value = self.at_end(robot, method, &plan.states[self.steps]);
        let effort = self.period * self.effort;
        let mut corrections = Vec::new();
        for (k, (a, b)) in linear.iter().enumerate().rev() {
            let (state, tau) = (&plan.states[k], &plan.torques[k]);
            let own = DVector::from_fn(N, |i, _| effort * (tau[i] - hold[i]));
            let by_torque = own + b.tr_mul(&value.gradient);
            let ahead = &value.hessian * a;
            let mut by_both = b.tr_mul(&ahead);
            let mut by_state_twice = a.tr_mul(&ahead);
            if method == Method::Exact {
                self.add_curvature(
                    robot,
                    state,
                    tau,
                    &value.gradient,
                    &mut by_state_twice,
                    &mut by_both,
                );
            }
            let mut by_torque_twice = b.tr_mul(&(&value.hessian * b));
            for i in 0..N {
                by_torque_twice[(i, i)] += effort;
            }
            let factors = Cholesky::new(by_torque_twice)?;
            let correction = Correction {
                shift: -factors.solve(&by_torque),
                gain: -factors.solve(&by_both),
            };
            let gradient = a.tr_mul(&value.gradient) + by_both.tr_mul(&correction.shift);
            let hessian = by_state_twice + by_both.tr_mul(&correction.gain);
            value = Value {
                gradient,
                hessian: (&hessian + hessian.transpose()) * 0.5,
            };
            self.add_rates(&mut value, &state[1]);
            corrections.push(correction);
        }
        corrections.reverse();
        Some(corrections)
    }

    /// The cost at the end.
    fn at_end<R: Plannable<N>>(&self, robot: &R, method: Method, [q, qd]: &[[f64; N]; 2]) -> Value {
        let [place, rest] = self.miss;
        let error = self.error(robot, q).map(|x| place * x);
        let jacobian = robot.geometric_jacobian(q).map(|column| column.b());
        let dot = |x: [f64; 3], y: [f64; 3]| -> f64 { x.iter().zip(y).map(|(x, y)| x * y).sum() };
        let [x, y, z] = error;
        let curvature = match method {
            Method::GaussNewton => [[0.0; N]; N],
            Method::Exact => robot.forward_kinematics_hessian(q, &[0.0, 0.0, 0.0, x, y, z]),
        };
        let mut value = Value {
            gradient: stacked(
                jacobian.map(|column| dot(column, error)),
                qd.map(|rate| rest * rate),
            ),
            hessian: DMatrix::from_fn(2 * N, 2 * N, |i, j| {
                if i < N && j < N {
                    place * dot(jacobian[i], jacobian[j]) + curvature[i][j]
                } else if i == j {
                    rest
                } else {
                    0.0
                }
            }),
        };
        self.add_rates(&mut value, qd);
        value
    }

    /// Adds the cost of the rates at a state.
    fn add_rates(&self, value: &mut Value, qd: &[f64; N]) {
        let haste = self.period * self.haste;
        for (i, rate) in (N..).zip(qd) {
            value.gradient[i] += haste * rate;
            value.hessian[(i, i)] += haste;
        }
    }

    /// Adds the second derivatives of λᵀ times the next state, by the state twice and by torques and state.
    fn add_curvature<R: Plannable<N>>(
        &self,
        robot: &R,
        [q, qd]: &[[f64; N]; 2],
        tau: &[f64; N],
        multipliers: &DVector<f64>,
        by_state_twice: &mut DMatrix<f64>,
        by_both: &mut DMatrix<f64>,
    ) {
        // Both q̇⁺ = q̇ + Δt q̈ and q⁺ = q + Δt q̇⁺ have q̈.
        let dt = self.period;
        let weights = from_fn(|i| dt * (multipliers[N + i] + dt * multipliers[i]));
        let hessian = robot.forward_dynamics_hessian(q, qd, tau, &weights);
        for i in 0..N {
            for j in 0..N {
                by_state_twice[(i, j)] += hessian.dq_dq[i][j];
                by_state_twice[(i, N + j)] += hessian.dq_dqd[i][j];
                by_state_twice[(N + j, i)] += hessian.dq_dqd[i][j];
                by_state_twice[(N + i, N + j)] += hessian.dqd_dqd[i][j];
                by_both[(j, i)] += hessian.dq_dtau[i][j];
            }
        }
    }

    fn linear<R: Plannable<N>>(
        &self,
        robot: &R,
        [q, qd]: &[[f64; N]; 2],
        tau: &[f64; N],
    ) -> Linear {
        let by = robot.step_derivatives(Integrator::SemiImplicit, q, qd, tau, self.period);
        let a = DMatrix::from_fn(2 * N, 2 * N, |i, j| {
            let block = match (i < N, j < N) {
                (true, true) => &by.q_by_q,
                (true, false) => &by.q_by_qd,
                (false, true) => &by.qd_by_q,
                (false, false) => &by.qd_by_qd,
            };
            block[i % N][j % N]
        });
        let b = DMatrix::from_fn(2 * N, N, |i, j| {
            let block = if i < N { &by.q_by_tau } else { &by.qd_by_tau };
            block[i % N][j]
        });
        (a, b)
    }
}

fn square(entries: &[f64]) -> f64 {
    entries.iter().map(|x| x * x).sum()
}

/// Entries by q above those by q̇.
fn stacked<const N: usize>(by_q: [f64; N], by_qd: [f64; N]) -> DVector<f64> {
    DVector::from_iterator(2 * N, by_q.into_iter().chain(by_qd))
}
