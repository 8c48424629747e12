//! Desired motions of arms, and their simulation.
//!
//! In: amplitudes and rates; or a robot, a state and torques. Out: desired q, q̇ and q̈ at a time; or the state after a
//! step.

use std::array::from_fn;

use homogen::robot::ForwardDynamics;

/// A desired motion: q, q̇, q̈.
pub type Desired<const N: usize> = [[f64; N]; 3];

/// A motion of cosines: each coordinate oscillates on one side of its start with its own rate, initially at rest.
#[derive(Clone, Copy, Debug)]
pub struct Waves<const N: usize> {
    /// Start \[rad\].
    pub from: [f64; N],
    /// Amplitude: half of the range of motion \[rad\].
    pub reach: [f64; N],
    /// Angular frequency [rad/s].
    pub rate: [f64; N],
}

impl<const N: usize> Waves<N> {
    /// The desired motion at a time \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> Desired<N> {
        let of = |f: &dyn Fn(f64, f64) -> f64| from_fn(|i| f(self.reach[i], self.rate[i]));
        let moved: [f64; N] = of(&|a, w| a * (1.0 - (w * t).cos()));
        [
            from_fn(|i| self.from[i] + moved[i]),
            of(&|a, w| a * w * (w * t).sin()),
            of(&|a, w| a * w * w * (w * t).cos()),
        ]
    }
}

/// One step of the Runge–Kutta method of order 4 with constant torques.
pub fn step<R, const N: usize>(
    robot: &R,
    period: f64,
    q: &mut [f64; N],
    qd: &mut [f64; N],
    tau: &[f64; N],
) where
    R: ForwardDynamics<N>,
{
    let after = |x: &[f64; N], h: f64, d: &[f64; N]| -> [f64; N] { from_fn(|i| x[i] + h * d[i]) };
    let rate = |q: &[f64; N], qd: &[f64; N]| (*qd, robot.forward_dynamics(q, qd, tau));
    let half = 0.5 * period;
    let (v_1, a_1) = rate(q, qd);
    let (v_2, a_2) = rate(&after(q, half, &v_1), &after(qd, half, &a_1));
    let (v_3, a_3) = rate(&after(q, half, &v_2), &after(qd, half, &a_2));
    let (v_4, a_4) = rate(&after(q, period, &v_3), &after(qd, period, &a_3));
    for i in 0..N {
        q[i] += period / 6.0 * (v_1[i] + 2.0 * (v_2[i] + v_3[i]) + v_4[i]);
        qd[i] += period / 6.0 * (a_1[i] + 2.0 * (a_2[i] + a_3[i]) + a_4[i]);
    }
}

/// The largest magnitude of some numbers; 0 without any.
#[must_use]
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().map(f64::abs).fold(0.0, f64::max)
}
