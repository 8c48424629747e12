//! A payload that is known at run time, as a field of a robot.
//!
//! In: mass, centre and inertia. Out: the ten numbers that generated code reads. Nothing is checked;
//! [`Inertia::check`](crate::Inertia::check) rejects a non-physical inertia.

use crate::scalar::Scalar;

/// A body fixed to a link: the type of a field with `#[robot(payload_on = "link")]`.
///
/// ```
/// use homogen::Payload;
///
/// let bottle = Payload {
///     mass: 1.2,
///     center: [0.0, 0.0, 0.1],
///     inertia: [0.003, 0.0, 0.0, 0.003, 0.0, 0.001],
/// };
/// assert_eq!(Payload::<f64>::default().mass, 0.0);
/// # assert_eq!(bottle.numbers()[3], 0.1);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Payload<T = f64> {
    /// m \[kg\].
    pub mass: T,
    /// Its centre of mass in the link's frame \[m\].
    pub center: [T; 3],
    /// I_xx, I_xy, I_xz, I_yy, I_yz, I_zz about that centre, in the axes of the link's frame [kg m²]: the
    /// order of URDF, whose products of inertia are I_xy = −∫ x y dm.
    pub inertia: [T; 6],
}

impl<T: Copy> Payload<T> {
    /// Mass, centre and inertia, one after the other.
    #[inline]
    #[must_use]
    pub const fn numbers(&self) -> [T; 10] {
        let ([x, y, z], [xx, xy, xz, yy, yz, zz]) = (self.center, self.inertia);
        [self.mass, x, y, z, xx, xy, xz, yy, yz, zz]
    }
}

impl<T: Scalar> Payload<T> {
    /// A point mass \[kg\] at `center` in the link's frame \[m\].
    #[inline]
    #[must_use]
    pub fn of_point(mass: T, center: [T; 3]) -> Self {
        let inertia = [T::constant(0.0); 6];
        Self {
            mass,
            center,
            inertia,
        }
    }
}
