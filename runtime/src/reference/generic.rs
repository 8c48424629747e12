//! Every function of a robot, at run time, as the paper writes it (feature `nalgebra`).
//!
//! In: a [`Chain`] and a state. Out: what generated code returns, by dense 4×4 products in frame 0
//! (Part II). It is the reference: short enough to be compared with the paper line by line, free of
//! any simplification, and therefore slow. It shares nothing with the code generator.
//!
//! A chain that [`check`](Chain::check) refuses gives numbers that mean nothing, and no panic.
//!
//! ```
//! use homogen::{Chain, Inertia, Joint, Pose, Screw, generic};
//!
//! // A pendulum: 2 kg at 0.5 m below a hinge about y, in the frame of the hinge.
//! let hinge = Screw::new([0.0, 1.0, 0.0], [0.0; 3]);
//! let bob = Inertia::of_particle(2.0, [0.0, 0.0, -0.5]);
//! let chain: Chain<1, 0> = Chain::new(
//!     [Joint::new("hinge", None, Pose::identity(), hinge, bob)],
//!     [],
//!     [0.0, 0.0, -9.81],
//! );
//! let horizontal = core::f64::consts::FRAC_PI_2;
//! let [torque] = generic::gravity(&chain, &[horizontal]);
//! assert!((torque - 9.81).abs() < 1e-14);
//! ```

use super::dense::{axial, block, column, gravity_matrix, inverse, pseudo_scalar_product};
use super::motion::{Freedom, Motion, Positions};
use crate::matrix::{Acceleration, Action, Momentum, Point, Pose, Screw, Velocity};
use crate::robot::chain::{Chain, Frame};
use crate::robot::derivatives::ForwardDynamicsDerivatives;
use core::array::from_fn;
use nalgebra::{Cholesky, Const, Matrix4, RealField, SMatrix, SVector};

pub use super::closure::{
    actuated_inverse_dynamics, constrained_forward_dynamics, constraint, constraint_bias,
    constraint_jacobian,
};
pub use super::derivatives::{coriolis_matrix, gravity_derivative, inverse_dynamics_derivatives};

/// M₀,frame.
///
/// SPACELIB: what its programs for serial robots compute as direct kinematics.
#[must_use]
pub fn forward_kinematics<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
) -> Pose<T> {
    let m = Positions::at(chain, q).pose_of(frame);
    Pose::new(block(&m), column(&m))
}

/// L₁ … L_N in frame 0, pole at its origin; zero for velocities that do not move the frame, and a sum
/// for those that several joints have.
#[must_use]
pub fn spatial_jacobian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
) -> [Screw<T>; N] {
    jacobian(chain, frame, q, |_| Matrix4::identity())
}

/// L₁ … L_N in `frame`, pole at its origin.
#[must_use]
pub fn body_jacobian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
) -> [Screw<T>; N] {
    jacobian(chain, frame, q, |m_0_frame| inverse(m_0_frame))
}

/// L₁ … L_N with the axes of frame 0, pole at the origin of `frame`.
#[must_use]
pub fn geometric_jacobian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
) -> [Screw<T>; N] {
    jacobian(chain, frame, q, |m_0_frame| {
        // The frame with the axes of (0) and its origin in that of `frame`, seen from there.
        Matrix4::new_translation(&-m_0_frame.fixed_view::<3, 1>(0, 3))
    })
}

/// L̇₁ … L̇_N in frame 0 [1/s, m/s]; zero for joints that do not move the frame.
#[must_use]
pub fn spatial_jacobian_rate<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
) -> [Screw<T>; N] {
    jacobian_rate(chain, frame, q, qd, |_, _| {
        (Matrix4::identity(), Matrix4::zeros())
    })
}

/// L̇₁ … L̇_N in `frame`, entry by entry in its moving axes [1/s, m/s].
#[must_use]
pub fn body_jacobian_rate<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
) -> [Screw<T>; N] {
    jacobian_rate(chain, frame, q, qd, |m_0_frame, w| (inverse(m_0_frame), *w))
}

/// L̇₁ … L̇_N with the axes of frame 0, pole at the moving origin of `frame` [1/s, m/s].
#[must_use]
pub fn geometric_jacobian_rate<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
) -> [Screw<T>; N] {
    jacobian_rate(chain, frame, q, qd, |m_0_frame, w| {
        let tip = m_0_frame.column(3);
        // Ṗ = W P of the pole, whose axes do not turn.
        let mut w_pole = Matrix4::zeros();
        w_pole.set_column(3, &(w * tip));
        let back = Matrix4::new_translation(&-m_0_frame.fixed_view::<3, 1>(0, 3));
        (back, w_pole)
    })
}

