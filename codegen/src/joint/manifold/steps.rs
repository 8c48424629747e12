//! Integration, difference and normalisation of the coordinates of one joint.
//!
//! The formulas and the order of operations are those of `homogen::robot::manifold`, which explains them: generated
//! files round as the runtime does. There are no branches, and accuracy is kept near 0 and near half a revolution.

use super::{Manifold, rotation_matrix};
use crate::expression::Term;
use crate::matrix::{Rotation, Vector};
use crate::real::Real;

/// 2⁴⁰: the squares of a quaternion are representable in every type if its largest entry is between this and its
/// inverse.
const MODERATE: f64 = 1_099_511_627_776.0;

/// Added to the square of an angle \[rad²\] to avoid division by zero; below any rounding error.
const LEAST: f64 = 1e-20;

/// Number of terms of the arc tangent, enough for `f64` up to π/16.
const ARC_TANGENT: u8 = 12;

/// A quaternion: x, y, z, and w.
type Quaternion<'g> = (Vector<Term<'g>>, Term<'g>);

impl Manifold {
    /// The coordinates after one unit of time with constant velocities `v` from `q`.
    pub fn integrate<'g>(
        self,
        q: impl Fn(usize) -> Term<'g>,
        v: impl Fn(usize) -> Term<'g>,
        real: Real,
    ) -> Vec<Term<'g>> {
        match self {
            Self::Planar => {
                let zero = q(0).graph().constant(0.0);
                let (omega, v) = (Vector([zero, zero, v(2)]), Vector([v(0), v(1), zero]));
                let shift = Rotation::about_z(q(2).sin_cos()) * displacement(omega, v, real);
                vec![q(0) + shift.x(), q(1) + shift.y(), q(2) + omega.z()]
            }
            Self::Spherical => {
                let ([x, y, z], w) = rotated(quaternion(0, q), Vector([0, 1, 2].map(v)));
                vec![x, y, z, w]
            }
            Self::Floating => {
                let (omega, v) = (Vector([3, 4, 5].map(&v)), Vector([0, 1, 2].map(&v)));
                let (axis, w) = quaternion(3, &q);
                let place = Vector([0, 1, 2].map(&q))
                    + rotation_matrix(axis.0, w) * displacement(omega, v, real);
                let (rotation, w) = rotated((axis, w), omega);
                [&place.0[..], &rotation, &[w]].concat()
            }
        }
    }

    /// The velocities that lead from `start` to `end` in one unit of time; rotations are the shortest.
    pub fn difference<'g>(
        self,
        start: impl Fn(usize) -> Term<'g>,
        end: impl Fn(usize) -> Term<'g>,
    ) -> Vec<Term<'g>> {
        let from_start = |k| end(k) - start(k);
        match self {
            Self::Planar => {
                let graph = start(0).graph();
                let [zero, half] = [0.0, 0.5].map(|value| graph.constant(value));
                let shift = Vector([from_start(0), from_start(1), zero]);
                let seen = Rotation::about_z(start(2).sin_cos()).transposed() * shift;
                let (sine, cosine) = (half * from_start(2)).sin_cos();
                let (omega, v) = motion((Vector([zero, zero, sine]), cosine), seen);
                vec![v.x(), v.y(), omega.z()]
            }
            Self::Spherical => {
                let between = between(quaternion(0, start), quaternion(0, end));
                logarithm(between).0.into()
            }
            Self::Floating => {
                let (axis, w) = quaternion(3, &start);
                let seen =
                    rotation_matrix(axis.0, w).transposed() * Vector([0, 1, 2].map(from_start));
                let (omega, v) = motion(between((axis, w), quaternion(3, &end)), seen);
                [v.0, omega.0].concat()
            }
        }
    }

    /// The coordinates with unit quaternions.
    pub fn normalize<'g>(self, q: impl Fn(usize) -> Term<'g>) -> Vec<Term<'g>> {
        let count = self.coordinates().len();
        match self {
            Self::Planar => (0..count).map(q).collect(),
            Self::Spherical | Self::Floating => {
                let first = count - 4;
                let quaternion = normalized([0, 1, 2, 3].map(|k| q(first + k)));
                (0..first).map(q).chain(quaternion).collect()
            }
        }
    }
}

/// The quaternion that begins at a coordinate.
fn quaternion<'g>(first: usize, q: impl Fn(usize) -> Term<'g>) -> Quaternion<'g> {
    let [x, y, z, w] = [0, 1, 2, 3].map(|k| q(first + k));
    (Vector([x, y, z]), w)
}

/// The quaternion rotated by `omega` about its own axes; a relative error ε of its length becomes of order ε².
fn rotated<'g>(q: Quaternion<'g>, omega: Vector<Term<'g>>) -> ([Term<'g>; 3], Term<'g>) {
    let number = |value: f64| q.1.graph().constant(value);
    let angle = angle(omega);
    let (sine, cosine) = (number(0.5) * angle).sin_cos();
    let (v, w) = times(q, (omega * (sine / angle), cosine));
    // 1/√(1 + ε) to first order, exact up to rounding.
    let mend = number(1.5) - number(0.5) * square(v.0, w);
    (v.map(|entry| mend * entry).0, mend * w)
}

