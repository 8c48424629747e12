//! Statements of Rust for a routine.
//!
//! In: a [`Program`] and its inputs. Out: a `let` for each statement of its [`Routine`], and its results as
//! expressions. The only branches are those of loops, and the only calls are sines, cosines, roots and fused products.

use std::mem;

use proc_macro2::{Ident, Literal, Punct, Spacing, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

use super::arguments::{pattern, unpack};
use super::dialect::{Dialect, StateCount};
use super::early::Filling;
use super::library::Library;
use super::literals::Numerals;
use super::names::ident;
#[cfg(feature = "files")]
use crate::module::Module;
use crate::print::Fields;
use crate::print::expression::{Infix, Spelling, Text, spelled};
#[cfg(feature = "files")]
use crate::print::steps::ConfigurationFunction;
use crate::print::walk::{Language, walk};
use crate::request::Parameter;
use crate::schedule::{
    Angle, Entries, LONGEST_SCOPE, Length, Meaning, Names, Operation, Program, Readable, Routine,
    RoutineLoop, Statement, StorePlace, Stored, Value,
};
use crate::space::{Spaces, Variable};

/// Function body.
pub(super) struct FunctionBody {
    /// Statements before the result.
    pub statements: TokenStream,
    /// Results.
    pub results: Results,
    /// Names of values with their meanings.
    pub meanings: Vec<(String, Meaning)>,
    /// True if fields of the robot are read.
    pub reads_robot: bool,
}

/// Results of a function.
pub(super) enum Results {
    /// Numbers in order.
    Numbers(Numbers),
    /// Matrix that holds all numbers.
    Filled(Ident),
}

/// Numbers in order, and the names that loops need which copy them.
pub(super) struct Numbers {
    /// The numbers.
    pub entries: Vec<Number>,
    /// Zero.
    pub zero: TokenStream,
    /// The work array, if there is one.
    pub work: Option<Ident>,
    /// Name of a matrix that loops fill.
    pub matrix: Ident,
    /// Name of the index of its row.
    pub row: Ident,
    /// Name of another loop's index.
    pub index: Ident,
}

/// Number of a result.
pub(super) struct Number {
    /// As an expression.
    pub text: TokenStream,
    /// As an operand; of a function with one result, that of its last operation.
    pub value: Value,
}

/// Shape of the results.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Returns {
    /// A single number.
    Number,
    /// Numbers in arrays.
    Arrays,
    /// Matrix with rows of this length, whose entries may be stored as soon as they are computed.
    Matrix(usize),
}

/// Field of a prepared robot.
pub(super) const VALUES: &str = "values";

/// Maximum number of fields loaded in one scope; three numbers of a field take up to four `let`s.
const FIELDS: usize = LONGEST_SCOPE / 4;

