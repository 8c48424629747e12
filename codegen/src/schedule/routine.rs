//! Routines: programs with names, statements and scopes, in the structure that every language prints.
//!
//! In: a [`Program`], its readable inputs, and reserved names. Out: a [`Routine`]. Values that are not read get no
//! name.

mod loops;
mod meaning;
mod section;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet, HashMap};

pub use self::loops::{Cells, LoopTable, RoutineLoop};
pub use self::meaning::{Meaning, RotationAngle};
pub use self::section::{SectionBody, Work};
use super::blocks::{Block, ScopeEntry, nested};
use super::inlined::Inlined;
use super::names::Names;
use super::sections::{Length, Shared};
use super::sums::Sums;
use super::{Arranged, Operand, Operation, Program};
use crate::expression::Input;
use crate::space::{Limbs, Spaces, Variable};

/// Inputs of a function.
#[derive(Clone, Copy, Debug)]
pub struct Readable<'a> {
    /// Arguments.
    pub arguments: &'a [Variable],
    /// Spaces of the arguments.
    pub spaces: &'a Spaces,
    /// Equal limbs, over which there are loops; none where a number is a vector of several states already.
    pub limbs: &'a [Limbs],
    /// Preferred names of the entries of each field, in the order of the fields in [`Input::Parameter`].
    pub fields: &'a [Vec<String>],
}

/// Body of one function.
#[derive(Clone, Debug)]
pub struct Routine {
    /// Arguments; no other value has their names.
    pub arguments: Vec<(Variable, Entries)>,
    /// Fields.
    pub fields: Vec<Entries>,
    /// Statements in execution order.
    pub statements: Vec<Statement>,
    /// Sections that run after the statements, if the function is long.
    pub work: Option<Work>,
    /// Results; those in `stored` need not be bound to a name at the end.
    pub results: Vec<Value>,
    /// Indices of results that are stored as soon as they are computed.
    pub stored: BTreeSet<usize>,
    /// True if a value is a literal, outside of sections.
    pub has_literals: bool,
    /// True if an operation is fused, outside of sections.
    pub is_fused: bool,
    /// All names in use and the reserved ones, for further names of a language.
    pub names: Names,
    /// Meanings of the names in the order of their creation, without those of fields.
    pub meanings: Vec<(String, Meaning)>,
}

/// Name of each entry of an argument or a field; `None` for an entry that is not read.
pub type Entries = Vec<Option<String>>;

/// One statement of a routine.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// Operation and the name of its result.
    Operation(String, Operation<Value>),
    /// All sines and cosines; at least one angle.
    SinesAndCosines(Vec<Angle>),
    /// Statements in an inner scope.
    Block {
        /// Statements of the scope.
        statements: Vec<Statement>,
        /// Names that are read after the scope.
        outputs: Vec<String>,
    },
    /// Stores a value in the work array or in a table of a loop.
    Store(StorePlace, Value),
    /// Stores a value as the result with an index.
    StoreResult(usize, Value),
    /// Loop.
    Loop(RoutineLoop),
}

/// Place in which a section or an iteration of a loop stores a value.
#[derive(Clone, Debug, PartialEq)]
pub enum StorePlace {
    /// Entry of the work array.
    Work(usize),
    /// Entry of a row for the iteration that is the value of this index.
    Cell(Cells, String),
}

impl StorePlace {
    /// The stored value.
    #[must_use]
    pub fn value(&self) -> Value {
        match self {
            Self::Work(place) => Value::Work(*place),
            Self::Cell(row, index) => Value::Cell(row.clone(), index.clone()),
        }
    }
}

/// Time at which results are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// All of them, after the last statement.
    AtTheEnd,
    /// Each after the statement that computes it, if possible.
    Early,
}

/// Angle, and the names of its sine and cosine; `None` if it is not read.
#[derive(Clone, Debug, PartialEq)]
pub struct Angle {
    /// The angle \[rad\].
    pub value: Value,
    /// Its sine.
    pub sine: Option<String>,
    /// Its cosine.
    pub cosine: Option<String>,
}

