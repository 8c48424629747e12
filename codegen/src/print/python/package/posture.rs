//! Steps of single joints whose coordinates are no angles and shifts alone.
//!
//! Quaternions are x, y, z, w; motions are of a body in its own frame, and last for one unit of time. Nothing
//! branches, and digits are kept near rest and near half a turn.

use crate::number::Number;

/// 2⁴⁰: a quaternion whose largest entry is between this and its inverse has squares in every type.
const MODERATE: f64 = 1_099_511_627_776.0;

/// What is added to the square of an angle, so that nothing is divided by zero: no rounding sees it.
const LEAST: f64 = 1e-20;

/// So many terms of the arc tangent are beside those that `f64` sees, up to π/16.
const TERMS: u8 = 12;

/// Where a planar joint gets to.
#[inline(always)]
pub fn integrate_planar<T: Number>([x, y, angle]: [T; 3], [vx, vy, wz]: [T; 3]) -> [T; 3] {
    let zero = x.like(0.0);
    let [ahead, aside, _] = way([zero, zero, wz], [vx, vy, zero]);
    let ([sine], [cosine]) = T::sin_cos_all([angle]);
    [
        x + (cosine * ahead - sine * aside),
        y + (sine * ahead + cosine * aside),
        angle + wz,
    ]
}

/// Where a spherical joint gets to; an error of the length of `q` is squared.
#[inline(always)]
pub fn integrate_spherical<T: Number>(q: [T; 4], omega: [T; 3]) -> [T; 4] {
    let [x, y, z, w] = times(q, turn(omega));
    let square = x * x + y * y + z * z + w * w;
    // 1/√(1 + ε) to the first order, which is exact beside rounding.
    let mend = square.like(1.5) - square.like(0.5) * square;
    [mend * x, mend * y, mend * z, mend * w]
}

/// Where a floating joint gets to.
#[inline(always)]
pub fn integrate_floating<T: Number>(
    [x, y, z, qx, qy, qz, qw]: [T; 7],
    [vx, vy, vz, wx, wy, wz]: [T; 6],
) -> [T; 7] {
    let (quaternion, omega) = ([qx, qy, qz, qw], [wx, wy, wz]);
    let [r0, r1, r2] = rotation(quaternion);
    let gone = way(omega, [vx, vy, vz]);
    let [qx, qy, qz, qw] = integrate_spherical(quaternion, omega);
    let (x, y, z) = (x + dot(r0, gone), y + dot(r1, gone), z + dot(r2, gone));
    [x, y, z, qx, qy, qz, qw]
}

/// How a planar joint gets from `q0` to `q1`.
#[inline(always)]
pub fn difference_planar<T: Number>(q0: [T; 3], q1: [T; 3]) -> [T; 3] {
    let zero = q0[2].like(0.0);
    let [dx, dy, turned] = sub(q1, q0);
    let half = turned.like(0.5) * turned;
    let ([sine, half_sine], [cosine, half_cosine]) = T::sin_cos_all([q0[2], half]);
    let seen = [cosine * dx + sine * dy, cosine * dy - sine * dx, zero];
    let ([_, _, wz], [vx, vy, _]) = motion([zero, zero, half_sine, half_cosine], seen);
    [vx, vy, wz]
}

/// How a spherical joint gets from `q0` to `q1`.
#[inline(always)]
pub fn difference_spherical<T: Number>(q0: [T; 4], q1: [T; 4]) -> [T; 3] {
    log(times(back(q0), q1))
}

/// How a floating joint gets from `q0` to `q1`.
#[inline(always)]
pub fn difference_floating<T: Number>(
    [x, y, z, qx, qy, qz, qw]: [T; 7],
    [to_x, to_y, to_z, to_qx, to_qy, to_qz, to_qw]: [T; 7],
) -> [T; 6] {
    let quaternion = [qx, qy, qz, qw];
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = rotation(quaternion);
    let gone = sub([to_x, to_y, to_z], [x, y, z]);
    let seen = [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]].map(|axis| dot(axis, gone));
    let turned = times(back(quaternion), [to_qx, to_qy, to_qz, to_qw]);
    let ([wx, wy, wz], [vx, vy, vz]) = motion(turned, seen);
    [vx, vy, vz, wx, wy, wz]
}

/// A quaternion with length 1, whatever its length; NaN where all entries are zero, or one is not finite.
#[inline(always)]
pub fn normalized<T: Number>(quaternion: [T; 4]) -> [T; 4] {
    let [x, y, z, w] = moderate(quaternion);
    let length = (x * x + y * y + z * z + w * w).sqrt();
    [x / length, y / length, z / length, w / length]
}

/// A quaternion over its largest entry, where that is beyond 2⁻⁴⁰ to 2⁴⁰ and squares may overflow or vanish, and
/// else over 1, which changes no digit.
#[inline(always)]
fn moderate<T: Number>([x, y, z, w]: [T; 4]) -> [T; 4] {
    let [one, half, most, least] = [1.0, 0.5, MODERATE, 1.0 / MODERATE].map(|n| x.like(n));
    // 1 of a number that is not negative, 0 of another.
    let step = |x: T| half + half * sign(x);
    let larger = |a: T, b: T| {
        let first = step(a - b);
        first * a + (one - first) * b
    };
    let [a, b, c, d] = [x, y, z, w].map(|entry| sign(entry) * entry);
    let largest = larger(larger(a, b), larger(c, d));
    let is_moderate = step(most - largest) * step(largest - least);
    let size = is_moderate + (one - is_moderate) * largest;
    [x / size, y / size, z / size, w / size]
}