/// The displacement \[m\] of a body that moves by `v` \[m\] and rotates by `omega` \[rad\], both in its own frame, in
/// the axes of its start: V(ω) v.
fn displacement<'g>(omega: Vector<Term<'g>>, v: Vector<Term<'g>>, real: Real) -> Vector<Term<'g>> {
    let number = |value: f64| omega.z().graph().constant(value);
    let angle = angle(omega);
    let ratio = (number(0.5) * angle).sin_cos().0 / angle;
    let bulge = minus_sine(angle, real) / (angle * angle * angle);
    let across = omega.cross(v);
    v + (across * (number(2.0) * ratio * ratio) + omega.cross(across) * bulge)
}

/// The motion (ω, v) of a body in its own frame that rotates it by a quaternion and moves its origin by `t` \[m\].
fn motion<'g>(
    (axis, w): Quaternion<'g>,
    t: Vector<Term<'g>>,
) -> (Vector<Term<'g>>, Vector<Term<'g>>) {
    let number = |value: f64| w.graph().constant(value);
    let omega = logarithm((axis, w));
    let cotangent = half_angle(axis, w) * sign(w) * w;
    let square = omega.dot(omega) + number(LEAST);
    let across = omega.cross(t);
    let bent = omega.cross(across) * ((number(1.0) - cotangent) / square);
    (omega, t - across * number(0.5) + bent)
}

/// The shortest rotation vector \[rad\] of a quaternion.
fn logarithm((axis, w): Quaternion<'_>) -> Vector<Term<'_>> {
    axis * (w.graph().constant(2.0) * sign(w) * half_angle(axis, w))
}

/// α/‖v‖ with α = atan(‖v‖/|w|); the angle is halved three times before the series.
fn half_angle<'g>(v: Vector<Term<'g>>, w: Term<'g>) -> Term<'g> {
    let number = |value: f64| w.graph().constant(value);
    let (one, square) = (number(1.0), v.dot(v));
    let half = one / ((square + w * w).sqrt() + sign(w) * w);
    let quarter = half / (one + (one + square * half * half).sqrt());
    let eighth = quarter / (one + (one + square * quarter * quarter).sqrt());
    let tangent = square * eighth * eighth;
    let coefficients = (0..ARC_TANGENT).map(|k| number(1.0 / (2.0 * f64::from(k) + 1.0)));
    let series = coefficients.rev().reduce(|sum, next| next - tangent * sum);
    number(8.0) * eighth * series.expect("the series has terms")
}

/// φ − sin φ for φ ≥ 0: by its series up to 2 rad, where the difference would cancel.
fn minus_sine(angle: Term<'_>, real: Real) -> Term<'_> {
    let number = |value: f64| angle.graph().constant(value);
    // Enough terms for the type up to 2 rad.
    let terms: u8 = match real {
        Real::F32 => 7,
        Real::F64 | Real::Generic => 12,
    };
    let is_large = step(angle - number(2.0));
    let is_small = number(1.0) - is_large;
    // Zero for a large angle, so that its powers do not overflow.
    let phi = is_small * angle;
    let square = phi * phi;
    let bracket = (2..=terms).rev().fold(number(1.0), |bracket, k| {
        let n = 2.0 * f64::from(k);
        number(1.0) - square * number(1.0 / (n * (n + 1.0))) * bracket
    });
    let series = phi * square * bracket / number(6.0);
    series + is_large * (angle - angle.sin_cos().0)
}

/// ‖ω‖, slightly above 0 if ω is 0.
fn angle(omega: Vector<Term<'_>>) -> Term<'_> {
    (omega.dot(omega) + omega.z().graph().constant(LEAST)).sqrt()
}

/// a⁻¹ b of quaternions of length 1.
fn between<'g>((axis, w): Quaternion<'g>, b: Quaternion<'g>) -> Quaternion<'g> {
    times((-axis, w), b)
}

/// The product of quaternions.
fn times<'g>((a, aw): Quaternion<'g>, (b, bw): Quaternion<'g>) -> Quaternion<'g> {
    (b * aw + a * bw + a.cross(b), aw * bw - a.dot(b))
}

/// The square of the length of a quaternion.
fn square<'g>([x, y, z]: [Term<'g>; 3], w: Term<'g>) -> Term<'g> {
    x * x + y * y + z * z + w * w
}

/// The unit quaternion; NaN if all entries are 0, or one is not finite.
fn normalized(quaternion: [Term<'_>; 4]) -> [Term<'_>; 4] {
    let number = |value: f64| quaternion[0].graph().constant(value);
    // Divided by the largest entry if squares could overflow or underflow, otherwise by 1.
    let [a, b, c, d] = quaternion.map(|entry| sign(entry) * entry);
    let largest = larger(larger(a, b), larger(c, d));
    let [most, least] = [MODERATE, 1.0 / MODERATE].map(number);
    let is_moderate = step(most - largest) * step(largest - least);
    let size = is_moderate + (number(1.0) - is_moderate) * largest;
    let scaled = quaternion.map(|entry| entry / size);
    let [x, y, z, w] = scaled;
    let length = square([x, y, z], w).sqrt();
    scaled.map(|entry| entry / length)
}

/// The larger of two numbers.
fn larger<'g>(a: Term<'g>, b: Term<'g>) -> Term<'g> {
    let first = step(a - b);
    first * a + (a.graph().constant(1.0) - first) * b
}

/// 1 for a number ≥ 0, else 0.
fn step(number: Term<'_>) -> Term<'_> {
    let half = number.graph().constant(0.5);
    half + half * sign(number)
}

/// 1 with the sign of a number; 1 for 0 and NaN.
fn sign(number: Term<'_>) -> Term<'_> {
    (number.sign() + number.graph().constant(0.5)).sign()
}
