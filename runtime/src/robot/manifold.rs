//! Integration and difference of the configurations of planar, spherical and floating joints; quaternions.
//!
//! In: quaternions x, y, z, w, coordinates of one joint, and velocities of a body in its own frame times a
//! duration. Out: the configuration after the step, or the shortest step between two configurations.
//! Everything is generic over [`Scalar`], without branches, and accurate near rest and near 180°.
//! [`Chain::integrate`](crate::Chain::integrate) does the same for a whole robot.
//!
//! ```
//! use homogen::robot::manifold::{exp, log};
//! let half: [f64; 4] = exp([0.0, 0.0, core::f64::consts::PI]);
//! assert!((half[2] - 1.0).abs() < 1e-15 && half[3].abs() < 1e-15);
//! assert!((log(half)[2].abs() - core::f64::consts::PI).abs() < 1e-15);
//! ```

use crate::matrix::rotation::from_quaternion;
use crate::matrix::vector::{add, cross, dot, product, scale, sub, transposed_product};
use crate::scalar::Scalar;
use crate::scalar::rounding::{Rounding, Unfused};

/// 2⁴⁰: if the largest entry of a quaternion is between this and its inverse, squares neither overflow nor
/// vanish in any type.
const MODERATE: f64 = 1_099_511_627_776.0;

/// Added to the square of an angle \[rad²\] to avoid divisions by zero; below rounding.
const LEAST: f64 = 1e-20;

/// The product a b of quaternions x, y, z, w: the rotation b, then a, both about fixed axes; or a, then b
/// about the axes rotated by a.
#[inline]
#[must_use]
pub fn times<T: Scalar>([ax, ay, az, aw]: [T; 4], [bx, by, bz, bw]: [T; 4]) -> [T; 4] {
    let (a, b) = ([ax, ay, az], [bx, by, bz]);
    let [x, y, z] = add(add(scale(aw, b), scale(bw, a)), cross(a, b));
    [x, y, z, aw * bw - dot(a, b)]
}

/// The inverse rotation of a quaternion x, y, z, w of unit length.
#[inline]
#[must_use]
pub fn inverse<T: Scalar>([x, y, z, w]: [T; 4]) -> [T; 4] {
    [-x, -y, -z, w]
}

/// The quaternion x, y, z, w scaled to length 1, from any length; subnormal entries have fewer digits. NaN if all
/// entries are zero or one is not finite.
#[inline]
#[must_use]
pub fn normalized<T: Scalar>(quaternion: [T; 4]) -> [T; 4] {
    let scaled = moderate(quaternion);
    let [x, y, z, w] = scaled;
    let length = (x * x + y * y + z * z + w * w).sqrt();
    scaled.map(|entry| entry / length)
}

/// The sign of a number, ±1; 1 for zero and NaN.
#[inline]
fn side<T: Scalar>(x: T) -> T {
    (x.sign() + T::constant(0.5)).sign()
}

/// A quaternion divided by its largest entry if that is outside 2⁻⁴⁰ to 2⁴⁰, so that squares neither overflow nor
/// vanish; the same quaternion otherwise.
#[inline]
fn moderate<T: Scalar>(quaternion: [T; 4]) -> [T; 4] {
    let [one, half, most, least] = [1.0, 0.5, MODERATE, 1.0 / MODERATE].map(T::constant);
    // 1 if a number is at least 0, otherwise 0.
    let step = |x: T| half + half * side(x);
    let [a, b, c, d] = quaternion.map(|entry| side(entry) * entry);
    let larger = |a: T, b: T| {
        let first = step(a - b);
        first * a + (one - first) * b
    };
    let largest = larger(larger(a, b), larger(c, d));
    let is_moderate = step(most - largest) * step(largest - least);
    let size = is_moderate + (one - is_moderate) * largest;
    quaternion.map(|entry| entry / size)
}

