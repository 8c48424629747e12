//! Plain Python: functions over operators, sines and cosines, for numbers of any type.
//!
//! In: a [`Module`] and the order of six numbers. Out: a module of Python as text that imports `math` alone. Functions take
//! what can be indexed and return numbers and lists; the caller names the library that has the sines of its numbers, so that
//! floats, arrays and symbols run through the same code. Operations and their order are those of the file in C.

mod body;
mod function;
mod head;
mod names;
#[cfg(test)]
mod tests;

use super::arrays::Order;
use super::steps::{ConfigurationFunction, has_signs};
use crate::module::Module;
use function::{of_state, of_step};

/// Options of the output.
#[derive(Clone, Copy, Debug)]
pub struct PythonOptions<'a> {
    /// The request.
    pub asked: &'a str,
    /// Order of the two halves of twists, wrenches and momenta.
    pub order: Order,
}

/// The module of Python.
#[must_use]
pub fn print(module: &Module, options: &PythonOptions<'_>) -> String {
    let mut names = names::of_module();
    let functions = module.functions.iter();
    let named = functions.map(|generated| (names.fresh(&generated.name()), generated));
    let named: Vec<_> = named.collect();
    let of_state = named
        .iter()
        .map(|(name, generated)| of_state(module, (name, generated), options.order));
    let steps = ConfigurationFunction::of(module).iter();
    // The neutral configuration is a constant.
    let steps = steps.filter(|step| !step.arguments().is_empty());
    let of_steps = steps.map(|&step| of_step(module, step));
    let counted: Vec<_> = named.iter().map(|(name, of)| (&**name, *of)).collect();
    let mut text = head::head(module, &counted, options.asked);
    text.push_str(&head::constants(module));
    if has_signs(module) {
        text.push_str(head::SIGN_OF_A_NUMBER);
    }
    for function in of_state.chain(of_steps) {
        text.push_str("\n\n");
        text.push_str(&function);
    }
    text
}
