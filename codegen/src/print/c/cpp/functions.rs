//! Functions in C++: templates over the types of their arguments, which return arrays.

use std::fmt::Write;

use crate::formulation::Sines;
use crate::module::{GeneratedFunction, Module};
use crate::print::Fields;
use crate::print::c::COptions;
use crate::print::c::body::{body, of_step};
use crate::print::c::comments::comment;
use crate::print::c::declarations::{argument_lengths, lengths, number, results};
use crate::print::c::names::symbols;
use crate::print::documentation::{self, SineAngles};
use crate::print::steps::{ConfigurationFunction, has_angles};
use crate::space::{Quantity, Variable};

/// All functions.
pub(super) fn text(module: &Module, options: &COptions<'_>, angles: &SineAngles) -> String {
    let mut text = String::new();
    for (generated, name) in module.functions.iter().zip(symbols(module, options.prefix)) {
        let about =
            documentation::of_function(module, generated, Some((angles, options.order)), None);
        let fields = Fields::Own(&module.parameters);
        // Functions are whole, so that no section needs a name.
        let body = body(module, (generated, fields), options, &mut str::to_owned);
        let results = members(module, generated);
        let arguments = generated.arguments(&module.spaces);
        let arguments = arguments
            .iter()
            .map(|&of| (of.name(), argument_lengths(of, &module.spaces)));
        let function = CppFunction {
            name: &name,
            arguments: arguments.collect(),
            results,
        };
        text.push_str(&function.structure());
        text.push_str(&comment(&about));
        text.push_str(&function.text(module, &body.text));
    }
    for &step in ConfigurationFunction::of(module) {
        let about = documentation::of_step(module, step, Some(angles));
        let body = of_step(step, module, options);
        let length = |space| vec![module.spaces.len(space)];
        let arguments = step
            .arguments()
            .iter()
            .map(|&(name, space)| (name, length(space)));
        let name = step.name().to_owned();
        let function = CppFunction {
            name: step.name(),
            arguments: arguments.collect(),
            results: vec![(name.clone(), name, length(step.result()))],
        };
        text.push_str(&comment(&about));
        text.push_str(&function.text(module, &body.text));
    }
    text
}

/// A call of the first function at the neutral configuration, at rest and with fields of zero, without its namespace; empty
/// if there is no function.
#[must_use]
pub fn call(module: &Module) -> String {
    let names = symbols(module, "").into_iter();
    let Some((generated, name)) = module.functions.iter().zip(names).next() else {
        return String::new();
    };
    let robot = (!module.parameters.is_empty()).then(|| "Robot<>{}".to_owned());
    let number = number(module.scalar);
    let arguments = generated.arguments(&module.spaces).into_iter();
    let arguments = arguments.map(|argument| match argument {
        Variable::Q => "NEUTRAL".to_owned(),
        _ => array(number, &argument_lengths(argument, &module.spaces)) + "{}",
    });
    let all: Vec<String> = robot.into_iter().chain(arguments).collect();
    format!("{name}({})", all.join(", "))
}

/// A function and the lengths of its arrays.
struct CppFunction<'f> {
    name: &'f str,
    arguments: Vec<(&'f str, Vec<usize>)>,
    /// Name in the body, name of the member, and lengths of each result.
    results: Vec<(String, String, Vec<usize>)>,
}

/// Results with their names in the body and in the struct.
fn members(module: &Module, generated: &GeneratedFunction) -> Vec<(String, String, Vec<usize>)> {
    let named = results(&generated.functions);
    let lengths_of = |quantity: &Quantity| lengths(quantity, &module.spaces);
    let parts = generated
        .functions
        .iter()
        .flat_map(|function| function.result().parts());
    let is_one = generated.functions.len() == 1;
    let members = named
        .into_iter()
        .zip(parts)
        .map(|((name, quantity), (part, _))| {
            let member = part
                .filter(|_| is_one)
                .map_or_else(|| name.clone(), str::to_owned);
            (name, member, lengths_of(&quantity))
        });
    members.collect()
}

/// `std::array<std::array<T, 3>, 2>` for the number `T`.
fn array(number: &str, lengths: &[usize]) -> String {
    let inner = lengths.iter().rev();
    inner.fold(number.to_owned(), |of, length| {
        format!("std::array<{of}, {length}>")
    })
}

impl CppFunction<'_> {
    /// Name of the struct of several results.
    fn structure_name(&self) -> String {
        format!("{}_results", self.name)
    }

    /// The struct of several results.
    fn structure(&self) -> String {
        if self.results.len() == 1 {
            return String::new();
        }
        let mut text = format!("template <class T>\nstruct {} {{\n", self.structure_name());
        for (_, member, lengths) in &self.results {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "    {} {member};", array("T", lengths));
        }
        text + "};\n\n"
    }

    /// The definition around a body.
    fn text(&self, module: &Module, body: &str) -> String {
        let has_fields = !module.parameters.is_empty();
        let mut types = Vec::new();
        let mut parameters = Vec::new();
        let mut scalars = Vec::new();
        if has_fields {
            types.push("class P".to_owned());
            parameters.push("const Robot<P>& robot".to_owned());
            scalars.push("P".to_owned());
        }
        let mut checks = String::new();
        for (name, lengths) in &self.arguments {
            let kind = format!("{}{}", name[..1].to_uppercase(), &name[1..]);
            types.push(format!("class {kind}"));
            parameters.push(format!("const {kind}& {name}"));
            let first = "[0]".repeat(lengths.len());
            scalars.push(format!("decltype({name}{first})"));
            // Writing to a string cannot fail.
            let _ = writeln!(checks, "    detail::check<{}, {kind}>();", lengths[0]);
        }
        let (types, parameters, scalars) =
            (types.join(", "), parameters.join(", "), scalars.join(", "));
        let template = match &*types {
            "" => "inline ".to_owned(),
            types => format!("template <{types}>\n"),
        };
        let scalar = format!("    using T = detail::scalar<{scalars}>;\n");
        let mut locals = String::new();
        let value = if let [(name, _, lengths)] = &*self.results {
            let _ = writeln!(locals, "    {} {name};", array("T", lengths));
            name.clone()
        } else {
            let result = format!("{}<T> result", self.structure_name());
            let _ = writeln!(locals, "    {result};");
            for (name, member, _) in &self.results {
                let _ = writeln!(locals, "    auto& {name} = result.{member};");
            }
            "result".to_owned()
        };
        let sines = if module.sines == Sines::Platform && has_angles(module) {
            "    using std::cos;\n    using std::sin;\n"
        } else {
            ""
        };
        format!(
            "{template}auto {}({parameters})\n{{\n{scalar}{checks}{sines}{locals}{body}    return {value};\n}}\n\n",
            self.name
        )
    }
}
