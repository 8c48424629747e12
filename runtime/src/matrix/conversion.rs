//! Conversions to and from nalgebra (feature `nalgebra`).
//!
//! In: a typed matrix. Out: its `Matrix4`, an `Isometry3`, or a `Vector6` with the order of rows in the
//! name. A `Matrix4` is converted back only if it has exactly the form of the type (rotations: to within
//! 10⁻⁹, or 10⁻⁴ in single precision); it is rejected otherwise, never repaired.

use super::acceleration::Acceleration;
use super::action::Action;
use super::displacement::Displacement;
use super::inertia::Inertia;
use super::momentum::Momentum;
use super::point::{Direction, Point};
use super::pose::Pose;
use super::rotation::{from_quaternion, to_quaternion};
use super::screw::Screw;
use super::vector::axial;
use super::velocity::Velocity;
use crate::error::{Error, finite};
use crate::scalar::{Real, Scalar};
use core::array::from_fn;
use nalgebra::{
    Isometry3, Matrix4, Point3, Quaternion, RealField, Translation3, UnitQuaternion, Vector3,
    Vector4, Vector6,
};

/// Implements `From` into `Matrix4` by `to_matrix`.
macro_rules! into_matrix {
    ($($kind:ident)*) => {$(
        impl<T: Scalar + nalgebra::Scalar> From<$kind<T>> for Matrix4<T> {
            #[inline]
            fn from(matrix: $kind<T>) -> Self {
                dense(&matrix.to_matrix())
            }
        }
    )*};
}

into_matrix!(Pose Displacement Screw Velocity Acceleration Inertia Momentum Action);

/// Implements conversions to and from `Vector6`, in both orders of rows, for a type of an angular and a linear vector.
macro_rules! as_vector {
    ($($kind:ident: $first:ident, $second:ident;)*) => {$(
        impl<T: Scalar + nalgebra::Scalar> $kind<T> {
            #[doc = concat!("The six numbers `", stringify!($first), "`, `", stringify!($second), "`.")]
            #[inline]
            #[must_use]
            pub fn to_vector_angular_first(&self) -> Vector6<T> {
                let ([a, b, c], [d, e, f]) = (self.$first(), self.$second());
                Vector6::new(a, b, c, d, e, f)
            }

            #[doc = concat!("The six numbers `", stringify!($second), "`, `", stringify!($first), "`.")]
            #[inline]
            #[must_use]
            pub fn to_vector_linear_first(&self) -> Vector6<T> {
                let ([a, b, c], [d, e, f]) = (self.$second(), self.$first());
                Vector6::new(a, b, c, d, e, f)
            }

            #[doc = concat!("From the six numbers `", stringify!($first), "`, `", stringify!($second), "`.")]
            #[inline]
            #[must_use]
            pub fn from_vector_angular_first(vector: &Vector6<T>) -> Self {
                let [[a, b, c, d, e, f]] = vector.data.0;
                Self::new([a, b, c], [d, e, f])
            }

            #[doc = concat!("From the six numbers `", stringify!($second), "`, `", stringify!($first), "`.")]
            #[inline]
            #[must_use]
            pub fn from_vector_linear_first(vector: &Vector6<T>) -> Self {
                let [[a, b, c, d, e, f]] = vector.data.0;
                Self::new([d, e, f], [a, b, c])
            }
        }
    )*};
}

as_vector! {
    Screw: u, b;
    Velocity: omega, v;
    Momentum: gamma, rho;
    Action: c, f;
}

/// Implements `TryFrom<Matrix4>`: the matrix of the blocks that are read must be the given one.
macro_rules! try_from_matrix {
    ($($kind:ident, $form:literal, |$x:ident, $column:ident| $read:expr;)*) => {$(
        impl<T: Real + nalgebra::Scalar> TryFrom<Matrix4<T>> for $kind<T> {
            type Error = Error;

            #[doc = concat!("Refuses a matrix that is not exactly of the form ", $form, ".")]
            fn try_from(matrix: Matrix4<T>) -> Result<Self, Error> {
                let ($x, $column) = blocks(&matrix);
                let read: Self = $read;
                same_form($form, &matrix, &read.to_matrix())?;
                Ok(read)
            }
        }
    )*};
}

try_from_matrix! {
    Screw, "(u, b; 0, 0) with a skew block", |x, column| Self::new(axial(&x), column);
    Velocity, "(ω, v; 0, 0) with a skew block", |x, column| Self::new(axial(&x), column);
    Acceleration, "(G, a; 0, 0)", |x, column| Self::new(x, column);
    Momentum, "(γ, ρ; −ρ, 0) with a skew block", |x, column| Self::new(axial(&x), column);
    Action, "(c, f; −f, 0) with a skew block", |x, column| Self::new(axial(&x), column);
}

impl<T: Real + nalgebra::Scalar> TryFrom<Matrix4<T>> for Inertia<T> {
    type Error = Error;

