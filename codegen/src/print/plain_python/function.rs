//! A function in Python: its parameters, documentation, loads and results.
//!
//! In: a function of a [`Module`]. Out: its definition. Arguments are read once, by their indices along the first axis.

use super::body::{PythonWriter, list, literal, nested};
use super::names::{LIBRARY, STANDARD, of_fields, of_function};
use crate::module::{GeneratedFunction, Module};
use crate::print::arrays::{self, Array, Order, Signature};
use crate::print::expression::Spelling;
use crate::print::python::docstring;
use crate::print::steps::ConfigurationFunction;
use crate::print::walk::walk;
use crate::print::{Fields, documentation};
use crate::schedule::{Entries, Length, Readable, Routine, Stored};
use crate::space::{ACTION, Variable};
use crate::wording::code;

/// A function of the state with its name.
pub(super) fn of_state(
    module: &Module,
    (name, generated): (&str, &GeneratedFunction),
    order: Order,
) -> String {
    let spaces = &module.spaces;
    let mut generated = generated.clone();
    arrays::arrange_results(&mut generated, spaces, order);
    let arguments = generated.arguments(spaces);
    let fields = of_fields(module);
    let mut names = of_function();
    for (field, parameter) in fields.iter().zip(&module.parameters) {
        // A number has the name of its parameter where it can.
        if parameter.target.entries() > 1 {
            names.take(field);
        }
    }
    let readable = Readable {
        arguments: &arguments,
        spaces,
        // Symbolic numbers gain nothing by loops.
        limbs: &[],
        fields: &Fields::Own(&module.parameters).entries(),
    };
    let program = (&generated.program, Length::UNBOUNDED);
    let routine = Routine::of(program, &readable, names, Stored::AtTheEnd);
    let frame = generated.frame.as_deref().unwrap_or(&module.about.tip);
    let signatures = generated.functions.iter();
    let signatures: Vec<Signature> = signatures
        .map(|&function| arrays::signature(module, function, frame))
        .collect();
    let results: Vec<Array> = results(&signatures);
    let mut lines = documentation::of_function(module, &generated, None, None);
    lines.push(String::new());
    lines.push(returned(&results));
    if signatures.iter().any(|signature| signature.has_order) {
        lines.push(format!("Order of six numbers: {}.", halves(order)));
    }
    let mut writer = PythonWriter::default();
    load_numbers(&mut writer, &fields, &routine.fields);
    for (field, entries) in fields.iter().zip(&routine.fields) {
        if entries.len() > 1 {
            load(&mut writer, field, entries);
        }
    }
    for (argument, entries) in &routine.arguments {
        match argument {
            Variable::Actions => {
                let actions = entries.chunks(ACTION.len()).enumerate();
                for (action, entries) in actions {
                    let entries = ordered(entries, order);
                    load(
                        &mut writer,
                        &format!("{}[{action}]", argument.name()),
                        &entries,
                    );
                }
            }
            Variable::Wrench => load(&mut writer, argument.name(), &ordered(entries, order)),
            _ => load(&mut writer, argument.name(), entries),
        }
    }
    let arguments = arguments.iter().map(|argument| argument.name());
    definition(
        (name, &parameter_list(arguments, &fields)),
        &lines,
        writer,
        (&routine, &results),
    )
}

/// A function of configurations.
pub(super) fn of_step(module: &Module, step: ConfigurationFunction) -> String {
    let mut names = of_function();
    let arguments = step.arguments().iter().map(|(name, _)| *name);
    arguments.clone().for_each(|argument| names.take(argument));
    let routine = step.routine(module, names);
    let mut writer = PythonWriter::default();
    for (argument, entries) in arguments.clone().zip(&routine.fields) {
        load(&mut writer, argument, entries);
    }
    let result = Array {
        name: step.name().to_owned(),
        shape: vec![module.spaces.len(step.result())],
        len: module.spaces.len(step.result()),
        below: None,
        units: Vec::new(),
        is_change: false,
    };
    let mut lines = documentation::of_step(module, step, None);
    let results = [result];
    lines.extend([String::new(), returned(&results)]);
    definition(
        (step.name(), &parameter_list(arguments, &[])),
        &lines,
        writer,
        (&routine, &results),
    )
}

/// The results of functions one after the other.
fn results(signatures: &[Signature]) -> Vec<Array> {
    let results = signatures.iter();
    results
        .flat_map(|signature| signature.results.iter().cloned())
        .collect()
}