/// W₀,frame₍₀₎ [rad/s, m/s].
#[must_use]
pub fn velocity<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
) -> Velocity<T> {
    let rest = [T::zero(); N];
    let w = Motion::at(chain, q, qd, &rest).velocity_of(frame.body);
    Velocity::new(axial(&w), column(&w))
}

/// H₀,frame₍₀₎ [rad/s², m/s²], without gravity.
#[must_use]
pub fn acceleration<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
) -> Acceleration<T> {
    let h = Motion::at(chain, q, qd, qdd).acceleration_of(frame.body);
    Acceleration::new(block(&h), column(&h))
}

/// H₀,frame₍₀₎ at q̈ = 0 [rad/s², m/s²], without gravity: H̃ of Part II.
#[must_use]
pub fn acceleration_bias<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
) -> Acceleration<T> {
    acceleration(chain, frame, q, qd, &[T::zero(); N])
}

/// The torques [N m] and forces \[N\] of the joints that produce q̈ (Part II, Newton–Euler).
///
/// What drives take comes on top: armature q̈ + damping q̇ + friction sign q̇.
///
/// The action through joint i is the sum of Φ = skew[(H − H_g) J] over the bodies it carries, its
/// torque the pseudo scalar product L ⊗ Φ.
#[must_use]
pub fn inverse_dynamics<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
) -> [T; N] {
    let motion = Motion::at(chain, q, qd, qdd);
    let (positions, h_g) = (&motion.positions, gravity_matrix::<T>(chain.gravity));
    // Φ of each body, then the sum carried by each joint: children come after their parents.
    let mut phi: [Matrix4<T>; B] = from_fn(|i| {
        let (h, j) = (motion.h[i] - h_g, positions.j[i]);
        h * j - j * h.transpose()
    });
    for i in (0..B).rev() {
        if let Some(parent) = chain.parent(i) {
            let carried = phi[i];
            phi[parent] += carried;
        }
    }
    let mut torques = [T::zero(); N];
    for freedom in positions.freedoms() {
        if let Some(torque) = torques.get_mut(freedom.velocity) {
            *torque += pseudo_scalar_product(&freedom.l, &phi[freedom.body]);
            *torque += freedom.driven(qd, qdd);
        }
    }
    torques
}

/// Jᵗ Φ: what an action on a frame, in its axes and with the couple about its origin, is for the joints
/// [N m, N].
///
/// A motion under the actions Φ of the surroundings takes the torques of [`inverse_dynamics`] less the sum
/// of these.
#[must_use]
pub fn torques_of_action<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    action: &Action<T>,
) -> [T; N] {
    let dot = |a: [T; 3], b: [T; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let screws = body_jacobian(chain, frame, q);
    screws.map(|screw| dot(screw.u(), action.c()) + dot(screw.b(), action.f()))
}

/// Inverse dynamics at rest: what holds the robot against gravity [N m, N].
///
/// As virtual work: −Σ Tr(H_g Jₕ Lₘᵗ) over the bodies h that joint m carries (Part II, Lagrange).
#[must_use]
pub fn gravity<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [T; N] {
    let rest = [T::zero(); N];
    bias(chain, q, &rest)
}

/// Inverse dynamics at q̈ = 0: C\[m\] = Tr(Σ (H̃ₕ − H_g) Jₕ Lₘᵗ) over the bodies h that joint m
/// carries (Part II, Lagrange), and friction.
#[must_use]
pub fn bias<T: RealField + Copy, const N: usize, const F: usize, const Q: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> [T; N] {
    let rest = [T::zero(); N];
    let motion = Motion::at(chain, q, qd, &rest);
    let (positions, h_g) = (&motion.positions, gravity_matrix::<T>(chain.gravity));
    let mut torques = [T::zero(); N];
    for freedom in positions.freedoms() {
        let Freedom {
            body, velocity, l, ..
        } = freedom;
        let carried = (0..B).filter(|h| chain.carries(body, Some(*h)));
        let work = carried.map(|h| (motion.h[h] - h_g) * positions.j[h] * l.transpose());
        if let Some(torque) = torques.get_mut(velocity) {
            *torque += sum(work.map(|work| work.trace())) + freedom.driven(qd, &rest);
        }
    }
    torques
}

/// The joint-space inertia M\[i\]\[m\] = Tr(Σ Lᵢ Jₕ Lₘᵗ), over the bodies h that both joints carry
/// (Part II, Lagrange), and on its diagonal the armatures.
#[must_use]
pub fn mass_matrix<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [[T; N]; N] {
    let positions = Positions::at(chain, q);
    let carries = |joint: usize, body: usize| chain.carries(joint, Some(body));
    let mut rows = [[T::zero(); N]; N];
    for one in positions.freedoms() {
        for other in positions.freedoms() {
            let both = (0..B).filter(|h| carries(one.body, *h) && carries(other.body, *h));
            let work = both.map(|h| (one.l * positions.j[h] * other.l.transpose()).trace());
            let row = rows.get_mut(one.velocity);
            if let Some(entry) = row.and_then(|row| row.get_mut(other.velocity)) {
                *entry += sum(work);
            }
        }
        let row = rows.get_mut(one.velocity);
        if let Some(entry) = row.and_then(|row| row.get_mut(one.velocity)) {
            *entry += one.armature();
        }
    }
    rows
}

/// The joint accelerations [rad/s², m/s²] that the torques \[N m\] and forces \[N\] `tau` produce:
/// M q̈ = τ − bias, solved by Cholesky.
///
/// NaN where M is not positive definite.
#[must_use]
pub fn forward_dynamics<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
) -> [T; N] {
    let bias = bias(chain, q, qd);
    let lacking: SVector<T, N> = SVector::from_fn(|i, _| tau[i] - bias[i]);
    let found = mass_matrix_factors(chain, q).map(|factors| factors.solve(&lacking));
    from_fn(|i| found.map_or(nan(), |found| found[i]))
}

