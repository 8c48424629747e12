//! Desired motions of arms.
//!
//! In: amplitudes and rates. Out: desired q, q̇ and q̈ at a time.

use std::array::from_fn;

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

/// The largest magnitude of some numbers; 0 without any.
#[must_use]
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().map(f64::abs).fold(0.0, f64::max)
}
