//! What generated functions cost, counted on the programs that the macro prints.
//!
//! In: the text of a robot's file. Out: the facts and prices that stand in the doc comments. It calls
//! the code generator as the derive does, and counts nothing itself.

use homogen_codegen::description::{Name, read_text};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::expand::expand;
use homogen_codegen::module::{About, GeneratedFunction};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::Price;
use homogen_codegen::space::Spaces;
use homogen_codegen::{Function, Real};

/// What is modelled of a robot, and the price of every function of it.
pub struct Prices {
    /// What the doc comments say of it.
    pub about: About,
    /// What its arguments and results are over.
    pub spaces: Spaces,
    functions: Vec<GeneratedFunction>,
}

impl Prices {
    /// The price of a function.
    ///
    /// # Panics
    /// Never: all functions have been counted.
    #[must_use]
    pub fn of(&self, function: Function) -> Price {
        let generated = self.functions.iter();
        let mut generated = generated.filter(|generated| generated.functions == [function]);
        generated.next().expect("all functions are listed").price
    }
}

/// Counts all functions of the robot in a file of that name and text.
///
/// # Errors
/// All the mistakes of the description.
pub fn count(file: &str, text: &str, tip: &str) -> Result<Prices, Errors> {
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
    Ok(Prices {
        about: module.about,
        spaces: module.spaces,
        functions: module.functions,
    })
}