/// The inverse of the joint-space inertia matrix, by Cholesky.
///
/// NaN where M is not positive definite.
#[must_use]
pub fn mass_matrix_inverse<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [[T; N]; N] {
    let found = mass_matrix_factors(chain, q).map(|factors| factors.inverse());
    from_fn(|i| from_fn(|m| found.map_or(nan(), |found| found[(i, m)])))
}

/// ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂τ of the accelerations that the torques \[N m\] and forces \[N\] `tau` produce: of
/// M q̈ + … = τ with q̈ as it is, ∂q̈ = M⁻¹ (∂τ − what inverse dynamics changes by), by Cholesky.
///
/// NaN where M is not positive definite.
#[must_use]
pub fn forward_dynamics_derivatives<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
) -> ForwardDynamicsDerivatives<N, T> {
    let qdd = forward_dynamics(chain, q, qd, tau);
    let needed = inverse_dynamics_derivatives(chain, q, qd, &qdd);
    let factors = mass_matrix_factors(chain, q);
    let answer = |needed: [[T; N]; N]| {
        let needed: SMatrix<T, N, N> = SMatrix::from_fn(|i, m| -needed[i][m]);
        let found = factors.as_ref().map(|factors| factors.solve(&needed));
        from_fn(|i| from_fn(|m| found.map_or(nan(), |found| found[(i, m)])))
    };
    ForwardDynamicsDerivatives {
        dq: answer(needed.dq),
        dqd: answer(needed.dqd),
        dtau: mass_matrix_inverse(chain, q),
    }
}

/// The kinetic energy Σ ½ Tr(W J Wᵗ) \[J\] (22), and ½ q̇² of each armature.
#[must_use]
pub fn kinetic_energy<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> T {
    let rest = [T::zero(); N];
    let motion = Motion::at(chain, q, qd, &rest);
    let half: T = nalgebra::convert(0.5);
    let bodies = sum((0..B).map(|i| {
        let w = motion.w[i];
        half * (w * motion.positions.j[i] * w.transpose()).trace()
    }));
    let drives = motion.positions.freedoms().map(|freedom| {
        let rate = qd.get(freedom.velocity).copied().unwrap_or(T::zero());
        half * freedom.armature() * rate * rate
    });
    bodies + sum(drives)
}

/// The potential energy Σ −Tr(H_g J) \[J\], zero at the origin of frame 0 (§ 4.5).
#[must_use]
pub fn potential_energy<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> T {
    let h_g = gravity_matrix::<T>(chain.gravity);
    let positions = Positions::at(chain, q);
    sum(positions.j.iter().map(|j| -(h_g * j).trace()))
}

