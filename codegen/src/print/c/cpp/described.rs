//! A robot's description of itself in C++: counts, names, limits and configurations as constants, and the struct of
//! fields.

use std::fmt::Write;

use crate::module::Module;
use crate::print::c::comments::{comment, harmless};
use crate::print::c::declarations::{members, number};
use crate::print::c::literals::{literal, string};
use crate::print::described::{
    CONFIGURATIONS, NameList, NumberList, limits, names, neutral, radii,
};
use crate::print::documentation;
use crate::print::review::filled;
use crate::real::Real;
use crate::space::Space;

/// Counts, names, limits and configurations.
pub(super) fn constants(module: &Module) -> String {
    let [nq, nv] = [Space::Coordinates, Space::Velocities].map(|space| module.spaces.len(space));
    let mut text = format!(
        "/* Number of coordinates. */\ninline constexpr std::size_t NQ = {nq};\n\
         /* Number of velocities. */\ninline constexpr std::size_t NV = {nv};\n"
    );
    for NameList { name, about, names } in names(module) {
        let names: Vec<String> = names.iter().map(|name| string(name)).collect();
        list(&mut text, ("const char*", name, about), &names);
    }
    let scalar = number(module.scalar);
    let numbers = limits(module).into_iter().chain([neutral(module)]);
    let numbers = numbers.chain(radii(module));
    for NumberList {
        name,
        about,
        numbers,
    } in numbers
    {
        let numbers: Vec<String> = numbers
            .iter()
            .map(|&value| finite(value, module.scalar))
            .collect();
        list(&mut text, (scalar, name, about), &numbers);
    }
    let configurations = &module.configurations;
    if !configurations.is_empty() {
        let names = configurations.iter().map(|own| string(&own.name));
        let names: Vec<String> = names.collect();
        let about = "Names of the configurations.";
        list(
            &mut text,
            ("const char*", "configuration_names", about),
            &names,
        );
        let rows = configurations.iter().map(|own| {
            let numbers = own.q.iter().map(|&value| finite(value, module.scalar));
            format!("{{{}}}", numbers.collect::<Vec<_>>().join(", "))
        });
        let rows: Vec<String> = rows.collect();
        let start = format!(
            "inline constexpr std::array<std::array<{scalar}, {nq}>, {}> CONFIGURATIONS = {{{{",
            rows.len()
        );
        let rows = filled((&start, "    "), &rows, "}};");
        // Writing to a string cannot fail.
        let _ = writeln!(text, "/* {} */\n{rows}", harmless(CONFIGURATIONS));
    }
    text.push('\n');
    text
}

/// A constant of several items.
fn list(text: &mut String, (kind, name, about): (&str, &str, &str), items: &[String]) {
    let (name, count) = (name.to_uppercase(), items.len());
    let start = format!("inline constexpr std::array<{kind}, {count}> {name} = {{");
    let items = filled((&start, "    "), items, "};");
    // Writing to a string cannot fail.
    let _ = writeln!(text, "/* {} */\n{items}", harmless(about));
}

/// Literal of a number, which may be infinite.
fn finite(value: f64, real: Real) -> String {
    if value.is_finite() {
        return literal(value, real);
    }
    let sign = if value < 0.0 { "-" } else { "" };
    format!("{sign}std::numeric_limits<{}>::infinity()", number(real))
}

/// The struct of fields, if there are fields.
pub(super) fn structure(module: &Module) -> String {
    if module.parameters.is_empty() {
        return String::new();
    }
    let mut text = comment(&["The fields of the robot.".to_owned()]);
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "template <class P = {}>\nstruct Robot {{",
        number(module.scalar)
    );
    for (parameter, member) in module.parameters.iter().zip(members(module)) {
        let about = documentation::of_field(&parameter.target);
        let kind = match parameter.target.entries() {
            1 => "P".to_owned(),
            entries => format!("std::array<P, {entries}>"),
        };
        let _ = writeln!(text, "    {kind} {member}; /* {} */", harmless(&about));
    }
    text + "};\n\n"
}