/// The quaternion of a turn by a vector.
#[inline(always)]
fn turn<T: Number>(omega: [T; 3]) -> [T; 4] {
    let angle = angle(omega);
    let ([sine], [cosine]) = T::sin_cos_all([angle.like(0.5) * angle]);
    let [x, y, z] = scale(sine / angle, omega);
    [x, y, z, cosine]
}

/// The shortest vector that turns as a quaternion does.
#[inline(always)]
fn log<T: Number>([x, y, z, w]: [T; 4]) -> [T; 3] {
    let v = [x, y, z];
    scale(w.like(2.0) * sign(w) * half_angle(v, w), v)
}

/// How far a body has gone that moves by `v` and turns by `omega`, both in its own frame, seen from where it was.
#[inline(always)]
fn way<T: Number>(omega: [T; 3], v: [T; 3]) -> [T; 3] {
    let (half, two) = (v[0].like(0.5), v[0].like(2.0));
    let angle = angle(omega);
    let ([sine, half_sine], _) = T::sin_cos_all([angle, half * angle]);
    let ratio = half_sine / angle;
    let bulge = angle.less_sine(sine) / (angle * angle * angle);
    let across = cross(omega, v);
    let turned = add(
        scale(two * ratio * ratio, across),
        scale(bulge, cross(omega, across)),
    );
    add(v, turned)
}

/// The motion (ω, v) that turns a body as the quaternion and takes its origin by `t`.
#[inline(always)]
fn motion<T: Number>([x, y, z, w]: [T; 4], t: [T; 3]) -> ([T; 3], [T; 3]) {
    let omega = log([x, y, z, w]);
    let cotangent = half_angle([x, y, z], w) * sign(w) * w;
    let square = dot(omega, omega) + x.like(LEAST);
    let across = cross(omega, t);
    let bent = scale((x.like(1.0) - cotangent) / square, cross(omega, across));
    (omega, add(sub(t, scale(x.like(0.5), across)), bent))
}

/// ‖ω‖, and not quite zero where it is.
#[inline(always)]
fn angle<T: Number>(omega: [T; 3]) -> T {
    let square = dot(omega, omega);
    (square + square.like(LEAST)).sqrt()
}

/// α/‖v‖ with α = atan(‖v‖/|w|), an angle that is halved three times before its series is summed.
#[inline(always)]
fn half_angle<T: Number>(v: [T; 3], w: T) -> T {
    let one = w.like(1.0);
    let square = dot(v, v);
    let half = one / ((square + w * w).sqrt() + sign(w) * w);
    let quarter = half / (one + (one + square * half * half).sqrt());
    let eighth = quarter / (one + (one + square * quarter * quarter).sqrt());
    let tangent = square * eighth * eighth;
    let series = (0..TERMS).rev().fold(w.like(0.0), |sum, k| {
        w.like(1.0 / (2.0 * f64::from(k) + 1.0)) - tangent * sum
    });
    w.like(8.0) * eighth * series
}

/// 1 with the sign of a number; 1 of zero and of NaN.
#[inline(always)]
fn sign<T: Number>(number: T) -> T {
    (number.sgn() + number.like(0.5)).sgn()
}

/// The product of quaternions.
#[inline(always)]
fn times<T: Number>([ax, ay, az, aw]: [T; 4], [bx, by, bz, bw]: [T; 4]) -> [T; 4] {
    let (a, b) = ([ax, ay, az], [bx, by, bz]);
    let [x, y, z] = add(add(scale(aw, b), scale(bw, a)), cross(a, b));
    [x, y, z, aw * bw - dot(a, b)]
}

/// The turn back.
#[inline(always)]
fn back<T: Number>([x, y, z, w]: [T; 4]) -> [T; 4] {
    [-x, -y, -z, w]
}

/// The rotation of a quaternion, as rows.
#[inline(always)]
fn rotation<T: Number>([x, y, z, w]: [T; 4]) -> [[T; 3]; 3] {
    let (one, two) = (w.like(1.0), w.like(2.0));
    let (xx, yy, zz) = (two * x * x, two * y * y, two * z * z);
    let (xy, xz, yz) = (two * x * y, two * x * z, two * y * z);
    let (wx, wy, wz) = (two * w * x, two * w * y, two * w * z);
    [
        [one - (yy + zz), xy - wz, xz + wy],
        [xy + wz, one - (xx + zz), yz - wx],
        [xz - wy, yz + wx, one - (xx + yy)],
    ]
}

#[inline(always)]
fn add<T: Number>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ax + bx, ay + by, az + bz]
}

#[inline(always)]
fn sub<T: Number>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ax - bx, ay - by, az - bz]
}

#[inline(always)]
fn scale<T: Number>(factor: T, [x, y, z]: [T; 3]) -> [T; 3] {
    [factor * x, factor * y, factor * z]
}

#[inline(always)]
fn dot<T: Number>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> T {
    ax * bx + ay * by + az * bz
}

#[inline(always)]
fn cross<T: Number>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}
