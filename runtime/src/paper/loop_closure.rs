//! Closed loops: mobility, and positions, velocities and accelerations for given driving joints.
//!
//! In: a chain, and pairs of its frames that coincide when the loops are closed. Out: the matrix A of
//! A q̇ = 0 and A q̈ = b(H̃), its rank, and the motion of the passive joints (Part II, closed loops). An
//! unreachable position is an error, a singular position a flag. Positions are those of the branch nearest
//! to the start.
//!
//! Inverse kinematics is the same problem: the target is a frame of the base that the end effector must
//! meet.

mod found;
mod gap;
mod linear;
mod projection;

use super::open_chain::{BodyMotion, motions, poses, rounded_pose, screws};
use crate::matrix::Pose;
use crate::matrix::vector::{largest_magnitude, norm};
use crate::robot::chain::{Chain, Frame, UNMOVED};
use crate::scalar::Real;
use core::array::from_fn;
use gap::{components, components_of_rate, missing_screw, relative_acceleration};
use linear::{Linear, with_lengths_in_parts_of};

pub use found::{NotClosed, Position, Rates};
pub use projection::{
    ClosureOutcome, Projection, Regularity, project, project_by, project_rates, regularity,
};

/// A chain whose frames are joined in `K` closed loops.
///
/// Each loop is cut through one of its bodies, not through a joint: all joints stay in the chain,
/// and the two faces of the cut are frames of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedChain<const N: usize, const F: usize, const K: usize> {
    /// The bodies and joints, with the loops cut open.
    pub chain: Chain<N, F>,
    /// The pairs of frames that the loops close.
    pub closures: [Closure; K],
}

/// A loop by two frames that coincide when it is closed: M_left,right = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closure {
    /// The frame at one face of the cut.
    pub left: Frame,
    /// The frame at the other face; the equations of the loop are in this frame.
    pub right: Frame,
}

impl<const N: usize, const F: usize> ClosedChain<N, F, 1> {
    /// One loop, closed where the tip of `chain` meets the frame 0 of the base: Π M = 1, Σ W = 0,
    /// Σ H = 0 (Part II, closed loops).
    #[must_use]
    pub fn tip_at_base(chain: Chain<N, F>) -> Self {
        Self::tip_at(chain, UNMOVED)
    }

    /// One loop, closed where the tip of `chain` meets the pose `target` in frame 0: the inverse
    /// kinematics of the chain.
    #[must_use]
    pub fn tip_at(chain: Chain<N, F>, target: Pose<f64>) -> Self {
        let (left, right) = (chain.tip(), Frame::new("target", None, target));
        Self {
            chain,
            closures: [Closure { left, right }],
        }
    }
}

/// The matrix A: of each loop six rows u_x … b_z, one column (u, b) a joint (Part II, closed loops).
///
/// A column is L of the joint in the frame `right` of the loop, reference point at its origin; negative for a
/// joint between the base and `right`, zero for one that is not in the loop.
#[must_use]
pub fn matrix<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
) -> [[[T; N]; 6]; K] {
    let poses = poses(&closed.chain, q);
    let screws = screws(&closed.chain, &poses);
    closed.closures.map(|closure| {
        let m_right_0 = pose_of(&closure.right, &poses).inverse();
        let columns: [[T; 6]; N] = from_fn(|i| {
            let moves = |frame: &Frame| closed.chain.carries(i, frame.body);
            match (moves(&closure.left), moves(&closure.right)) {
                (true, false) => components(&m_right_0.change_frame(&screws[i])),
                (false, true) => components(&-m_right_0.change_frame(&screws[i])),
                // A joint that moves both faces does not change their relative pose.
                _ => [T::constant(0.0); 6],
            }
        });
        from_fn(|row| from_fn(|i| columns[i][row]))
    })
}

/// The rank of A at `q`, by singular values above 64 ε times the largest; rows of lengths are divided by the
/// size of the robot.
#[must_use]
pub fn rank<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
) -> usize {
    let nothing = [[T::constant(0.0); 6]; K];
    linear_at(closed, q, &[None; N]).solve(nothing).0
}

/// The mobility at `q`: the number of joints less the rank of A (Part II, closed loops).
///
/// At a singular position it is the mobility to first order, which may be larger than at neighbouring
/// positions.
#[must_use]
pub fn mobility<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
) -> usize {
    N - rank(closed, q)
}