/// The quaternion x, y, z, w of the rotation vector `omega` \[rad\], exp ω̲.
///
/// v = ω sin(φ/2)/φ and w = cos(φ/2), φ = ‖ω‖.
#[inline]
#[must_use]
pub fn exp<T: Scalar>(omega: [T; 3]) -> [T; 4] {
    let angle = angle(omega);
    let ([sine], [cosine]) = Unfused::sin_cos_all([T::constant(0.5) * angle]);
    let [x, y, z] = scale(sine / angle, omega);
    [x, y, z, cosine]
}

/// The shortest rotation vector \[rad\] of a quaternion v, w: ω with R = exp ω̲ and ‖ω‖ ≤ π. At 180° it is either of
/// the two. The quaternion may have any length whose square neither overflows nor vanishes.
///
/// ω = ±2 v α/‖v‖ with α = atan(‖v‖/|w|). The angle is halved three times by
/// tan α/2 = tan α/(1 + √(1 + tan² α)) before its series is summed.
#[inline]
#[must_use]
pub fn log<T: Scalar>([x, y, z, w]: [T; 4]) -> [T; 3] {
    let v = [x, y, z];
    scale(T::constant(2.0) * side(w) * half_angle(v, w), v)
}

/// The displacement \[m\] of the origin of a body that moves by `v` \[m\] while it rotates by `omega` \[rad\], both in
/// its own frame; in the frame before the motion: V(ω) v with exp (ω̲, v; 0, 0) = (exp ω̲, V(ω) v; 0, 1).
///
/// V = 1 + ω̲ (1 − cos φ)/φ² + ω̲² (φ − sin φ)/φ³, φ = ‖ω‖ (§ 5).
#[inline]
#[must_use]
pub fn displacement<T: Scalar>(omega: [T; 3], v: [T; 3]) -> [T; 3] {
    let (half, two) = (T::constant(0.5), T::constant(2.0));
    let angle = angle(omega);
    let ([sine, half_sine], _) = Unfused::sin_cos_all([angle, half * angle]);
    let ratio = half_sine / angle;
    let bulge = angle.minus_sine(sine) / (angle * angle * angle);
    let across = cross(omega, v);
    let turned = add(
        scale(two * ratio * ratio, across),
        scale(bulge, cross(omega, across)),
    );
    add(v, turned)
}

/// The step (ω, v) in the frame of a body that rotates it by the quaternion and displaces its origin by `t` \[m\], in
/// the frame before the motion: ω = [`log`] and V(ω) v = t.
///
/// V⁻¹ = 1 − ½ ω̲ + ω̲² (1 − α cot α)/φ², α = φ/2.
#[inline]
#[must_use]
pub fn motion<T: Scalar>(quaternion: [T; 4], t: [T; 3]) -> ([T; 3], [T; 3]) {
    let [x, y, z, w] = quaternion;
    let omega = log(quaternion);
    // α cot α = (α/‖v‖) |w|, for any length.
    let cotangent = half_angle([x, y, z], w) * side(w) * w;
    let square = dot(omega, omega) + T::constant(LEAST);
    let across = cross(omega, t);
    let bent = scale(
        (T::constant(1.0) - cotangent) / square,
        cross(omega, across),
    );
    (omega, add(sub(t, scale(T::constant(0.5), across)), bent))
}

/// The coordinates of a planar joint after a step v_x, v_y, ω_z from `q`.
#[inline]
#[must_use]
pub fn integrate_planar<T: Scalar>([x, y, angle]: [T; 3], [vx, vy, wz]: [T; 3]) -> [T; 3] {
    let zero = T::constant(0.0);
    let [ahead, aside, _] = displacement([zero, zero, wz], [vx, vy, zero]);
    let ([sine], [cosine]) = Unfused::sin_cos_all([angle]);
    [
        x + (cosine * ahead - sine * aside),
        y + (sine * ahead + cosine * aside),
        angle + wz,
    ]
}

/// The coordinates of a spherical joint after a rotation by `omega` from `q`; an error of the length of `q` is squared.
#[inline]
#[must_use]
pub fn integrate_spherical<T: Scalar>(q: [T; 4], omega: [T; 3]) -> [T; 4] {
    let [x, y, z, w] = times(q, exp(omega));
    let square = x * x + y * y + z * z + w * w;
    // 1/√(1 + ε) to the first order; the rest is below rounding.
    let correction = T::constant(1.5) - T::constant(0.5) * square;
    [x, y, z, w].map(|entry| correction * entry)
}

