//! Statements of C for a routine.
//!
//! In: a function of a [`Module`], or its `prepare`, and options. Out: a constant for each statement of its
//! [`Routine`], and stores of the results in the arrays of the caller. The only branches are those of loops, and the
//! only calls are sines, cosines, roots and fused products.

use std::fmt::Write;
use std::mem;

use super::COptions;
use super::declarations::{VALUES, argument_lengths, lengths, members, number, results};
use super::literals::literal;
use super::names::{ascii, unscoped};
use super::roots::SQRT;
use crate::formulation::Sines;
use crate::module::{GeneratedFunction, Module, Prepared};
use crate::print::Fields;
use crate::print::expression::{Spelling, spelled};
use crate::print::large::columns;
use crate::print::review::filled;
use crate::print::steps::ConfigurationFunction;
use crate::print::walk::{Language, walk};
use crate::real::Real;
use crate::schedule::{
    Angle, Length, LoopTable, Names, Operation, Program, Readable, Routine, RoutineLoop,
    StorePlace, Stored, Value,
};
use crate::space::Variable;

/// Function body, and the sections that it calls.
pub(super) struct FunctionBody {
    /// Definitions of the sections, each after an empty line.
    pub sections: String,
    /// Lines within the braces.
    pub text: String,
}

/// Body of a function with these fields; `own` makes the names of its sections.
pub(super) fn body(
    module: &Module,
    (generated, fields): (&GeneratedFunction, Fields<'_>),
    options: &COptions<'_>,
    own: &mut dyn FnMut(&str) -> String,
) -> FunctionBody {
    let arguments = generated.arguments(&module.spaces);
    let results = results(&generated.functions);
    let reserved = results.iter().map(|(name, _)| name.as_str());
    let names = names(reserved, options);
    let large = columns(&generated.functions, &module.spaces).is_some();
    let filled = results.first().filter(|_| large);
    let filled = filled.map(|(name, quantity)| (name.clone(), lengths(quantity, &module.spaces)));
    let (mut writer, routine) = CWriter::of(
        (&generated.program, filled),
        (module, fields),
        &arguments,
        (names, options),
    );
    let sections = writer.sections(&routine, own);
    writer.store_results(&routine, module, &results);
    FunctionBody {
        sections,
        text: writer.text,
    }
}

/// Body of the function that computes everything that depends on fields alone.
pub(super) fn once(
    module: &Module,
    prepared: &Prepared,
    options: &COptions<'_>,
    own: &mut dyn FnMut(&str) -> String,
) -> FunctionBody {
    let names = names(["prepared"].into_iter(), options);
    let fields = Fields::Own(&module.parameters);
    let (mut writer, routine) = CWriter::of(
        (&prepared.once, None),
        (module, fields),
        &[],
        (names, options),
    );
    let sections = writer.sections(&routine, own);
    for (k, value) in routine.results.iter().enumerate() {
        let value = writer.read(value);
        writer.line(&format!("prepared->{VALUES}[{k}] = {value};"));
    }
    FunctionBody {
        sections,
        text: writer.text,
    }
}

/// Body of a function of configurations.
pub(super) fn of_step(
    step: ConfigurationFunction,
    module: &Module,
    options: &COptions<'_>,
) -> FunctionBody {
    let arguments = step.arguments().iter().map(|(name, _)| *name);
    let names = names(arguments.clone().chain([step.name()]), options);
    let routine = step.routine(module, names);
    let mut writer = CWriter {
        sines: module.sines,
        names: routine.names.clone(),
        ..CWriter::new(module.scalar, options)
    };
    for (argument, entries) in arguments.zip(&routine.fields) {
        for (k, name) in entries.iter().enumerate() {
            let Some(name) = name else { continue };
            let value = writer.loaded(format!("{argument}[{k}]"));
            writer.constant(name, &value);
        }
    }
    if !module.parameters.is_empty() {
        writer.line("(void)robot;");
    }
    walk(&mut writer, &routine.statements);
    for (k, value) in routine.results.iter().enumerate() {
        let value = writer.stored(value);
        writer.line(&format!("{}[{k}] = {value};", step.name()));
    }
    FunctionBody {
        sections: String::new(),
        text: writer.text,
    }
}

/// Preferred names of the entries of fields, in ASCII.
fn in_ascii(fields: Fields<'_>) -> Vec<Vec<String>> {
    let fields = fields.entries().into_iter();
    fields
        .map(|entries| entries.iter().map(|entry| ascii(entry)).collect())
        .collect()
}

/// Reserved names in a function with these results.
fn names<'n>(results: impl Iterator<Item = &'n str>, options: &COptions<'_>) -> Names {
    let mut names = unscoped();
    for name in ["cos", "cosf", "robot", "sin", "sinf", "sqrt", "sqrtf"] {
        names.take(name);
    }
    for name in results {
        names.take(name);
    }
    for own in ["sin_cos", SQRT, "turn"] {
        names.take(&options.own(own));
    }
    for own in RESERVED.iter().filter(|_| options.templates) {
        names.take(own);
    }
    names
}

