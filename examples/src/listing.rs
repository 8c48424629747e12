//! The generated function that README and guide show.
//!
//! In: the two-link arm of `robots/`. Out: its inverse dynamics as `homogen inspect` prints it.

use homogen_codegen::Function;
use homogen_codegen::description::read_text;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::print::rust::{FormattedSource, Item, Library, methods};
use homogen_codegen::request::Request;

const URDF: &str = include_str!("../../robots/two_link.urdf");

/// The method with its doc comment, formatted.
///
/// # Errors
/// All errors of the description.
pub fn inverse_dynamics_of_two_links() -> Result<String, Errors> {
    let mut errors = Errors::new();
    let Some(robot) = read_text(URDF, "two_link.urdf", None, &mut errors) else {
        return Err(errors);
    };
    let request = Request {
        functions: vec![vec![Function::InverseDynamics]],
        ..Request::default()
    };
    let module = expand(&robot, &request)?;
    let methods = methods(&module, &Item::named_after("two link"), &Library::default());
    Ok(FormattedSource::new("", &methods).to_string())
}
