//! Declarations of C.
//!
//! In: a [`Module`] and a prefix. Out: the struct of fields, the parameters of functions, and the entries of spaces as
//! constants.

use std::fmt::Write;

use super::comments::{comment, harmless};
use super::literals::literal;
use super::names::{self, constant, constants, own};
use crate::function::Function;
use crate::module::{GeneratedFunction, Module};
use crate::print::documentation;
use crate::print::steps::ConfigurationFunction;
use crate::real::Real;
use crate::request::Parameter;
use crate::space::{ACTION, Quantity, Space, Spaces, Variable};
use crate::wording::code;

/// The scalar type.
pub(super) const fn number(real: Real) -> &'static str {
    match real {
        Real::F32 => "float",
        Real::F64 | Real::Generic => "double",
    }
}

/// The struct of fields, if there are fields.
pub(super) fn structure(text: &mut String, module: &Module, prefix: &str) {
    if module.parameters.is_empty() {
        return;
    }
    let number = number(module.scalar);
    text.push_str("typedef struct {\n");
    for (parameter, member) in module.parameters.iter().zip(members(module)) {
        let about = documentation::of_field(&parameter.target);
        let size = match parameter.target.entries() {
            1 => String::new(),
            entries => format!("[{entries}]"),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "    {number} {member}{size}; /* {} */",
            harmless(&about)
        );
    }
    let _ = writeln!(text, "}} {};\n", own(prefix, "robot"));
}

/// Member of the struct of a prepared robot.
pub(super) const VALUES: &str = "values";

/// The struct of a prepared robot, if it was requested.
pub(super) fn prepared(text: &mut String, module: &Module, prefix: &str) {
    let Some(prepared) = &module.prepared else {
        return;
    };
    let (number, count) = (number(module.scalar), prepared.names.len());
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "typedef struct {{\n    {number} {VALUES}[{count}]; /* Results of {}. */\n}} {};\n",
        own(prefix, "prepare"),
        own(prefix, "prepared")
    );
}

/// Parameters of the function that fills it.
pub(super) fn of_prepare(prefix: &str) -> String {
    let [robot, prepared] = ["robot", "prepared"].map(|name| own(prefix, name));
    format!("const {robot} *robot, {prepared} *prepared")
}

/// Values of the base parameters, if the base regressor was requested.
pub(super) fn base_parameters(text: &mut String, module: &Module, prefix: &str) {
    let values = module.base_parameters();
    let Some(values) = values.filter(|values| !values.is_empty()) else {
        return;
    };
    text.push_str(&comment(&documentation::of_base_parameters(module)));
    let numbers = values.iter().map(|&value| literal(value, module.scalar));
    let numbers: Vec<String> = numbers.collect();
    let (number, count) = (number(module.scalar), values.len());
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "static const {number} {}[{count}] = {{{}}};\n",
        own(prefix, "base_parameters"),
        numbers.join(", ")
    );
}

/// Names of the fields.
///
/// They may differ from those of the struct in another language: only their order matters.
pub(super) fn members(module: &Module) -> Vec<String> {
    names::members(module.parameters.iter().map(Parameter::name))
}

/// Numbers and indices of coordinates, velocities and residuals of loops.
pub(super) fn indices(text: &mut String, module: &Module, prefix: &str) {
    let mut spaces = vec![(Space::Coordinates, "Q"), (Space::Velocities, "V")];
    if module.spaces.len(Space::Constraints) > 0 {
        spaces.push((Space::Constraints, "C"));
    }
    for (space, letter) in spaces {
        let variables = Variable::ALL.into_iter();
        // Entries of a change are those of what changes.
        let variables = variables.filter(|of| of.space() == space && !of.is_change());
        let variables: Vec<_> = variables
            .filter(|&of| of != Variable::Weights || has_argument(module, of))
            .collect();
        let mut letters: Vec<_> = variables.iter().map(|of| of.letter()).collect();
        if variables.is_empty() {
            letters.push("the residuals of loops");
        }
        // Writing to a string cannot fail.
        let _ = writeln!(text, "/* Entries of {}. */\nenum {{", letters.join(", "));
        let names = constants(&module.spaces, space, (prefix, letter));
        for (name, entry) in names.iter().zip(module.spaces.entries(space)) {
            let units = variables.iter().map(|of| of.unit(entry.kind));
            let units: Vec<_> = units.filter(|unit| *unit != "1").collect();
            let within = if units.is_empty() { "" } else { " in " };
            let about = format!("{}{within}{}", code(&entry.name), units.join(", "));
            let about = harmless(&about);
            let _ = writeln!(text, "    {name}, /* {about} */");
        }
        let count = constant(prefix, &format!("n{letter}"));
        let _ = writeln!(text, "    {count}\n}};\n");
    }
}

