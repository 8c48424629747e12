//! An extended Kalman filter that weighs what a robot holds, written once for every robot whose payload can be set.
//!
//! In: torques that were applied, and coordinates that were measured, period by period. Out: the state and the mass, and
//! how well they are known. The state follows q̇' = q̇ + h q̈, q' = q + h q̇'; the mass stays, but for a drift that
//! lets it change.

use std::array::from_fn;

use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives, InverseDynamics};
use nalgebra::{Cholesky, DMatrix, DVector};

/// How exact things are: standard deviations.
#[derive(Clone, Copy, Debug)]
pub struct Doubts {
    /// Of a measured coordinate \[rad\].
    pub encoder: f64,
    /// Of what the model's accelerations are off by, in a second [rad/s].
    pub model: f64,
    /// Of what the mass changes by in a second \[kg\].
    pub drift: f64,
    /// Of the mass in the beginning \[kg\].
    pub mass: f64,
}

/// What is believed: q, q̇ and the mass, with their covariances.
#[derive(Clone, Debug)]
pub struct Belief<const N: usize> {
    /// Coordinates and rates.
    pub state: [[f64; N]; 2],
    /// What the robot holds \[kg\].
    pub mass: f64,
    covariance: DMatrix<f64>,
    doubts: Doubts,
}

impl<const N: usize> Belief<N> {
    /// At rest at a place, with a mass that is guessed.
    #[must_use]
    pub fn new(q: [f64; N], mass: f64, doubts: Doubts) -> Self {
        let known = DVector::from_fn(2 * N + 1, |i, _| match i {
            i if i < 2 * N => doubts.encoder * doubts.encoder,
            _ => doubts.mass * doubts.mass,
        });
        Self {
            state: [q, [0.0; N]],
            mass,
            covariance: DMatrix::from_diagonal(&known),
            doubts,
        }
    }

    /// The standard deviation of the mass \[kg\].
    #[must_use]
    pub fn doubt(&self) -> f64 {
        self.covariance[(2 * N, 2 * N)].sqrt()
    }

    /// What is believed a period \[s\] later, under torques; `holding` is the robot that holds a mass.
    pub fn predict<R>(&mut self, period: f64, tau: &[f64; N], holding: impl Fn(f64) -> R)
    where
        R: ForwardDynamics<N> + ForwardDynamicsDerivatives<N> + InverseDynamics<N>,
    {
        let ([q, qd], h) = (self.state, period);
        let robot = holding(self.mass);
        let qdd = robot.forward_dynamics(&q, &qd, tau);
        let by = robot.forward_dynamics_derivatives(&q, &qd, tau);
        // Torques are linear in the mass.
        let more = holding(self.mass + 1.0).inverse_dynamics(&q, &qd, &qdd);
        let now = robot.inverse_dynamics(&q, &qd, &qdd);
        let slowed: [f64; N] = from_fn(|i| {
            let row = by.dtau[i].iter().zip(more.iter().zip(&now));
            -row.map(|(mobility, (more, now))| mobility * (more - now))
                .sum::<f64>()
        });
        let moved = DMatrix::from_fn(2 * N + 1, 2 * N + 1, |i, j| {
            let same = if i == j { 1.0 } else { 0.0 };
            if i == 2 * N {
                return same;
            }
            let row = i % N;
            let own = if j == N + row { 1.0 } else { 0.0 };
            let rate = own
                + h * match j {
                    j if j < N => by.dq[row][j],
                    j if j < 2 * N => by.dqd[row][j - N],
                    _ => slowed[row],
                };
            if i < N { same + h * rate } else { rate }
        });
        let qd: [f64; N] = from_fn(|i| qd[i] + h * qdd[i]);
        self.state = [from_fn(|i| q[i] + h * qd[i]), qd];
        self.covariance = &moved * &self.covariance * moved.transpose();
        for i in N..2 * N {
            self.covariance[(i, i)] += h * self.doubts.model * self.doubts.model;
        }
        self.covariance[(2 * N, 2 * N)] += h * self.doubts.drift * self.doubts.drift;
    }

    /// What is believed once coordinates were measured.
    ///
    /// # Panics
    /// Where encoders are said to be exact, or a number is none.
    pub fn correct(&mut self, measured: &[f64; N]) {
        let noise = DMatrix::identity(N, N) * (self.doubts.encoder * self.doubts.encoder);
        let seen = self.covariance.rows(0, N).clone_owned();
        let spread = self.covariance.view((0, 0), (N, N)) + noise;
        let spread = Cholesky::new(spread).expect("encoders are never exact");
        let gain = spread.solve(&seen).transpose();
        let surprise = DVector::from_fn(N, |i, _| measured[i] - self.state[0][i]);
        let change = &gain * surprise;
        for i in 0..N {
            self.state[0][i] += change[i];
            self.state[1][i] += change[N + i];
        }
        self.mass += change[2 * N];
        self.covariance -= gain * seen;
        self.covariance = (&self.covariance + self.covariance.transpose()) * 0.5;
    }
}