    /// Rejects a matrix that is not exactly symmetric.
    fn try_from(matrix: Matrix4<T>) -> Result<Self, Error> {
        let ([[xx, xy, xz], [_, yy, yz], [_, _, zz]], q) = blocks(&matrix);
        let read = Self::new([xx, yy, zz, xy, xz, yz], q, matrix[(3, 3)]);
        same_form("a symmetric matrix", &matrix, &read.to_matrix())?;
        Ok(read)
    }
}

impl<T: Real + nalgebra::Scalar> TryFrom<Matrix4<T>> for Pose<T> {
    type Error = Error;

    /// Rejects a matrix whose last row is not 0, 0, 0, 1 or whose block is not a rotation.
    fn try_from(matrix: Matrix4<T>) -> Result<Self, Error> {
        let (rotation, translation) = blocks(&matrix);
        // About the root of the unit roundoff: files and long products are within it.
        let tolerance = T::constant(0.1) * T::EPSILON.sqrt();
        let read = Self::checked(rotation, translation, tolerance)?;
        same_form("(R, t; 0, 1)", &matrix, &read.to_matrix())?;
        Ok(read)
    }
}

impl<T: Real + nalgebra::Scalar> TryFrom<Matrix4<T>> for Displacement<T> {
    type Error = Error;

    /// As for [`Pose`].
    fn try_from(matrix: Matrix4<T>) -> Result<Self, Error> {
        Pose::try_from(matrix).map(Self::from_relative_pose)
    }
}

impl<T: Real + RealField> From<Pose<T>> for Isometry3<T> {
    /// By the quaternion of [`to_quaternion`].
    fn from(pose: Pose<T>) -> Self {
        let [w, x, y, z] = to_quaternion(pose.rotation());
        let [tx, ty, tz] = pose.translation();
        Self::from_parts(
            Translation3::new(tx, ty, tz),
            UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z)),
        )
    }
}

impl<T: Real + RealField> From<Isometry3<T>> for Pose<T> {
    fn from(isometry: Isometry3<T>) -> Self {
        let quaternion = isometry.rotation.quaternion();
        let rotation = from_quaternion([quaternion.w, quaternion.i, quaternion.j, quaternion.k]);
        let [translation] = isometry.translation.vector.data.0;
        Self::new(rotation, translation)
    }
}

impl<T: nalgebra::Scalar> From<Point<T>> for Point3<T> {
    fn from(point: Point<T>) -> Self {
        Self::from(point.0)
    }
}

impl<T: nalgebra::Scalar> From<Point3<T>> for Point<T> {
    fn from(point: Point3<T>) -> Self {
        let [coordinates] = point.coords.data.0;
        Self(coordinates)
    }
}

impl<T: nalgebra::Scalar> From<Direction<T>> for Vector3<T> {
    fn from(direction: Direction<T>) -> Self {
        Self::from(direction.0)
    }
}

impl<T: nalgebra::Scalar> From<Vector3<T>> for Direction<T> {
    fn from(vector: Vector3<T>) -> Self {
        let [components] = vector.data.0;
        Self(components)
    }
}

impl<T: Scalar + nalgebra::Scalar> From<Point<T>> for Vector4<T> {
    /// Four homogeneous coordinates, the last one 1.
    fn from(point: Point<T>) -> Self {
        Self::from(point.to_homogeneous())
    }
}

impl<T: Scalar + nalgebra::Scalar> From<Direction<T>> for Vector4<T> {
    /// Four homogeneous coordinates, the last one 0.
    fn from(direction: Direction<T>) -> Self {
        Self::from(direction.to_homogeneous())
    }
}

fn dense<T: nalgebra::Scalar + Copy>(rows: &[[T; 4]; 4]) -> Matrix4<T> {
    Matrix4::from_fn(|i, j| rows[i][j])
}

/// The upper left block as rows, and the upper part of the last column.
fn blocks<T: nalgebra::Scalar + Copy>(matrix: &Matrix4<T>) -> ([[T; 3]; 3], [T; 3]) {
    (
        from_fn(|i| from_fn(|j| matrix[(i, j)])),
        from_fn(|i| matrix[(i, 3)]),
    )
}

/// Rejects a matrix with an entry that differs from that of its form.
fn same_form<T: Real + nalgebra::Scalar>(
    quantity: &'static str,
    given: &Matrix4<T>,
    read: &[[T; 4]; 4],
) -> Result<(), Error> {
    finite("an entry of the matrix", given.iter())?;
    let zero = T::constant(0.0);
    let mut largest = zero;
    for (i, row) in read.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let difference = (given[(i, j)] - *entry).abs();
            if difference > largest {
                largest = difference;
            }
        }
    }
    if largest > zero {
        return Err(Error::NotOfForm {
            quantity,
            value: largest.to_f64(),
        });
    }
    Ok(())
}
