//! Names of a module of Python.
//!
//! In: a [`Module`]. Out: reserved names, and the names of fields as parameters.

use crate::module::Module;
use crate::print::python::unscoped;
use crate::schedule::Names;
use crate::space::Variable;

/// Parameter for the module that has sines.
pub(super) const LIBRARY: &str = "library";

/// The module that is meant where a call names none.
pub(super) const STANDARD: &str = "math";

/// Private function for the sign of a number.
pub(super) const SIGN: &str = "_sign";

/// Names that no function of the state may have.
pub(super) fn of_module() -> Names {
    let mut names = unscoped();
    for own in [STANDARD, "integrate", "difference", "normalize"] {
        names.take(own);
    }
    names
}

/// Names that no value of a function may have.
pub(super) fn of_function() -> Names {
    let mut names = unscoped();
    for own in [LIBRARY, SIGN, "range"] {
        names.take(own);
    }
    names
}

/// Parameters for fields, the same in every function: no entry of an argument has such a name.
pub(super) fn of_fields(module: &Module) -> Vec<String> {
    let mut names = of_function();
    for argument in Variable::ALL {
        names.take(argument.name());
        for entry in 1..=module.spaces.len(argument.space()) {
            names.take(&format!("{}_{entry}", argument.name()));
        }
    }
    let fields = module.parameters.iter();
    fields.map(|field| names.fresh(&field.name())).collect()
}
