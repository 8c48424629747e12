//! The relative displacement and acceleration of the two faces of a cut.
//!
//! In: poses and motions of both. Out: their relative displacement as a screw, and their relative
//! acceleration, as six components in the order of the rows of A.

use crate::matrix::vector::scale;
use crate::matrix::{Acceleration, Displacement, Pose, Screw};
use crate::paper::open_chain::{BodyMotion, commutator};
use crate::scalar::Real;

/// (φ u, φ b) of M_right,left = exp(L φ), in the frame `right`.
pub(super) fn missing_screw<T: Real>(m_right_left: Pose<T>) -> [T; 6] {
    let (l, phi) = Displacement::from_relative_pose(m_right_left).log();
    components(&Screw::new(scale(phi, l.u()), scale(phi, l.b())))
}

/// H of left relative to right at W = 0, from both relative to the base: Ẇ of the difference, without the part
/// due to the motion of `right` (13).
pub(super) fn relative_acceleration<T: Real>(
    left: &BodyMotion<T>,
    right: &BodyMotion<T>,
) -> Acceleration<T> {
    let w = left.velocity - right.velocity;
    let w_dot = left.acceleration.velocity_derivative(&left.velocity)
        - right.acceleration.velocity_derivative(&right.velocity);
    let carried = commutator(&right.velocity, &w);
    Acceleration::from_velocity_derivative(&w, &(w_dot - carried))
}

/// u_x … b_z.
pub(super) fn components<T: Real>(l: &Screw<T>) -> [T; 6] {
    let ([ux, uy, uz], [bx, by, bz]) = (l.u(), l.b());
    [ux, uy, uz, bx, by, bz]
}

/// ω̇_x … a_z.
pub(super) fn components_of_rate<T: Real>(h: &Acceleration<T>) -> [T; 6] {
    let ([px, py, pz], [ax, ay, az]) = (h.omega_dot(), h.a());
    [px, py, pz, ax, ay, az]
}