/// Y of τ = Y π [m²/s², m/s², 1/s² and a unit of length less for forces]: π lists for each body m, q_x, q_y, q_z, J_xx,
/// J_xy, J_xz, J_yy, J_yz, J_zz in its frame; and behind them, where there is room for it, for each velocity of each joint
/// armature, damping and friction, whose columns are q̈, q̇ and its sign.
///
/// A column is the torques of Φ = skew[(H − H_g) J] of a J that is 1 in one place and its mirror image (25).
///
/// # Panics
/// Where P is neither 10 B nor that and three for each velocity of a joint.
#[must_use]
pub fn regressor<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const P: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
) -> [[T; P]; N] {
    const PLACES: [(usize, usize); 10] = [
        (3, 3),
        (0, 3),
        (1, 3),
        (2, 3),
        (0, 0),
        (0, 1),
        (0, 2),
        (1, 1),
        (1, 2),
        (2, 2),
    ];
    let motion = Motion::at(chain, q, qd, qdd);
    let (positions, h_g) = (&motion.positions, gravity_matrix::<T>(chain.gravity));
    let of_bodies = PLACES.len() * B;
    let drives = 3 * positions.freedoms().count();
    assert!(
        P == of_bodies || P == of_bodies + drives,
        "a body has ten parameters, and a velocity of a joint three"
    );
    let mut rows = [[T::zero(); P]; N];
    if P > of_bodies {
        for (k, freedom) in positions.freedoms().enumerate() {
            let of_drives = freedom.of_drives(qd, qdd);
            rows[freedom.velocity][of_bodies + 3 * k..][..3].copy_from_slice(&of_drives);
        }
    }
    for (parameter, k) in (0..of_bodies).map(|parameter| (parameter, parameter % PLACES.len())) {
        let body = parameter / PLACES.len();
        let mut unit = Matrix4::zeros();
        let (row, place) = PLACES[k];
        unit[(row, place)] = T::one();
        unit[(place, row)] = T::one();
        let m = positions.m[body];
        let hj = (motion.h[body] - h_g) * m * unit * m.transpose();
        let phi = hj - hj.transpose();
        for freedom in positions.freedoms() {
            if let Some(row) = rows.get_mut(freedom.velocity)
                && chain.carries(freedom.body, Some(body))
            {
                row[parameter] += pseudo_scalar_product(&freedom.l, &phi);
            }
        }
    }
    rows
}

/// The centre of mass of what joints move \[m\], in frame 0: the last column of Σ J is ∫P dm (16).
///
/// NaN without mass.
#[must_use]
pub fn center_of_mass<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> Point<T> {
    let j = total(&Positions::at(chain, q));
    Point(column(&j).map(|moment| moment / j[(3, 3)]))
}

/// Its velocity [m/s], in the axes of frame 0: the last column of Σ W J is ∫Ṗ dm.
#[must_use]
pub fn center_of_mass_velocity<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> [T; 3] {
    let motion = Motion::at(chain, q, qd, &[T::zero(); N]);
    let mass = total(&motion.positions)[(3, 3)];
    column(&moments(&motion)).map(|momentum| momentum / mass)
}

/// Its velocity at a unit rate of each joint, in the axes of frame 0.
#[must_use]
pub fn center_of_mass_jacobian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [[T; 3]; N] {
    from_fn(|i| center_of_mass_velocity(chain, q, &unit(i)))
}

/// Γ₍₀₎ = skew[Σ W J] of what joints move [kg m²/s, kg m/s], pole at the origin of frame 0 (20).
#[must_use]
pub fn momentum<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> Momentum<T> {
    let moments = moments(&Motion::at(chain, q, qd, &[T::zero(); N]));
    let gamma = moments - moments.transpose();
    Momentum::new(axial(&gamma), column(&gamma))
}

/// Γ of what joints move about their centre of mass [kg m²/s, kg m/s], in the axes of frame 0.
#[must_use]
pub fn centroidal_momentum<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> Momentum<T> {
    let motion = Motion::of(
        chain,
        Positions::at_first_body(chain, q),
        qd,
        &[T::zero(); N],
    );
    let gamma = about_center(&motion.positions, &moments(&motion));
    Momentum::new(axial(&gamma), column(&gamma))
}

/// Γ about the centre of mass at a unit rate of each joint [kg m², kg m, kg], in the axes of frame 0.
#[must_use]
pub fn centroidal_momentum_matrix<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [Momentum<T>; N] {
    from_fn(|i| centroidal_momentum(chain, q, &unit(i)))
}

