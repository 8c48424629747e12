//! Inverse kinematics: coordinates at which frames of a robot are at given poses.
//!
//! In: a robot with poses and geometric Jacobians, targets, limits, a start. Out: a [`Solution`] with its [`Outcome`] and
//! the remaining errors; or an [`Error`] of the call: empty limits, a target that is no pose, NaN. No allocation and a
//! bounded number of evaluations; NaN and infinite coordinates are never returned. Joints have one coordinate each.
//!
//! Steps are damped least squares (Levenberg, 1944; Marquardt, 1963; with damping proportional to the squared error, as in
//! Sugihara, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", 2011) over the joints that
//! are not held at a limit. Where no step reduces the error, the solver restarts from pseudo-random configurations within
//! the limits, the same ones at each call. A rest configuration, if there is one, is approached along the motions that
//! keep the targets met.
//!
//! ```
//! use homogen::ik::{Outcome, Solver};
//! use homogen::robot::{ForwardKinematics, GeometricJacobian};
//! use homogen::{Pose, Screw};
//!
//! /// Two links of 0.5 m in the plane xy.
//! struct Arm;
//! impl ForwardKinematics<2> for Arm {
//!     fn forward_kinematics(&self, q: &[f64; 2]) -> Pose<f64> {
//!         let (s, c) = (q[0] + q[1]).sin_cos();
//!         let tip = [0.5 * (q[0].cos() + c), 0.5 * (q[0].sin() + s), 0.0];
//!         Pose::new([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]], tip)
//!     }
//! }
//! impl GeometricJacobian<2> for Arm {
//!     fn geometric_jacobian(&self, q: &[f64; 2]) -> [Screw<f64>; 2] {
//!         let (s, c) = (q[0] + q[1]).sin_cos();
//!         let outer = [-0.5 * s, 0.5 * c, 0.0];
//!         let inner = [outer[0] - 0.5 * q[0].sin(), outer[1] + 0.5 * q[0].cos(), 0.0];
//!         [inner, outer].map(|b| Screw::new([0.0, 0.0, 1.0], b))
//!     }
//! }
//!
//! let solver = Solver::within([[-3.0, 3.0]; 2]);
//! let target = Arm.forward_kinematics(&[0.4, 1.1]);
//! let found = solver.solve(&Arm, &target, &[0.0, 0.1])?;
//! assert_eq!(found.outcome, Outcome::Converged);
//! assert!((found.q[0] - 0.4).abs() < 1e-5 && (found.q[1] - 1.1).abs() < 1e-5);
//!
//! let far = solver.solve(&Arm, &Pose::from_translation([2.0, 0.0, 0.0]), &[0.3, 0.1])?;
//! assert_eq!(far.outcome, Outcome::OutOfReach);
//! assert!((far.position_error - 1.0).abs() < 1e-3); // as near as it gets
//! # Ok::<(), homogen::Error>(())
//! ```

mod checked;

use crate::error::Error;
use crate::matrix::vector::{dot, matrix_product, norm, scale, sub, transpose};
use crate::matrix::{Pose, Screw, rotation};
use crate::robot::described::Robot;
use crate::robot::{ForwardKinematics, GeometricJacobian};
use crate::scalar::Real;
use core::array::from_fn;

/// A solver with its limits, tolerances and bounds on its work.
///
/// ```
/// use homogen::ik::Solver;
///
/// let mut solver = Solver::within([[-3.1, 3.1]; 6]);
/// solver.rest = Some([0.0; 6]);
/// solver.restarts = 8;
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Solver<T, const N: usize> {
    /// Lower and upper limit of each coordinate [rad, m]; −∞ and ∞ where there is none.
    pub limits: [[T; 2]; N],
    /// The configuration that is approached as far as the targets leave degrees of freedom [rad, m].
    pub rest: Option<[T; N]>,
    /// Largest angle between a frame and its target \[rad\].
    pub orientation_tolerance: T,
    /// Largest distance between the origins of a frame and its target \[m\].
    pub position_tolerance: T,
    /// Length that makes angles comparable with distances: an angle of 1 rad weighs as much as this distance \[m\].
    pub length_scale: T,
    /// Maximum number of evaluations of the robot from one start, and the same again for the rest configuration.
    pub max_evaluations: usize,
    /// Maximum number of restarts.
    pub restarts: usize,
}

/// The end of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// Every frame is within the tolerances of its target.
    Converged,
    /// Every start ended at a local minimum of the error within the limits.
    OutOfReach,
    /// The maximum number of evaluations was used up while the error still decreased; or poses or Jacobians are not
    /// finite at a start.
    Stalled,
}

