//! Cardan and Euler angles, all twelve sequences: position, velocity and acceleration.
//!
//! In: three angles about the axes of a [`Sequence`], with their rates and second rates; or a
//! rotation with ω and ω̇. Out: the other representation. At the singular middle angles, the angles of a
//! rotation still reproduce it; rates do not exist there and are an error.
//!
//! Axes move with the body: R = Rᵢ(α) Rⱼ(β) Rₖ(γ). Angles about fixed axes are the same in reverse
//! order: roll, pitch and yaw of URDF are `Sequence::Zyx` with (yaw, pitch, roll).
//!
//! ```
//! use homogen::angles::{self, Sequence};
//! let [roll, pitch, yaw]: [f64; 3] = [0.1, -0.4, 1.2];
//! let rotation = angles::rotation(Sequence::Zyx, [yaw, pitch, roll]);
//! let found = angles::from_rotation(Sequence::Zyx, &rotation);
//! assert!((found[1] - pitch).abs() < 1e-15);
//! ```

use super::frames::are_cyclic;
use crate::error::Error;
use crate::matrix::rotation::from_axis_angle;
use crate::matrix::vector::{add, cross, identity, matrix_product, norm, product, scale, sub};
use crate::matrix::{Acceleration, Pose, Velocity};
use crate::scalar::{Real, Scalar};

/// The axes i, j, k of three successive rotations about axes of the moving frame.
///
/// Cardan (Tait–Bryan) sequences have three different axes; in Euler sequences the last axis is the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sequence {
    /// Cardan x, y, z.
    Xyz,
    /// Cardan x, z, y.
    Xzy,
    /// Cardan y, x, z.
    Yxz,
    /// Cardan y, z, x.
    Yzx,
    /// Cardan z, x, y.
    Zxy,
    /// Cardan z, y, x: yaw, pitch, roll.
    Zyx,
    /// Euler x, y, x.
    Xyx,
    /// Euler x, z, x.
    Xzx,
    /// Euler y, x, y.
    Yxy,
    /// Euler y, z, y.
    Yzy,
    /// Euler z, x, z: the classical one.
    Zxz,
    /// Euler z, y, z: as in most wrists.
    Zyz,
}

impl Sequence {
    /// All twelve.
    pub const ALL: [Self; 12] = [
        Self::Xyz,
        Self::Xzy,
        Self::Yxz,
        Self::Yzx,
        Self::Zxy,
        Self::Zyx,
        Self::Xyx,
        Self::Xzx,
        Self::Yxy,
        Self::Yzy,
        Self::Zxz,
        Self::Zyz,
    ];

    /// The indices of the three axes: 0 is x, 1 is y, 2 is z.
    #[inline]
    #[must_use]
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Zyx => [2, 1, 0],
            Self::Xyx => [0, 1, 0],
            Self::Xzx => [0, 2, 0],
            Self::Yxy => [1, 0, 1],
            Self::Yzy => [1, 2, 1],
            Self::Zxz => [2, 0, 2],
            Self::Zyz => [2, 1, 2],
        }
    }

    /// True if the first and the last axis are the same: Euler angles, singular at β = 0 and π.
    /// Cardan angles are singular at β = ±π/2.
    #[inline]
    #[must_use]
    pub const fn is_euler(self) -> bool {
        let [i, _, k] = self.axes();
        i == k
    }

    /// i, j, the third axis, and true if these three are a cyclic order of x, y, z.
    const fn axes_and_sense(self) -> ([usize; 3], bool) {
        let [i, j, _] = self.axes();
        ([i, j, 3 - i - j], are_cyclic(i, j))
    }
}

/// R = Rᵢ(α) Rⱼ(β) Rₖ(γ), as rows; angles in rad.
///
/// SPACELIB: `cardator`, `eulertor`, `cardatom`, `eulertom`.
#[inline]
#[must_use]
pub fn rotation<T: Scalar>(sequence: Sequence, angles: [T; 3]) -> [[T; 3]; 3] {
    let [first, second, third] = elementary(sequence, angles);
    matrix_product(&matrix_product(&first, &second), &third)
}

/// M, the pose with the rotation of these angles and its origin at `origin` (m).
///
/// SPACELIB: `cardatom`, `eulertom`.
#[inline]
#[must_use]
pub fn pose<T: Scalar>(sequence: Sequence, angles: [T; 3], origin: [T; 3]) -> Pose<T> {
    Pose::new(rotation(sequence, angles), origin)
}

