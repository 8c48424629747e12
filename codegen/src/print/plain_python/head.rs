//! Head of a module of Python: comments, its documentation, and the robot's description of itself.
//!
//! In: a [`Module`], its functions with their names, and the request. Out: text before the functions.

use std::fmt::Write;

use super::body::{list, literal};
use super::names::STANDARD;
use crate::module::{GeneratedFunction, Module};
use crate::print::described::{
    CONFIGURATIONS, NameList, NumberList, limits, names, neutral, radii,
};
use crate::print::documentation;
use crate::print::python::{docstring, string};
use crate::wording::{code, visible};

/// Definition of the sign of a number, of which `math` has none.
pub(super) const SIGN_OF_A_NUMBER: &str = "

def _sign(a, library):
    \"\"\"The sign of a: -1, 0 or 1.\"\"\"
    return float(a > 0) - float(a < 0) if library is math else library.sign(a)
";

/// Comments, documentation and imports.
pub(super) fn head(
    module: &Module,
    functions: &[(&str, &GeneratedFunction)],
    asked: &str,
) -> String {
    let mut lines = documentation::head(module, asked);
    lines.push(format!("Needs: Python 3 with {}.", code(STANDARD)));
    for (name, generated) in functions {
        lines.extend(documentation::operation_count(generated, name));
    }
    let mut text = String::new();
    for line in &lines {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "# {}", visible(line));
    }
    let about = [
        format!("Kinematics and dynamics of the robot {}.", code(&module.about.robot)),
        String::new(),
        "A vector is anything whose entry k is `q[k]`: a list, a vector of a library, or an array whose first axis has the \
         entries, such as `q.T` of states in rows. Entries have +, -, * and /, and their sines are those of `library`: `math`, \
         `numpy`, `jax.numpy`, `torch`, `casadi`, `sympy`. Results are numbers, lists, and lists of rows; entries that are the \
         same for all states are floats."
            .to_owned(),
    ];
    let _ = write!(text, "{}\n\nimport {STANDARD}\n", docstring(&about, ""));
    text
}

/// Sizes, names, limits, configurations and base parameters.
pub(super) fn constants(module: &Module) -> String {
    let mut text = String::new();
    let mut constant = |name: &str, about: &[&str], value: &str| {
        text.push('\n');
        for line in about {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "#: {}", visible(line));
        }
        let _ = writeln!(text, "{} = {value}", name.to_uppercase());
    };
    let (coordinates, velocities) = (&module.spaces.coordinates, &module.spaces.velocities);
    constant(
        "nq",
        &["Number of coordinates."],
        &coordinates.len().to_string(),
    );
    constant(
        "nv",
        &["Number of degrees of freedom."],
        &velocities.len().to_string(),
    );
    for NameList { name, about, names } in names(module) {
        let names: Vec<String> = names.into_iter().map(string).collect();
        constant(name, &[about], &list(&names));
    }
    let numbers = limits(module).into_iter().chain([neutral(module)]);
    let numbers = numbers.chain(radii(module));
    for NumberList {
        name,
        about,
        numbers,
    } in numbers
    {
        constant(name, &[about], &numbers_of(&numbers));
    }
    if !module.configurations.is_empty() {
        let configurations = module.configurations.iter();
        let entries = configurations.map(|configuration| {
            let name = string(&configuration.name);
            format!("{name}: {}", numbers_of(&configuration.q))
        });
        let entries = entries.collect::<Vec<_>>().join(", ");
        constant(
            "configurations",
            &[CONFIGURATIONS],
            &format!("{{{entries}}}"),
        );
    }
    let values = module.base_parameters();
    if let Some(values) = values.filter(|values| !values.is_empty()) {
        let about = documentation::of_base_parameters(module);
        let about: Vec<&str> = about.iter().map(String::as_str).collect();
        constant("base_parameters", &about, &numbers_of(values));
    }
    text
}

fn numbers_of(numbers: &[f64]) -> String {
    let numbers = numbers.iter().map(|&number| match number {
        f64::INFINITY => format!("{STANDARD}.inf"),
        f64::NEG_INFINITY => format!("-{STANDARD}.inf"),
        finite => literal(finite),
    });
    list(&numbers.collect::<Vec<_>>())
}