/// The result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Solution<T, const N: usize> {
    /// The best coordinates found, within the limits [rad, m].
    pub q: [T; N],
    /// The end of the search.
    pub outcome: Outcome,
    /// Largest angle between a frame and its target \[rad\].
    pub orientation_error: T,
    /// Largest distance between the origins of a frame and its target \[m\].
    pub position_error: T,
    /// Number of evaluations of the robot.
    pub evaluations: usize,
}

/// The pose of a frame of the robot, and its geometric Jacobian (axes of frame 0, reference point at the frame's origin).
pub type PoseAndJacobian<T, const N: usize> = (Pose<T>, [Screw<T>; N]);

/// The normal equations of an error e at a configuration: JᵗJ and Jᵗe.
#[derive(Clone, Copy)]
struct Normal<T, const N: usize> {
    q: [T; N],
    square: [[T; N]; N],
    gradient: [T; N],
    /// ‖e‖².
    cost: T,
    angle: T,
    distance: T,
}

impl<T: Real, const N: usize> Normal<T, N> {
    /// The trace of JᵗJ.
    fn trace(&self) -> T {
        let entries = self.square.iter().enumerate();
        entries.fold(T::constant(0.0), |sum, (i, row)| sum + row[i])
    }
}

/// The end of a descent.
enum Descent {
    Met,
    Stationary,
    Unfinished,
}

impl<T: Real, const N: usize> Solver<T, N> {
    /// A solver within the limits of a robot, as [`within`](Self::within).
    #[must_use]
    pub fn of<R: Robot<N>>(robot: &R) -> Self {
        let _ = robot;
        Self::within(from_fn(|i| [R::LOWER[i], R::UPPER[i]].map(T::constant)))
    }

    /// A solver within limits [rad, m], with tolerances of 10⁻⁶ rad and 10⁻⁶ m (64 ε where that is more), a length scale
    /// of 0.5 m, 64 evaluations a start and 31 restarts.
    #[must_use]
    pub fn within(limits: [[T; 2]; N]) -> Self {
        let tolerance = T::constant(1e-6).max(T::constant(64.0) * T::EPSILON);
        Self {
            limits,
            rest: None,
            orientation_tolerance: tolerance,
            position_tolerance: tolerance,
            length_scale: T::constant(0.5),
            max_evaluations: 64,
            restarts: 31,
        }
    }

    /// Brings the end effector to a target, given in frame 0. A start outside the limits is moved to the nearest of them.
    ///
    /// A target rotation that is orthogonal to 10⁻⁶ (10⁻³ in `f32`), as printed digits are, is replaced by that of its unit
    /// quaternion; a larger defect is an error: [`normalize`](crate::normalize) makes a rotation of any matrix.
    ///
    /// # Errors
    ///
    /// [`Error::EmptyRange`] for empty limits: crossed, NaN, or infinite to the wrong side;
    /// [`Error::NotRotation`] for a target whose 3×3 part is no rotation; [`Error::NotFinite`] for NaN and infinity in a
    /// target, the start, the rest configuration or the length scale, and for a tolerance that is NaN.
    pub fn solve<R>(
        &self,
        robot: &R,
        target: &Pose<T>,
        start: &[T; N],
    ) -> Result<Solution<T, N>, Error>
    where
        R: ForwardKinematics<N, T> + GeometricJacobian<N, T>,
    {
        let evaluate = |q: &[T; N]| [(robot.forward_kinematics(q), robot.geometric_jacobian(q))];
        self.solve_frames(evaluate, &[*target], start)
    }

    /// Brings several frames to their targets at once, all given in frame 0; `evaluate` returns poses and Jacobians.
    ///
    /// # Errors
    ///
    /// As [`solve`](Self::solve).
    pub fn solve_frames<const K: usize>(
        &self,
        evaluate: impl Fn(&[T; N]) -> [PoseAndJacobian<T, N>; K],
        targets: &[Pose<T>; K],
        start: &[T; N],
    ) -> Result<Solution<T, N>, Error> {
        checked::check(self, start)?;
        let targets = checked::targets(targets)?;
        Ok(self.search(|q| self.normal(q, &evaluate(&q), &targets), start))
    }

    /// Descends from the start, and from other configurations until the targets are met.
    fn search(&self, normal: impl Fn([T; N]) -> Normal<T, N>, start: &[T; N]) -> Solution<T, N> {
        let mut random = Random(0);
        let mut evaluations = 0;
        let mut ended = true;
        let mut best: Option<Normal<T, N>> = None;
        for attempt in 0..=self.restarts {
            let from = if attempt == 0 {
                *start
            } else {
                self.anywhere(start, &mut random)
            };
            let mut at = normal(self.inside(from));
            evaluations += 1;
            if !at.cost.is_finite() {
                ended = false;
                continue;
            }
            match self.descend(&normal, &mut at, &mut evaluations) {
                Descent::Met => {
                    let at = self.towards_rest(&normal, at, &mut evaluations);
                    return Self::solution(&at, Outcome::Converged, evaluations);
                }
                Descent::Stationary => {}
                Descent::Unfinished => ended = false,
            }
            if best.as_ref().is_none_or(|best| at.cost < best.cost) {
                best = Some(at);
            }
        }
        let outcome = if ended {
            Outcome::OutOfReach
        } else {
            Outcome::Stalled
        };
        best.map_or_else(
            || self.nowhere(evaluations),
            |best| Self::solution(&best, outcome, evaluations),
        )
    }

