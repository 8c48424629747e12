//! Seeded random states.
//!
//! In: a seed. Out: states that are the same on every platform. Their numbers are exact in single
//! precision, so that both precisions compute the same states.

use std::f32::consts::PI;

use homogen_random::Random;

/// Coordinates, rates, second rates and torques of N joints; rad or m, s, N m or N.
#[derive(Clone, Copy, Debug)]
pub struct State<T, const N: usize> {
    /// q.
    pub q: [T; N],
    /// q̇.
    pub qd: [T; N],
    /// q̈.
    pub qdd: [T; N],
    /// τ.
    pub tau: [T; N],
    /// Weights λ of torques.
    pub weights: [T; N],
    /// Change of q.
    pub q_change: [T; N],
    /// Change of q̇.
    pub qd_change: [T; N],
    /// Change of q̈.
    pub qdd_change: [T; N],
    /// Change of τ.
    pub tau_change: [T; N],
    /// A wrench that weights the twist of a frame: couple, then force.
    pub wrench: [T; 6],
}

impl<const N: usize> State<f32, N> {
    /// The same state in double precision.
    #[must_use]
    pub fn widen(&self) -> State<f64, N> {
        State {
            q: self.q.map(f64::from),
            qd: self.qd.map(f64::from),
            qdd: self.qdd.map(f64::from),
            tau: self.tau.map(f64::from),
            weights: self.weights.map(f64::from),
            q_change: self.q_change.map(f64::from),
            qd_change: self.qd_change.map(f64::from),
            qdd_change: self.qdd_change.map(f64::from),
            tau_change: self.tau_change.map(f64::from),
            wrench: self.wrench.map(f64::from),
        }
    }
}

/// States with q in ±π, q̇ in ±2, q̈ in ±10, τ in ±20 and λ in ±1; changes repeat λ, the wrench τ.
#[must_use]
pub fn random<const N: usize>(count: usize, seed: u64) -> Vec<State<f32, N>> {
    let mut random = Random::new(seed);
    let mut within = |limit: f32| std::array::from_fn(|_| limit * random.coarse());
    let state = |_| {
        let tau = within(20.0);
        let weights = tau.map(|entry| entry / 20.0);
        State {
            q: within(PI),
            qd: within(2.0),
            qdd: within(10.0),
            tau,
            weights,
            q_change: weights,
            qd_change: weights,
            qdd_change: weights,
            tau_change: weights,
            wrench: std::array::from_fn(|k| tau[k % N]),
        }
    };
    (0..count).map(state).collect()
}
