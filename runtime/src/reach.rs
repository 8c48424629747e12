//! Inverse kinematics: where the joints must be for frames of a robot to be at given poses.
//!
//! In: a robot that tells its poses and geometric Jacobians, targets, limits, a place to start from. Out: a
//! [`Solution`], which says whether the targets are met, and what is left where they are not; or an [`Error`] of the
//! call: limits that no number is within, a target that is no pose, NaN. It allocates
//! nothing, ends after a number of looks at the robot that is given beforehand, and never returns NaN or an infinite
//! coordinate. It knows no more of a robot than the two functions; joints have one coordinate each.
//!
//! Steps are damped least squares (Levenberg, 1944; Marquardt, 1963; damped by what is left, as by Sugihara,
//! "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", 2011), of the joints that no
//! limit stops. Where no step brings the frames nearer, it starts again from elsewhere within the limits, the same
//! places each time. A posture, if there is one, pulls along the motions that leave the targets met.
//!
//! ```
//! use homogen::reach::{Outcome, Reach};
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
//! let reach = Reach::within([[-3.0, 3.0]; 2]);
//! let target = Arm.forward_kinematics(&[0.4, 1.1]);
//! let found = reach.solve(&Arm, &target, &[0.0, 0.1])?;
//! assert_eq!(found.outcome, Outcome::Converged);
//! assert!((found.q[0] - 0.4).abs() < 1e-5 && (found.q[1] - 1.1).abs() < 1e-5);
//!
//! let far = reach.solve(&Arm, &Pose::from_translation([2.0, 0.0, 0.0]), &[0.3, 0.1])?;
//! assert_eq!(far.outcome, Outcome::OutOfReach);
//! assert!((far.shift - 1.0).abs() < 1e-3); // as near as it gets
//! # Ok::<(), homogen::Error>(())
//! ```

mod checked;

use crate::error::Error;
use crate::matrix::vector::{dot, matrix_product, norm, scale, sub, transpose};
use crate::matrix::{Pose, Screw, rotation};
use crate::robot::{ForwardKinematics, GeometricJacobian};
use crate::scalar::Real;
use core::array::from_fn;

/// What is asked of the joints beside the targets, and when to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach<T, const N: usize> {
    /// The least and the largest value of each coordinate [rad, m]; −∞ and ∞ where there is no limit.
    pub limits: [[T; 2]; N],
    /// Where the joints should be, as far as the targets leave them free [rad, m].
    pub posture: Option<[T; N]>,
    /// How far a frame may be turned from its target \[rad\].
    pub turn: T,
    /// How far the origin of a frame may be from its target's \[m\].
    pub shift: T,
    /// How many metres weigh as much as a radian \[m\].
    pub radius: T,
    /// How many times the robot is looked at, at most, from one start and for a posture each.
    pub looks: usize,
    /// From how many places it is tried.
    pub starts: usize,
}

/// How it ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// Every frame is as near to its target as was asked.
    Converged,
    /// Wherever it started from, it came to where no small motion within the limits brings the frames nearer.
    OutOfReach,
    /// The robot was evaluated as often as was allowed, and the frames still came nearer; or its poses or Jacobians
    /// are not finite where it started.
    Stalled,
}

/// Where the joints should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<T, const N: usize> {
    /// The coordinates, within the limits [rad, m]: the best that were found.
    pub q: [T; N],
    /// Whether they will do.
    pub outcome: Outcome,
    /// The largest angle between a frame and its target \[rad\].
    pub turn: T,
    /// The largest distance between the origin of a frame and its target's \[m\].
    pub shift: T,
    /// How many times the robot was looked at.
    pub looks: usize,
}

/// A frame of the robot: its pose, and its geometric Jacobian (axes of frame 0, pole at its origin).
pub type Seen<T, const N: usize> = (Pose<T>, [Screw<T>; N]);

/// The normal equations at a place: JᵗJ, Jᵗe, and the error e they are of.
#[derive(Clone, Copy)]
struct Look<T, const N: usize> {
    q: [T; N],
    square: [[T; N]; N],
    pull: [T; N],
    /// ‖e‖².
    cost: T,
    turn: T,
    shift: T,
}

impl<T: Real, const N: usize> Look<T, N> {
    /// That of JᵗJ.
    fn trace(&self) -> T {
        let entries = self.square.iter().enumerate();
        entries.fold(T::constant(0.0), |sum, (i, row)| sum + row[i])
    }
}

/// How a descent ended.
enum Descent {
    Met,
    Stationary,
    Unfinished,
}