/// The angles (rad) of a rotation: α and γ in [−π, π], β in [−π/2, π/2] (Cardan) or [0, π] (Euler).
///
/// At the singular middle angles only a sum or a difference of α and γ is determined; the result is one of
/// the solutions, to rounding. [`other_angles`] gives the second solution.
///
/// SPACELIB: `rtocarda`, `rtoeuler`, `mtocarda`, `mtoeuler`.
#[must_use]
pub fn from_rotation<T: Real>(sequence: Sequence, rotation: &[[T; 3]; 3]) -> [T; 3] {
    let ([i, j, k], cyclic) = sequence.axes_and_sense();
    let r = rotation;
    let signed = |x: T| if cyclic { x } else { -x };
    let zero = T::constant(0.0);
    let (alpha, beta) = if sequence.is_euler() {
        // Subtracting from zero avoids atan2(0, −0) = π.
        (
            r[j][i].atan2(zero - signed(r[k][i])),
            norm([r[i][j], r[i][k]]).atan2(r[i][i]),
        )
    } else {
        (
            (zero - signed(r[j][k])).atan2(r[k][k]),
            signed(r[i][k]).atan2(norm([r[i][i], r[i][j]])),
        )
    };
    // Rᵢ(−α) R = Rⱼ(β) Rₖ(γ), whose row j is that of Rₖ(γ): γ compensates for any error of α.
    let (sine, cosine) = alpha.sin_cos();
    let row = add(scale(cosine, r[j]), scale(signed(sine), r[k]));
    let gamma = if sequence.is_euler() {
        (zero - signed(row[k])).atan2(row[j])
    } else {
        signed(row[i]).atan2(row[j])
    };
    [alpha, beta, gamma]
}

/// The other angles of the same rotation: (α + π, π − β, γ + π) for Cardan, (α + π, −β, γ + π) for
/// Euler sequences, not reduced to any range.
///
/// SPACELIB: `rtocarda`, `rtoeuler`, their second result.
#[must_use]
pub fn other_angles<T: Scalar>(sequence: Sequence, angles: [T; 3]) -> [T; 3] {
    let half_turn = T::constant(core::f64::consts::PI);
    let [alpha, beta, gamma] = angles;
    let beta = if sequence.is_euler() {
        -beta
    } else {
        half_turn - beta
    };
    [alpha + half_turn, beta, gamma + half_turn]
}

/// ω = α̇ e₁ + β̇ e₂ + γ̇ e₃ (rad/s), in the fixed frame.
///
/// SPACELIB: `cardatoW`, `eulertoW`, `cardatoomega`, `eulertoomega`.
#[inline]
#[must_use]
pub fn omega<T: Scalar>(sequence: Sequence, angles: [T; 3], rates: [T; 3]) -> [T; 3] {
    let e = axes_in_space(sequence, angles);
    combination(&e, rates)
}

/// ω̇ (rad/s²), in the fixed frame: the second rates along the axes, plus the rates of the axes, which
/// move with the earlier rotations.
///
/// SPACELIB: `cardatoH`, `eulertoH`, `cardatoomegapto`, `eulertoomegapto`.
#[inline]
#[must_use]
pub fn omega_dot<T: Scalar>(
    sequence: Sequence,
    angles: [T; 3],
    rates: [T; 3],
    second_rates: [T; 3],
) -> [T; 3] {
    let e = axes_in_space(sequence, angles);
    add(combination(&e, second_rates), carried(&e, rates))
}

/// W of a body with these angles and rates whose point at `point` (m) moves with `velocity` (m/s).
///
/// SPACELIB: `cardatoW`, `eulertoW`.
#[inline]
#[must_use]
pub fn velocity<T: Scalar>(
    sequence: Sequence,
    angles: [T; 3],
    rates: [T; 3],
    point: [T; 3],
    velocity: [T; 3],
) -> Velocity<T> {
    Velocity::at_point(omega(sequence, angles, rates), velocity, point)
}

/// H of a body with these angles, rates and second rates whose point at `point` (m) has the
/// `acceleration` (m/s²).
///
/// SPACELIB: `cardatoH`, `eulertoH`.
#[inline]
#[must_use]
pub fn acceleration<T: Scalar>(
    sequence: Sequence,
    angles: [T; 3],
    rates: [T; 3],
    second_rates: [T; 3],
    point: [T; 3],
    acceleration: [T; 3],
) -> Acceleration<T> {
    Acceleration::at_point(
        omega_dot(sequence, angles, rates, second_rates),
        omega(sequence, angles, rates),
        acceleration,
        point,
    )
}

