//! Motions that arms are told to make, and what they make of the torques they are given.
//!
//! In: amplitudes and rates; or a robot, a state and torques. Out: where the joints should be at a time, with rates and
//! second rates; or the state a step later. It knows no controller.

use std::array::from_fn;

use homogen::robot::ForwardDynamics;

/// Where joints should be: q, q̇, q̈.
pub type Desired<const N: usize> = [[f64; N]; 3];

/// Coordinates that swing, each to one side of where it begins, with its own rate; at rest in the beginning.
#[derive(Clone, Copy, Debug)]
pub struct Waves<const N: usize> {
    /// Where they begin \[rad\].
    pub from: [f64; N],
    /// How far they swing: by twice as much \[rad\].
    pub reach: [f64; N],
    /// How fast [rad/s].
    pub rate: [f64; N],
}

impl<const N: usize> Waves<N> {
    /// Where they are at a time \[s\].
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

/// One step of Runge and Kutta's method under torques that are held.
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

/// The largest size of some numbers; 0 of none.
#[must_use]
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().map(f64::abs).fold(0.0, f64::max)
}