/// Body of a program that reads these arguments and fields of the struct, with functions of at most this length.
pub(super) fn body(
    (program, length): (&Program, Length),
    (arguments, returns): (&[Variable], Returns),
    (fields, spaces): (Fields<'_>, &Spaces),
    dialect: &Dialect,
) -> FunctionBody {
    let mut names = dialect.names.clone();
    for &argument in arguments {
        names.take(&dialect.argument(argument).to_string());
    }
    let first = arguments
        .first()
        .map(|&argument| dialect.argument(argument));
    let (numerals, constant) = dialect.numerals(first.as_ref(), &mut names);
    let (fused, mul_add) = dialect.fused(&mut names);
    let readable = Readable {
        arguments,
        spaces,
        limbs: match dialect.states {
            StateCount::One => &spaces.limbs,
            StateCount::Several => &[],
        },
        fields: &fields.entries(),
    };
    let stored = match returns {
        Returns::Matrix(_) => Stored::Early,
        Returns::Number | Returns::Arrays => Stored::AtTheEnd,
    };
    let mut routine = Routine::of((program, length), &readable, names, stored);
    let is_number = returns == Returns::Number;
    let returned = is_number.then(|| returned(&mut routine)).flatten();
    let parameters = match fields {
        Fields::Own(parameters) => parameters,
        Fields::Computed(_) => &[],
    };
    let loads = routine.fields.iter().zip(parameters);
    let loads = loads.filter(|(entries, _)| entries.iter().any(Option::is_some));
    let loads: Vec<_> = loads.collect();
    let mut writer = RustWriter {
        dialect,
        numerals,
        fused,
        names: routine.names,
        work: routine.work.as_ref().map(|work| ident(&work.name)),
        filling: None,
        text: TokenStream::new(),
        outer: Vec::new(),
    };
    if let (Returns::Matrix(columns), false) = (returns, routine.stored.is_empty()) {
        let matrix = ident(&writer.names.fresh("y"));
        writer.filling = Some(Filling { matrix, columns });
    }

    let mut statements = TokenStream::new();
    if let Some(work) = &routine.work {
        statements.extend(writer.sections(work, (&constant, &mul_add)));
    }
    if routine.has_literals || !loads.is_empty() {
        statements.extend(constant);
    }
    if routine.is_fused {
        statements.extend(mul_add);
    }
    let arguments = routine.arguments.iter();
    statements.extend(arguments.map(|argument| unpack(argument, dialect)));
    let computed = match (fields, &*routine.fields) {
        (Fields::Computed(_), [values]) => computed(values, &dialect.this()),
        _ => None,
    };
    let reads_robot = computed.is_some() || !loads.is_empty();
    statements.extend(computed);
    let load = |(entries, field): &(&Entries, &Parameter)| writer.load(entries, field);
    if loads.len() <= FIELDS {
        statements.extend(loads.iter().map(load));
    } else {
        statements.extend(loads.chunks(FIELDS).map(|loads| {
            let entries = loads.iter().flat_map(|(entries, _)| *entries);
            block(&loads.iter().map(load).collect(), entries.flatten())
        }));
    }
    let results = routine.results.iter();
    let results = results.map(|result| writer.read(result));
    let results: Vec<_> = match returned {
        Some(operation) => vec![spelled(&writer, &operation)],
        None => results.collect(),
    };
    let first = routine.statements.iter().position(stores);
    let (before, after) = (routine.statements).split_at(first.unwrap_or(routine.statements.len()));
    statements.extend(writer.statements(before));
    let results = if let Some(filling) = &writer.filling {
        let one = writer.numerals.write(1.0);
        statements.extend(filling.begin(&results, &routine.stored, &one));
        Results::Filled(filling.matrix.clone())
    } else {
        Results::Numbers(writer.numbers(results, routine.results))
    };
    statements.extend(writer.statements(after));
    statements.extend(routine.work.as_ref().map(|work| writer.calls(work)));
    FunctionBody {
        statements,
        results,
        meanings: routine.meanings,
        reads_robot,
    }
}

/// Statements of a function of configurations, and the entries of its result.
#[cfg(feature = "files")]
pub(super) fn of_step(
    step: ConfigurationFunction,
    module: &Module,
    dialect: &Dialect,
) -> (TokenStream, Vec<TokenStream>) {
    let mut names = dialect.names.clone();
    let arguments = step.arguments().iter();
    let arguments: Vec<Ident> = arguments.map(|(name, _)| dialect.local(name)).collect();
    for argument in &arguments {
        names.take(&argument.to_string());
    }
    let (numerals, constant) = dialect.numerals(arguments.first(), &mut names);
    let routine = step.routine(module, names);
    let mut statements = TokenStream::new();
    if routine.has_literals {
        statements.extend(constant);
    }
    for (argument, entries) in arguments.iter().zip(&routine.fields) {
        let entries = entries.iter().map(Option::as_ref).map(pattern);
        statements.extend(quote! { let [#(#entries),*] = *#argument; });
    }
    let mut writer = RustWriter {
        dialect,
        numerals,
        fused: None,
        names: routine.names,
        work: None,
        filling: None,
        text: TokenStream::new(),
        outer: Vec::new(),
    };
    statements.extend(writer.statements(&routine.statements));
    let results = routine.results.iter().map(|result| writer.read(result));
    (statements, results.collect())
}

impl Results {
    /// Numbers of a function without a matrix that is filled early.
    pub(super) fn numbers(self) -> Vec<TokenStream> {
        match self {
            Self::Numbers(numbers) => {
                let entries = numbers.entries.into_iter();
                entries.map(|number| number.text).collect()
            }
            Self::Filled(_) => unreachable!("no matrix was asked for"),
        }
    }
}

/// True if results are stored within a statement.
fn stores(statement: &Statement) -> bool {
    match statement {
        Statement::StoreResult(..) => true,
        Statement::Block { statements, .. } => statements.iter().any(stores),
        Statement::Operation(..)
        | Statement::SinesAndCosines(_)
        | Statement::Store(..)
        | Statement::Loop(_) => false,
    }
}

/// Removes the last operation of a routine if it is the result: clippy rejects a name that is bound only to be
/// returned.
fn returned(routine: &mut Routine) -> Option<Operation<Value>> {
    let [Value::Name(result)] = &*routine.results else {
        return None;
    };
    let last = routine
        .statements
        .pop_if(|last| matches!(last, Statement::Operation(name, _) if name == result));
    match last {
        Some(Statement::Operation(_, operation)) => Some(operation),
        _ => None,
    }
}

/// Printer of routines.
pub(super) struct RustWriter<'d> {
    pub(super) dialect: &'d Dialect,
    pub(super) numerals: Numerals,
    fused: Option<Ident>,
    names: Names,
    /// Work array, if there is one.
    pub(super) work: Option<Ident>,
    /// Matrix that results are stored in, if there is one.
    filling: Option<Filling>,
    /// Text of the current scope.
    text: TokenStream,
    /// Text of the scopes around it, the outermost first.
    outer: Vec<TokenStream>,
}

impl RustWriter<'_> {
    pub(super) fn statements(&mut self, statements: &[Statement]) -> TokenStream {
        let before = mem::take(&mut self.text);
        walk(self, statements);
        mem::replace(&mut self.text, before)
    }

    /// These values with their expressions, and names for loops that copy them.
    fn numbers(&mut self, texts: Vec<TokenStream>, values: Vec<Value>) -> Numbers {
        let entries = texts.into_iter().zip(values);
        let entries = entries.map(|(text, value)| Number { text, value });
        let entries = entries.collect();
        let [matrix, row, index] =
            ["matrix", "row", "k"].map(|name| ident(&self.names.fresh(name)));
        Numbers {
            entries,
            zero: self.numerals.write(0.0),
            work: self.work.clone(),
            matrix,
            row,
            index,
        }
    }

    /// Ends a scope and returns its text.
    fn inside(&mut self) -> TokenStream {
        let outer = self.outer.pop().expect("a scope that began");
        mem::replace(&mut self.text, outer)
    }

    /// `let payload = self.payload;` or `let [gravity_x, _, gravity_z] = self.gravity;`, converted.
    fn load(&self, entries: &Entries, Parameter { field, target, .. }: &Parameter) -> TokenStream {
        // An error about a field of another type is shown at the field.
        let span = field.span().resolved_at(Span::call_site());
        let this = self.dialect.this();
        let value = match (&self.dialect.library, target.is_payload()) {
            (Library::Runtime(runtime), true) => {
                quote_spanned! {span=> #runtime::Payload::numbers(&#this.#field) }
            }
            (Library::Runtime(_) | Library::Core(_) | Library::Lanes(_), _) => {
                quote_spanned! {span=> #this.#field }
            }
        };
        let converted = |value: &TokenStream| self.dialect.converted(&self.numerals, value, span);
        if let [Some(name)] = &**entries {
            let (name, value) = (ident(name), converted(&value));
            return quote! { let #name = #value; };
        }
        let conversions = entries.iter().flatten().filter_map(|name| {
            let name = ident(name).into_token_stream();
            let converted = converted(&name);
            // Without a conversion the pattern has bound the value.
            let needed = converted.to_string() != name.to_string();
            needed.then(|| quote! { let #name = #converted; })
        });
        let patterns = entries.iter().map(Option::as_ref).map(pattern);
        quote! { let [#(#patterns),*] = #value; #(#conversions)* }
    }
}

impl Text for TokenStream {
    fn natural(number: usize) -> Self {
        Literal::usize_unsuffixed(number).into_token_stream()
    }

    fn infix(&self, symbol: Infix, b: &Self) -> Self {
        let symbol = Punct::new(symbol.letter(), Spacing::Alone);
        quote! { #self #symbol #b }
    }

    fn negative(&self) -> Self {
        quote! { -#self }
    }

    fn in_parentheses(&self) -> Self {
        quote! { (#self) }
    }
}

impl Spelling for RustWriter<'_> {
    type Text = TokenStream;

    fn read(&self, value: &Value) -> TokenStream {
        match value {
            Value::Literal(value) => self.numerals.write(*value),
            Value::Name(name) => ident(name).into_token_stream(),
            Value::Work(place) => self.place(*place),
            Value::Cell(row, column) => self.cell(row, column),
            Value::Entry(table, row, column) => {
                let table = ident(table);
                let [row, column] = [*row, *column].map(Literal::usize_unsuffixed);
                quote! { #table[#row][#column] }
            }
            Value::Operation(operation) => spelled(self, operation),
        }
    }

    fn root(&self, a: &TokenStream) -> TokenStream {
        self.dialect.sqrt(a)
    }

    fn sign(&self, a: &TokenStream) -> TokenStream {
        self.dialect.sign(a)
    }

    fn fused(&self, operands: impl FnOnce() -> [TokenStream; 3]) -> Option<TokenStream> {
        let function = self.fused.as_ref()?;
        let [a, b, c] = operands();
        Some(quote! { #function(#a, #b, #c) })
    }
}

impl Language for RustWriter<'_> {
    fn operation(&mut self, name: &str, operation: &Operation<Value>) {
        let (name, value) = (ident(name), spelled(self, operation));
        self.text.extend(quote! { let #name = #value; });
    }

    fn sines_and_cosines(&mut self, angles: &[Angle]) {
        let sines = angles.iter().map(|angle| pattern(angle.sine.as_ref()));
        let cosines = angles.iter().map(|angle| pattern(angle.cosine.as_ref()));
        let values = angles.iter().map(|angle| self.read(&angle.value));
        let [sines, cosines] = [sines.collect::<Vec<_>>(), cosines.collect()];
        let values: Vec<_> = values.collect();
        let bound = (self.dialect).sines_and_cosines(&sines, &cosines, &values, &mut self.names);
        self.text.extend(bound);
    }

    fn put(&mut self, place: &StorePlace, value: &Value) {
        let [place, value] = [&place.value(), value].map(|of| self.read(of));
        self.text.extend(quote! { #place = #value; });
    }

    fn store(&mut self, result: usize, value: &Value) {
        let filling = self.filling.as_ref();
        let filling = filling.expect("early results have a matrix");
        self.text.extend(filling.store(result, &self.read(value)));
    }

    fn begin_loop(&mut self, each: &RoutineLoop) {
        let rows = each.rows.iter().map(|row| {
            let row = row.iter().map(|value| self.read(value));
            quote! { [#(#row),*] }
        });
        let rows: Vec<_> = rows.collect();
        if !rows.is_empty() {
            let table = ident(&each.table);
            self.text.extend(quote! { let #table = [#(#rows),*]; });
        }
        if let Some(found) = &each.found {
            let (table, before) = (ident(&found.table), self.read(&found.before));
            let [height, count] = [found.height, each.count].map(Literal::usize_unsuffixed);
            self.text
                .extend(quote! { let mut #table = [[#before; #count]; #height]; });
        }
        self.begin_scope();
        let takes = each.loads.iter().map(|(name, row)| {
            let (name, cell) = (ident(name), self.cell(row, &each.index));
            quote! { let #name = #cell; }
        });
        let takes: TokenStream = takes.collect();
        self.text.extend(takes);
    }

    fn end_loop(&mut self, each: &RoutineLoop) {
        let index = ident(&each.index);
        let count = Literal::usize_unsuffixed(each.count);
        let inside = self.inside();
        // LLVM computes two iterations in a vector only if they are counted down.
        let range = if each.count == 2 {
            quote! { (0..#count).rev() }
        } else {
            quote! { 0..#count }
        };
        // A processor with vectors reads along a row; clippy prefers a loop over the rows.
        self.text.extend(quote! {
            #[allow(clippy::needless_range_loop)]
            for #index in #range { #inside }
        });
    }

    fn begin_scope(&mut self) {
        self.outer.push(mem::take(&mut self.text));
    }

    fn end_scope(&mut self, outputs: &[String]) {
        let inside = self.inside();
        self.text.extend(block(&inside, outputs.iter()));
    }
}

/// `let [phi_2_in_2_cz, _, payload_m] = self.values;`, if any of them is read.
fn computed(values: &Entries, this: &TokenStream) -> Option<TokenStream> {
    let any = values.iter().any(Option::is_some);
    let patterns = values.iter().map(Option::as_ref).map(pattern);
    let field = ident(VALUES);
    any.then(|| quote! { let [#(#patterns),*] = #this.#field; })
}

/// `let [a, b] = { …; [a, b] };`: statements in an inner scope and its values. Without values it is a plain block,
/// since the type of `[]` is unknown.
fn block<'n>(inside: &TokenStream, names: impl Iterator<Item = &'n String>) -> TokenStream {
    let names: Vec<_> = names.map(|name| ident(name)).collect();
    if names.is_empty() {
        return quote! { { #inside } };
    }
    quote! { let [#(#names),*] = { #inside [#(#names),*] }; }
}
