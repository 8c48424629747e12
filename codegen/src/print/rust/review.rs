//! Material for the reviewer of a Rust file.
//!
//! In: a [`Module`] with its [`Review`](crate::module::Review), and its struct. Out: text after the items: a module of
//! tests, and the origins of inertial numbers.

use std::fmt::Write;

use syn::ext::IdentExt;

use super::item::Item;
use super::library::Library;
use super::names::of_methods;
use crate::module::{GeneratedFunction, Module, TestVector};
use crate::print::c;
use crate::print::review;
use crate::real::Real;
use crate::schedule::Names;
use crate::space::{ACTION, Variable};
use crate::template;
use crate::wording::visible;

/// Text after the items: tests, and the origins of inertial numbers.
#[must_use]
pub fn appendix(module: &Module, item: &Item, library: &Library) -> String {
    let mut text = String::new();
    if let Library::Core(_) = library {
        text.push_str(&tests(module, item));
    }
    let origins = review::origins(module);
    if !origins.is_empty() {
        text.push('\n');
    }
    for line in origins {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "// {}", visible(&line));
    }
    text
}

/// Module with a test for each function.
fn tests(module: &Module, item: &Item) -> String {
    let vectors = module
        .review
        .as_ref()
        .map_or(&[][..], |review| &review.vectors);
    let mut text = String::new();
    if vectors.is_empty() {
        return text;
    }
    let number = match module.scalar {
        Real::F32 => "f32",
        Real::F64 | Real::Generic => "f64",
    };
    let robot = item.ident.to_string();
    // No struct has this name, so that the remaining words are names of the module.
    let mut own = words(&calls(module, vectors, "Self", number));
    let (name, used) = if own.clone().alone(&robot) == robot {
        (robot.clone(), robot)
    } else {
        let name = own.alone("Robot");
        let used = format!("{robot} as {name}");
        (name, used)
    };
    let of_tests = format!("{}vectors", c::prefix(&item.ident.unraw().to_string()));
    let words = [
        ("@module@", &*of_tests),
        ("@used@", &used),
        ("@number@", number),
    ];
    text.push_str(&template::filled(TESTS, &words));
    text.push_str(&calls(module, vectors, &name, number));
    text.push_str("}\n");
    text
}

/// All words of the module with these calls.
fn words(calls: &str) -> Names {
    let is_word = |letter: char| letter == '_' || letter.is_alphanumeric();
    let code = TESTS
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let mut names = Names::default();
    for line in code.chain(calls.lines()) {
        let words = line.split(|letter| !is_word(letter));
        words.for_each(|word| names.take(word));
    }
    names
}

/// Tests, one for each function.
fn calls(module: &Module, vectors: &[TestVector], robot: &str, number: &str) -> String {
    let mut text = String::new();
    let functions = module.functions.iter().zip(of_methods(module)).enumerate();
    for (function, (generated, method)) in functions {
        let own = vectors.iter().filter(|vector| vector.function == function);
        let calls: String = own
            .map(|vector| {
                call(
                    module,
                    (generated, vector),
                    (robot, &method.to_string()),
                    number,
                )
            })
            .collect();
        if !calls.is_empty() {
            // Writing to a string cannot fail.
            let _ = write!(text, "\n    #[test]\n    fn {method}() {{\n{calls}    }}\n");
        }
    }
    text
}