    /// The error at a configuration, and its normal equations.
    fn normal<const K: usize>(
        &self,
        q: [T; N],
        frames: &[PoseAndJacobian<T, N>; K],
        targets: &[Pose<T>; K],
    ) -> Normal<T, N> {
        let zero = T::constant(0.0);
        let mut found = Normal {
            q,
            square: [[zero; N]; N],
            gradient: [zero; N],
            cost: zero,
            angle: zero,
            distance: zero,
        };
        let weight = self.length_scale * self.length_scale;
        for ((pose, jacobian), target) in frames.iter().zip(targets) {
            let back = matrix_product(target.rotation(), &transpose(pose.rotation()));
            let (axis, angle) = rotation::axis_angle(&back);
            let rotation = scale(angle, axis);
            let offset = sub(target.translation(), pose.translation());
            for (i, column) in jacobian.iter().enumerate() {
                let weighted = scale(weight, column.u());
                found.gradient[i] =
                    found.gradient[i] + dot(weighted, rotation) + dot(column.b(), offset);
                for (j, other) in jacobian[..=i].iter().enumerate() {
                    let product = dot(weighted, other.u()) + dot(column.b(), other.b());
                    found.square[i][j] = found.square[i][j] + product;
                }
            }
            found.cost = found.cost + weight * dot(rotation, rotation) + dot(offset, offset);
            found.angle = found.angle.max(angle.abs());
            found.distance = found.distance.max(norm(offset));
        }
        found
    }

    /// Descends until no step helps or the evaluations are used up.
    fn descend(
        &self,
        normal: &impl Fn([T; N]) -> Normal<T, N>,
        at: &mut Normal<T, N>,
        evaluations: &mut usize,
    ) -> Descent {
        let [less, more] = [0.25, 4.0].map(T::constant);
        let (least, most) = (T::constant(1e-4), T::constant(1e4));
        let mut damping = T::constant(0.1);
        let mut slow = 0;
        for _ in 1..self.max_evaluations {
            if self.is_met(at) {
                return Descent::Met;
            }
            if self.is_stationary(at) {
                return Descent::Stationary;
            }
            let step = self.step(at, damping * at.cost, &at.gradient);
            let next = normal(self.inside(from_fn(|i| at.q[i] + step[i])));
            *evaluations += 1;
            if next.cost < at.cost {
                slow = if next.cost > T::constant(SLOW) * at.cost {
                    slow + 1
                } else {
                    0
                };
                *at = next;
                damping = (damping * less).max(least);
            } else {
                slow += 1;
                damping = damping * more;
            }
            if damping > most || slow == PATIENCE {
                return Descent::Stationary;
            }
        }
        if self.is_met(at) {
            Descent::Met
        } else {
            Descent::Unfinished
        }
    }

    fn is_met(&self, at: &Normal<T, N>) -> bool {
        at.angle <= self.orientation_tolerance && at.distance <= self.position_tolerance
    }

    /// True where the error is perpendicular to all motions of the joints that may move.
    fn is_stationary(&self, at: &Normal<T, N>) -> bool {
        let small = T::constant(1e-8) * at.cost;
        (0..N).all(|i| {
            let gradient = at.gradient[i];
            self.stops(i, at.q[i], gradient) || gradient * gradient <= small * at.square[i][i]
        })
    }

    /// (JᵗJ + damping) step = right side, over the joints that are not held at a limit.
    fn step(&self, at: &Normal<T, N>, damping: T, right: &[T; N]) -> [T; N] {
        let zero = T::constant(0.0);
        // Large enough for a Cholesky factor of the rounded JᵗJ.
        let damping = damping + T::constant(16.0) * T::EPSILON * at.trace() + T::MIN_POSITIVE;
        let mut free = [true; N];
        let mut step = [zero; N];
        // Each iteration stops a joint or is the last one.
        for _ in 0..=N {
            step = solve(&at.square, damping, right, &free);
            let mut stopped = false;
            for i in 0..N {
                if free[i] && self.stops(i, at.q[i], step[i]) {
                    free[i] = false;
                    stopped = true;
                }
            }
            if !stopped {
                break;
            }
        }
        from_fn(|i| if free[i] { step[i] } else { zero })
    }