/// Operand of a routine's operation.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Number known during generation.
    Literal(f64),
    /// Value bound to a name.
    Name(String),
    /// Entry of the work array.
    Work(usize),
    /// Entry of a loop's table: name of the table, row, and iteration.
    Entry(String, usize, usize),
    /// Entry of a row for the iteration that is the value of this index.
    Cell(Cells, String),
    /// Result of an operation that is written here.
    Operation(Box<Operation<Value>>),
}

impl Routine {
    /// Names the inputs and values of a program, beside the reserved names, and divides it by the length of functions.
    /// Results are stored at the end if the function has sections or loops, or no literal to initialise their array
    /// with.
    ///
    /// # Panics
    /// If the program reads an input that is not readable, or a step before it is computed.
    #[must_use]
    pub fn of(
        (program, length): (&Program, Length),
        readable: &Readable<'_>,
        mut names: Names,
        stored: Stored,
    ) -> Self {
        for argument in readable.arguments {
            names.take(argument.name());
        }
        let arranged = Arranged::of(program, readable.limbs, length);
        let program = &*arranged.program;
        let sums = Sums::of(program);
        let inlined = Inlined::of(&arranged, |step| meaning(program, &sums, step).is_some());
        let mut naming = Naming {
            program,
            sums: &sums,
            inlined: &inlined,
            names,
            meanings: Vec::with_capacity(program.steps.len()),
            inputs: program.operands().filter_map(unbound).collect(),
            angles: Vec::new(),
            steps: Vec::with_capacity(program.steps.len()),
            parts: Vec::new(),
            unnamed: 0,
            loops: 0,
            index: None,
            stores: BTreeMap::new(),
            found: BTreeMap::new(),
            is_named: true,
            loads: HashMap::new(),
            waiting: HashMap::new(),
        };
        let arguments = readable.arguments.iter().map(|&argument| {
            let count = readable.spaces.len(argument.space());
            (argument, naming.argument(argument, count))
        });
        let arguments = arguments.collect();
        let fields = (0_u16..).zip(readable.fields);
        let fields = fields.map(|(field, wishes)| naming.field(field, wishes));
        let fields = fields.collect();
        if let Some(sections) = &arranged.sections {
            return naming.in_sections(sections, arguments, fields);
        }
        let repeats = &arranged.repeats;
        let is_literal = |read| matches!(read, Operand::Literal(_));
        let has_literals = program.operands().any(is_literal);
        let early = stored == Stored::Early && repeats.is_empty() && has_literals;
        let kept = if early { &[][..] } else { &program.results };
        let mut stored = BTreeSet::new();
        let mut turned = Vec::new();
        for (result, &operand) in program.results.iter().enumerate().filter(|_| early) {
            match operand {
                Operand::Literal(_) | Operand::Input(_) => continue,
                Operand::Sin(_) | Operand::Cos(_) => turned.push((result, operand)),
                Operand::Step(step) => naming.found.entry(step).or_default().push(result),
            }
            stored.insert(result);
        }
        let parts = nested(program, repeats, kept, &inlined);
        let mut statements = naming.statements(&parts.before);
        statements.extend(naming.sines_and_cosines());
        let found = |(result, operand)| Statement::StoreResult(result, naming.value(operand));
        statements.extend(turned.into_iter().map(found));
        let mut repeats = repeats.iter();
        for parts in &parts.after {
            statements.extend(naming.statements(parts));
            let each = repeats.next().map(|repeat| naming.loop_of(repeat, None));
            statements.extend(each.map(Statement::Loop));
        }
        let results = program.results.iter();
        Self {
            arguments,
            fields,
            statements,
            work: None,
            results: results.map(|&result| naming.value(result)).collect(),
            stored,
            has_literals,
            is_fused: (program.steps.iter()).any(|step| step.operation.is_fused()),
            names: naming.names,
            meanings: naming.meanings,
        }
    }
}

/// Meaning of the result of a step, if it has one.
fn meaning(program: &Program, sums: &Sums, step: u32) -> Option<Meaning> {
    let label = program.steps[step as usize].label.map(Meaning::Entry);
    label.or_else(|| Some(Meaning::Sum(sums.of_step(step)?.to_vec())))
}