/// Statements that call a method and compare its results.
fn call(
    module: &Module,
    (generated, vector): (&GeneratedFunction, &TestVector),
    (robot, method): (&str, &str),
    number: &str,
) -> String {
    let mut text = String::new();
    let mut line = |line: &str| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "        {line}");
    };
    let written = |numbers: &[f64]| -> Vec<String> {
        let each = numbers.iter().map(|&value| of_type(value, module.scalar));
        each.collect()
    };
    for (argument, numbers) in &vector.arguments {
        let (kind, numbers) = match argument {
            Variable::Actions => {
                let each = numbers.chunks(ACTION.len());
                let each: Vec<String> = each
                    .map(|one| format!("[{}]", written(one).join(", ")))
                    .collect();
                (
                    format!("[[{number}; {}]; {}]", ACTION.len(), each.len()),
                    each,
                )
            }
            _ => (format!("[{number}; {}]", numbers.len()), written(numbers)),
        };
        line(&filled(
            &format!("let {}: {kind} = [", argument.name()),
            &numbers,
            "];",
        ));
    }
    let fields = module.parameters.iter().zip(&vector.fields);
    let fields: Vec<String> = fields
        .map(|(parameter, values)| match &*written(values) {
            [value] => format!("{}: {value}", parameter.field),
            values => format!("{}: [{}]", parameter.field, values.join(", ")),
        })
        .collect();
    let robot = if fields.is_empty() {
        robot.to_owned()
    } else {
        line(&filled(&format!("let robot = {robot} {{ "), &fields, " };"));
        "robot".to_owned()
    };
    let arguments = vector
        .arguments
        .iter()
        .map(|(of, _)| format!("&{}", of.name()));
    let arguments: Vec<String> = arguments.collect();
    line(&format!(
        "let found = {robot}.{method}({});",
        arguments.join(", ")
    ));
    let (mut expected, mut tolerances) = (&*vector.expected, &*vector.tolerances);
    for (place, quantity) in results(generated) {
        let size = quantity.size(&module.spaces);
        let (own, rest) = expected.split_at(size.min(expected.len()));
        let (most, others) = tolerances.split_at(size.min(tolerances.len()));
        (expected, tolerances) = (rest, others);
        let depth = quantity.over.len() + quantity.entity.dimensions().len();
        let each = match depth {
            0 => format!("core::iter::once(&{place})"),
            depth => format!("{place}.iter(){}", ".flatten()".repeat(depth - 1)),
        };
        let most = match most {
            [first, others @ ..] if others.iter().all(|other| other == first) => {
                format!("&[{first:?}; {size}]);")
            }
            most => {
                let most: Vec<String> = most.iter().map(|most| format!("{most:?}")).collect();
                filled("&[", &most, "]);")
            }
        };
        line(&filled(&format!("near({each}, &["), &written(own), "],"));
        line(&format!("    {most}"));
    }
    text
}

/// Expressions for the results of a function, with their quantities.
fn results(generated: &GeneratedFunction) -> Vec<(String, crate::space::Quantity)> {
    let several = generated.functions.len() > 1;
    let functions = generated.functions.iter().enumerate();
    let places = functions.flat_map(|(k, function)| {
        let place = if several {
            format!("found.{k}")
        } else {
            "found".to_owned()
        };
        let parts = function.result().parts();
        parts.map(move |(part, quantity)| match part {
            Some(part) => (format!("{place}.{part}"), quantity),
            None => (place.clone(), quantity),
        })
    });
    places.collect()
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the type is the purpose"
)]
fn of_type(value: f64, scalar: Real) -> String {
    match scalar {
        Real::F32 => format!("{:?}", value as f32),
        Real::F64 | Real::Generic => format!("{value:?}"),
    }
}

/// Items between brackets, as many on a line as fit.
fn filled(start: &str, items: &[String], end: &str) -> String {
    review::filled((start, "            "), items, end)
}

/// Head of the module, with placeholders between `@`.
const TESTS: &str = "
/// Expected results at a state or two, from dense 4×4 matrices of the description in 106 bits. Each number may differ
/// by the rounding error that is possible there.
#[cfg(test)]
#[allow(clippy::all, clippy::pedantic)]
#[rustfmt::skip]
mod @module@ {
    use super::@used@;

    fn near<'a>(found: impl Iterator<Item = &'a @number@>, expected: &[@number@], tolerances: &[@number@]) {
        let mut entry = 0;
        for &found in found {
            let off = if found > expected[entry] { found - expected[entry] } else { expected[entry] - found };
            // NaN fails.
            assert!(off <= tolerances[entry], \"entry {}: {} and not {}\", entry, found, expected[entry]);
            entry += 1;
        }
        assert!(entry == expected.len(), \"{} entries\", entry);
    }
";
