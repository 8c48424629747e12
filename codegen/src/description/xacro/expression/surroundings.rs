//! Properties, arguments and files: all that an expression may use.

use super::value::{ScopeId, Value};
use crate::description::xacro::budget::Budget;
use crate::description::xacro::failure::Failure;

/// Access to the state of an expansion.
pub(in crate::description::xacro) trait Surroundings {
    fn budget(&mut self) -> &mut Budget;

    /// The value of a property that is visible here.
    fn property(&mut self, name: &str) -> Result<Option<Value>, Failure>;

    /// The value of a property of a namespace.
    fn property_of(&mut self, scope: ScopeId, name: &str) -> Result<Option<Value>, Failure>;

    /// The names of all visible properties, for hints.
    fn names(&self) -> Vec<String>;

    /// The value of an argument.
    fn argument(&mut self, name: &str) -> Result<Value, Failure>;

    /// The content of a YAML file.
    fn yaml(&mut self, file: &str) -> Result<Value, Failure>;

    /// A path from the folder of the file that is read at the moment.
    fn full_path(&mut self, file: &str) -> Result<Value, Failure>;

    /// Reports a warning of the file's author.
    fn warn(&mut self, message: String);
}
