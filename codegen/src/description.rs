//! Descriptions of robots as the user wrote them, before anything is derived.
//!
//! In: a URDF, xacro, MJCF or SDF file, a Denavit–Hartenberg table, or tokens. Out: a [`Description`] whose numbers
//! and names know their place. It never merges, drops, orders or repairs anything, and checks only
//! what can be seen in one item alone; what takes two items belongs to the chain stage.

pub mod attributes;
mod axis;
#[cfg(test)]
mod changed;
mod constant;
pub mod denavit_hartenberg;
mod file;
pub(crate) mod fingerprint;
mod format;
#[cfg(feature = "formats")]
pub(crate) mod fresh;
mod given;
pub mod inline;
mod item;
mod kind;
mod load;
#[cfg(feature = "formats")]
pub mod mjcf;
mod names;
mod number;
mod position;
mod robot;
#[cfg(feature = "formats")]
pub mod sdf;
mod settings;
#[cfg(feature = "formats")]
pub(crate) mod spatial;
mod tokens;
mod unmodelled;
pub mod urdf;
#[doc(hidden)]
pub mod words;
#[cfg(feature = "formats")]
pub mod xacro;
mod xml;

#[cfg(feature = "formats")]
pub use self::file::expand_file;
pub use self::file::{is_utf_16, read_bytes, read_bytes_in, read_file, read_file_with, read_text};
pub use self::format::FileFormat;
pub use self::given::Given;
pub use self::item::Item;
pub use self::robot::{
    Axis, Collision, Configuration, Description, Inertial, Joint, JointId, Limits, Link, LinkId,
    Loop, Mimic, Source, Sphere, Step,
};
pub(crate) use self::settings::HOW_TO_ASK;
pub use self::unmodelled::{Modelled, Unmodelled};
#[doc(hidden)]
pub use self::xml::LARGEST_FILE;
pub use crate::joint::JointKind;
pub use crate::name::Name;
pub use crate::number::Number;