fn definition(
    (name, parameters): (&str, &str),
    about: &[String],
    mut writer: PythonWriter,
    (routine, results): (&Routine, &[Array]),
) -> String {
    walk(&mut writer, &routine.statements);
    let mut values = routine.results.iter().map(|value| writer.read(value));
    let results = results.iter().map(|of| {
        let below = of.below.iter().flatten();
        let below = below.map(|&entry| literal(entry));
        let entries: Vec<String> = values.by_ref().take(of.len).chain(below).collect();
        shaped(&entries, &of.shape)
    });
    let results: Vec<String> = results.collect();
    writer.line(&match &*results {
        [one] => format!("return {one}"),
        several => format!("return {}", tuple(several)),
    });
    let about = docstring(about, "    ");
    let text = writer.text;
    format!("def {name}({parameters}):\n    {about}\n{text}")
}

/// Results in parentheses, each on lines of its own.
fn tuple(results: &[String]) -> String {
    let nested = nested(results);
    let inner = nested
        .strip_prefix('[')
        .and_then(|rest| rest.strip_suffix(']'));
    format!("({})", inner.expect("rows in brackets"))
}

/// Entries as a number, a list, or a list of rows.
fn shaped(entries: &[String], shape: &[usize]) -> String {
    match shape {
        [] => entries.concat(),
        [_] => list(entries),
        [0, ..] => "[]".to_owned(),
        [rows, inner @ ..] => {
            let each = entries.len() / rows;
            let row = |row: usize| shaped(&entries[row * each..(row + 1) * each], inner);
            nested(&(0..*rows).map(row).collect::<Vec<_>>())
        }
    }
}

/// Line about the form of results.
fn returned(results: &[Array]) -> String {
    let form = |of: &Array| match &*of.shape {
        [] => "a number".to_owned(),
        [count] => format!("a list of {count}"),
        [rows, columns] => format!("{rows} rows of {columns}"),
        [first, rest @ ..] => {
            let rest: Vec<String> = rest.iter().map(ToString::to_string).collect();
            format!("{first} lists of {}", rest.join(" by "))
        }
    };
    match results {
        [one] => format!("Returns {}.", form(one)),
        several => {
            let forms = several
                .iter()
                .map(|of| format!("{} ({})", code(&of.name), form(of)));
            format!("Returns {}.", forms.collect::<Vec<_>>().join(", "))
        }
    }
}

/// The entries of a wrench, c before f, in an order.
fn ordered(entries: &[Option<String>], order: Order) -> Entries {
    let mut entries = entries.to_vec();
    match order {
        Order::LinearFirst => entries.rotate_left(ACTION.len() / 2),
        Order::AngularFirst => {}
    }
    entries
}

/// The halves of twists, wrenches and momenta.
const fn halves(order: Order) -> &'static str {
    match order {
        Order::LinearFirst => "v, ω; f, c; ρ, γ",
        Order::AngularFirst => "ω, v; c, f; γ, ρ",
    }
}

/// `q, qd, library=math, *, payload`.
fn parameter_list<'a>(arguments: impl Iterator<Item = &'a str>, fields: &[String]) -> String {
    let mut list: Vec<String> = arguments.map(str::to_owned).collect();
    list.push(format!("{LIBRARY}={STANDARD}"));
    if !fields.is_empty() {
        list.push("*".to_owned());
        list.extend(fields.iter().cloned());
    }
    list.join(", ")
}

/// Binds fields of one number whose name in the function is not that of the parameter, all at once.
fn load_numbers(writer: &mut PythonWriter, parameters: &[String], fields: &[Entries]) {
    let numbers = parameters.iter().zip(fields);
    let other = numbers.filter_map(|(parameter, entries)| match &**entries {
        [Some(name)] if name != parameter => Some((&**name, &**parameter)),
        _ => None,
    });
    let (names, parameters): (Vec<&str>, Vec<&str>) = other.unzip();
    if !names.is_empty() {
        writer.line(&format!("{} = {}", names.join(", "), parameters.join(", ")));
    }
}

/// Binds the entries of a vector that are read.
fn load(writer: &mut PythonWriter, vector: &str, entries: &[Option<String>]) {
    let read = entries.iter().enumerate();
    let read = read.filter_map(|(k, name)| Some((k, name.as_deref()?)));
    let (places, names): (Vec<usize>, Vec<&str>) = read.unzip();
    match (&*places, &*names) {
        ([], _) => {}
        ([place], [name]) => writer.line(&format!("{name} = {vector}[{place}]")),
        _ => {
            let all = if places.len() == entries.len() {
                format!("range({})", entries.len())
            } else {
                let places: Vec<String> = places.iter().map(ToString::to_string).collect();
                format!("({})", places.join(", "))
            };
            writer.line(&format!(
                "{} = ({vector}[k] for k in {all})",
                names.join(", ")
            ));
        }
    }
}