/// Names around a body in C++.
const RESERVED: [&str; 15] = [
    "Actions", "P", "Q", "Q0", "Q1", "Qd", "Qdd", "Robot", "T", "Tau", "V", "Weights", "detail",
    "result", "std",
];

/// Printer of routines.
pub(super) struct CWriter<'w> {
    pub(super) options: &'w COptions<'w>,
    pub(super) real: Real,
    sines: Sines,
    pub(super) text: String,
    /// Text around the current loop.
    outer: Vec<String>,
    pub(super) names: Names,
    /// Name of the work array, if there is one.
    pub(super) work: String,
    /// Matrix in which results are stored as soon as they are computed, with its lengths.
    filled: Option<(String, Vec<usize>)>,
}

impl<'w> CWriter<'w> {
    /// Printer of statements outside of functions.
    pub(super) fn new(real: Real, options: &'w COptions<'w>) -> Self {
        Self {
            options,
            real,
            sines: Sines::default(),
            text: String::new(),
            outer: Vec::new(),
            names: Names::default(),
            work: String::new(),
            filled: None,
        }
    }

    /// Text and routine of a program. `filled`: name and lengths of a matrix that is filled early.
    fn of(
        (program, filled): (&Program, Option<(String, Vec<usize>)>),
        (module, fields): (&Module, Fields<'_>),
        arguments: &[Variable],
        (names, options): (Names, &'w COptions<'w>),
    ) -> (Self, Routine) {
        let readable = Readable {
            arguments,
            spaces: &module.spaces,
            limbs: &module.spaces.limbs,
            fields: &in_ascii(fields),
        };
        // Templates are inline, so that sections would be, too.
        let length = if options.templates {
            Length::UNBOUNDED
        } else {
            module.length
        };
        let stored = match filled {
            Some(_) => Stored::Early,
            None => Stored::AtTheEnd,
        };
        let routine = Routine::of((program, length), &readable, names, stored);
        let work = routine.work.as_ref();
        let mut writer = Self {
            sines: module.sines,
            names: routine.names.clone(),
            work: work.map_or_else(String::new, |work| work.name.clone()),
            filled,
            ..Self::new(module.scalar, options)
        };
        writer.load(&routine, (module, fields));
        walk(&mut writer, &routine.statements);
        (writer, routine)
    }

    /// The type of numbers.
    fn number(&self) -> &'static str {
        if self.options.templates {
            "T"
        } else {
            number(self.real)
        }
    }

    /// `const double name = value;`.
    pub(super) fn constant(&mut self, name: &str, value: &str) {
        let number = self.number();
        self.line(&format!("const {number} {name} = {value};"));
    }

