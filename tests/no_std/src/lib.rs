//! Builds homogen without the standard library.
//!
//! In: homogen with the feature `libm` alone. Out: a library, if and only if that works. It defines its own panic
//! handler, so the standard library, included by any dependency, is an error ("found duplicate lang item
//! `panic_impl`") on every target, the host included.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

use core::panic::PanicInfo;

use homogen::{Inertia, Jacobian, Point, Pose, Real, Screw};

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {}
}

/// Joint screws of an arm with two links of 0.4 m and 0.3 m, both axes along z, at q = 0.
fn screws<T: Real>() -> [Screw<T>; 2] {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let axis = [zero, zero, one];
    [
        Screw::revolute(axis, [zero, zero, zero]),
        Screw::revolute(axis, [T::constant(0.4), zero, zero]),
    ]
}

/// Pose of the end effector at the angles `q` [rad].
fn tip<T: Real>(q: &[T; 2]) -> Pose<T> {
    let [shoulder, elbow] = screws::<T>();
    let zero = T::constant(0.0);
    let at_rest = Pose::from_translation([T::constant(0.7), zero, zero]);
    shoulder.exp(q[0]) * elbow.exp(q[1]) * at_rest
}

/// Direction of the end effector from the base [rad], in single precision.
#[must_use]
pub fn bearing(q: &[f32; 2]) -> f32 {
    let Point([x, y, _]) = tip(q) * Point::origin();
    y.atan2(x)
}

/// Kinetic energy [J] of a rod of 1 kg on the arm's second link, at q = 0.
#[must_use]
pub fn kinetic_energy(qd: &[f64; 2]) -> f64 {
    let tensor = [[0.001, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]];
    let rod = Inertia::from_tensor_at_center_of_mass(1.0, [0.55, 0.0, 0.0], &tensor);
    rod.kinetic_energy(&screws::<f64>().velocity(qd))
}
