//! Material for the reviewer of a C file.
//!
//! In: a [`Module`] with its [`Review`](crate::module::Review), and options. Out: limits as constants, a self-test, and
//! the origins of inertial numbers.

use std::fmt::Write;

use super::COptions;
use super::comments::{comment, harmless};
use super::declarations::{argument_lengths, lengths, number, results};
use super::literals::{literal, string};
use super::names::{constant, own, symbols, unscoped};
use crate::module::{Module, TestVector};
use crate::print::described::{self, CONFIGURATIONS, NumberList};
use crate::print::review;
use crate::schedule::Names;
use crate::space::Space;
use crate::template;

/// Macro that enables the self-test.
const SWITCH: &str = "HOMOGEN_SELF_TEST";

/// Limits, as initialisers of arrays.
pub(super) fn limits(text: &mut String, module: &Module, prefix: &str) {
    let limits = described::limits(module).into_iter();
    let limits = limits.chain(described::radii(module));
    let is_described = |list: &NumberList| list.numbers.iter().any(|limit| limit.is_finite());
    let limits: Vec<NumberList> = limits.filter(is_described).collect();
    let infinite = |list: &NumberList| list.numbers.iter().any(|limit| limit.is_infinite());
    if limits.is_empty() {
        return;
    }
    let largest = module.scalar.largest();
    let mut about = vec![format!(
        "Limits, each for an array: static const {} lower[] = {};",
        number(module.scalar),
        constant(prefix, "lower")
    )];
    if limits.iter().any(infinite) {
        about.push(
            "Without a limit in the description, it is the largest finite number.".to_owned(),
        );
    }
    text.push_str(&comment(&about));
    for NumberList {
        name,
        about,
        numbers,
    } in limits
    {
        let numbers = numbers.iter().map(|limit| limit.clamp(-largest, largest));
        let numbers = numbers.map(|limit| literal(limit, module.scalar));
        let numbers: Vec<String> = numbers.collect();
        let name = constant(prefix, name);
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

/// Configurations with names, as initialisers of arrays.
pub(super) fn configurations(text: &mut String, module: &Module, prefix: &str) {
    let configurations = &module.configurations;
    let nq = module.spaces.len(Space::Coordinates);
    // C has no arrays of length 0.
    if configurations.is_empty() || nq == 0 {
        return;
    }
    let names = configurations.iter().map(|own| string(&own.name));
    let rows = configurations.iter().map(|own| {
        let numbers = own.q.iter().map(|&value| literal(value, module.scalar));
        format!("{{{}}}", numbers.collect::<Vec<_>>().join(", "))
    });
    let count = configurations.len();
    let number = number(module.scalar);
    let lists = [
        (
            "configuration_names",
            format!("Names of the configurations: static const char *const names[{count}]."),
            names.collect::<Vec<_>>(),
        ),
        (
            "configurations",
            format!("{CONFIGURATIONS} For static const {number} configurations[{count}][{nq}]."),
            rows.collect(),
        ),
    ];
    for (name, about, items) in lists {
        let name = constant(prefix, name);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "/* {} */\n#define {name} {{{}}}",
            harmless(&about),
            items.join(", ")
        );
    }
    text.push('\n');
}

/// True if there is a self-test.
fn is_tested(module: &Module) -> bool {
    // C has no arrays of length 0.
    let has_results = module.spaces.len(Space::Velocities) > 0;
    let review = module.review.as_ref();
    has_results && review.is_some_and(|review| !review.vectors.is_empty())
}

/// Declaration of the self-test.
pub(super) fn declaration(text: &mut String, module: &Module, prefix: &str) {
    if !is_tested(module) {
        return;
    }
    let about = [
        format!("Number of wrong results; defined if {SWITCH} is."),
        String::new(),
        "Expected results are from dense 4×4 matrices of the description in 106 bits; each may differ by the \
         rounding error that is possible there."
            .to_owned(),
    ];
    let about = comment(&about);
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "#ifdef {SWITCH}\n{about}HOMOGEN_FN int {}(void);\n#endif\n",
        own(prefix, "self_test")
    );
}

/// Text after all functions: the self-test, and the origins of numbers.
pub(super) fn appendix(module: &Module, options: &COptions<'_>) -> String {
    let mut text = String::new();
    if let (true, Some(review)) = (is_tested(module), &module.review) {
        let test = Test::of(module, options.prefix);
        let words = [
            ("@compare@", &*test.compare),
            ("@self_test@", &test.own),
            ("@failures@", &test.local("failures")),
            ("@number@", number(module.scalar)),
        ];
        text.push_str(&template::filled(TESTS, &words));
        for vector in &review.vectors {
            text.push_str(&test.call(vector));
        }
        let failures = test.local("failures");
        // Writing to a string cannot fail.
        let _ = writeln!(text, "    return {failures};\n}}\n#endif");
    }
    let origins = review::origins(module);
    if !origins.is_empty() {
        text.push('\n');
        text.push_str(&comment(&origins));
    }
    text
}

