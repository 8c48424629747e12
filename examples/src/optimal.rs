//! Motions that cost least: the iterative linear-quadratic regulator (Li and Todorov, "Iterative linear quadratic
//! regulator design for nonlinear biological movement systems", 2004), for every robot with derivatives of its
//! accelerations.
//!
//! In: a robot, where it is and where it should come to rest. Out: torques over time, with the motion that they make and
//! what each round of improvement cost. States follow each other by q̇' = q̇ + h q̈, q' = q + h q̇'.

use std::array::from_fn;

use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives};
use nalgebra::{Cholesky, DMatrix, DVector};

/// What a motion is to do.
#[derive(Clone, Copy, Debug)]
pub struct Problem<const N: usize> {
    /// Where it begins, at rest \[rad\].
    pub from: [f64; N],
    /// Where it should end, at rest \[rad\].
    pub to: [f64; N],
    /// How many steps there are.
    pub steps: usize,
    /// How long each of them takes \[s\].
    pub period: f64,
    /// The price of a torque for a second, beside that of holding still [1/(N m)² s].
    pub effort: f64,
    /// The price of a rate for a second [s/rad²].
    pub haste: f64,
    /// The price of ending elsewhere [1/rad²], or not at rest [s²/rad²].
    pub miss: [f64; 2],
}

/// A motion.
#[derive(Clone, Debug)]
pub struct Plan<const N: usize> {
    /// q and q̇ at the beginning of each step, and at the end.
    pub states: Vec<[[f64; N]; 2]>,
    /// τ in each step \[N m\].
    pub torques: Vec<[f64; N]>,
    /// What it cost in the beginning, and after each round.
    pub costs: Vec<f64>,
}

/// What a step back tells: how torques change, by themselves and with the state.
struct Correction {
    shift: DVector<f64>,
    gain: DMatrix<f64>,
}

impl<const N: usize> Problem<N> {
    /// The best motion that is found from torques that stay as given, in at most so many rounds.
    ///
    /// # Panics
    /// Where torques have no price, or a number is none.
    pub fn solve<R>(&self, robot: &R, hold: &[f64; N], rounds: usize) -> Plan<N>
    where
        R: ForwardDynamics<N> + ForwardDynamicsDerivatives<N>,
    {
        let torques = vec![*hold; self.steps];
        let mut plan = self.follow(robot, &torques, |_, _| [0.0; N]);
        plan.costs = vec![self.cost(&plan, hold)];
        for _ in 0..rounds {
            let cost = plan.costs[plan.costs.len() - 1];
            let corrections = self.improve(robot, &plan, hold);
            // Shorter steps, until one pays.
            let tried = (0..10)
                .map(|halvings| 0.5_f64.powi(halvings))
                .find_map(|share| {
                    let next = self.follow(robot, &plan.torques, |k, [q, qd]| {
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

    /// The motion that torques make, each with a change that depends on where it has come to.
    fn follow<R>(
        &self,
        robot: &R,
        torques: &[[f64; N]],
        change: impl Fn(usize, &[[f64; N]; 2]) -> [f64; N],
    ) -> Plan<N>
    where
        R: ForwardDynamics<N>,
    {
        let mut states = vec![[self.from, [0.0; N]]];
        let mut changed = Vec::new();
        for (k, tau) in torques.iter().enumerate() {
            let [q, qd] = states[k];
            let change = change(k, &states[k]);
            let tau = from_fn(|i| tau[i] + change[i]);
            let qdd = robot.forward_dynamics(&q, &qd, &tau);
            let qd = from_fn(|i| qd[i] + self.period * qdd[i]);
            states.push([from_fn(|i| q[i] + self.period * qd[i]), qd]);
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

    /// Of each step what would make the rest of the motion cheaper, from the last one back.
    fn improve<R>(&self, robot: &R, plan: &Plan<N>, hold: &[f64; N]) -> Vec<Correction>
    where
        R: ForwardDynamics<N> + ForwardDynamicsDerivatives<N>,
    {
        let [q, qd] = plan.states[self.steps];
        let [place, rest] = self.miss;
        let mut slope = DVector::from_fn(2 * N, |i, _| {
            if i < N {
                place * (q[i] - self.to[i])
            } else {
                rest * qd[i - N]
            }
        });
        let mut bend =
            DMatrix::from_diagonal(&DVector::from_fn(
                2 * N,
                |i, _| {
                    if i < N { place } else { rest }
                },
            ));
        let [price, haste] = [self.effort, self.haste].map(|price| self.period * price);
        let hurry = |slope: &mut DVector<f64>, bend: &mut DMatrix<f64>, qd: &[f64; N]| {
            for (i, rate) in (N..).zip(qd) {
                slope[i] += haste * rate;
                bend[(i, i)] += haste;
            }
        };
        hurry(&mut slope, &mut bend, &qd);
        let back = (0..self.steps).rev().map(|k| {
            let tau = &plan.torques[k];
            let (a, b) = self.linear(robot, &plan.states[k], tau);
            let effort = DVector::from_fn(N, |i, _| price * (tau[i] - hold[i]));
            let by_torque = effort + b.transpose() * &slope;
            let by_both = b.transpose() * &bend * &a;
            let square = DMatrix::identity(N, N) * price + b.transpose() * &bend * &b;
            let square = Cholesky::new(square).expect("effort has a price");
            let correction = Correction {
                shift: -square.solve(&by_torque),
                gain: -square.solve(&by_both),
            };
            slope = a.transpose() * &slope + by_both.transpose() * &correction.shift;
            bend = a.transpose() * &bend * &a + by_both.transpose() * &correction.gain;
            bend = (&bend + bend.transpose()) * 0.5;
            hurry(&mut slope, &mut bend, &plan.states[k][1]);
            correction
        });
        let mut corrections: Vec<Correction> = back.collect();
        corrections.reverse();
        corrections
    }

    /// What the next state changes by with this one, and with the torques.
    fn linear<R>(
        &self,
        robot: &R,
        [q, qd]: &[[f64; N]; 2],
        tau: &[f64; N],
    ) -> (DMatrix<f64>, DMatrix<f64>)
    where
        R: ForwardDynamicsDerivatives<N>,
    {
        let h = self.period;
        let by = robot.forward_dynamics_derivatives(q, qd, tau);
        // Of q̇' first; q' has h times that and what q itself gives.
        let a = DMatrix::from_fn(2 * N, 2 * N, |i, j| {
            let (row, column) = (i % N, j % N);
            let same = if row == column { 1.0 } else { 0.0 };
            let rate = if j < N {
                h * by.dq[row][column]
            } else {
                same + h * by.dqd[row][column]
            };
            match (i < N, j < N) {
                (true, true) => same + h * rate,
                (true, false) => h * rate,
                (false, _) => rate,
            }
        });
        let b = DMatrix::from_fn(2 * N, N, |i, j| {
            let rate = h * by.dtau[i % N][j];
            if i < N { h * rate } else { rate }
        });
        (a, b)
    }
}