/// For each angle: is its sine read, is its cosine read.
fn turns(program: &Program) -> Vec<[bool; 2]> {
    let mut turns = vec![[false; 2]; program.angles.len()];
    for operand in program.operands() {
        match operand {
            Operand::Sin(angle) => turns[angle as usize][0] = true,
            Operand::Cos(angle) => turns[angle as usize][1] = true,
            Operand::Literal(_) | Operand::Input(_) | Operand::Step(_) => {}
        }
    }
    turns
}

/// State of the naming of a routine.
struct Naming<'p> {
    program: &'p Program,
    sums: &'p Sums,
    inlined: &'p Inlined,
    names: Names,
    meanings: Vec<(String, Meaning)>,
    /// All inputs that are read, with their names as soon as they are bound.
    inputs: BTreeMap<Input, Option<String>>,
    angles: Vec<Angle>,
    /// Location of the result of each step.
    steps: Vec<Value>,
    /// Names of values without a meaning. Each section has them anew, since it is a function of its own.
    parts: Vec<String>,
    /// Number of these names that the current function has.
    unnamed: usize,
    /// Number of loops.
    loops: usize,
    /// Name of the index of all loops, if there are any.
    index: Option<String>,
    /// Steps that the current section or loop stores, with the places.
    stores: BTreeMap<u32, StorePlace>,
    /// Steps that are stored as results, with the indices of the results.
    found: BTreeMap<u32, Vec<usize>>,
    /// False in loops over columns, where a value stands for entries of several matrices.
    is_named: bool,
    /// Entries of rows that the steps of the current loop read, by step and operand; empty outside of loops.
    loads: HashMap<(u32, usize), Value>,
    /// Places of the values that the current section reads once, in the work array.
    waiting: HashMap<Shared, usize>,
}

