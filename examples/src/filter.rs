//! An extended Kalman filter for the mass of a payload, for any robot with a payload as a field.
//!
//! In: applied torques and measured coordinates of each period. Out: estimates of the state and the mass, with their
//! covariance. The model is q̇' = q̇ + h q̈, q' = q + h q̇' and a constant mass with drift.

use std::array::from_fn;

use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives, InverseDynamics};
use nalgebra::{Cholesky, DMatrix, DVector};

/// Standard deviations of the noise.
#[derive(Clone, Copy, Debug)]
pub struct Deviations {
    /// Measured coordinates \[rad\].
    pub encoder: f64,
    /// Model error: the change of a rate by errors of the accelerations in a second [rad/s].
    pub model: f64,
    /// Drift: the change of the mass in a second \[kg\].
    pub drift: f64,
    /// Initial mass \[kg\].
    pub mass: f64,
}

/// Estimates of q, q̇ and the mass, with their covariance.
#[derive(Clone, Debug)]
pub struct Estimate<const N: usize> {
    /// Coordinates and rates.
    pub state: [[f64; N]; 2],
    /// The mass of the payload \[kg\].
    pub mass: f64,
    covariance: DMatrix<f64>,
    noise: Deviations,
}

impl<const N: usize> Estimate<N> {
    /// At rest at `q`, with a guess of the mass.
    #[must_use]
    pub fn new(q: [f64; N], mass: f64, noise: Deviations) -> Self {
        let variances = DVector::from_fn(2 * N + 1, |i, _| match i {
            i if i < 2 * N => noise.encoder * noise.encoder,
            _ => noise.mass * noise.mass,
        });
        Self {
            state: [q, [0.0; N]],
            mass,
            covariance: DMatrix::from_diagonal(&variances),
            noise,
        }
    }

    /// The standard deviation of the mass \[kg\].
    #[must_use]
    pub fn mass_deviation(&self) -> f64 {
        self.covariance[(2 * N, 2 * N)].sqrt()
    }

    /// Predicts the estimate after a period \[s\] under torques; `with_mass` makes the robot with a payload.
    pub fn predict<R>(&mut self, period: f64, tau: &[f64; N], with_mass: impl Fn(f64) -> R)
    where
        R: ForwardDynamics<N> + ForwardDynamicsDerivatives<N> + InverseDynamics<N>,
    {
        let ([q, qd], h) = (self.state, period);
        let robot = with_mass(self.mass);
        let qdd = robot.forward_dynamics(&q, &qd, tau);
        let by = robot.forward_dynamics_derivatives(&q, &qd, tau);
        // ∂q̈/∂m = −M⁻¹ ∂τ/∂m; torques are linear in the mass.
        let tau_plus = with_mass(self.mass + 1.0).inverse_dynamics(&q, &qd, &qdd);
        let tau = robot.inverse_dynamics(&q, &qd, &qdd);
        let by_mass: [f64; N] = from_fn(|i| {
            let row = by.dtau[i].iter().zip(tau_plus.iter().zip(&tau));
            -row.map(|(mobility, (tau_plus, tau))| mobility * (tau_plus - tau))
                .sum::<f64>()
        });
        let transition = DMatrix::from_fn(2 * N + 1, 2 * N + 1, |i, j| {
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
                    _ => by_mass[row],
                };
            if i < N { same + h * rate } else { rate }
        });
        let qd: [f64; N] = from_fn(|i| qd[i] + h * qdd[i]);
        self.state = [from_fn(|i| q[i] + h * qd[i]), qd];
        self.covariance = &transition * &self.covariance * transition.transpose();
        for i in N..2 * N {
            self.covariance[(i, i)] += h * self.noise.model * self.noise.model;
        }
        self.covariance[(2 * N, 2 * N)] += h * self.noise.drift * self.noise.drift;
    }

    /// Corrects the estimate by measured coordinates.
    ///
    /// # Panics
    /// If the deviation of the encoders is zero, or a number is NaN.
    pub fn correct(&mut self, measured: &[f64; N]) {
        let noise = DMatrix::identity(N, N) * (self.noise.encoder * self.noise.encoder);
        let rows = self.covariance.rows(0, N).clone_owned();
        let innovation_covariance = self.covariance.view((0, 0), (N, N)) + noise;
        let factors = Cholesky::new(innovation_covariance).expect("encoders have noise");
        let gain = factors.solve(&rows).transpose();
        let innovation = DVector::from_fn(N, |i, _| measured[i] - self.state[0][i]);
        let change = &gain * innovation;
        for i in 0..N {
            self.state[0][i] += change[i];
            self.state[1][i] += change[N + i];
        }
        self.mass += change[2 * N];
        self.covariance -= gain * rows;
        self.covariance = (&self.covariance + self.covariance.transpose()) * 0.5;
    }
}
