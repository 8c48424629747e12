//! A program as every language writes it: names, statements, spaces.
//!
//! In: a [`Program`], what it can read, and the names that are taken. Out: a [`Routine`]. It knows no
//! language, never names what nobody reads, and changes no operation.

mod apart;
mod meaning;
mod rounds;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet, HashMap};

pub use self::apart::{Apart, Work};
pub use self::meaning::{Meaning, Turn};
pub use self::rounds::Rounds;
use super::blocks::{Block, Part, nested};
use super::names::Names;
use super::repeats::repeats;
use super::sections::{Length, sections};
use super::{Operand, Operation, Program, Step};
use crate::expression::Input;
use crate::space::{Spaces, Variable};

/// What a function can read.
#[derive(Clone, Copy, Debug)]
pub struct Readable<'a> {
    /// Its arguments.
    pub arguments: &'a [Variable],
    /// What they are over.
    pub spaces: &'a Spaces,
    /// The names that the entries of each field would like, in the order in which
    /// [`Input::Parameter`] counts the fields.
    pub fields: &'a [Vec<String>],
}

/// The body of one function.
#[derive(Clone, Debug)]
pub struct Routine {
    /// The arguments; their own names are given to nothing else.
    pub arguments: Vec<(Variable, Entries)>,
    /// All fields.
    pub fields: Vec<Entries>,
    /// What is computed, in the order in which it is.
    pub statements: Vec<Statement>,
    /// What is computed behind that in functions of their own, where it is long.
    pub work: Option<Work>,
    /// The results, as the program has them; those that are stored as they are found may be bound no more.
    pub results: Vec<Value>,
    /// The results that are stored as they are found.
    pub stored: BTreeSet<usize>,
    /// Whether a number known at generation is among the values, but for those of functions of their own.
    pub has_literals: bool,
    /// Whether an operation is a product and a sum at once, but for those of functions of their own.
    pub is_fused: bool,
    /// All these names and those that were taken before, for what a language binds besides.
    pub names: Names,
    /// The names with what they stand for, in the order in which they were given, but for those of fields.
    pub meanings: Vec<(String, Meaning)>,
}

/// The name of each entry of an argument or a field; none where it is not read.
pub type Entries = Vec<Option<String>>;

/// One statement of a routine.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// An operation and the name of its result.
    Operation(String, Operation<Value>),
    /// All sines and cosines; there is at least one angle.
    SinesAndCosines(Vec<Angle>),
    /// Statements in a scope of their own.
    Block {
        /// What is inside.
        statements: Vec<Statement>,
        /// The names that are read behind it.
        handed_on: Vec<String>,
    },
    /// The value is put into the work array, at that place.
    Left(usize, Value),
    /// The value is stored as the result of that index.
    Found(usize, Value),
    /// The same statements in each of several rounds.
    Rounds(Rounds),
}

/// When results are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// All of them, behind the last statement.
    AtTheEnd,
    /// Each that is computed, behind the statement that computes it; where that is possible.
    AsFound,
}

/// An angle, and the names of its sine and cosine; none where it is not read.
#[derive(Clone, Debug, PartialEq)]
pub struct Angle {
    /// The angle \[rad\].
    pub value: Value,
    /// Its sine.
    pub sine: Option<String>,
    /// Its cosine.
    pub cosine: Option<String>,
}

/// What an operation of a routine acts on.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number known at generation.
    Literal(f64),
    /// What is bound to the name.
    Name(String),
    /// What waits at a place of the work array.
    Waiting(usize),
    /// What stands in a table of rounds: its name, the row, and the round.
    Entry(String, usize, usize),
}

impl Routine {
    /// Names what a program reads and computes, beside the names that are taken, in functions of a length.
    /// Results are stored at the end where anything waits in an array, or no number can be written in their place.
    ///
    /// # Panics
    /// Where the program reads an input that it cannot, or a step before it is computed.
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
        let mut naming = Naming {
            program,
            names,
            meanings: Vec::with_capacity(program.steps.len()),
            inputs: program.operands().filter_map(unbound).collect(),
            angles: Vec::new(),
            steps: Vec::with_capacity(program.steps.len()),
            sums: Vec::with_capacity(program.steps.len()),
            unnamed: 0,
            left: BTreeMap::new(),
            found: BTreeMap::new(),
            taken: HashMap::new(),
        };
        let arguments = readable.arguments.iter().map(|&argument| {
            let count = readable.spaces.len(argument.space());
            (argument, naming.argument(argument, count))
        });
        let arguments = arguments.collect();
        let fields = (0_u16..).zip(readable.fields);
        let fields = fields.map(|(field, wishes)| naming.field(field, wishes));
        let fields = fields.collect();
        if let Some(sections) = sections(program, length) {
            return naming.in_sections(&sections, arguments, fields);
        }
        let repeats = repeats(program);
        let is_literal = |read| matches!(read, Operand::Literal(_));
        let has_literals = program.operands().any(is_literal);
        let early = stored == Stored::AsFound && repeats.is_empty() && has_literals;
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
        let parts = nested(program, &repeats, kept);
        let mut statements = naming.statements(&parts.before);
        statements.extend(naming.sines_and_cosines());
        let found = |(result, operand)| Statement::Found(result, naming.value(operand));
        statements.extend(turned.into_iter().map(found));
        let mut repeats = repeats.iter();
        for parts in &parts.after {
            statements.extend(naming.statements(parts));
            let rounds = repeats.next().map(|repeat| naming.rounds(repeat));
            statements.extend(rounds.map(Statement::Rounds));
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

/// Of each angle whether anything reads its sine, and its cosine.
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

/// A routine in the making.
struct Naming<'p> {
    program: &'p Program,
    names: Names,
    meanings: Vec<(String, Meaning)>,
    /// All inputs that are read, with their names once they are bound.
    inputs: BTreeMap<Input, Option<String>>,
    angles: Vec<Angle>,
    /// Where the result of each step is found.
    steps: Vec<Value>,
    /// The coordinates that a step is the sum of.
    sums: Vec<Option<Vec<u16>>>,
    unnamed: usize,
    /// The steps that are put into the work array, and where.
    left: BTreeMap<u32, usize>,
    /// The steps that are stored as results, and as which.
    found: BTreeMap<u32, Vec<usize>>,
    /// Of the round that is written, what a step takes as one of its operands; nothing outside of rounds.
    taken: HashMap<(u32, usize), String>,
}

impl Naming<'_> {
    /// The name of a value of that meaning.
    fn named(&mut self, meaning: Meaning) -> String {
        let name = self.names.fresh(&meaning.to_string());
        self.meanings.push((name.clone(), meaning));
        name
    }