/// True if some function has the argument.
fn has_argument(module: &Module, variable: Variable) -> bool {
    let functions = module.functions.iter();
    let mut functions = functions.flat_map(|generated| &generated.functions);
    functions.any(|function| function.arguments().contains(&variable))
}

/// `const float q[6], float gravity[6]`, after a pointer to the struct with this name if there are fields.
pub(super) fn parameters(
    module: &Module,
    generated: &GeneratedFunction,
    (prefix, structure): (&str, &str),
) -> String {
    let spaces = &module.spaces;
    let arguments = generated.arguments(spaces).into_iter();
    let arguments =
        arguments.map(|argument| declarator(argument.name(), &argument_lengths(argument, spaces)));
    let results = results(&generated.functions).into_iter();
    let results = results.map(|(name, quantity)| declarator(&name, &lengths(&quantity, spaces)));
    pointers(module, (prefix, structure), arguments, results)
}

/// The same for a function of configurations.
pub(super) fn of_step(step: ConfigurationFunction, module: &Module, prefix: &str) -> String {
    let row = |(name, space): (&str, Space)| declarator(name, &[module.spaces.len(space)]);
    let arguments = step.arguments().iter().copied().map(row);
    let result = row((step.name(), step.result()));
    pointers(module, (prefix, "robot"), arguments, [result].into_iter())
}

fn pointers(
    module: &Module,
    (prefix, structure): (&str, &str),
    arguments: impl Iterator<Item = String>,
    results: impl Iterator<Item = String>,
) -> String {
    let number = number(module.scalar);
    let robot =
        (!module.parameters.is_empty()).then(|| format!("const {} *robot", own(prefix, structure)));
    let arguments = arguments.map(|argument| format!("const {number} {argument}"));
    let results = results.map(|result| format!("{number} {result}"));
    let all: Vec<_> = robot.into_iter().chain(arguments).chain(results).collect();
    all.join(", ")
}

/// Results of functions with their names: that of the function, and of the quantity if it returns several.
pub(in crate::print) fn results(functions: &[Function]) -> Vec<(String, Quantity)> {
    let results = functions.iter().flat_map(|function| {
        let name = function.name();
        let parts = function.result().parts();
        parts.map(move |(part, quantity)| match part {
            Some(part) => (format!("{name}_{part}"), quantity),
            None => (name.to_owned(), quantity),
        })
    });
    results.collect()
}

/// Lengths of the array of a result, the outermost first; empty for a number.
pub(super) fn lengths(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    [&*quantity.lengths(spaces), quantity.entity.dimensions()].concat()
}

/// The same for an argument.
pub(super) fn argument_lengths(argument: Variable, spaces: &Spaces) -> Vec<usize> {
    match argument {
        Variable::Actions => vec![spaces.actions(), ACTION.len()],
        _ => vec![spaces.len(argument.space())],
    }
}

/// `forward_kinematics[3][4]`; a pointer for a number.
pub(super) fn declarator(name: &str, lengths: &[usize]) -> String {
    if lengths.is_empty() {
        return format!("*{name}");
    }
    lengths
        .iter()
        .fold(name.to_owned(), |name, length| format!("{name}[{length}]"))
}