    pub(super) fn line(&mut self, statement: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "    {statement}");
    }

    /// Loads all arguments and fields that are read, before any result is stored.
    fn load(&mut self, routine: &Routine, (module, fields): (&Module, Fields<'_>)) {
        for (argument, entries) in &routine.arguments {
            let read = entries.iter().enumerate();
            for (k, name) in read.filter_map(|(k, name)| Some((k, name.as_ref()?))) {
                let lengths = argument_lengths(*argument, &module.spaces);
                let k = if argument.has_wrenches() {
                    self.options.order.place(k)
                } else {
                    k
                };
                let value = self.loaded(place(argument.name(), k, &lengths));
                self.constant(name, &value);
            }
            if entries.iter().all(Option::is_none) {
                self.line(&format!("(void){};", argument.name()));
            }
        }
        let mut unread = !module.parameters.is_empty();
        let members = match fields {
            Fields::Own(_) => members(module),
            Fields::Computed(_) => vec![VALUES.to_owned()],
        };
        for (entries, member) in routine.fields.iter().zip(members) {
            for (k, name) in entries.iter().enumerate() {
                let Some(name) = name else { continue };
                unread = false;
                let arrow = if self.options.templates { "." } else { "->" };
                let value = match (&**entries, fields) {
                    ([_], Fields::Own(_)) => format!("robot{arrow}{member}"),
                    _ => format!("robot{arrow}{member}[{k}]"),
                };
                let value = self.loaded(value);
                self.constant(name, &value);
            }
        }
        if unread {
            self.line("(void)robot;");
        }
    }

    /// The same as a number of its type: classes may have no conversion from a literal.
    pub(super) fn stored(&self, value: &Value) -> String {
        match (value, self.read(value)) {
            (Value::Literal(_), literal) if self.options.templates => format!("T({literal})"),
            (_, value) => value,
        }
    }

    /// An argument or a field, which may have another type than results.
    fn loaded(&self, value: String) -> String {
        if self.options.templates {
            format!("T({value})")
        } else {
            value
        }
    }

    /// Place of an entry of a result.
    pub(super) fn entry(&self, name: &str, index: usize, lengths: &[usize]) -> String {
        if self.options.templates && lengths.is_empty() {
            name.to_owned()
        } else {
            place(name, index, lengths)
        }
    }

    /// Call of a library function in the scalar type.
    fn call(&self, function: &str, value: &str) -> String {
        match self.real {
            Real::F32 if !self.options.templates => format!("{function}f({value})"),
            Real::F32 | Real::F64 | Real::Generic => format!("{function}({value})"),
        }
    }

    fn sine_and_cosine(&mut self, angle: &Angle) {
        let value = self.read(&angle.value);
        let parts = [
            (&angle.sine, "sin", "sine"),
            (&angle.cosine, "cos", "cosine"),
        ];
        let parts = parts.into_iter().filter_map(|(name, function, member)| {
            name.as_ref().map(|name| (name, function, member))
        });
        if self.sines == Sines::Platform {
            for (name, function, _) in parts {
                let value = self.call(function, &value);
                self.constant(name, &value);
            }
            return;
        }
        let [turn, sin_cos] = if self.options.templates {
            ["auto", "detail::sin_cos"].map(str::to_owned)
        } else {
            ["turn", "sin_cos"].map(|name| self.options.own(name))
        };
        // `s_1` and `c_1` are parts of `turn_1`.
        let subject = parts.clone().next().map_or("", |(name, ..)| &name[1..]);
        let both = self.names.fresh(&format!("turn{subject}"));
        self.line(&format!("const {turn} {both} = {sin_cos}({value});"));
        for (name, _, member) in parts {
            self.constant(name, &format!("{both}.{member}"));
        }
    }
}

