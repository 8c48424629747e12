//! Poses, Jacobians and their rates, velocities and accelerations, at run time.
//!
//! In: a [`Chain`], one of its frames, and a state. Out: matrices in frame 0 or in the given frame: M by products,
//! L of each joint in frame 0, W and H by composition (Part II, open chains).

use crate::matrix::{Acceleration, Pose, Screw, Velocity};
use crate::reference::dense::{axial, block, column, inverse};
use crate::reference::motion::{DegreeOfFreedom, Motion, Positions};
use crate::robot::chain::{Chain, Frame};
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// M₀,frame.
///
/// SPACELIB: the direct kinematics of its programs for serial robots.
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

/// L₁ … L_N in frame 0, reference point at its origin. Zero for velocities that do not move the frame; the sum over
/// the joints for a velocity that mimic joints share.
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

/// L₁ … L_N in `frame`, reference point at its origin.
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

/// L₁ … L_N with the axes of frame 0, reference point at the origin of `frame`.
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
        // To a frame with the axes of (0) and its origin at that of `frame`.
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

/// L̇₁ … L̇_N with the axes of frame 0, reference point at the moving origin of `frame` [1/s, m/s].
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
        // Ṗ = W P of the reference point; the axes do not rotate.
        let mut w_pole = Matrix4::zeros();
        w_pole.set_column(3, &(w * tip));
        let back = Matrix4::new_translation(&-m_0_frame.fixed_view::<3, 1>(0, 3));
        (back, w_pole)
    })
}

/// ∂L/∂q of the columns of [`geometric_jacobian`], a Jacobian for each coordinate \[1, m, 1/m\], or along each velocity of
/// a joint with a quaternion: its rate at a unit velocity of each joint alone.
#[must_use]
pub fn jacobian_derivative<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
) -> [[Screw<T>; N]; N] {
    from_fn(|k| {
        let unit = from_fn(|i| if i == k { T::one() } else { T::zero() });
        geometric_jacobian_rate(chain, frame, q, &unit)
    })
}

/// ∂(Jᵗ Φ)/∂q of [`geometric_jacobian`] for a constant wrench Φ at the origin of `frame` in the axes of frame 0, couple
/// \[N m\], then force \[N\]; a row for each torque or force of Jᵗ Φ [N m, N, N/m].
#[must_use]
pub fn forward_kinematics_hessian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    frame: &Frame,
    q: &[T; Q],
    wrench: &[T; 6],
) -> [[T; N]; N] {
    let derivatives = jacobian_derivative(chain, frame, q);
    let power = |screw: &Screw<T>| {
        let entries = screw.u().into_iter().chain(screw.b());
        let terms = entries.zip(wrench);
        terms.fold(T::zero(), |sum, (rate, force)| sum + rate * *force)
    };
    from_fn(|row| from_fn(|k| power(&derivatives[k][row])))
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
    for dof in positions.degrees_of_freedom() {
        let DegreeOfFreedom {
            body, velocity, l, ..
        } = dof;
        if let Some(column) = columns.get_mut(velocity)
            && chain.carries(body, frame.body)
        {
            *column += m * l * inverse(&m);
        }
    }
    columns.map(|l| Screw::new(axial(&l), column(&l)))
}

/// The rates of the columns M L₍₀₎ M⁻¹. The rate of L₍₀₎ is W L − L W; `seen_by` makes M, and the W in frame 0 of the
/// frame of the columns, from M₀,frame and W₀,frame.
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
    for dof in positions.degrees_of_freedom() {
        let DegreeOfFreedom {
            body, velocity, l, ..
        } = dof;
        if let Some(column) = columns.get_mut(velocity)
            && chain.carries(body, frame.body)
        {
            let w = motion.w[body] - w_seen;
            *column += m * (w * l - l * w) * inverse(&m);
        }
    }
    columns.map(|rate| Screw::new(axial(&rate), column(&rate)))
}