/// The coordinates that close the loops, by Newton–Raphson (Part II, closed loops).
///
/// `driving` holds the given coordinates (`None` is unknown), `start` a guess of the others.
/// Each step solves A Δq = −(φ u, φ b), with exp(L φ) the displacements by which the loops are open, and
/// moves no joint by more than 1 rad. Steps continue while they halve the residual, down to rounding; the
/// result is accepted if the residual is at most 4 (N + 2) ε.
///
/// # Errors
///
/// [`NotClosed`] if 100 steps are not enough, and for input that is not finite.
pub fn position<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    driving: &[Option<T>; N],
    start: &[T; N],
) -> Result<Position<T, N>, NotClosed> {
    let tolerance = (0..N + 2).fold(T::constant(0.0), |sum, _| {
        sum + T::constant(4.0) * T::EPSILON
    });
    let size = size(closed);
    let mut q: [T; N] = from_fn(|i| driving[i].unwrap_or(start[i]));
    let (mut screws, residual) = gaps(closed, &q, size);
    let mut best = (residual, q, 0);
    let (mut iterations, mut in_vain) = (0, 0);
    while iterations < STEPS && (best.0 > tolerance || in_vain < 2) {
        let linear = linear_at(closed, &q, driving);
        let (_, step) = linear.solve(screws.map(|screw| screw.map(|x| -x)));
        let factor = step_factor(closed, &step, size);
        q = from_fn(|i| driving[i].unwrap_or(q[i] + factor * step[i]));
        let residual;
        (screws, residual) = gaps(closed, &q, size);
        iterations += 1;
        // Rounding may decrease a residual slightly in many steps.
        let helps = residual + residual < best.0;
        in_vain = if helps { 0 } else { in_vain + 1 };
        if residual < best.0 {
            best = (residual, q, iterations);
        }
        if !residual.is_finite() {
            break;
        }
    }
    let (residual, q, needed) = best;
    if residual <= tolerance {
        let linear = linear_at(closed, &q, driving);
        let (rank, _) = linear.solve([[T::constant(0.0); 6]; K]);
        Ok(Position {
            q,
            residual,
            iterations: needed,
            is_singular: rank < linear.number_sought,
        })
    } else {
        Err(NotClosed {
            residual: residual.to_f64(),
            iterations,
        })
    }
}

/// The rates of all joints at a position `q` of closed loops: A q̇ = 0 with the `driving` rates given
/// (Part II, closed loops).
#[must_use]
pub fn velocity<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
    driving: &[Option<T>; N],
) -> Rates<T, N> {
    linear_at(closed, q, driving).rates([[T::constant(0.0); 6]; K], driving)
}

/// The second rates of all joints at `q` and `qd`: A q̈ = b(H̃) with the `driving` second rates given,
/// b(H̃) holding −(ω̇, a₀) of the loop at q̈ = 0 (Part II, closed loops).
#[must_use]
pub fn acceleration<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
    qd: &[T; N],
    driving: &[Option<T>; N],
) -> Rates<T, N> {
    let motions = motions(&closed.chain, q, qd, &[T::constant(0.0); N]);
    let poses = motions.map(|motion| motion.pose);
    let b = closed.closures.map(|closure| {
        let motion_of = |frame: &Frame| {
            let motion = frame.body.and_then(|i| motions.get(i));
            motion.copied().unwrap_or_else(BodyMotion::identity)
        };
        let (left, right) = (motion_of(&closure.left), motion_of(&closure.right));
        let m_right_0 = pose_of(&closure.right, &poses).inverse();
        let h = relative_acceleration(&left, &right);
        components_of_rate(&m_right_0.change_frame(&h)).map(|x| -x)
    });
    linear_at(closed, q, driving).rates(b, driving)
}

/// The largest number of steps of Newton–Raphson; a dead centre takes about 30.
const STEPS: usize = 100;

/// The factor that keeps a step below 1 rad in every joint, or below the size of the robot.
fn step_factor<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    step: &[T; N],
    size: T,
) -> T {
    let one = T::constant(1.0);
    let turns = closed.chain.joints.iter().zip(step).map(|(joint, step)| {
        if joint.screw.u().iter().all(|u| *u == 0.0) {
            step.abs() / size
        } else {
            step.abs()
        }
    });
    one / turns.fold(one, T::max)
}

/// A at `q`, to be solved for the passive joints.
fn linear_at<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
    driving: &[Option<T>; N],
) -> Linear<T, N, K> {
    Linear::new(matrix(closed, q), size(closed), driving)
}

/// The displacements by which the loops are open, (φ u, φ b) of M_right,left = exp(L φ) in the frame
/// `right`, and their largest component.
fn gaps<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
    q: &[T; N],
    size: T,
) -> ([[T; 6]; K], T) {
    let poses = poses(&closed.chain, q);
    let gaps = closed
        .closures
        .map(|closure| pose_of(&closure.right, &poses).inverse() * pose_of(&closure.left, &poses));
    let screws = gaps.map(missing_screw);
    let all = screws.map(|screw| with_lengths_in_parts_of(size, screw));
    let largest = largest_magnitude(all.as_flattened());
    // The logarithm and the maximum lose NaN; the sum of all entries does not.
    let sum = gaps.iter().fold(T::constant(0.0), |sum, m| {
        let rows = m.to_matrix();
        rows.as_flattened().iter().fold(sum, |sum, x| sum + x.abs())
    });
    (screws, if sum.is_finite() { largest } else { sum })
}

/// The size of the robot: the sum of the distances from joint to joint; 1 m if all of them are zero.
fn size<T: Real, const N: usize, const F: usize, const K: usize>(
    closed: &ClosedChain<N, F, K>,
) -> T {
    let joints = closed.chain.joints.iter().map(|joint| joint.placement);
    let cuts = closed.closures.iter();
    let cuts = cuts.flat_map(|closure| [closure.left.placement, closure.right.placement]);
    let zero = T::constant(0.0);
    let sum = joints.chain(cuts).fold(zero, |sum, pose: Pose<f64>| {
        sum + norm(pose.translation().map(T::constant))
    });
    if sum > zero { sum } else { T::constant(1.0) }
}

/// M₀,frame.
fn pose_of<T: Real, const N: usize>(frame: &Frame, poses: &[Pose<T>; N]) -> Pose<T> {
    let placement = rounded_pose(&frame.placement);
    match frame.body.and_then(|i| poses.get(i)) {
        Some(m_0_body) => *m_0_body * placement,
        None => placement,
    }
}
