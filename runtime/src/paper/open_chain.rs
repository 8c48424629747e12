//! Open chains: the relative motions of bodies, composed in any frame, and Newton–Euler.
//!
//! In: a [`Chain`] and its state, or the motions of single joints. Out: M, W and H of every body,
//! H̃ by recursion and as a closed sum, and the wrench through every joint with external wrenches on
//! the bodies (Part II, open chains and Newton–Euler). Every joint moves along a screw by a coordinate
//! of its own, as in the paper. Terms that are zero are computed too, unlike in generated code.

use crate::matrix::vector::{add, cross};
use crate::matrix::{Acceleration, Action, Inertia, Pose, Screw, Velocity};
use crate::robot::chain::Chain;
use crate::robot::joint::Joint;
use crate::scalar::Scalar;
use core::array::from_fn;

/// Position, velocity and acceleration of body j relative to body i.
///
/// The two kinematic matrices are in frame (i), so that W = Ṁ M⁻¹ and H = M̈ M⁻¹;
/// [`BodyMotion::in_frame`] gives them in any other frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion<T> {
    /// Mᵢⱼ.
    pub pose: Pose<T>,
    /// Wᵢⱼ₍ᵢ₎ [rad/s, m/s].
    pub velocity: Velocity<T>,
    /// Hᵢⱼ₍ᵢ₎ [rad/s², m/s²].
    pub acceleration: Acceleration<T>,
}

impl<T: Scalar> BodyMotion<T> {
    /// The motion of a body relative to itself.
    #[must_use]
    pub fn identity() -> Self {
        Self {
            pose: Pose::identity(),
            velocity: Velocity::zero(),
            acceleration: Acceleration::zero(),
        }
    }

    /// The motion of one joint: Mₕ₋₁,ₕ, Wₕ₋₁,ₕ = L q̇ and Hₕ₋₁,ₕ = L q̈ + L² q̇² (Part II, kinematic pairs).
    ///
    /// `q`, `qd`, `qdd` are in rad or m, and seconds.
    #[must_use]
    pub fn of_joint(joint: &Joint, q: T, qd: T, qdd: T) -> Self {
        let l = rounded_screw(&joint.screw);
        // exp(L q) moves along its own axis and does not change L.
        let pose = rounded_pose(&joint.placement) * l.exp(q).to_relative_pose();
        let l_in_parent = pose.change_frame(&l);
        Self {
            pose,
            velocity: l_in_parent.velocity(qd),
            acceleration: l_in_parent.acceleration(qd, qdd),
        }
    }

    /// The motion of k relative to i, `self` being that of j relative to i and `m_j_k` that of k
    /// relative to j: Mᵢₖ = Mᵢⱼ Mⱼₖ, Wᵢₖ = Wᵢⱼ + Wⱼₖ (12), Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ (13).
    #[must_use]
    pub fn then(&self, m_j_k: &Self) -> Self {
        let (w, h) = m_j_k.in_frame(&self.pose);
        Self {
            pose: self.pose * m_j_k.pose,
            velocity: self.velocity + w,
            acceleration: self.acceleration.compose(&h, &self.velocity, &w),
        }
    }

    /// The motion of i relative to j: M⁻¹, and from (12), (13) with k = i: −W and 2 W² − H, in
    /// frame (j).
    #[must_use]
    pub fn inverse(&self) -> Self {
        let w_dot = self.acceleration.velocity_derivative(&self.velocity);
        let pose = self.pose.inverse();
        Self {
            pose,
            velocity: pose.change_frame(&-self.velocity),
            // 2 W² − H = −Ẇ + W².
            acceleration: pose.change_frame(&Acceleration::from_velocity_derivative(
                &-self.velocity,
                &-w_dot,
            )),
        }
    }

    /// Wᵢⱼ₍ₖ₎ and Hᵢⱼ₍ₖ₎ for any frame (k), given M_k,i (8), (9).
    #[must_use]
    pub fn in_frame(&self, m_k_i: &Pose<T>) -> (Velocity<T>, Acceleration<T>) {
        (
            m_k_i.change_frame(&self.velocity),
            m_k_i.change_frame(&self.acceleration),
        )
    }
}

/// The motion of every body relative to the base, in frame 0 (Part II, open chains).
#[must_use]
pub fn motions<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    qdd: &[T; N],
) -> [BodyMotion<T>; N] {
    let mut motions = [BodyMotion::identity(); N];
    for (i, joint) in chain.joints.iter().enumerate() {
        let m_0_parent = chain
            .parent(i)
            .map_or_else(BodyMotion::identity, |p| motions[p]);
        motions[i] = m_0_parent.then(&BodyMotion::of_joint(joint, q[i], qd[i], qdd[i]));
    }
    motions
}

/// M₀,₁ … M₀,N: the pose of every body.
#[must_use]
pub fn poses<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> [Pose<T>; N] {
    let mut poses = [Pose::identity(); N];
    for (i, joint) in chain.joints.iter().enumerate() {
        let m_0_parent = chain.parent(i).map_or_else(Pose::identity, |p| poses[p]);
        let q_i = rounded_screw(&joint.screw).exp(q[i]);
        poses[i] = m_0_parent * rounded_pose(&joint.placement) * q_i.to_relative_pose();
    }
    poses
}

/// L₁₍₀₎ … L_N₍₀₎ of all joints, from the poses of the bodies: Lᵢ₍₀₎ = M₀ᵢ Lᵢ₍ᵢ₎ M₀ᵢ⁻¹ (8).
#[must_use]
pub fn screws<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    poses: &[Pose<T>; N],
) -> [Screw<T>; N] {
    from_fn(|i| poses[i].change_frame(&rounded_screw(&chain.joints[i].screw)))
}

