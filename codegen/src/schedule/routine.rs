//! A program as every language writes it: names, statements, spaces.
//!
//! In: a [`Program`], what it can read, and the names that are taken. Out: a [`Routine`]. It knows no
//! language, never names what nobody reads, and changes no operation.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use super::blocks::{Block, Part, nested};
use super::names::Names;
use super::{Operand, Operation, Program, Step};
use crate::expression::Input;
use crate::space::{ACTION, Spaces, Variable};

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
    /// The results, as the program has them.
    pub results: Vec<Value>,
    /// Whether a number known at generation is among the values.
    pub has_literals: bool,
    /// Whether an operation is a product and a sum at once.
    pub is_fused: bool,
    /// All these names and those that were taken before, for what a language binds besides.
    pub names: Names,
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
}

impl Routine {
    /// Names what a program reads and computes, beside the names that are taken.
    ///
    /// # Panics
    /// Where the program reads an input that it cannot, or a step before it is computed.
    #[must_use]
    pub fn of(program: &Program, readable: &Readable<'_>, mut names: Names) -> Self {
        for argument in readable.arguments {
            names.take(argument.name());
        }
        let mut naming = Naming {
            program,
            read: program.operands().collect(),
            names,
            inputs: program.operands().filter_map(unbound).collect(),
            angles: Vec::new(),
            steps: Vec::with_capacity(program.steps.len()),
            sums: Vec::with_capacity(program.steps.len()),
            unnamed: 0,
        };
        let arguments = readable.arguments.iter().map(|&argument| {
            let entries = 0..readable.spaces.len(argument.space());
            let wishes = entries.map(|k| wish(argument, k));
            let input = |k| Input::Variable(argument, k);
            (argument, naming.entries(wishes, input))
        });
        let arguments = arguments.collect();
        let fields = (0_u16..).zip(readable.fields).map(|(field, wishes)| {
            let input = |k| Input::Parameter(field, k);
            naming.entries(wishes.iter().cloned(), input)
        });
        let fields = fields.collect();
        let [before, after] = nested(program);
        let mut statements = naming.statements(&before);
        statements.extend(naming.sines_and_cosines());
        statements.extend(naming.statements(&after));
        let results = program.results.iter();
        Self {
            arguments,
            fields,
            statements,
            results: results.map(|&result| naming.value(result)).collect(),
            has_literals: (naming.read.iter()).any(|read| matches!(read, Operand::Literal(_))),
            is_fused: (program.steps.iter()).any(|step| step.operation.is_fused()),
            names: naming.names,
        }
    }
}

/// A routine in the making.
struct Naming<'p> {
    program: &'p Program,
    /// Everything that is read.
    read: Vec<Operand>,
    names: Names,
    /// All inputs that are read, with their names once they are bound.
    inputs: BTreeMap<Input, Option<String>>,
    angles: Vec<Angle>,
    steps: Vec<String>,
    /// The coordinates that a step is the sum of.
    sums: Vec<Option<Vec<u16>>>,
    unnamed: usize,
}

impl Naming<'_> {
    fn entries(
        &mut self,
        wishes: impl Iterator<Item = String>,
        input: impl Fn(u16) -> Input,
    ) -> Entries {
        let entries = (0_u16..).zip(wishes).map(|(k, wish)| {
            let name = self.inputs.get_mut(&input(k))?;
            *name = Some(self.names.fresh(&wish));
            name.clone()
        });
        entries.collect()
    }

    fn value(&self, operand: Operand) -> Value {
        let name = match operand {
            Operand::Literal(value) => return Value::Literal(value),
            Operand::Input(input) => self.inputs[&input].as_ref(),
            Operand::Sin(angle) => self.angles[angle as usize].sine.as_ref(),
            Operand::Cos(angle) => self.angles[angle as usize].cosine.as_ref(),
            Operand::Step(step) => self.steps.get(step as usize),
        };
        Value::Name(name.expect("what is read is bound before").clone())
    }

    fn statements(&mut self, parts: &[Part]) -> Vec<Statement> {
        let statements = parts.iter().map(|part| match part {
            Part::Step(step) => self.operation(&self.program.steps[*step as usize]),
            Part::Block(Block { parts, handed_on }) => {
                let statements = self.statements(parts);
                let handed_on = handed_on
                    .iter()
                    .map(|&step| self.steps[step as usize].clone());
                let handed_on = handed_on.collect();
                Statement::Block {
                    statements,
                    handed_on,
                }
            }
        });
        statements.collect()
    }

    /// An operation whose result is called as its entry of a matrix, or after the coordinates
    /// that it is the sum of, or by a number.
    fn operation(&mut self, step: &Step) -> Statement {
        let operation = step.operation.map(|operand| self.value(operand));
        let sum = self.sum(step.operation);
        let wish = match (&step.label, &sum) {
            (Some(label), _) => label.clone(),
            (None, Some(coordinates)) => format!("q_{}", numbers(coordinates)),
            (None, None) => {
                self.unnamed += 1;
                format!("t_{}", self.unnamed)
            }
        };
        let name = self.names.fresh(&wish);
        self.sums.push(sum);
        self.steps.push(name.clone());
        Statement::Operation(name, operation)
    }

    /// All sines and cosines, called after the coordinates that the angles are sums of.
    fn sines_and_cosines(&mut self) -> Option<Statement> {
        for (index, &angle) in (0_u32..).zip(&self.program.angles) {
            let subject = self.subject(angle);
            let value = self.value(angle);
            let mut bind = |letter: char, operand: Operand| {
                let name = || self.names.fresh(&format!("{letter}_{subject}"));
                self.read.contains(&operand).then(name)
            };
            let sine = bind('s', Operand::Sin(index));
            let cosine = bind('c', Operand::Cos(index));
            self.angles.push(Angle {
                value,
                sine,
                cosine,
            });
        }
        let some = !self.angles.is_empty();
        some.then(|| Statement::SinesAndCosines(self.angles.clone()))
    }

    /// What an angle is of: `2`, `2_3` for q₂ + q₃, or the name of a step.
    fn subject(&self, angle: Operand) -> String {
        match (self.coordinates_of(angle), angle) {
            (Some(coordinates), _) => numbers(&coordinates),
            (None, Operand::Step(step)) => self.steps[step as usize].clone(),
            (None, Operand::Input(input)) => self.inputs[&input].clone().unwrap_or_default(),
            (None, _) => "a".to_owned(),
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

/// What an entry of an argument would like to be called.
fn wish(argument: Variable, entry: usize) -> String {
    match argument {
        Variable::Actions => {
            let (action, entry) = (entry / ACTION.len(), entry % ACTION.len());
            format!("action_{}_{}", action + 1, ACTION[entry].0)
        }
        _ => format!("{}_{}", argument.name(), entry + 1),
    }
}

fn unbound(operand: Operand) -> Option<(Input, Option<String>)> {
    match operand {
        Operand::Input(input) => Some((input, None)),
        _ => None,
    }
}

/// Coordinates as the paper counts them, from 1.
fn numbers(coordinates: &[u16]) -> String {
    let numbers: Vec<_> = coordinates.iter().map(|k| (k + 1).to_string()).collect();
    numbers.join("_")
}
