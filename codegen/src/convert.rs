//! Conversion: writes a description as URDF or MJCF.
//!
//! In: a [`Description`], read from whatever format. Out: a text with the same joints, coordinates, inertias, limits and
//! actuators, as they were understood: right angles in full, quaternions normalised. What the format cannot say is
//! written by auxiliary links and joints where they give the same motion; otherwise it is an error if it moves bodies,
//! and a warning if it does not.

mod actuators;
mod elementary;
mod markup;
mod mjcf;
mod numbers;
mod placement;
mod urdf;

use crate::description::{Description, Modelled};
use crate::error::{Diagnostic, Errors};

/// A format to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// The Unified Robot Description Format.
    Urdf,
    /// The format of MuJoCo.
    Mjcf,
}

/// A written description.
#[derive(Clone, Debug)]
pub struct Converted {
    /// The text of the file.
    pub text: String,
    /// Parts of the description that the text lacks, and parts of the text that few programs read.
    pub warnings: Vec<Diagnostic>,
}

/// Writes a description.
///
/// # Errors
/// A description that is no tree, and motions that the format cannot say.
pub fn convert(description: &Description, target: OutputFormat) -> Result<Converted, Errors> {
    let mut converted = match target {
        OutputFormat::Urdf => urdf::write(description)?,
        OutputFormat::Mjcf => mjcf::write(description)?,
    };
    let written = Modelled {
        friction: true,
        armature: true,
        has_rotor: &|_| true,
    };
    let missing = description.unmodelled.warnings(&written);
    converted.warnings.splice(0..0, missing);
    Ok(converted)
}

#[cfg(test)]
mod tests;
