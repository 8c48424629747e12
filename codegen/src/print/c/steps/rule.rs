//! Coefficients of the rules of time steps.
//!
//! Stage i is at q + cᵢ Δt q̇ + Δt² Σⱼ aᵢⱼ q̈ⱼ with the velocities q̇ + Δt Σⱼ bᵢⱼ q̈ⱼ of the stages j before it, and the row
//! after the last stage is the end of the step.

use crate::request::Integrator;

/// Coefficients of a rule of explicit stages, a row for each stage and one for the end.
#[derive(Clone, Copy)]
pub(super) struct Table {
    /// The rule in a few words.
    pub about: &'static str,
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
    /// The implicit midpoint rule has none: its stage depends on its own acceleration.
    pub const fn of(rule: Integrator) -> Option<Self> {
        Some(match rule {
            Integrator::ImplicitMidpoint => return None,
            Integrator::SemiImplicit => Self {
                about: "qd+ = qd + dt qdd, q+ = q + dt qd+",
                time: &[0.0, 1.0],
                of_q: &[&[0.0], &[1.0]],
                of_qd: &[&[0.0], &[1.0]],
            },
            Integrator::Euler => Self {
                about: "qd+ = qd + dt qdd, q+ = q + dt qd",
                time: &[0.0, 1.0],
                of_q: &[&[0.0], &[0.0]],
                of_qd: &[&[0.0], &[1.0]],
            },
            Integrator::Rk4 => Self {
                about: "the classical rule of Runge and Kutta, of order 4",
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
        })
    }

    /// Number of stages.
    pub const fn stages(&self) -> usize {
        self.time.len() - 1
    }
}
