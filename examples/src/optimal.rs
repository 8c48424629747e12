//! Optimal motions by the iterative linear-quadratic regulator (Li and Todorov, "Iterative linear quadratic
//! regulator design for nonlinear biological movement systems", 2004), for any robot with derivatives of forward
//! dynamics.
//!
//! In: a robot, its start and its goal, both at rest. Out: torques over time with their motion, and the cost after each
//! iteration. The motion is that of semi-implicit steps.

use std::array::from_fn;

use homogen::Robot;
use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives};
use homogen::step::{Integrator, Step};
use nalgebra::{Cholesky, DMatrix, DVector};

/// An optimal control problem.
#[derive(Clone, Copy, Debug)]
pub struct Problem<const N: usize> {
    /// Start, at rest \[rad\].
    pub from: [f64; N],
    /// Goal, at rest \[rad\].
    pub to: [f64; N],
    /// Number of steps.
    pub steps: usize,
    /// Duration of a step \[s\].
    pub period: f64,
    /// Weight of the squared torques beyond the holding ones, per second [1/((N m)² s)].
    pub effort: f64,
    /// Weight of the squared rates, per second [s/rad²].
    pub haste: f64,
    /// Weights of the squared errors at the end: of coordinates [1/rad²] and of rates [s²/rad²].
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

impl<const N: usize> Problem<N> {
    /// The best motion found from constant torques `hold`, in at most `iterations` iterations.
    ///
    /// # Panics
    /// If the weight of torques is zero, or a number is NaN.
    pub fn solve<R>(&self, robot: &R, hold: &[f64; N], iterations: usize) -> Plan<N>
    where
        R: Robot<N> + ForwardDynamics<N> + ForwardDynamicsDerivatives<N>,
    {
        let torques = vec![*hold; self.steps];
        let mut plan = self.simulate(robot, &torques, |_, _| [0.0; N]);
        plan.costs = vec![self.cost(&plan, hold)];
        for _ in 0..iterations {
            let cost = plan.costs[plan.costs.len() - 1];
            let corrections = self.improve(robot, &plan, hold);
            // Line search: halve the step until the cost decreases.
            let tried = (0..10)
                .map(|halvings| 0.5_f64.powi(halvings))
                .find_map(|share| {
                    let next = self.simulate(robot, &plan.torques, |k, [q, qd]| {
                        let Correction { shift, gain } = &corrections[k];
                        let [q_0, qd_0] = &plan.states[k];
                        let off = DVector::from_fn(2 * N, |i, _| {
                            if i < N {
                                q[i] - q_0[i]
                            } else {
                                qd[i - N] - qd_0[i - N]
                            }
                        });
                        let change = shift * share + gain * off;
                        from_fn(|i| change[i])
                    });
                    let less = self.cost(&next, hold);
                    (less < cost).then_some((less, next))
                });
            let Some((less, next)) = tried else { break };
            let costs = [plan.costs, vec![less]].concat();
            plan = Plan { costs, ..next };
            if cost - less < 1e-9 * cost {
                break;
            }
        }
        plan
    }

    /// The motion of torques plus a change that depends on step and state.
    fn simulate<R>(
        &self,
        robot: &R,
        torques: &[[f64; N]],
        change: impl Fn(usize, &[[f64; N]; 2]) -> [f64; N],
    ) -> Plan<N>
    where
        R: Robot<N> + ForwardDynamics<N>,
    {
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

    fn cost(&self, plan: &Plan<N>, hold: &[f64; N]) -> f64 {
        let efforts = plan.torques.iter().flatten().zip(hold.iter().cycle());
        let efforts: f64 = efforts.map(|(tau, hold)| (tau - hold).powi(2)).sum();
        let [q, qd] = plan.states[self.steps];
        let square = |entries: [f64; N]| entries.iter().map(|x| x * x).sum::<f64>();
        let missed = square(from_fn(|i| q[i] - self.to[i]));
        let hurried: f64 = plan.states.iter().map(|[_, qd]| square(*qd)).sum();
        let [place, rest] = self.miss;
        let running = self.period * (self.effort * efforts + self.haste * hurried);
        0.5 * (running + place * missed + rest * square(qd))
    }

    /// The corrections of all steps, by the backward pass.
    fn improve<R>(&self, robot: &R, plan: &Plan<N>, hold: &[f64; N]) -> Vec<Correction>
    where
        R: Robot<N> + ForwardDynamics<N> + ForwardDynamicsDerivatives<N>,
    {
        let [q, qd] = plan.states[self.steps];
        let [place, rest] = self.miss;
        let mut gradient = DVector::from_fn(2 * N, |i, _| {
            if i < N {
                place * (q[i] - self.to[i])
            } else {
                rest * qd[i - N]
            }
        });
        let mut hessian =
            DMatrix::from_diagonal(&DVector::from_fn(
                2 * N,
                |i, _| {
                    if i < N { place } else { rest }
                },
            ));
        let [effort, haste] = [self.effort, self.haste].map(|weight| self.period * weight);
        let add_rates = |gradient: &mut DVector<f64>, hessian: &mut DMatrix<f64>, qd: &[f64; N]| {
            for (i, rate) in (N..).zip(qd) {
                gradient[i] += haste * rate;
                hessian[(i, i)] += haste;
            }
        };
        add_rates(&mut gradient, &mut hessian, &qd);
        let back = (0..self.steps).rev().map(|k| {
            let tau = &plan.torques[k];
            let (a, b) = self.linear(robot, &plan.states[k], tau);
            let own = DVector::from_fn(N, |i, _| effort * (tau[i] - hold[i]));
            let by_torque = own + b.transpose() * &gradient;
            let by_both = b.transpose() * &hessian * &a;
            let by_torque_twice = DMatrix::identity(N, N) * effort + b.transpose() * &hessian * &b;
            let factors = Cholesky::new(by_torque_twice).expect("torques have a weight");
            let correction = Correction {
                shift: -factors.solve(&by_torque),
                gain: -factors.solve(&by_both),
            };
            gradient = a.transpose() * &gradient + by_both.transpose() * &correction.shift;
            hessian = a.transpose() * &hessian * &a + by_both.transpose() * &correction.gain;
            hessian = (&hessian + hessian.transpose()) * 0.5;
            add_rates(&mut gradient, &mut hessian, &plan.states[k][1]);
            correction
        });
        let mut corrections: Vec<Correction> = back.collect();
        corrections.reverse();
        corrections
    }

    /// The derivatives A and B of the next state by this state and by the torques.
    fn linear<R>(
        &self,
        robot: &R,
        [q, qd]: &[[f64; N]; 2],
        tau: &[f64; N],
    ) -> (DMatrix<f64>, DMatrix<f64>)
    where
        R: Robot<N> + ForwardDynamics<N> + ForwardDynamicsDerivatives<N>,
    {
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
