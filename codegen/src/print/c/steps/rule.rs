//! Coefficients of the rules of time steps.
//!
//! Stage i is at q + cᵢ Δt q̇ + Δt² Σⱼ aᵢⱼ q̈ⱼ with the velocities q̇ + Δt Σⱼ bᵢⱼ q̈ⱼ of the stages j before it, and the row
//! after the last stage is the end of the step.

use crate::request::Integrator;

/// Coefficients of a rule, a row for each stage and one for the end.
pub(super) struct Table {
    /// cᵢ.
    pub time: &'static [f64],
    /// aᵢⱼ.
    pub of_q: &'static [&'static [f64]],
    /// bᵢⱼ.
    pub of_qd: &'static [&'static [f64]],
}

const SIXTH: f64 = 1.0 / 6.0;
const THIRD: f64 = 1.0 / 3.0;

impl Table {
    pub const fn of(rule: Integrator) -> Self {
        match rule {
            Integrator::SemiImplicit => Self {
                time: &[0.0, 1.0],
                of_q: &[&[0.0], &[1.0]],
                of_qd: &[&[0.0], &[1.0]],
            },
            Integrator::Euler => Self {
                time: &[0.0, 1.0],
                of_q: &[&[0.0], &[0.0]],
                of_qd: &[&[0.0], &[1.0]],
            },
            Integrator::Rk4 => Self {
                time: &[0.0, 0.5, 0.5, 1.0, 1.0],
                of_q: &[
                    &[0.0, 0.0, 0.0, 0.0],
                    &[0.0, 0.0, 0.0, 0.0],
                    &[0.25, 0.0, 0.0, 0.0],
                    &[0.0, 0.5, 0.0, 0.0],
                    &[SIXTH, SIXTH, SIXTH, 0.0],
                ],
                of_qd: &[
                    &[0.0, 0.0, 0.0, 0.0],
                    &[0.5, 0.0, 0.0, 0.0],
                    &[0.0, 0.5, 0.0, 0.0],
                    &[0.0, 0.0, 1.0, 0.0],
                    &[SIXTH, THIRD, THIRD, SIXTH],
                ],
            },
        }
    }

    /// Number of stages.
    pub const fn stages(&self) -> usize {
        self.time.len() - 1
    }
}
