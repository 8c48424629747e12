//! Checks of poses, screws and inertias; principal axes of an inertia.
//!
//! In: numbers from a file or a computation. Out: the typed matrix, or an error with the wrong quantity
//! and its value; the principal frame of a body. It never repairs anything.

use super::inertia::Inertia;
use super::pose::Pose;
use super::rotation;
use super::screw::Screw;
use super::symmetric::eigen;
use super::vector::{determinant, largest_magnitude, negate, norm, transpose};
use crate::error::{Error, finite};
use crate::scalar::Real;

impl<T: Real> Pose<T> {
    /// The pose with these blocks, its rotation checked to within `tolerance` (see
    /// [`rotation::defect`]).
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`], or [`Error::NotRotation`] with the defect.
    pub fn checked(
        rotation: [[T; 3]; 3],
        translation: [T; 3],
        tolerance: T,
    ) -> Result<Self, Error> {
        rotation::check(&rotation, tolerance)?;
        finite("an entry of t", &translation)?;
        Ok(Self::new(rotation, translation))
    }
}

impl<T: Real> Screw<T> {
    /// The screw (u̲, b; 0, 0), checked to within `tolerance`: u has unit length, or is zero and b has unit
    /// length.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`] for NaN and infinity, [`Error::NotUnit`] for another length.
    pub fn checked(u: [T; 3], b: [T; 3], tolerance: T) -> Result<Self, Error> {
        finite("a component of the axis u", &u)?;
        finite("a component of b", &b)?;
        let (quantity, length) = if u == [T::constant(0.0); 3] {
            ("the direction b of a translation", norm(b))
        } else {
            ("the axis u", norm(u))
        };
        if (length - T::constant(1.0)).abs() > tolerance {
            return Err(Error::NotUnit {
                quantity,
                value: length.to_f64(),
            });
        }
        Ok(Self::new(u, b))
    }
}

impl<T: Real> Inertia<T> {
    /// Rejects a non-physical inertia: J must be positive semidefinite (§ 4.3). Neither the mass nor a
    /// second moment about the centre of mass may be negative.
    ///
    /// `tolerance` is relative to the largest second moment. The smallest second moment of flat and
    /// rod-like bodies is zero, to a few units of rounding.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`], [`Error::NegativeMass`], or [`Error::NotPhysical`] with the most negative
    /// principal second moment, or with the first moment of a body without mass.
    pub fn check(&self, tolerance: T) -> Result<(), Error> {
        let zero = T::constant(0.0);
        finite("the mass", &[self.mass()])?;
        finite("a component of q", &self.q())?;
        finite("a second moment", self.second_moments().iter().flatten())?;
        if self.mass() < zero {
            return Err(Error::NegativeMass {
                value: self.mass().to_f64(),
            });
        }
        let smallest = self.smallest_second_moment();
        let offset = largest_magnitude(&self.q());
        if self.mass() == zero && offset > zero {
            return Err(Error::NotPhysical {
                quantity: "the product of zero mass and the centre's position",
                value: offset.to_f64(),
            });
        }
        if smallest < -(tolerance * self.largest_second_moment()) {
            return Err(Error::NotPhysical {
                quantity: "a principal second moment about the centre of mass",
                value: smallest.to_f64(),
            });
        }
        Ok(())
    }

    /// The smallest principal second moment about the centre of mass (kg m²): negative by the amount
    /// by which the triangle inequality of the moments of inertia fails, zero for a flat body.
    ///
    /// About the origin for a body without mass.
    #[must_use]
    pub fn smallest_second_moment(&self) -> T {
        let ([_, _, smallest], _) = eigen(&self.central_rows());
        smallest
    }

    /// The principal frame of a body with mass: its pose in the frame of J, and the second moments
    /// ∫x², ∫y², ∫z² dm (kg m²) in it, in descending order.
    ///
    /// In this frame J is diagonal and (25) takes the form printed after (26).
    #[must_use]
    pub fn principal_frame(&self) -> (Pose<T>, [T; 3]) {
        let (moments, [x, y, z]) = eigen(&self.central_rows());
        let axes = if determinant(&[x, y, z]) < T::constant(0.0) {
            [x, y, negate(z)]
        } else {
            [x, y, z]
        };
        (Pose::new(transpose(&axes), self.center_of_mass()), moments)
    }

    /// Second moments about the centre of mass, as rows.
    fn central_rows(&self) -> [[T; 3]; 3] {
        if self.mass() == T::constant(0.0) {
            return self.second_moments();
        }
        Self::new(self.central_second_moments(), self.q(), self.mass()).second_moments()
    }

    /// The largest second moment, to which rounding errors are relative.
    fn largest_second_moment(&self) -> T {
        largest_magnitude(self.second_moments().as_flattened())
    }
}
