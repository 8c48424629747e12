//! A robot's description of itself.
//!
//! In: a description. Out: counts, names, limits and the neutral configuration as constants of a trait, the bound of
//! controllers for any robot.

use super::joint::Motion;

/// A robot that describes itself: counts, names, limits and the neutral configuration.
///
/// `N` is the number of degrees of freedom, `Q` the number of coordinates. `#[derive(Robot)]`, [`chain!`](crate::chain)
/// and files made for this crate implement the trait; the same constants but [`MOTIONS`](Self::MOTIONS) are associated
/// constants of the struct. Limits are those of the description, infinite where it has none. Orders are those of
/// arguments and results: entry k of [`MAX_EFFORT`](Self::MAX_EFFORT) belongs to entry k of τ.
///
/// ```
/// use homogen::Robot;
/// use homogen::robot::{Bias, MassMatrix};
///
/// /// Torques for an acceleration, within the effort limits of the actuators.
/// fn computed_torque<R, const N: usize>(robot: &R, q: &[f64; N], qd: &[f64; N], qdd: &[f64; N]) -> [f64; N]
/// where
///     R: Robot<N> + MassMatrix<N> + Bias<N>,
/// {
///     let (mass, bias) = (robot.mass_matrix(q), robot.bias(q, qd));
///     core::array::from_fn(|i| {
///         let tau: f64 = (0..N).map(|j| mass[i][j] * qdd[j]).sum();
///         (tau + bias[i]).clamp(-R::MAX_EFFORT[i], R::MAX_EFFORT[i])
///     })
/// }
/// ```
pub trait Robot<const N: usize, const Q: usize = N> {
    /// The robot as data, which generic recursions take: a [`Chain`](crate::Chain) of these lengths.
    type Chain;
    /// Names of the joints that move, parents before children.
    const JOINTS: &'static [&'static str];
    /// Types of motion of these joints, in the same order.
    const MOTIONS: &'static [Motion];
    /// Names of the entries of q.
    const COORDINATES: [&'static str; Q];
    /// Names of the entries of q̇, q̈ and τ.
    const VELOCITIES: [&'static str; N];
    /// Names of the frames that have poses and Jacobians, the end effector first.
    const FRAMES: &'static [&'static str];
    /// Lower limits of q \[rad or m\].
    const LOWER: [f64; Q];
    /// Upper limits of q \[rad or m\].
    const UPPER: [f64; Q];
    /// Limits of |q̇| \[rad/s or m/s\].
    const MAX_VELOCITY: [f64; N];
    /// Limits of |τ| \[N m or N\].
    const MAX_EFFORT: [f64; N];
    /// The neutral configuration, with every joint at its placement: zeros, and 0, 0, 0, 1 for quaternions (x, y, z, w).
    const NEUTRAL: [f64; Q];
    /// Configurations with names, from the keyframes of a file \[rad, m, quaternions x, y, z, w\]; none if it has no
    /// keyframes.
    const CONFIGURATIONS: &'static [(&'static str, [f64; Q])] = &[];
}