/// State of the construction of the self-test.
struct Test<'l> {
    module: &'l Module,
    /// Names of the functions that it calls, in the order of the module.
    symbols: Vec<String>,
    /// Name of the comparison.
    compare: String,
    /// Name of the self-test.
    own: String,
    /// Name of the struct with fields.
    robot: String,
    /// Reserved names.
    taken: Names,
}

impl<'l> Test<'l> {
    fn of(module: &'l Module, prefix: &str) -> Self {
        let symbols = symbols(module, prefix);
        let [compare, test, robot] =
            ["failures", "self_test", "robot"].map(|name| own(prefix, name));
        let mut taken = unscoped();
        for name in symbols.iter().chain([&compare, &test, &robot]) {
            taken.take(name);
        }
        Self {
            module,
            symbols,
            compare,
            own: test,
            robot,
            taken,
        }
    }

    /// Name of a local variable.
    fn local(&self, wish: &str) -> String {
        self.taken.clone().alone(wish)
    }

    /// Literals of numbers.
    fn written(&self, numbers: &[f64]) -> Vec<String> {
        let numbers = numbers.iter();
        numbers
            .map(|&value| literal(value, self.module.scalar))
            .collect()
    }

    /// Block that calls a function and counts failures.
    fn call(&self, vector: &TestVector) -> String {
        let Self {
            module, compare, ..
        } = self;
        let (spaces, number) = (&module.spaces, number(module.scalar));
        let (mut call, mut lines) = self.arguments(vector);
        let quantities = results(&module.functions[vector.function].functions);
        let mut counts = Vec::new();
        let (mut expected, mut tolerances) = (&*vector.expected, &*vector.tolerances);
        for (name, quantity) in &quantities {
            let lengths = lengths(quantity, spaces);
            let size = lengths.iter().product::<usize>();
            let (own, rest) = expected.split_at(size.min(expected.len()));
            let (most, others) = tolerances.split_at(size.min(tolerances.len()));
            (expected, tolerances) = (rest, others);
            let name = self.local(name);
            lines.push(format!("{number} {};", declared(&name, &lengths)));
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
            let numbers = [("expected", own), ("off_by", most)].map(|(what, numbers)| {
                let list = self.local(&format!("{name}_{what}"));
                let start = format!("static const {number} {list}[{size}] = {{");
                lines.push(filled(&start, &self.written(numbers), "};"));
                list
            });
            let failures = self.local("failures");
            let numbers = numbers.join(", ");
            counts.push(format!(
                "{failures} += {compare}({first}, {numbers}, {size});"
            ));
        }
        let symbol = &self.symbols[vector.function];
        lines.push(format!("{symbol}({});", call.join(", ")));
        lines.extend(counts);
        let mut text = "    {\n".to_owned();
        for line in lines {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "        {line}");
        }
        text + "    }\n"
    }

    /// Arguments of a call, and the lines that declare them.
    fn arguments(&self, vector: &TestVector) -> (Vec<String>, Vec<String>) {
        let Self { module, robot, .. } = self;
        let number = number(module.scalar);
        let (mut call, mut lines) = (Vec::new(), Vec::new());
        if !module.parameters.is_empty() {
            let fields = vector.fields.iter();
            let fields = fields.map(|values| match &*self.written(values) {
                [value] => value.clone(),
                values => format!("{{{}}}", values.join(", ")),
            });
            let fields: Vec<String> = fields.collect();
            let name = self.local("robot");
            let start = format!("const {robot} {name} = {{");
            lines.push(filled(&start, &fields, "};"));
            call.push(format!("&{name}"));
        }
        for (argument, numbers) in &vector.arguments {
            let lengths = argument_lengths(*argument, &module.spaces);
            let name = self.local(argument.name());
            let numbers = match &*lengths {
                [_, each] => {
                    let rows = numbers.chunks(*each);
                    rows.map(|row| format!("{{{}}}", self.written(row).join(", ")))
                        .collect()
                }
                _ => self.written(numbers),
            };
            let start = format!("const {number} {} = {{", declared(&name, &lengths));
            lines.push(filled(&start, &numbers, "};"));
            call.push(name);
        }
        (call, lines)
    }
}

/// `mass_matrix[2][2]`.
fn declared(name: &str, lengths: &[usize]) -> String {
    let brackets = lengths.iter().map(|length| format!("[{length}]"));
    format!("{name}{}", brackets.collect::<String>())
}

/// Items between brackets, as many on a line as fit.
fn filled(start: &str, items: &[String], end: &str) -> String {
    review::filled((start, "            "), items, end)
}

/// Head of the self-test, with placeholders between `@`.
const TESTS: &str = "
#ifdef HOMOGEN_SELF_TEST
static int @compare@(const @number@ *found, const @number@ *expected, const @number@ *off_by, int count)
{
    int failures = 0;
    for (int k = 0; k < count; k++) {
        const @number@ off = found[k] - expected[k];
        /* NaN fails. */
        failures += !(off <= off_by[k] && -off <= off_by[k]);
    }
    return failures;
}

HOMOGEN_FN int @self_test@(void)
{
    int @failures@ = 0;
";