impl<T: Real, const N: usize> Reach<T, N> {
    /// Within limits [rad, m], to 10⁻⁶ rad and 10⁻⁶ m, or 64 roundings where that is more; with 64 looks from each
    /// of 32 places.
    #[must_use]
    pub fn within(limits: [[T; 2]; N]) -> Self {
        let tolerance = T::constant(1e-6).max(T::constant(64.0) * T::EPSILON);
        Self {
            limits,
            posture: None,
            turn: tolerance,
            shift: tolerance,
            radius: T::constant(0.5),
            looks: 64,
            starts: 32,
        }
    }

    /// Brings the tip to a target, given in frame 0. A start outside the limits is moved to the nearest of them.
    ///
    /// A rotation that misses orthogonality by its digits alone, up to 10⁻⁶ (10⁻³ in `f32`), is taken as that of its
    /// unit quaternion; one that misses it by more is refused: [`normalize`](crate::normalize) makes it a rotation.
    ///
    /// # Errors
    ///
    /// [`Error::NoRange`] for limits that no number is within: crossed, NaN, or infinite to the wrong side;
    /// [`Error::NotRotation`] for a target whose 3×3 part is no rotation; [`Error::NotFinite`] for NaN and infinity in a
    /// target, the start, the posture or the radius, and for a tolerance that is NaN.
    pub fn solve<R>(
        &self,
        robot: &R,
        target: &Pose<T>,
        start: &[T; N],
    ) -> Result<Solution<T, N>, Error>
    where
        R: ForwardKinematics<N, T> + GeometricJacobian<N, T>,
    {
        let see = |q: &[T; N]| [(robot.forward_kinematics(q), robot.geometric_jacobian(q))];
        self.solve_frames(see, &[*target], start)
    }

    /// Brings several frames to their targets, given in frame 0, at once.
    ///
    /// # Errors
    ///
    /// As [`solve`](Self::solve).
    pub fn solve_frames<const K: usize>(
        &self,
        see: impl Fn(&[T; N]) -> [Seen<T, N>; K],
        targets: &[Pose<T>; K],
        start: &[T; N],
    ) -> Result<Solution<T, N>, Error> {
        checked::check(self, start)?;
        let targets = checked::targets(targets)?;
        Ok(self.search(|q| self.look(q, &see(&q), &targets), start))
    }