impl Naming<'_> {
    /// Name of a value with this meaning.
    fn named(&mut self, meaning: Meaning) -> String {
        let name = self.names.fresh(&meaning.to_string());
        self.meanings.push((name.clone(), meaning));
        name
    }

    /// Names of the entries of an argument.
    fn argument(&mut self, argument: Variable, count: usize) -> Entries {
        let entries = (0_u16..).take(count).map(|k| {
            let named = |naming: &mut Self| naming.named(Meaning::Argument(argument, k));
            self.bound(Input::Variable(argument, k), named)
        });
        entries.collect()
    }

    /// Names of the entries of a field, from their preferred names.
    fn field(&mut self, field: u16, wishes: &[String]) -> Entries {
        let entries = (0_u16..).zip(wishes).map(|(k, wish)| {
            self.bound(Input::Parameter(field, k), |naming| {
                naming.names.fresh(wish)
            })
        });
        entries.collect()
    }

    /// Name of an input, if it is read.
    fn bound(&mut self, input: Input, name: impl FnOnce(&mut Self) -> String) -> Option<String> {
        if !self.inputs.contains_key(&input) {
            return None;
        }
        let name = name(self);
        self.inputs.insert(input, Some(name.clone()));
        Some(name)
    }

    fn value(&self, operand: Operand) -> Value {
        let place = Shared::of(operand).and_then(|value| self.waiting.get(&value));
        if let Some(&place) = place {
            return Value::Work(place);
        }
        let name = match operand {
            Operand::Literal(value) => return Value::Literal(value),
            Operand::Input(input) => self.inputs[&input].as_ref(),
            Operand::Sin(angle) => self.angles[angle as usize].sine.as_ref(),
            Operand::Cos(angle) => self.angles[angle as usize].cosine.as_ref(),
            Operand::Step(step) => {
                let value = self.steps.get(step as usize);
                return value.expect("what is read is computed before").clone();
            }
        };
        Value::Name(name.expect("what is read is bound before").clone())
    }

    fn statements(&mut self, entries: &[ScopeEntry]) -> Vec<Statement> {
        let mut statements = Vec::with_capacity(entries.len());
        for entry in entries {
            match entry {
                ScopeEntry::Step(step) => self.step(*step, &mut statements),
                ScopeEntry::Block(Block { entries, outputs }) => {
                    let inside = self.statements(entries);
                    let outputs = outputs.iter().filter_map(|&step| self.name(step));
                    statements.push(Statement::Block {
                        statements: inside,
                        outputs: outputs.collect(),
                    });
                }
            }
        }
        statements
    }

    /// Statements of a step, after the steps before it that are inlined.
    fn step(&mut self, step: u32, statements: &mut Vec<Statement>) {
        while self.next() < step {
            let operation = self.operation();
            self.steps.push(Value::Operation(Box::new(operation)));
        }
        let operation = self.operation();
        let place = self.stores.get(&step).cloned();
        if let (Some(place), true) = (&place, self.inlined.in_store(step)) {
            let value = Value::Operation(Box::new(operation));
            self.steps.push(place.value());
            statements.push(Statement::Store(place.clone(), value));
            return;
        }
        let name = self.name_of_next();
        let value = Value::Name(name.clone());
        statements.push(Statement::Operation(name, operation));
        statements.extend(place.map(|place| Statement::Store(place, value.clone())));
        let results = self.found.get(&step).into_iter().flatten();
        let store = |&result| Statement::StoreResult(result, value.clone());
        statements.extend(results.map(store));
        self.steps.push(value);
    }

    /// Operation of the next step.
    fn operation(&self) -> Operation<Value> {
        let step = self.next();
        let mut operand = 0;
        let operation = self.program.steps[step as usize].operation;
        operation.map(|of| {
            let loaded = self.loads.get(&(step, operand));
            operand += 1;
            loaded.map_or_else(|| self.value(of), Value::clone)
        })
    }

    /// Name for the result of the next step: that of its matrix entry, of the coordinates that it sums, or a number.
    fn name_of_next(&mut self) -> String {
        let meaning = self.meaning(self.next()).filter(|_| self.is_named);
        match meaning {
            Some(meaning) => self.named(meaning),
            None => self.unnamed(),
        }
    }

    /// Meaning of the result of a step, if it has one.
    fn meaning(&self, step: u32) -> Option<Meaning> {
        meaning(self.program, self.sums, step)
    }

    /// Name of the result of a step, unless it is in the work array alone.
    fn name(&self, step: u32) -> Option<String> {
        match &self.steps[step as usize] {
            Value::Name(name) => Some(name.clone()),
            _ => None,
        }
    }

    /// Index of the step that is named next.
    fn next(&self) -> u32 {
        u32::try_from(self.steps.len()).expect("fewer than 2³² steps")
    }

    /// Next name of a value without a meaning.
    fn unnamed(&mut self) -> String {
        let known = self.parts.get(self.unnamed).cloned();
        self.unnamed += 1;
        known.unwrap_or_else(|| {
            let name = self.named(Meaning::Part(self.unnamed));
            self.parts.push(name.clone());
            name
        })
    }

    /// All sines and cosines, named after the coordinates that the angles are sums of.
    fn sines_and_cosines(&mut self) -> Option<Statement> {
        for (&angle, &[has_sine, has_cosine]) in
            self.program.angles.iter().zip(&turns(self.program))
        {
            let value = self.value(angle);
            let turn = self.turn(angle, &value);
            let sine = has_sine.then(|| self.named(Meaning::Sine(turn.clone())));
            let cosine = has_cosine.then(|| self.named(Meaning::Cosine(turn)));
            self.angles.push(Angle {
                value,
                sine,
                cosine,
            });
        }
        let some = !self.angles.is_empty();
        some.then(|| Statement::SinesAndCosines(self.angles.clone()))
    }

    /// Angle with its name and coordinates.
    fn turn(&self, angle: Operand, value: &Value) -> RotationAngle {
        let name = match value {
            Value::Name(name) => name.clone(),
            Value::Literal(_)
            | Value::Work(_)
            | Value::Entry(..)
            | Value::Cell(..)
            | Value::Operation(_) => "a".to_owned(),
        };
        RotationAngle {
            name,
            coordinates: self.sums.of_operand(angle).unwrap_or_default(),
        }
    }
}

fn unbound(operand: Operand) -> Option<(Input, Option<String>)> {
    match operand {
        Operand::Input(input) => Some((input, None)),
        _ => None,
    }
}
