//! What the reviewer of a file reads beside its code.
//!
//! In: a [`Listing`] with its [`Review`](crate::print::Review), and how it is written. Out: limits as constants, a
//! function that tests all others, and where numbers come from. It never prints an operation.

use std::fmt::Write;

use super::Writing;
use super::comments::{comment, harmless};
use super::declarations::{argument_lengths, lengths, members, number, results};
use super::literals::literal;
use super::names::symbols;
use crate::print::review::{self, Limits};
use crate::print::{Listed, Listing, Vector};
use crate::space::Space;

/// What makes the compiler take the tests.
const SWITCH: &str = "HOMOGEN_SELF_TEST";

/// The limits, as what stands behind the `=` of an array.
pub(super) fn limits(text: &mut String, listing: &Listing, prefix: &str) {
    let limits = review::limits(listing).into_iter();
    let limits: Vec<Limits> = limits.collect();
    let infinite = |limits: &Limits| limits.numbers.iter().any(|limit| limit.is_infinite());
    if limits.is_empty() {
        return;
    }
    let largest = listing.scalar.largest();
    let mut about = vec![format!(
        "Limits, each for an array: static const {} lower[] = {};",
        number(listing.scalar),
        format!("{prefix}lower").to_uppercase()
    )];
    if limits.iter().any(infinite) {
        about.push("The largest number that there is stands where none is described.".to_owned());
    }
    text.push_str(&comment(&about));
    for Limits {
        name,
        about,
        numbers,
    } in limits
    {
        let numbers = numbers.iter().map(|limit| limit.clamp(-largest, largest));
        let numbers = numbers.map(|limit| literal(limit, listing.scalar));
        let numbers: Vec<String> = numbers.collect();
        let name = format!("{prefix}{name}").to_uppercase();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "/* {} */\n#define {name} {{{}}}",
            harmless(about),
            numbers.join(", ")
        );
    }
    text.push('\n');
}

/// Whether there is a function that tests all others.
fn is_tested(listing: &Listing) -> bool {
    // Arrays of no length are none.
    let has_results = listing.spaces.len(Space::Velocities) > 0;
    let review = listing.review.as_ref();
    has_results && review.is_some_and(|review| !review.vectors.is_empty())
}

/// The declaration of that function.
pub(super) fn declaration(text: &mut String, listing: &Listing, prefix: &str) {
    if !is_tested(listing) {
        return;
    }
    let about = [
        format!("How many results are not what they should be; there where {SWITCH} is defined."),
        String::new(),
        "What they should be, dense 4×4 matrices of the description tell in 106 bits; each may be off by what \
         rounding can make of it."
            .to_owned(),
    ];
    let about = comment(&about);
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "#ifdef {SWITCH}\n{about}HOMOGEN_FN int {prefix}self_test(void);\n#endif\n"
    );
}

/// What stands behind all functions: that one, and where numbers come from.
pub(super) fn appendix(listing: &Listing, writing: &Writing<'_>) -> String {
    let mut text = String::new();
    if let (true, Some(review)) = (is_tested(listing), &listing.review) {
        let prefix = writing.prefix;
        let tests = TESTS.replace("ROBOT_", prefix);
        let tests = tests.replace("NUMBER", number(listing.scalar));
        text.push_str(&tests);
        let symbols = symbols(listing, prefix);
        for vector in &review.vectors {
            let listed = &listing.functions[vector.function];
            text.push_str(&call(
                listing,
                (listed, vector),
                (prefix, &symbols[vector.function]),
            ));
        }
        text.push_str("    return failures;\n}\n#endif\n");
    }
    let origins = review::origins(listing);
    if !origins.is_empty() {
        text.push('\n');
        text.push_str(&comment(&origins));
    }
    text
}

/// The block that calls a function and counts what is wrong.
fn call(
    listing: &Listing,
    (listed, vector): (&Listed, &Vector),
    (prefix, symbol): (&str, &str),
) -> String {
    let (spaces, number) = (&listing.spaces, number(listing.scalar));
    let mut text = "    {\n".to_owned();
    let mut line = |line: &str| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "        {line}");
    };
    let written = |numbers: &[f64]| -> Vec<String> {
        let each = numbers.iter().map(|&value| literal(value, listing.scalar));
        each.collect()
    };
    let mut call: Vec<String> = Vec::new();
    if !listing.parameters.is_empty() {
        let fields = vector.fields.iter().zip(members(listing));
        let fields: Vec<String> = fields
            .map(|(values, _)| match &*written(values) {
                [value] => value.clone(),
                values => format!("{{{}}}", values.join(", ")),
            })
            .collect();
        line(&filled(
            &format!("const {prefix}robot robot = {{"),
            &fields,
            "};",
        ));
        call.push("&robot".to_owned());
    }
    for (argument, numbers) in &vector.arguments {
        let lengths = argument_lengths(*argument, spaces);
        let name = declared(argument.name(), &lengths);
        let numbers = match &*lengths {
            [_, each] => {
                let rows = numbers
                    .chunks(*each)
                    .map(|row| format!("{{{}}}", written(row).join(", ")));
                rows.collect()
            }
            _ => written(numbers),
        };
        line(&filled(
            &format!("const {number} {name} = {{"),
            &numbers,
            "};",
        ));
        call.push(argument.name().to_owned());
    }
    let quantities = results(&listed.functions);
    let mut counts = Vec::new();
    let (mut expected, mut tolerances) = (&*vector.expected, &*vector.tolerances);
    for (name, quantity) in &quantities {
        let lengths = lengths(quantity, spaces);
        let size = lengths.iter().product::<usize>();
        let (own, rest) = expected.split_at(size.min(expected.len()));
        let (most, others) = tolerances.split_at(size.min(tolerances.len()));
        (expected, tolerances) = (rest, others);
        line(&format!("{number} {};", declared(name, &lengths)));
        let first = match lengths.len() {
            0 => format!("&{name}"),
            1 => name.clone(),
            depth => format!("&{name}{}", "[0]".repeat(depth)),
        };
        call.push(if lengths.is_empty() {
            first.clone()
        } else {
            name.clone()
        });
        for (what, numbers) in [("expected", own), ("off_by", most)] {
            let start = format!("static const {number} {name}_{what}[{size}] = {{");
            line(&filled(&start, &written(numbers), "};"));
        }
        counts.push(format!(
            "failures += {prefix}failures({first}, {name}_expected, {name}_off_by, {size});"
        ));
    }
    line(&format!("{symbol}({});", call.join(", ")));
    for count in counts {
        line(&count);
    }
    text + "    }\n"
}

/// `mass_matrix[2][2]`.
fn declared(name: &str, lengths: &[usize]) -> String {
    let brackets = lengths.iter().map(|length| format!("[{length}]"));
    format!("{name}{}", brackets.collect::<String>())
}

/// Items between brackets, as many on a line as fit it.
fn filled(start: &str, items: &[String], end: &str) -> String {
    review::filled((start, "            "), items, end)
}

/// The head of the function.
const TESTS: &str = "
#ifdef HOMOGEN_SELF_TEST
static int ROBOT_failures(const NUMBER *found, const NUMBER *expected, const NUMBER *off_by, int count)
{
    int failures = 0;
    for (int k = 0; k < count; k++) {
        const NUMBER off = found[k] - expected[k];
        /* What is no number is wrong. */
        failures += !(off <= off_by[k] && -off <= off_by[k]);
    }
    return failures;
}

HOMOGEN_FN int ROBOT_self_test(void)
{
    int failures = 0;
";