    /// Goes down from the start, and from elsewhere until the targets are met.
    fn search(&self, look: impl Fn([T; N]) -> Look<T, N>, start: &[T; N]) -> Solution<T, N> {
        let mut random = Random(0);
        let mut looks = 0;
        let mut ended = true;
        let mut best: Option<Look<T, N>> = None;
        for attempt in 0..self.starts.max(1) {
            let from = if attempt == 0 {
                *start
            } else {
                self.anywhere(start, &mut random)
            };
            let mut at = look(self.inside(from));
            looks += 1;
            if !at.cost.is_finite() {
                ended = false;
                continue;
            }
            match self.descend(&look, &mut at, &mut looks) {
                Descent::Met => {
                    let at = self.towards_posture(&look, at, &mut looks);
                    return Self::solution(&at, Outcome::Converged, looks);
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
            || self.nowhere(looks),
            |best| Self::solution(&best, outcome, looks),
        )
    }

    /// What is left at a place, and how it changes with the joints.
    fn look<const K: usize>(
        &self,
        q: [T; N],
        seen: &[Seen<T, N>; K],
        targets: &[Pose<T>; K],
    ) -> Look<T, N> {
        let zero = T::constant(0.0);
        let mut found = Look {
            q,
            square: [[zero; N]; N],
            pull: [zero; N],
            cost: zero,
            turn: zero,
            shift: zero,
        };
        let weight = self.radius * self.radius;
        for ((pose, jacobian), target) in seen.iter().zip(targets) {
            let back = matrix_product(target.rotation(), &transpose(pose.rotation()));
            let (axis, angle) = rotation::axis_angle(&back);
            let turn = scale(angle, axis);
            let shift = sub(target.translation(), pose.translation());
            for (i, column) in jacobian.iter().enumerate() {
                let weighted = scale(weight, column.u());
                found.pull[i] = found.pull[i] + dot(weighted, turn) + dot(column.b(), shift);
                for (j, other) in jacobian[..=i].iter().enumerate() {
                    let product = dot(weighted, other.u()) + dot(column.b(), other.b());
                    found.square[i][j] = found.square[i][j] + product;
                }
            }
            found.cost = found.cost + weight * dot(turn, turn) + dot(shift, shift);
            found.turn = found.turn.max(angle.abs());
            found.shift = found.shift.max(norm(shift));
        }
        found
    }

    /// Goes down to where no step helps, if the looks last.
    fn descend(
        &self,
        look: &impl Fn([T; N]) -> Look<T, N>,
        at: &mut Look<T, N>,
        looks: &mut usize,
    ) -> Descent {
        let [less, more] = [0.25, 4.0].map(T::constant);
        let (least, most) = (T::constant(1e-4), T::constant(1e4));
        let mut damping = T::constant(0.1);
        let mut slow = 0;
        for _ in 1..self.looks {
            if self.is_met(at) {
                return Descent::Met;
            }
            if self.is_stationary(at) {
                return Descent::Stationary;
            }
            let step = self.step(at, damping * at.cost, &at.pull);
            let next = look(self.inside(from_fn(|i| at.q[i] + step[i])));
            *looks += 1;
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

    fn is_met(&self, at: &Look<T, N>) -> bool {
        at.turn <= self.turn && at.shift <= self.shift
    }

    /// Whether what is left is perpendicular to what the joints that may move can do.
    fn is_stationary(&self, at: &Look<T, N>) -> bool {
        let small = T::constant(1e-8) * at.cost;
        (0..N).all(|i| {
            let pull = at.pull[i];
            self.stops(i, at.q[i], pull) || pull * pull <= small * at.square[i][i]
        })
    }

    /// (JᵗJ + damping) step = right side, of the joints that their limits do not stop.
    fn step(&self, at: &Look<T, N>, damping: T, right: &[T; N]) -> [T; N] {
        let zero = T::constant(0.0);
        // Enough that JᵗJ, rounded, has a square root.
        let damping = damping + T::constant(16.0) * T::EPSILON * at.trace() + T::MIN_POSITIVE;
        let mut free = [true; N];
        let mut step = [zero; N];
        // Each round stops a joint or is the last one.
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

    /// Follows the motions that leave the targets met to where the posture is nearest.
    fn towards_posture(
        &self,
        look: &impl Fn([T; N]) -> Look<T, N>,
        mut at: Look<T, N>,
        looks: &mut usize,
    ) -> Look<T, N> {
        let Some(posture) = self.posture else {
            return at;
        };
        let distance = |q: &[T; N]| norm(from_fn::<T, N, _>(|i| posture[i] - q[i]));
        let last = *looks + self.looks;
        let mut share = T::constant(1.0);
        while share > T::constant(0.1) && *looks < last {
            // (JᵗJ + λ)⁻¹ λ z is z less what J sees of it.
            let damping = T::EPSILON.sqrt() * at.trace();
            let wanted = from_fn(|i| damping * share * (posture[i] - at.q[i]));
            let step = self.step(&at, damping, &wanted);
            let mut next = look(self.inside(from_fn(|i| at.q[i] + step[i])));
            *looks += 1;
            let met = matches!(self.descend(look, &mut next, looks), Descent::Met);
            if met && distance(&next.q) < T::constant(0.999) * distance(&at.q) {
                at = next;
            } else {
                share = share * T::constant(0.5);
            }
        }
        at
    }

    /// Whether a limit stops a joint that would go that way.
    fn stops(&self, joint: usize, q: T, way: T) -> bool {
        let ([least, most], zero) = (self.limits[joint], T::constant(0.0));
        way < zero && q <= least || way > zero && q >= most
    }

    fn inside(&self, q: [T; N]) -> [T; N] {
        from_fn(|i| {
            let [least, most] = self.limits[i];
            let q = if q[i] < least { least } else { q[i] };
            if q > most { most } else { q }
        })
    }

    /// A place within the limits, or within half a turn or half a metre of the start where there are none.
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

    fn solution(at: &Look<T, N>, outcome: Outcome, looks: usize) -> Solution<T, N> {
        Solution {
            q: at.q,
            outcome,
            turn: at.turn,
            shift: at.shift,
            looks,
        }
    }

    /// What is said where no pose of the robot is finite.
    fn nowhere(&self, looks: usize) -> Solution<T, N> {
        let infinite = T::constant(f64::INFINITY);
        Solution {
            q: self.inside([T::constant(0.0); N]),
            outcome: Outcome::Stalled,
            turn: infinite,
            shift: infinite,
            looks,
        }
    }
}

/// A step is slow that leaves so much of the cost.
const SLOW: f64 = 0.95;

/// So many slow steps in a row are as good as none.
const PATIENCE: usize = 8;

/// (A + damping) x = b of the rows and columns that are free, by Cholesky's factors; of A the lower half is read.
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
                // What rounding has left of nothing is taken for the damping.
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

/// A sequence of numbers (splitmix64 of Steele, Lea and Flood, 2014).
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
