//! What can be wrong with numbers that were handed in.
//!
//! In: nothing, or numbers that must be finite. Out: one enumeration that names the quantity and its
//! value. Functions that check return it; functions that do not check say so in their documentation,
//! and none panics.

use crate::scalar::Real;
use core::fmt::{self, Display, Formatter};

/// Why numbers were refused. Values are given as f64 whatever the type they were computed in.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number is infinite or NaN.
    NotFinite {
        /// What it was meant to be.
        quantity: &'static str,
        /// The number.
        value: f64,
    },
    /// A 3×3 block is not a rotation.
    NotRotation {
        /// The largest entry of |RᵗR − I|, or the determinant where that is not positive.
        value: f64,
    },
    /// A vector is not of unit length.
    NotUnit {
        /// What it was meant to be.
        quantity: &'static str,
        /// Its length.
        value: f64,
    },
    /// A mass is negative.
    NegativeMass {
        /// The mass \[kg\].
        value: f64,
    },
    /// No body has this inertia: J is not positive semidefinite.
    NotPhysical {
        /// What is negative.
        quantity: &'static str,
        /// By how much.
        value: f64,
    },
    /// The data do not determine the result: coincident points, parallel lines, a singular system.
    Degenerate {
        /// What vanishes.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A joint of a chain stands on a body that does not come before its own, or a frame on none of its
    /// bodies.
    NotATree {
        /// The name of the joint or frame.
        joint: &'static str,
        /// The index of what it stands on.
        parent: usize,
    },
    /// A joint of a chain follows another that is not there or does not move along a screw by a coordinate
    /// of its own.
    NotALeader {
        /// The name of the joint that follows.
        joint: &'static str,
        /// The index of the one that it follows.
        leader: usize,
    },
    /// The joints of a chain do not have as many coordinates or velocities as its type says.
    WrongCount {
        /// Which of the two.
        quantity: &'static str,
        /// How many the type says.
        stated: usize,
        /// How many the joints have.
        found: usize,
    },
    /// No number is within the limits of a coordinate: they are crossed, NaN, or infinite to the wrong side.
    NoRange {
        /// The index of the coordinate.
        coordinate: usize,
        /// Its lower limit [rad, m].
        least: f64,
        /// Its upper limit [rad, m].
        most: f64,
    },
    /// A 4×4 matrix is not of the form asked for.
    NotOfForm {
        /// The form.
        quantity: &'static str,
        /// The largest amount by which an entry differs from it.
        value: f64,
    },
}

impl Display for Error {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { quantity, value } => write!(f, "{quantity} is {value}"),
            Self::NotRotation { value } if value < 0.0 => {
                write!(f, "not a rotation: its determinant is {value}")
            }
            Self::NotRotation { value } => {
                write!(f, "not a rotation: it fails orthogonality by {value:e}")
            }
            Self::NotUnit { quantity, value } => {
                write!(
                    f,
                    "{quantity} must be of unit length, but has length {value}"
                )
            }
            Self::NegativeMass { value } => write!(f, "the mass is {value} kg"),
            Self::NotPhysical { quantity, value } => {
                write!(f, "no body has this inertia: {quantity} is {value:e}")
            }
            Self::Degenerate { quantity, value } => {
                write!(
                    f,
                    "the data do not determine the result: {quantity} is {value:e}"
                )
            }
            Self::NotATree { joint, parent } => {
                write!(
                    f,
                    "{joint} stands on body {parent}, which does not come before it"
                )
            }
            Self::NotALeader { joint, leader } => {
                write!(
                    f,
                    "{joint} follows joint {leader}, which does not move along a screw by a coordinate \
                     of its own"
                )
            }
            Self::WrongCount {
                quantity,
                stated,
                found,
            } => {
                write!(f, "the joints have {found} {quantity}, not {stated}")
            }
            Self::NoRange {
                coordinate,
                least,
                most,
            } => {
                write!(
                    f,
                    "no number is within the limits of coordinate {coordinate}, {least} and {most}"
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

/// Refuses NaN and infinity.
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