/// Φ = skew[Σ H J] at q̈ = 0 without gravity, about the centre of mass [N m, N], in the axes of frame 0: the rate of
/// the centroidal momentum matrix times q̇.
#[must_use]
pub fn centroidal_momentum_bias<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> Action<T> {
    let motion = Motion::of(
        chain,
        Positions::at_first_body(chain, q),
        qd,
        &[T::zero(); N],
    );
    let each = motion.h.iter().zip(&motion.positions.j);
    let forces = each.fold(Matrix4::zeros(), |sum, (h, j)| sum + h * j);
    let phi = about_center(&motion.positions, &forces);
    Action::new(axial(&phi), column(&phi))
}

/// Σ J.
fn total<T: RealField + Copy, const B: usize>(positions: &Positions<T, B>) -> Matrix4<T> {
    positions.j.iter().fold(Matrix4::zeros(), |sum, j| sum + j)
}

/// Σ W J.
fn moments<T: RealField + Copy, const B: usize>(motion: &Motion<T, B>) -> Matrix4<T> {
    let each = motion.w.iter().zip(&motion.positions.j);
    each.fold(Matrix4::zeros(), |sum, (w, j)| sum + w * j)
}

/// skew[X] of X = Σ W J or Σ H J with the centre of mass as pole (17).
fn about_center<T: RealField + Copy, const B: usize>(
    positions: &Positions<T, B>,
    x: &Matrix4<T>,
) -> Matrix4<T> {
    let j = total(positions);
    let back = Matrix4::new_translation(&(-j.fixed_view::<3, 1>(0, 3) / j[(3, 3)]));
    back * (x - x.transpose()) * back.transpose()
}

/// A unit rate of one joint.
fn unit<T: RealField + Copy, const N: usize>(joint: usize) -> [T; N] {
    from_fn(|i| if i == joint { T::one() } else { T::zero() })
}

/// The columns M L₍₀₎ M⁻¹, M being the change of frame that `m_from_0` makes of M₀,frame.
fn jacobian<T: RealField + Copy, const N: usize, const F: usize, const Q: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    m_from_0: impl Fn(&Matrix4<T>) -> Matrix4<T>,
) -> [Screw<T>; N] {
    let positions = Positions::at(chain, q);
    let m = m_from_0(&positions.pose_of(frame));
    let mut columns = [Matrix4::zeros(); N];
    for freedom in positions.freedoms() {
        let Freedom {
            body, velocity, l, ..
        } = freedom;
        if let Some(column) = columns.get_mut(velocity)
            && chain.carries(body, frame.body)
        {
            *column += m * l * inverse(&m);
        }
    }
    columns.map(|l| Screw::new(axial(&l), column(&l)))
}

/// The rates of the columns M L₍₀₎ M⁻¹: of L₍₀₎ the rate is W L − L W, and of the frame in which they are seen,
/// M and its own W in frame 0 are made by `seen_by` of M₀,frame and W₀,frame.
fn jacobian_rate<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    qd: &[T; N],
    seen_by: impl Fn(&Matrix4<T>, &Matrix4<T>) -> (Matrix4<T>, Matrix4<T>),
) -> [Screw<T>; N] {
    let motion = Motion::at(chain, q, qd, &[T::zero(); N]);
    let positions = &motion.positions;
    let (m, w_seen) = seen_by(&positions.pose_of(frame), &motion.velocity_of(frame.body));
    let mut columns = [Matrix4::zeros(); N];
    for freedom in positions.freedoms() {
        let Freedom {
            body, velocity, l, ..
        } = freedom;
        if let Some(column) = columns.get_mut(velocity)
            && chain.carries(body, frame.body)
        {
            let w = motion.w[body] - w_seen;
            *column += m * (w * l - l * w) * inverse(&m);
        }
    }
    columns.map(|rate| Screw::new(axial(&rate), column(&rate)))
}

/// M by Cholesky; `None` where it is not positive definite.
fn mass_matrix_factors<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> Option<Cholesky<T, Const<N>>> {
    let rows = mass_matrix(chain, q);
    SMatrix::<T, N, N>::from_fn(|i, m| rows[i][m]).cholesky()
}

fn nan<T: RealField>() -> T {
    nalgebra::convert(f64::NAN)
}

fn sum<T: RealField + Copy>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::zero(), |sum, term| sum + term)
}
