//! The arm: its linear model about a goal, its controller, and its simulation.
//!
//! In: a goal and a state. Out: torques within limits of efforts and rates.

use core::array::from_fn;

use homogen::step::{Integrator, NextState, Step, StepDerivatives};
use homogen::{Robot, Scalar};

use crate::admm::{Bounds, Controller, Found, Problem, times};

/// Number of joints.
pub const JOINTS: usize = 7;
/// Coordinates, then rates.
pub const STATES: usize = 2 * JOINTS;
/// One number for each joint.
pub type Joints = [f32; JOINTS];

/// The arm.
#[derive(Robot)]
#[robot(urdf = "../../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(
    gravity,
    gravity_derivative,
    forward_dynamics,
    forward_dynamics_derivatives
))]
pub struct Panda;

/// Number of steps ahead, and their duration \[s\]: longer than the millisecond between two control steps.
pub const AHEAD: usize = 10;
const STEP: f32 = 0.01;
/// Share of the effort limits that the controller may use.
const SHARE: f32 = 0.3;
/// Most iterations of a control step.
pub const ITERATIONS: u32 = 10;
/// Limit of the rates \[rad/s\].
pub const RATE: f32 = 0.5;
/// Residual at which a step ends: of shares of efforts, and of rates \[rad/s\].
const TOLERANCE: f32 = 1e-3;
/// Iterations of the recursion for the gain.
const GAIN: u32 = 2000;

/// Torques that move the arm to a goal.
#[derive(Clone, Debug)]
pub struct Reach {
    goal: Joints,
    /// The derivative of the torques of gravity there, which A has.
    stiffness: [Joints; JOINTS],
    /// Its inputs are shares of the effort limits.
    controller: Controller<STATES, JOINTS, AHEAD>,
}

/// Effort limits \[N m\].
fn efforts() -> Joints {
    Panda::MAX_EFFORT.map(f32::constant)
}

/// A and B of a time step at rest at the goal.
#[inline(never)]
#[must_use]
pub fn linearised(goal: &Joints) -> StepDerivatives<JOINTS, f32> {
    let hold = Panda.gravity(goal);
    Panda.step_derivatives(Integrator::SemiImplicit, goal, &[0.0; JOINTS], &hold, STEP)
}

impl Reach {
    /// The controller for a goal; `None` if its gain is not found.
    #[must_use]
    pub fn new(goal: &Joints) -> Option<Self> {
        let by = linearised(goal);
        let efforts = efforts();
        let infinite = f32::INFINITY;
        let of = |q: f32, qd: f32| from_fn(|i| if i < JOINTS { q } else { qd });
        let problem = Problem {
            a: from_fn(|i| {
                from_fn(|j| {
                    let block = match (i < JOINTS, j < JOINTS) {
                        (true, true) => &by.q_by_q,
                        (true, false) => &by.q_by_qd,
                        (false, true) => &by.qd_by_q,
                        (false, false) => &by.qd_by_qd,
                    };
                    block[i % JOINTS][j % JOINTS]
                })
            }),
            b: from_fn(|i| {
                let block = if i < JOINTS {
                    &by.q_by_tau
                } else {
                    &by.qd_by_tau
                };
                from_fn(|j| block[i % JOINTS][j] * efforts[j])
            }),
            state_weights: of(100.0, 1.0),
            input_weights: [1.0; JOINTS],
            state_bounds: Bounds {
                lower: of(-infinite, -RATE),
                upper: of(infinite, RATE),
                penalties: of(0.0, 20.0),
            },
            input_bounds: Bounds {
                lower: [-SHARE; JOINTS],
                upper: [SHARE; JOINTS],
                penalties: [1.0; JOINTS],
            },
        };
        Some(Self {
            goal: *goal,
            stiffness: Panda.gravity_derivative(goal),
            controller: Controller::new(&problem, GAIN)?,
        })
    }

    /// The torques at a state \[N m\], in at most `iterations` iterations.
    ///
    /// The part of gravity beyond the linear model is added to the model's input, and its bounds are moved by it.
    #[inline(never)]
    pub fn torques(&mut self, q: &Joints, qd: &Joints, iterations: u32) -> (Joints, Found<JOINTS>) {
        let off: Joints = from_fn(|i| q[i] - self.goal[i]);
        let (gravity, linear) = (Panda.gravity(q), times(&self.stiffness, &off));
        let efforts = efforts();
        let known: Joints = from_fn(|i| (gravity[i] - linear[i]) / efforts[i]);
        self.controller.bound_inputs(
            known.map(|known| -SHARE - known),
            known.map(|known| SHARE - known),
        );
        let state = from_fn(|i| if i < JOINTS { off[i] } else { qd[i - JOINTS] });
        let found = self.controller.step(&state, iterations, TOLERANCE);
        (from_fn(|i| efforts[i] * (known[i] + found.input[i])), found)
    }
}

/// The state after a millisecond.
#[must_use]
pub fn simulated(q: &Joints, qd: &Joints, tau: &Joints) -> NextState<JOINTS, f32> {
    Panda.step(Integrator::SemiImplicit, q, qd, tau, 1e-3)
}

/// Control steps of the demonstration, a millisecond each.
pub const STEPS: u16 = 1200;
/// Start of the demonstration, at rest, and its goal.
pub const START: Joints = [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8];
/// The goal.
pub const GOAL: Joints = [0.4, -0.3, -0.3, -1.8, 0.3, 1.9, 0.4];

#[cfg(test)]
mod tests {
    use super::{GOAL, ITERATIONS, RATE, Reach, SHARE, START, STEPS, efforts, simulated};

    #[test]
    fn the_arm_reaches_its_goal_within_the_limits() {
        let mut reach = Reach::new(&GOAL).expect("the gain exists");
        let (mut q, mut qd) = (START, [0.0; 7]);
        let mut fastest: f32 = 0.0;
        for _ in 0..STEPS {
            let (tau, _) = reach.torques(&q, &qd, ITERATIONS);
            for (tau, effort) in tau.iter().zip(efforts()) {
                assert!(tau.abs() <= SHARE * effort * 1.0001, "{tau}");
            }
            let next = simulated(&q, &qd, &tau);
            (q, qd) = (next.q, next.qd);
            fastest = qd
                .iter()
                .fold(fastest, |fastest, rate| fastest.max(rate.abs()));
        }
        let off = q
            .iter()
            .zip(&GOAL)
            .map(|(q, goal)| (q - goal).abs())
            .fold(0.0, f32::max);
        assert!(off < 1e-3, "{off}");
        // The linear model has the inertia at the goal. Observed: 0.527 rad/s.
        assert!((0.95 * RATE..1.1 * RATE).contains(&fastest), "{fastest}");
    }
}