/// J₁₍₀₎ … J_N₍₀₎ of all bodies, from their poses: Jᵢ₍₀₎ = M₀ᵢ Jᵢ₍ᵢ₎ M₀ᵢᵗ (17).
///
/// The preprint's listing of the inverse dynamics of the Stanford arm takes M₀,ᵢ₋₁ here; with the
/// inertia given in the frame of its own body it must be M₀,ᵢ.
#[must_use]
pub fn inertias<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    poses: &[Pose<T>; N],
) -> [Inertia<T>; N] {
    from_fn(|i| poses[i].change_frame(&rounded_inertia(&chain.joints[i].inertia)))
}

/// H̃₀,₁ … H̃₀,N in frame 0: the accelerations at q̈ = 0, due to Coriolis and centrifugal terms (Part II, open
/// chains), by the recursion (13).
#[must_use]
pub fn bias_accelerations<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
) -> [Acceleration<T>; N] {
    motions(chain, q, qd, &[T::constant(0.0); N]).map(|motion| motion.acceleration)
}

/// H̃₀ₕ = Σ (W₀,ᵢ₋₁ Wᵢ − Wᵢ W₀,ᵢ₋₁) + W₀ₕ², the sum over the joints i between the base and body h, in
/// frame 0 (Part II, open chains).
///
/// `velocities` holds W₀ᵢ of all bodies, in frame 0.
#[must_use]
pub fn bias_acceleration_as_sum<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    velocities: &[Velocity<T>; N],
    body: usize,
) -> Acceleration<T> {
    let velocity_of = |body: Option<usize>| body.map_or_else(Velocity::zero, |i| velocities[i]);
    let mut sum = Velocity::zero();
    let mut at = Some(body).filter(|i| *i < N);
    while let Some(i) = at {
        let parent = chain.parent(i);
        let w_0_parent = velocity_of(parent);
        sum = sum + commutator(&w_0_parent, &(velocities[i] - w_0_parent));
        at = parent;
    }
    Acceleration::from_velocity_derivative(&velocity_of(Some(body).filter(|i| *i < N)), &sum)
}

/// A B − B A: the rate of the velocity matrix B of a body that moves with A, both in one frame. Its blocks are
/// ω_A × ω_B and ω_A × v_B − ω_B × v_A.
#[must_use]
pub fn commutator<T: Scalar>(a: &Velocity<T>, b: &Velocity<T>) -> Velocity<T> {
    Velocity::new(
        cross(a.omega(), b.omega()),
        add(cross(a.omega(), b.v()), cross(a.v(), b.omega())),
    )
}

/// The wrench through every joint in frame 0, exerted on the body that it carries
/// (Part II, Newton–Euler).
///
/// The wrench through joint i is Σ (skew\[(Hₕ − H_g) Jₕ\] − Φₕ) over the bodies h that it carries. Φₕ is the
/// `external` wrench on body h in frame 0 besides its weight [N m, N]. The component along L is the torque or
/// force of the joint's motor; the bearings support the others.
#[must_use]
pub fn joint_actions<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    qdd: &[T; N],
    external: &[Action<T>; N],
) -> [Action<T>; N] {
    let motions = motions(chain, q, qd, qdd);
    let inertias = inertias(chain, &motions.map(|motion| motion.pose));
    let gravity = chain.gravity.map(T::constant);
    let own: [Action<T>; N] = from_fn(|i| {
        let h = motions[i].acceleration.less_gravity(gravity);
        inertias[i].action(&h) - external[i]
    });
    sums_over_carried(chain, own, |sum, action| sum + action)
}

/// Sums of a quantity of each body over the bodies that each joint carries; children come after their
/// parents.
pub(super) fn sums_over_carried<X: Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    own: [X; N],
    add: impl Fn(X, X) -> X,
) -> [X; N] {
    let mut sums = own;
    for i in (0..N).rev() {
        if let Some(parent) = chain.parent(i) {
            sums[parent] = add(sums[parent], sums[i]);
        }
    }
    sums
}

/// The torques [N m] and forces \[N\] of the joints, L ⊗ Φ of [`joint_actions`]
/// (Part II, Newton–Euler).
#[must_use]
pub fn inverse_dynamics<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    qdd: &[T; N],
    external: &[Action<T>; N],
) -> [T; N] {
    let screws = screws(chain, &poses(chain, q));
    let actions = joint_actions(chain, q, qd, qdd, external);
    from_fn(|i| screws[i].pseudo_scalar_product(&actions[i]))
}

/// A constant pose, rounded to T.
pub(crate) fn rounded_pose<T: Scalar>(pose: &Pose<f64>) -> Pose<T> {
    Pose::new(
        pose.rotation().map(|row| row.map(T::constant)),
        pose.translation().map(T::constant),
    )
}

/// A constant screw, rounded to T.
pub(crate) fn rounded_screw<T: Scalar>(l: &Screw<f64>) -> Screw<T> {
    Screw::new(l.u().map(T::constant), l.b().map(T::constant))
}

/// A constant inertia, rounded to T.
pub(crate) fn rounded_inertia<T: Scalar>(j: &Inertia<f64>) -> Inertia<T> {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = j.second_moments();
    Inertia::new(
        [xx, yy, zz, xy, xz, yz].map(T::constant),
        j.q().map(T::constant),
        T::constant(j.mass()),
    )
}