    /// The names of the entries of an argument.
    fn argument(&mut self, argument: Variable, count: usize) -> Entries {
        let entries = (0_u16..).take(count).map(|k| {
            let named = |naming: &mut Self| naming.named(Meaning::Argument(argument, k));
            self.bound(Input::Variable(argument, k), named)
        });
        entries.collect()
    }

    /// The names of the entries of a field, which would like to be called so.
    fn field(&mut self, field: u16, wishes: &[String]) -> Entries {
        let entries = (0_u16..).zip(wishes).map(|(k, wish)| {
            self.bound(Input::Parameter(field, k), |naming| {
                naming.names.fresh(wish)
            })
        });
        entries.collect()
    }

    /// The name of an input, where it is read.
    fn bound(&mut self, input: Input, name: impl FnOnce(&mut Self) -> String) -> Option<String> {
        if !self.inputs.contains_key(&input) {
            return None;
        }
        let name = name(self);
        self.inputs.insert(input, Some(name.clone()));
        Some(name)
    }

    fn value(&self, operand: Operand) -> Value {
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

    fn statements(&mut self, parts: &[Part]) -> Vec<Statement> {
        let mut statements = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                Part::Step(step) => {
                    statements.push(self.operation(&self.program.steps[*step as usize]));
                    if let Some(&place) = self.left.get(step) {
                        let value = self.steps[*step as usize].clone();
                        statements.push(Statement::Left(place, value));
                    }
                    for &result in self.found.get(step).into_iter().flatten() {
                        let value = self.steps[*step as usize].clone();
                        statements.push(Statement::Found(result, value));
                    }
                }
                Part::Block(Block { parts, handed_on }) => {
                    let inside = self.statements(parts);
                    let handed_on = handed_on.iter().map(|&step| self.name(step));
                    statements.push(Statement::Block {
                        statements: inside,
                        handed_on: handed_on.collect(),
                    });
                }
            }
        }
        statements
    }

    /// The name that the result of a step is bound to.
    fn name(&self, step: u32) -> String {
        match &self.steps[step as usize] {
            Value::Name(name) => name.clone(),
            _ => unreachable!("a step outside of rounds is bound to a name"),
        }
    }

    /// An operation whose result is called as its entry of a matrix, or after the coordinates
    /// that it is the sum of, or by a number.
    fn operation(&mut self, step: &Step) -> Statement {
        let mut operand = 0;
        let operation = step.operation.map(|of| {
            let taken = self.taken.get(&(self.next(), operand));
            operand += 1;
            taken.map_or_else(|| self.value(of), |name| Value::Name(name.clone()))
        });
        // What is computed for several is an entry of none of them.
        let by_itself = self.taken.is_empty();
        let label = step.label.filter(|_| by_itself);
        let sum = self.sum(step.operation).filter(|_| by_itself);
        let name = match (label, &sum) {
            (Some(label), _) => self.named(Meaning::Entry(label)),
            (None, Some(coordinates)) => self.named(Meaning::Sum(coordinates.clone())),
            (None, None) => self.unnamed(),
        };
        self.sums.push(sum);
        self.steps.push(Value::Name(name.clone()));
        Statement::Operation(name, operation)
    }

    /// The step that has no name yet.
    fn next(&self) -> u32 {
        u32::try_from(self.steps.len()).expect("fewer than 2³² steps")
    }

    /// The next name of what is no entry of anything.
    fn unnamed(&mut self) -> String {
        self.unnamed += 1;
        self.named(Meaning::Part(self.unnamed))
    }

    /// All sines and cosines, called after the coordinates that the angles are sums of.
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

    /// An angle with its name and coordinates.
    fn turn(&self, angle: Operand, value: &Value) -> Turn {
        let name = match value {
            Value::Name(name) => name.clone(),
            Value::Literal(_) | Value::Waiting(_) | Value::Entry(..) => "a".to_owned(),
        };
        Turn {
            name,
            coordinates: self.coordinates_of(angle).unwrap_or_default(),
        }
    }

    /// The coordinates that an operation sums, if it does nothing else.
    fn sum(&self, operation: Operation) -> Option<Vec<u16>> {
        let Operation::Add(a, b) = operation else {
            return None;
        };
        let mut coordinates = self.coordinates_of(a)?;
        coordinates.extend(self.coordinates_of(b)?);
        coordinates.sort_unstable();
        Some(coordinates)
    }

    fn coordinates_of(&self, operand: Operand) -> Option<Vec<u16>> {
        match operand {
            Operand::Input(Input::Variable(Variable::Q, k)) => Some(vec![k]),
            Operand::Step(step) => self.sums.get(step as usize)?.clone(),
            _ => None,
        }
    }
}

fn unbound(operand: Operand) -> Option<(Input, Option<String>)> {
    match operand {
        Operand::Input(input) => Some((input, None)),
        _ => None,
    }
}