/// The rates (rad/s) of the angles at the angular velocity `omega` (rad/s).
///
/// SPACELIB: `omegatocarda`, `Wtocarda`, `Wtoeuler`.
///
/// # Errors
///
/// [`Error::Degenerate`] at the singular middle angles, where cos β (Cardan) or sin β (Euler)
/// vanishes to rounding.
pub fn rates<T: Real>(sequence: Sequence, angles: [T; 3], omega: [T; 3]) -> Result<[T; 3], Error> {
    components(sequence, angles, omega)
}

/// The second rates (rad/s²) of the angles at the angular acceleration `omega_dot` (rad/s²), given
/// the rates.
///
/// SPACELIB: `Htocarda`, `Htoeuler`.
///
/// # Errors
///
/// As [`rates`].
pub fn second_rates<T: Real>(
    sequence: Sequence,
    angles: [T; 3],
    rates: [T; 3],
    omega_dot: [T; 3],
) -> Result<[T; 3], Error> {
    let e = axes_in_space(sequence, angles);
    components(sequence, angles, sub(omega_dot, carried(&e, rates)))
}

/// The three rotations.
#[inline]
fn elementary<T: Scalar>(sequence: Sequence, angles: [T; 3]) -> [[[T; 3]; 3]; 3] {
    let [i, j, k] = unit_vectors(sequence);
    let [alpha, beta, gamma] = angles;
    [
        from_axis_angle(i, alpha),
        from_axis_angle(j, beta),
        from_axis_angle(k, gamma),
    ]
}

/// The unit vectors of the three axes.
#[inline]
fn unit_vectors<T: Scalar>(sequence: Sequence) -> [[T; 3]; 3] {
    let unit_vectors = identity();
    sequence.axes().map(|axis| unit_vectors[axis])
}

/// The axes of the three rotations in the fixed frame, each rotated by those before it.
#[inline]
fn axes_in_space<T: Scalar>(sequence: Sequence, angles: [T; 3]) -> [[T; 3]; 3] {
    let [i, j, k] = unit_vectors(sequence);
    let [first, second, _] = elementary(sequence, angles);
    [i, product(&first, j), product(&first, product(&second, k))]
}

/// x₁ e₁ + x₂ e₂ + x₃ e₃.
#[inline]
fn combination<T: Scalar>(e: &[[T; 3]; 3], x: [T; 3]) -> [T; 3] {
    add(add(scale(x[0], e[0]), scale(x[1], e[1])), scale(x[2], e[2]))
}

/// ė₂ β̇ + ė₃ γ̇.
#[inline]
fn carried<T: Scalar>(e: &[[T; 3]; 3], rates: [T; 3]) -> [T; 3] {
    let first = scale(rates[0], e[0]);
    let second = scale(rates[1], e[1]);
    let third = scale(rates[2], e[2]);
    add(cross(first, second), cross(add(first, second), third))
}

/// x in e₁ x₁ + e₂ x₂ + e₃ x₃ = v.
///
/// In axes that move with the first rotation, e₁ and e₂ are two of the axes, and only e₃ needs a division:
/// the combination of the result is accurate to rounding even for a small divisor.
fn components<T: Real>(
    sequence: Sequence,
    [alpha, beta, _]: [T; 3],
    v: [T; 3],
) -> Result<[T; 3], Error> {
    let ([i, j, k], cyclic) = sequence.axes_and_sense();
    let signed = |x: T| if cyclic { x } else { -x };
    let ((sin_alpha, cos_alpha), (sin_beta, cos_beta)) = (alpha.sin_cos(), beta.sin_cos());
    let along_j = cos_alpha * v[j] + signed(sin_alpha) * v[k];
    let along_k = cos_alpha * v[k] - signed(sin_alpha) * v[j];
    let (quantity, e_3_i, e_3_k) = if sequence.is_euler() {
        let quantity = "the sine of the middle angle";
        (quantity, cos_beta, -signed(sin_beta))
    } else {
        let quantity = "the cosine of the middle angle";
        (quantity, signed(sin_beta), cos_beta)
    };
    if e_3_k.abs() <= T::EPSILON || !e_3_k.is_finite() {
        return Err(Error::Degenerate {
            quantity,
            value: e_3_k.to_f64(),
        });
    }
    let third = along_k / e_3_k;
    Ok([v[i] - e_3_i * third, along_j, third])
}
