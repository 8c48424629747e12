//! The slider-crank: three revolute joints and a prismatic one in a closed loop (Part II, worked
//! examples).
//!
//! In: the lengths of crank and rod, and the crank's angle and rates. Out: the robot as a
//! [`ClosedChain`], the matrix A, and positions, rates and second rates of all joints in closed form, on the
//! branch with the slider in front of the crank pin.

use crate::matrix::{Inertia, Pose, Screw};
use crate::paper::loop_closure::ClosedChain;
use crate::robot::chain::Chain;
use crate::robot::joint::Joint;
use crate::scalar::Real;
use core::array::from_fn;

/// Crank and rod in the plane x, y; the slider moves along x, through the axis of the crank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderCrank {
    /// l₁ \[m\].
    pub crank: f64,
    /// l₂ \[m\].
    pub rod: f64,
}

/// Coordinates, rates and second rates of the four joints: the angles of the crank, of the rod from
/// the crank, and of the slider from the rod, and the position of the slider (rad or m, and seconds).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T> {
    /// q.
    pub q: [T; 4],
    /// q̇.
    pub qd: [T; 4],
    /// q̈.
    pub qdd: [T; 4],
}

impl SliderCrank {
    /// The loop: crank, rod, slider, and the base again behind the prismatic joint. The bodies have no mass.
    #[must_use]
    pub fn closed_chain(&self) -> ClosedChain<4, 0, 1> {
        let about = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]);
        // Relative to the slider the base moves backwards.
        let along = Screw::prismatic([-1.0, 0.0, 0.0]);
        let joint = |name, parent, x, screw| {
            let placement = Pose::from_translation([x, 0.0, 0.0]);
            Joint::new(name, parent, placement, screw, Inertia::zero())
        };
        ClosedChain::tip_at_base(Chain::new(
            [
                joint("crank", None, 0.0, about),
                joint("rod", Some(0), self.crank, about),
                joint("pin", Some(1), self.rod, about),
                joint("slide", Some(2), 0.0, along),
            ],
            [],
            [0.0, 0.0, -9.81],
        ))
    }

    /// The state at the crank's angle `alpha` \[rad\] and its rates.
    ///
    /// With β the angle of the rod from x: l₁ sin α + l₂ sin β = 0 and x = l₁ cos α + l₂ cos β, cos β > 0,
    /// and their derivatives. NaN if the rod is too short for the crank angle α; infinite rates at cos β = 0.
    #[must_use]
    pub fn state<T: Real>(&self, alpha: T, alpha_d: T, alpha_dd: T) -> State<T> {
        let (one, l_1, l_2) = (
            T::constant(1.0),
            T::constant(self.crank),
            T::constant(self.rod),
        );
        let (sin_alpha, cos_alpha) = alpha.sin_cos();
        let sin_beta = -(l_1 * sin_alpha / l_2);
        // 1 − sin² as a product is accurate where the rod is nearly upright.
        let cos_beta = ((one - sin_beta) * (one + sin_beta)).sqrt();
        let beta = sin_beta.atan2(cos_beta);
        let x = l_1 * cos_alpha + l_2 * cos_beta;
        let beta_d = -(l_1 * cos_alpha * alpha_d) / (l_2 * cos_beta);
        let x_d = -(l_1 * sin_alpha * alpha_d) - l_2 * sin_beta * beta_d;
        let (alpha_2, beta_2) = (alpha_d * alpha_d, beta_d * beta_d);
        let beta_dd = (l_1 * (sin_alpha * alpha_2 - cos_alpha * alpha_dd)
            + l_2 * sin_beta * beta_2)
            / (l_2 * cos_beta);
        let x_dd = -(l_1 * (sin_alpha * alpha_dd + cos_alpha * alpha_2))
            - l_2 * (sin_beta * beta_dd + cos_beta * beta_2);
        State {
            q: [alpha, beta - alpha, -beta, x],
            qd: [alpha_d, beta_d - alpha_d, -beta_d, x_d],
            qdd: [alpha_dd, beta_dd - alpha_dd, -beta_dd, x_dd],
        }
    }

    /// A, with rows u_x … b_z and one column a joint.
    ///
    /// Only u_z, b_x and b_y are not zero: (1, 0, 0), (1, l₁ sin α, −l₁ cos α), (1, 0, −x) and
    /// (0, −1, 0). Its rank is 3 and the mobility 1, except with l₁ = l₂ in α = ±90°, where the axes of
    /// crank and pin coincide and the rank is 2.
    /// The minor of rod, pin and slide is −l₂ cos β: zero where a driving crank is stuck. That of
    /// crank, rod and pin is −l₁ x sin α: zero in the dead centres of a driving slider.
    #[must_use]
    pub fn matrix<T: Real>(&self, q: &[T; 4]) -> [[T; 4]; 6] {
        let (zero, one, l_1) = (T::constant(0.0), T::constant(1.0), T::constant(self.crank));
        let (sin_alpha, cos_alpha) = q[0].sin_cos();
        let columns = [
            [one, zero, zero],
            [one, l_1 * sin_alpha, -(l_1 * cos_alpha)],
            [one, zero, -q[3]],
            [zero, -one, zero],
        ];
        let row = |k: usize| from_fn(|i| columns[i][k]);
        [[zero; 4], [zero; 4], row(0), row(1), row(2), [zero; 4]]
    }
}