    /// Follows the motions that keep the targets met, towards the rest configuration.
    fn towards_rest(
        &self,
        normal: &impl Fn([T; N]) -> Normal<T, N>,
        mut at: Normal<T, N>,
        evaluations: &mut usize,
    ) -> Normal<T, N> {
        let Some(rest) = self.rest else {
            return at;
        };
        let distance = |q: &[T; N]| norm(from_fn::<T, N, _>(|i| rest[i] - q[i]));
        let last = *evaluations + self.max_evaluations;
        let mut share = T::constant(1.0);
        while share > T::constant(0.1) && *evaluations < last {
            // (JᵗJ + λ)⁻¹ λ z is z without its part in the row space of J.
            let damping = T::EPSILON.sqrt() * at.trace();
            let wanted = from_fn(|i| damping * share * (rest[i] - at.q[i]));
            let step = self.step(&at, damping, &wanted);
            let mut next = normal(self.inside(from_fn(|i| at.q[i] + step[i])));
            *evaluations += 1;
            let met = matches!(self.descend(normal, &mut next, evaluations), Descent::Met);
            if met && distance(&next.q) < T::constant(0.999) * distance(&at.q) {
                at = next;
            } else {
                share = share * T::constant(0.5);
            }
        }
        at
    }

    /// True where a limit stops a joint that would move in a direction.
    fn stops(&self, joint: usize, q: T, direction: T) -> bool {
        let ([least, most], zero) = (self.limits[joint], T::constant(0.0));
        direction < zero && q <= least || direction > zero && q >= most
    }

    fn inside(&self, q: [T; N]) -> [T; N] {
        from_fn(|i| {
            let [least, most] = self.limits[i];
            let q = if q[i] < least { least } else { q[i] };
            if q > most { most } else { q }
        })
    }

    /// A configuration within the limits, or within π of the start where there are none.
    fn anywhere(&self, start: &[T; N], random: &mut Random) -> [T; N] {
        from_fn(|i| {
            let part = T::constant(random.next());
            let [least, most] = self.limits[i];
            if (most - least).is_finite() {
                least + part * (most - least)
            } else {
                start[i] + (part + part - T::constant(1.0)) * T::constant(core::f64::consts::PI)
            }
        })
    }

    fn solution(at: &Normal<T, N>, outcome: Outcome, evaluations: usize) -> Solution<T, N> {
        Solution {
            q: at.q,
            outcome,
            orientation_error: at.angle,
            position_error: at.distance,
            evaluations,
        }
    }

    /// The solution where no pose of the robot is finite.
    fn nowhere(&self, evaluations: usize) -> Solution<T, N> {
        let infinite = T::constant(f64::INFINITY);
        Solution {
            q: self.inside([T::constant(0.0); N]),
            outcome: Outcome::Stalled,
            orientation_error: infinite,
            position_error: infinite,
            evaluations,
        }
    }
}

/// Share of the cost above which a step counts as slow.
const SLOW: f64 = 0.95;

/// Number of slow steps in a row that end a descent.
const PATIENCE: usize = 8;

/// (A + damping) x = b over the free rows and columns, by Cholesky factors; reads the lower half of A.
fn solve<T: Real, const N: usize>(
    a: &[[T; N]; N],
    damping: T,
    b: &[T; N],
    free: &[bool; N],
) -> [T; N] {
    let zero = T::constant(0.0);
    let mut factor = [[zero; N]; N];
    let mut x = [zero; N];
    for i in (0..N).filter(|&i| free[i]) {
        for j in (0..=i).filter(|&j| free[j]) {
            let known = (0..j).fold(zero, |sum, k| sum + factor[i][k] * factor[j][k]);
            factor[i][j] = if i == j {
                let square = a[i][i] + damping - known;
                // A pivot below the damping is rounding error.
                square.max(damping).sqrt()
            } else {
                (a[i][j] - known) / factor[j][j]
            };
        }
        let known = (0..i).fold(zero, |sum, k| sum + factor[i][k] * x[k]);
        x[i] = (b[i] - known) / factor[i][i];
    }
    for i in (0..N).rev().filter(|&i| free[i]) {
        let known = (i + 1..N).fold(zero, |sum, k| sum + factor[k][i] * x[k]);
        x[i] = (x[i] - known) / factor[i][i];
    }
    x
}

/// Pseudo-random numbers (splitmix64 of Steele, Lea and Flood, 2014).
struct Random(u64);

impl Random {
    /// Between 0 and 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let [a, b, c, d, ..] = bits.to_be_bytes();
        f64::from(u32::from_be_bytes([a, b, c, d])) / 4_294_967_296.0
    }
}
