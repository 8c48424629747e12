//! Frames from points and vectors.
//!
//! In: an origin and two directions, or three points. Out: the pose of their frame, with the first
//! direction exactly along its axis and the second in its half-plane. Parallel or zero directions are an
//! error.

use super::geometry::refuse_parallel;
use crate::error::{Error, finite};
use crate::matrix::Pose;
use crate::matrix::vector::{cross, dot, identity, negate, norm, scale, sub, transpose, unit};
use crate::scalar::{Real, Scalar};

/// A coordinate axis.
///
/// SPACELIB: `X`, `Y`, `Z`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

impl Axis {
    /// 0, 1 or 2.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }

    /// Its unit vector.
    ///
    /// SPACELIB: `axis`.
    #[must_use]
    pub fn unit_vector<T: Scalar>(self) -> [T; 3] {
        identity()[self.index()]
    }
}

/// True if axes i and j and the third one are a cyclic order of x, y, z.
pub(super) const fn are_cyclic(i: usize, j: usize) -> bool {
    (j + 3 - i) % 3 == 1
}

/// The rotation whose axis `first` has the direction `v`, and whose axis `second` lies in the half
/// plane of `v` and `w`, as rows.
///
/// SPACELIB: `frameV`.
///
/// # Errors
///
/// [`Error::NotFinite`]; [`Error::Degenerate`] for vectors that are zero or parallel to rounding, or
/// for one axis named twice.
///
/// ```
/// use homogen::frames::{Axis, rotation_from_vectors};
/// let r = rotation_from_vectors([0.0, 0.0, 2.0], [1.0, 0.0, 5.0], Axis::X, Axis::Y).unwrap();
/// assert_eq!(r, [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
/// ```
pub fn rotation_from_vectors<T: Real>(
    v: [T; 3],
    w: [T; 3],
    first: Axis,
    second: Axis,
) -> Result<[[T; 3]; 3], Error> {
    finite("a component of the first vector", &v)?;
    finite("a component of the second vector", &w)?;
    if first == second {
        return Err(Error::Degenerate {
            quantity: "the angle between an axis and itself",
            value: 0.0,
        });
    }
    let zero_length = |quantity| Error::Degenerate {
        quantity,
        value: 0.0,
    };
    let a = unit(v).ok_or(zero_length("the length of the first vector"))?;
    let b = unit(w).ok_or(zero_length("the length of the second vector"))?;
    let normal = cross(a, b);
    refuse_parallel("the sine of the angle between the vectors", norm(normal))?;
    // Computed this way, the axes are orthogonal to rounding even for a small sine.
    let normal = orthogonal_unit(normal, a);
    let b = cross(normal, a);
    let (i, j) = (first.index(), second.index());
    let mut axes = [a; 3];
    axes[j] = b;
    axes[3 - i - j] = if are_cyclic(i, j) {
        normal
    } else {
        negate(normal)
    };
    Ok(transpose(&axes))
}

/// The unit vector of the part of `x` that is perpendicular to the unit vector `a`.
fn orthogonal_unit<T: Real>(x: [T; 3], a: [T; 3]) -> [T; 3] {
    let straight = |x: [T; 3]| {
        let x = unit(x).unwrap_or(x);
        let along = dot(x, a);
        sub(x, scale(along, a))
    };
    // Twice is enough (W. Kahan, in Parlett, The Symmetric Eigenvalue Problem, § 6-9).
    let x = straight(straight(x));
    unit(x).unwrap_or(x)
}

/// M of the frame with its origin at `origin` (m) and the axes of [`rotation_from_vectors`].
///
/// SPACELIB: `frame4V`.
///
/// # Errors
///
/// As [`rotation_from_vectors`].
pub fn pose_from_vectors<T: Real>(
    origin: [T; 3],
    v: [T; 3],
    w: [T; 3],
    first: Axis,
    second: Axis,
) -> Result<Pose<T>, Error> {
    finite("a coordinate of the origin", &origin)?;
    Ok(Pose::new(
        rotation_from_vectors(v, w, first, second)?,
        origin,
    ))
}

/// The rotation whose axis `first` points from `origin` to `on_axis`, and whose axis `second` lies in
/// the half-plane of `in_plane`, as rows.
///
/// SPACELIB: `frameP`.
///
/// # Errors
///
/// As [`rotation_from_vectors`], for points that coincide or lie on one line.
pub fn rotation_from_points<T: Real>(
    origin: [T; 3],
    on_axis: [T; 3],
    in_plane: [T; 3],
    first: Axis,
    second: Axis,
) -> Result<[[T; 3]; 3], Error> {
    rotation_from_vectors(sub(on_axis, origin), sub(in_plane, origin), first, second)
}

/// M of the frame with its origin at `origin` (m) and the axes of [`rotation_from_points`].
///
/// SPACELIB: `frame4P`.
///
/// # Errors
///
/// As [`rotation_from_points`].
pub fn pose_from_points<T: Real>(
    origin: [T; 3],
    on_axis: [T; 3],
    in_plane: [T; 3],
    first: Axis,
    second: Axis,
) -> Result<Pose<T>, Error> {
    Ok(Pose::new(
        rotation_from_points(origin, on_axis, in_plane, first, second)?,
        origin,
    ))
}