impl Spelling for CWriter<'_> {
    type Text = String;

    fn read(&self, value: &Value) -> String {
        match value {
            Value::Literal(value) => literal(*value, self.real),
            Value::Name(name) => name.clone(),
            Value::Work(place) => self.place(*place),
            Value::Entry(table, row, column) => format!("{table}[{row}][{column}]"),
            Value::Cell(row, column) => self.cell(row, column),
            Value::Operation(operation) => spelled(self, operation),
        }
    }

    fn root(&self, a: &String) -> String {
        if self.options.templates {
            // An expression may have a type of its own.
            format!("detail::root({})", self.loaded(a.clone()))
        } else {
            format!("{}({a})", self.options.own(SQRT))
        }
    }

    fn sign(&self, a: &String) -> String {
        let (number, zero) = (self.number(), literal(0.0, self.real));
        let difference = format!("(({a} > {zero}) - ({a} < {zero}))");
        if self.options.templates {
            format!("{number}{difference}")
        } else {
            format!("({number}){difference}")
        }
    }

    fn fused(&self, operands: impl FnOnce() -> [String; 3]) -> Option<String> {
        self.options.fused.then(|| {
            let [a, b, c] = operands();
            format!("{}({a}, {b}, {c})", self.options.mul_add())
        })
    }
}

/// Scopes are omitted: names are unique in the function, and C compilers have no limit on their number.
impl Language for CWriter<'_> {
    fn operation(&mut self, name: &str, operation: &Operation<Value>) {
        let value = spelled(self, operation);
        self.constant(name, &value);
    }

    fn sines_and_cosines(&mut self, angles: &[Angle]) {
        for angle in angles {
            self.sine_and_cosine(angle);
        }
    }

    fn put(&mut self, place: &StorePlace, value: &Value) {
        let (place, value) = (self.read(&place.value()), self.stored(value));
        self.line(&format!("{place} = {value};"));
    }

    fn store(&mut self, result: usize, value: &Value) {
        let filled = self.filled.as_ref();
        let (name, lengths) = filled.expect("early results have a matrix");
        let (place, value) = (place(name, result, lengths), self.stored(value));
        self.line(&format!("{place} = {value};"));
    }

    fn begin_loop(&mut self, each: &RoutineLoop) {
        let (number, index, count) = (self.number(), &each.index, each.count);
        if !each.rows.is_empty() {
            let rows = each.rows.iter().map(|row| {
                let row: Vec<String> = row.iter().map(|value| self.stored(value)).collect();
                format!("{{{}}}", row.join(", "))
            });
            let rows: Vec<String> = rows.collect();
            let start = format!(
                "    const {number} {}[{}][{count}] = {{",
                each.table,
                rows.len()
            );
            let filled = filled((&start, "        "), &rows, "};");
            let _ = writeln!(self.text, "{filled}");
        }
        if let Some(LoopTable { table, height, .. }) = &each.found {
            self.line(&format!("{number} {table}[{height}][{count}];"));
        }
        self.line(&format!(
            "for (int {index} = 0; {index} < {count}; {index}++) {{"
        ));
        self.outer.push(mem::take(&mut self.text));
        for (name, row) in &each.loads {
            let cell = self.cell(row, index);
            self.constant(name, &cell);
        }
    }

    fn end_loop(&mut self, _: &RoutineLoop) {
        let outer = self.outer.pop().expect("a loop that began");
        let inside = mem::replace(&mut self.text, outer);
        for line in inside.lines() {
            let _ = writeln!(self.text, "    {line}");
        }
        self.line("}");
    }
}

/// Entry with this index of an argument or a result: `gravity[3]`, `mass_matrix[1][2]`, `*kinetic_energy`.
pub(super) fn place(name: &str, index: usize, lengths: &[usize]) -> String {
    if lengths.is_empty() {
        return format!("*{name}");
    }
    let mut rest = index;
    let indices = lengths.iter().rev().map(|length| {
        let index = rest % length;
        rest /= length;
        index
    });
    let indices: Vec<_> = indices.collect();
    indices
        .iter()
        .rev()
        .fold(name.to_owned(), |place, index| format!("{place}[{index}]"))
}
