//! Rotations: conversions between matrix, axis and angle, and quaternion; check of orthogonality.
//!
//! In: rows of R, an axis and an angle, or a quaternion w, x, y, z. Out: another of these, to a few units of
//! rounding at every angle. Nothing here repairs a matrix; [`crate::normalize`] does.

use super::screw::Screw;
use super::vector::{determinant, dot, norm, transpose, unit};
use crate::error::{Error, finite};
use crate::scalar::{Real, Scalar};

/// R = I + u̲ sin φ + u̲² (1 − cos φ), as rows: the rotation by `phi` (rad) about the unit vector `u`
/// (§ 2.3, § 5).
///
/// SPACELIB: `rotat`, `rotat2`, `rotat23`.
#[inline]
#[must_use]
pub fn from_axis_angle<T: Scalar>(u: [T; 3], phi: T) -> [[T; 3]; 3] {
    *Screw::new(u, [T::constant(0.0); 3]).exp(phi).rotation()
}

/// The axis (a unit vector) and the angle φ in \[0, π\] of a rotation (§ 2.3); the z axis and 0 for
/// the identity. At φ = π it is either of the two opposite axes.
///
/// Computed by the quaternion of [`to_quaternion`] and φ = 2 atan2(‖v‖, w), which are accurate at every
/// angle; acos((tr R − 1)/2) and a division by 2 sin φ lose digits near 0 and π.
/// A defect of orthogonality of R causes an error of the same size.
///
/// SPACELIB: `extract`.
///
/// ```
/// use homogen::rotation::{axis_angle, from_axis_angle};
/// let (axis, angle) = axis_angle(&from_axis_angle([0.0, 1.0, 0.0], 1e-9));
/// assert_eq!((axis, angle), ([0.0, 1.0, 0.0], 1e-9));
/// ```
#[must_use]
pub fn axis_angle<T: Real>(rotation: &[[T; 3]; 3]) -> ([T; 3], T) {
    let half = HalfAngle::of_rotation(rotation);
    (half.axis, half.angle())
}

/// The axis with the sine and cosine of half the angle: a quaternion of any length in polar form. Only the
/// ratio of sine and cosine is used, so that they are not divided by the length, which would round them.
pub(crate) struct HalfAngle<T> {
    /// A unit vector.
    pub(crate) axis: [T; 3],
    /// A multiple of sin φ/2, at least 0.
    pub(crate) sine: T,
    /// The same multiple of cos φ/2, at least 0.
    pub(crate) cosine: T,
}

impl<T: Real> HalfAngle<T> {
    pub(crate) fn of_rotation(rotation: &[[T; 3]; 3]) -> Self {
        let zero = T::constant(0.0);
        let [w, v @ ..] = multiple_of_quaternion(rotation);
        let sine = norm(v);
        let axis = unit(v).unwrap_or([zero, zero, T::constant(1.0)]);
        Self {
            axis,
            sine,
            cosine: w,
        }
    }

    /// φ in \[0, π\].
    pub(crate) fn angle(&self) -> T {
        T::constant(2.0) * self.sine.atan2(self.cosine)
    }
}

/// The unit quaternion (w, x, y, z) of a rotation, w ≥ 0.
///
/// Source: S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1 (1978): the
/// largest of the four components comes from the diagonal, the others by division by it, so that
/// nothing cancels.
#[must_use]
pub fn to_quaternion<T: Real>(rotation: &[[T; 3]; 3]) -> [T; 4] {
    let multiple = multiple_of_quaternion(rotation);
    unit(multiple).unwrap_or(multiple)
}

/// The quaternion times four times its longest component, w ≥ 0.
fn multiple_of_quaternion<T: Real>(rotation: &[[T; 3]; 3]) -> [T; 4] {
    let one = T::constant(1.0);
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *rotation;
    let trace = xx + yy + zz;
    let (wx, wy, wz) = (zy - yz, xz - zx, yx - xy);
    let (sxy, sxz, syz) = (xy + yx, xz + zx, yz + zy);
    // Each row is the quaternion times four times one of its components; the longest row is used.
    let multiple = if trace >= xx && trace >= yy && trace >= zz {
        [one + trace, wx, wy, wz]
    } else if xx >= yy && xx >= zz {
        [wx, one + xx - yy - zz, sxy, sxz]
    } else if yy >= zz {
        [wy, sxy, one + yy - xx - zz, syz]
    } else {
        [wz, sxz, syz, one + zz - xx - yy]
    };
    if multiple[0] < T::constant(0.0) {
        multiple.map(|component| -component)
    } else {
        multiple
    }
}

/// The rotation of a quaternion (w, x, y, z) of unit length, as rows.
#[inline]
#[must_use]
pub fn from_quaternion<T: Scalar>([w, x, y, z]: [T; 4]) -> [[T; 3]; 3] {
    let (one, two) = (T::constant(1.0), T::constant(2.0));
    let (xx, yy, zz) = (two * x * x, two * y * y, two * z * z);
    let (xy, xz, yz) = (two * x * y, two * x * z, two * y * z);
    let (wx, wy, wz) = (two * w * x, two * w * y, two * w * z);
    [
        [one - (yy + zz), xy - wz, xz + wy],
        [xy + wz, one - (xx + zz), yz - wx],
        [xz - wy, yz + wx, one - (xx + yy)],
    ]
}

/// The largest entry of |RᵗR − I|: zero for an orthogonal matrix.
#[must_use]
pub fn defect<T: Real>(rotation: &[[T; 3]; 3]) -> T {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let columns = transpose(rotation);
    let mut largest = zero;
    for (i, a) in columns.iter().enumerate() {
        for (j, b) in columns.iter().enumerate() {
            let expected = if i == j { one } else { zero };
            let entry = (dot(*a, *b) - expected).abs();
            // NaN must be returned, but is lost in every comparison.
            if !entry.is_finite() {
                return entry;
            }
            largest = largest.max(entry);
        }
    }
    largest
}

/// Rejects a matrix that is not a rotation within `tolerance`.
///
/// # Errors
///
/// [`Error::NotFinite`] for NaN and infinity, [`Error::NotRotation`] for a defect above `tolerance`
/// and for a reflection.
pub fn check<T: Real>(rotation: &[[T; 3]; 3], tolerance: T) -> Result<(), Error> {
    finite("an entry of R", rotation.iter().flatten())?;
    let defect = defect(rotation);
    if defect > tolerance || !defect.is_finite() {
        return Err(Error::NotRotation {
            value: defect.to_f64(),
        });
    }
    let determinant = determinant(rotation);
    if determinant < T::constant(0.0) {
        return Err(Error::NotRotation {
            value: determinant.to_f64(),
        });
    }
    Ok(())
}
