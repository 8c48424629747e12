//! Inverse dynamics, gravity, bias, mass matrix and regressor, at run time.
//!
//! In: a [`Chain`] and its motion. Out: torques by Newton and Euler; gravity, bias and M by Lagrange's virtual work
//! (Part II).

use super::kinematics::body_jacobian;
use super::sum;
use crate::matrix::Action;
use crate::reference::dense::{gravity_matrix, pseudo_scalar_product};
use crate::reference::motion::{DegreeOfFreedom, Motion, Positions};
use crate::robot::chain::{Chain, Frame};
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// The torques [N m] and forces \[N\] of the joints that produce q̈ (Part II, Newton–Euler).
///
/// Armature and friction add armature q̈ + damping q̇ + friction sign q̇.
///
/// The wrench through joint i is the sum of Φ = skew[(H − H_g) J] over the bodies it carries; its
/// torque is the pseudo scalar product L ⊗ Φ.
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
    // Φ of each body, then the sum over the bodies that each joint carries; children come after their parents.
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
    for dof in positions.degrees_of_freedom() {
        if let Some(torque) = torques.get_mut(dof.velocity) {
            *torque += pseudo_scalar_product(&dof.l, &phi[dof.body]);
            *torque += dof.actuator_torque(qd, qdd);
        }
    }
    torques
}

/// Jᵗ Φ: the joint torques and forces of a wrench on a frame, in its axes and with the torque about its origin
/// [N m, N].
///
/// With external wrenches Φ, a motion needs the torques of [`inverse_dynamics`] minus the sum of these.
#[must_use]
pub fn torques_of_wrench<
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

/// Inverse dynamics at rest: the torques and forces that hold the robot against gravity [N m, N].
///
/// By virtual work: −Σ Tr(H_g Jₕ Lₘᵗ) over the bodies h that joint m carries (Part II, Lagrange).
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
    for dof in positions.degrees_of_freedom() {
        let DegreeOfFreedom {
            body, velocity, l, ..
        } = dof;
        let carried = (0..B).filter(|h| chain.carries(body, Some(*h)));
        let work = carried.map(|h| (motion.h[h] - h_g) * positions.j[h] * l.transpose());
        if let Some(torque) = torques.get_mut(velocity) {
            *torque += sum(work.map(|work| work.trace())) + dof.actuator_torque(qd, &rest);
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
    for one in positions.degrees_of_freedom() {
        for other in positions.degrees_of_freedom() {
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

/// Number of inertial parameters of a body.
pub(super) const PARAMETERS: usize = 10;

/// J of a body, in frame 0, that is 1 at one of its parameters and at its mirror image, in the order of [`regressor`].
pub(super) fn unit_inertia<T: RealField + Copy, const B: usize>(
    positions: &Positions<T, B>,
    parameter: usize,
) -> Matrix4<T> {
    const PLACES: [(usize, usize); PARAMETERS] = [
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
    let (row, column) = PLACES[parameter % PARAMETERS];
    let mut unit = Matrix4::zeros();
    unit[(row, column)] = T::one();
    unit[(column, row)] = T::one();
    let m = positions.m[parameter / PARAMETERS];
    m * unit * m.transpose()
}

/// Panics if `P` is not the number of parameters of B bodies, or of these and as many actuators.
pub(super) fn assert_count<const P: usize, const B: usize>(actuators: usize) {
    let of_bodies = PARAMETERS * B;
    assert!(
        P == of_bodies || P == of_bodies + 3 * actuators,
        "a body has ten parameters, and a velocity of a joint three"
    );
}

/// Y of τ = Y π [m²/s², m/s², 1/s² and a unit of length less for forces].
///
/// π lists for each body m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz in its frame. If `P` is large enough,
/// armature, damping and friction of each velocity of each joint follow, with the columns q̈, q̇ and sign q̇.
///
/// A column is the torques of Φ = skew[(H − H_g) J] with J = 1 in one entry and its mirror image (25).
///
/// # Panics
///
/// If `P` is neither 10 B nor 10 B plus three for each velocity of a joint.
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
    let motion = Motion::at(chain, q, qd, qdd);
    let (positions, h_g) = (&motion.positions, gravity_matrix::<T>(chain.gravity));
    let of_bodies = PARAMETERS * B;
    assert_count::<P, B>(positions.degrees_of_freedom().count());
    let mut rows = [[T::zero(); P]; N];
    if P > of_bodies {
        for (k, dof) in positions.degrees_of_freedom().enumerate() {
            let unit_torques = dof.unit_actuator_torques(qd, qdd);
            rows[dof.velocity][of_bodies + 3 * k..][..3].copy_from_slice(&unit_torques);
        }
    }
    for parameter in 0..of_bodies {
        let body = parameter / PARAMETERS;
        let hj = (motion.h[body] - h_g) * unit_inertia(positions, parameter);
        let phi = hj - hj.transpose();
        for dof in positions.degrees_of_freedom() {
            if let Some(row) = rows.get_mut(dof.velocity)
                && chain.carries(dof.body, Some(body))
            {
                row[parameter] += pseudo_scalar_product(&dof.l, &phi);
            }
        }
    }
    rows
}
