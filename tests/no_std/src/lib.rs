//! Uses homogen where there is no standard library.
//!
//! In: homogen with `libm` and nothing else. Out: a library that builds, and only then. It defines
//! its own panic handler, so a standard library that crept in through any dependency would be an
//! error ("found duplicate lang item `panic_impl`") on every target, the host included.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

use core::panic::PanicInfo;

use homogen::{Inertia, Jacobian, Point, Pose, Real, Screw};

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {}
}

/// The joints' screws of an arm of two links of 0.4 m and 0.3 m, both axes along z, at q = 0.
fn screws<T: Real>() -> [Screw<T>; 2] {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let axis = [zero, zero, one];
    [
        Screw::revolute(axis, [zero, zero, zero]),
        Screw::revolute(axis, [T::constant(0.4), zero, zero]),
    ]
}

/// The pose of the arm's tip at the angles `q` [rad].
fn tip<T: Real>(q: &[T; 2]) -> Pose<T> {
    let [shoulder, elbow] = screws::<T>();
    let zero = T::constant(0.0);
    let at_rest = Pose::from_translation([T::constant(0.7), zero, zero]);
    shoulder.exp(q[0]) * elbow.exp(q[1]) * at_rest
}

/// The direction in which the tip of the arm is seen from its base [rad], in single precision.
#[must_use]
pub fn bearing(q: &[f32; 2]) -> f32 {
    let Point([x, y, _]) = tip(q) * Point::origin();
    y.atan2(x)
}

/// The kinetic energy [J] of a rod of 1 kg on the arm's second link, seen at q = 0.
#[must_use]
pub fn kinetic_energy(qd: &[f64; 2]) -> f64 {
    let tensor = [[0.001, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]];
    let rod = Inertia::from_tensor_at_center_of_mass(1.0, [0.55, 0.0, 0.0], &tensor);
    rod.kinetic_energy(&screws::<f64>().velocity(qd))
}