/// The coordinates of a floating joint after a step v, ω from `q`.
#[inline]
#[must_use]
pub fn integrate_floating<T: Scalar>(q: [T; 7], motion: [T; 6]) -> [T; 7] {
    let ([x, y, z, qx, qy, qz, qw], [vx, vy, vz, wx, wy, wz]) = (q, motion);
    let omega = [wx, wy, wz];
    let turned = from_quaternion([qw, qx, qy, qz]);
    let gone = product(&turned, displacement(omega, [vx, vy, vz]));
    let [x, y, z] = add([x, y, z], gone);
    let [qx, qy, qz, qw] = integrate_spherical([qx, qy, qz, qw], omega);
    [x, y, z, qx, qy, qz, qw]
}

/// The step v_x, v_y, ω_z of a planar joint from `from` to `to`, |ω_z| ≤ π.
#[inline]
#[must_use]
pub fn difference_planar<T: Scalar>(from: [T; 3], to: [T; 3]) -> [T; 3] {
    let zero = T::constant(0.0);
    let [dx, dy, turned] = sub(to, from);
    let half = T::constant(0.5) * turned;
    let ([sine, half_sine], [cosine, half_cosine]) = Unfused::sin_cos_all([from[2], half]);
    let seen = [cosine * dx + sine * dy, cosine * dy - sine * dx, zero];
    let ([.., wz], [vx, vy, _]) = motion([zero, zero, half_sine, half_cosine], seen);
    [vx, vy, wz]
}

/// The step ω of a spherical joint from `from` to `to`, ‖ω‖ ≤ π.
#[inline]
#[must_use]
pub fn difference_spherical<T: Scalar>(from: [T; 4], to: [T; 4]) -> [T; 3] {
    log(times(inverse(from), to))
}

/// The step v, ω of a floating joint from `from` to `to`, ‖ω‖ ≤ π.
#[inline]
#[must_use]
pub fn difference_floating<T: Scalar>(from: [T; 7], to: [T; 7]) -> [T; 6] {
    let [x, y, z, qx, qy, qz, qw] = from;
    let [to_x, to_y, to_z, to_quaternion @ ..] = to;
    let turned = from_quaternion([qw, qx, qy, qz]);
    let seen = transposed_product(&turned, sub([to_x, to_y, to_z], [x, y, z]));
    let turn = times(inverse([qx, qy, qz, qw]), to_quaternion);
    let ([wx, wy, wz], [vx, vy, vz]) = motion(turn, seen);
    [vx, vy, vz, wx, wy, wz]
}

/// ‖ω‖ with [`LEAST`] added to its square, so that it is never zero.
#[inline]
pub(crate) fn angle<T: Scalar>(omega: [T; 3]) -> T {
    (dot(omega, omega) + T::constant(LEAST)).sqrt()
}

/// α/‖v‖ with α = atan(‖v‖/|w|) in \[0, π/2\], without a division by zero at v = 0.
#[inline]
fn half_angle<T: Scalar>(v: [T; 3], w: T) -> T {
    /// Terms of the series up to which it is exact in `f64`, for angles up to π/16.
    const TERMS: u8 = 12;
    let one = T::constant(1.0);
    let square = dot(v, v);
    // tan(α/2)/‖v‖, tan(α/4)/‖v‖, tan(α/8)/‖v‖.
    let half = one / ((square + w * w).sqrt() + side(w) * w);
    let quarter = half / (one + (one + square * half * half).sqrt());
    let eighth = quarter / (one + (one + square * quarter * quarter).sqrt());
    let tangent = square * eighth * eighth;
    let series = (0..TERMS).rev().fold(T::constant(0.0), |sum, k| {
        T::constant(1.0 / (2.0 * f64::from(k) + 1.0)) - tangent * sum
    });
    T::constant(8.0) * eighth * series
}
