//! Operation counts of generated functions, from the code generator.
//!
//! In: the text of a robot's file. Out: the facts and operation counts of the doc comments of generated code.

use homogen_codegen::description::{Name, read_text};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::expand::expand;
use homogen_codegen::module::{About, GeneratedFunction};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::OperationCount;
use homogen_codegen::space::Spaces;
use homogen_codegen::{Function, Real};

/// The model of a robot, and the operation count of each of its functions.
pub struct OperationCounts {
    /// The facts in the doc comments.
    pub about: About,
    /// The lists of coordinates, velocities, frames and others that arguments and results range over.
    pub spaces: Spaces,
    functions: Vec<GeneratedFunction>,
}

impl OperationCounts {
    /// The operation count of a function.
    ///
    /// # Panics
    /// Never: all functions have been counted.
    #[must_use]
    pub fn of(&self, function: Function) -> OperationCount {
        let generated = self.functions.iter();
        let mut generated = generated.filter(|generated| generated.functions == [function]);
        generated
            .next()
            .expect("all functions are counted")
            .operation_count
    }
}

/// Counts all functions of the robot in a file of that name and text.
///
/// # Errors
/// All errors of the description.
pub fn count(file: &str, text: &str, tip: &str) -> Result<OperationCounts, Errors> {
    let mut errors = Errors::new();
    let Some(description) = read_text(text, file, None, &mut errors) else {
        return Err(errors);
    };
    let tip = Name {
        text: tip.to_owned(),
        place: Place::Unknown,
    };
    let request = Request {
        tip: Some(tip),
        functions: Function::ALL.map(|function| vec![function]).into(),
        scalar: Real::Generic,
        ..Request::default()
    };
    let module = expand(&description, &request)?;
    Ok(OperationCounts {
        about: module.about,
        spaces: module.spaces,
        functions: module.functions,
    })
}
