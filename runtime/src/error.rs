//! Errors of input data.
//!
//! In: numbers. Out: one enumeration that names the wrong quantity and its value. Functions that check
//! return it; functions that do not check say so in their documentation; none panics.

use crate::scalar::Real;
use core::fmt::{self, Display, Formatter};

/// An error of input data, with the wrong quantity and its value, as `f64` for every type of scalar.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number is infinite or NaN.
    NotFinite {
        /// The name of the quantity.
        quantity: &'static str,
        /// The number.
        value: f64,
    },
    /// A 3×3 block is not a rotation.
    NotRotation {
        /// The largest entry of |RᵗR − I|, or the determinant if that is not positive.
        value: f64,
    },
    /// A vector is not of unit length.
    NotUnit {
        /// The name of the vector.
        quantity: &'static str,
        /// Its length.
        value: f64,
    },
    /// A mass is negative.
    NegativeMass {
        /// The mass \[kg\].
        value: f64,
    },
    /// An inertia is not physical: J is not positive semidefinite.
    NotPhysical {
        /// The quantity that must not be negative, or must be zero.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The data do not determine the result: coincident points, parallel lines, a singular system.
    Degenerate {
        /// The quantity that vanishes.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The parent of a joint of a chain does not come before the joint, or the body of a frame does not exist.
    ParentAfterChild {
        /// The name of the joint or frame.
        joint: &'static str,
        /// The index of the parent or body.
        parent: usize,
    },
    /// The mimicked joint of a mimic joint does not exist, or does not move along a screw with a coordinate of
    /// its own.
    InvalidMimic {
        /// The name of the mimic joint.
        joint: &'static str,
        /// The index of the mimicked joint.
        mimicked: usize,
    },
    /// The number of coordinates or velocities in the type of a chain is not that of its joints.
    WrongCount {
        /// `coordinates` or `velocities`.
        quantity: &'static str,
        /// The number in the type.
        stated: usize,
        /// The number of the joints.
        found: usize,
    },
    /// The limits of a coordinate are empty: crossed, NaN, or infinite to the wrong side.
    EmptyRange {
        /// The index of the coordinate.
        coordinate: usize,
        /// Its lower limit [rad, m].
        least: f64,
        /// Its upper limit [rad, m].
        most: f64,
    },
    /// A 4×4 matrix does not have the form of its type.
    NotOfForm {
        /// The form.
        quantity: &'static str,
        /// The largest deviation of an entry from it.
        value: f64,
    },
}

impl Display for Error {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { quantity, value } => {
                write!(f, "{quantity} is {value}, and must be finite")
            }
            Self::NotRotation { value } if value < 0.0 => {
                write!(f, "not a rotation: its determinant is {value}")
            }
            Self::NotRotation { value } => {
                write!(
                    f,
                    "not a rotation: an entry of RᵗR differs from I by {value:e}; \
                     `normalize::nearest_rotation` gives the nearest one"
                )
            }
            Self::NotUnit { quantity, value } => {
                write!(
                    f,
                    "{quantity} must be of unit length, but has length {value}"
                )
            }
            Self::NegativeMass { value } => {
                write!(f, "the mass is {value} kg, and must not be negative")
            }
            Self::NotPhysical { quantity, value } => {
                write!(f, "non-physical inertia: {quantity} is {value:e}")
            }
            Self::Degenerate { quantity, value } => {
                write!(
                    f,
                    "the data do not determine the result: {quantity} is {value:e}"
                )
            }
            Self::ParentAfterChild { joint, parent } => {
                write!(
                    f,
                    "\"{joint}\": there is no joint {parent} before it; list parents first"
                )
            }
            Self::InvalidMimic { joint, mimicked } => {
                write!(
                    f,
                    "mimic joint \"{joint}\": the mimicked joint {mimicked} must be `Motion::Along`, with a \
                     coordinate of its own"
                )
            }
            Self::WrongCount {
                quantity,
                stated,
                found,
            } => {
                write!(
                    f,
                    "the type of the chain has {stated} {quantity}, its joints have {found}"
                )
            }
            Self::EmptyRange {
                coordinate,
                least,
                most,
            } => {
                write!(
                    f,
                    "empty limits of coordinate {coordinate}: from {least} to {most}"
                )
            }
            Self::NotOfForm { quantity, value } => {
                write!(
                    f,
                    "not of the form {quantity}: an entry differs by {value:e}"
                )
            }
        }
    }
}

impl core::error::Error for Error {}

/// Rejects NaN and infinity.
pub(crate) fn finite<'a, T: Real + 'a>(
    quantity: &'static str,
    values: impl IntoIterator<Item = &'a T>,
) -> Result<(), Error> {
    match values.into_iter().find(|x| !x.is_finite()) {
        Some(x) => Err(Error::NotFinite {
            quantity,
            value: x.to_f64(),
        }),
        None => Ok(()),
    }
}
