//! Separation of programs into the part that depends on struct fields alone, and the rest.
//!
//! In: the programs of a robot. Out: one program of the fields with everything that the programs compute from fields
//! alone, and for each program its rest, which reads the results of the first in place of fields. Operations are
//! neither changed nor added, and none is moved past another that it depends on, so that results have the same bits.

#[cfg(test)]
mod tests;

use std::collections::HashMap;

use super::names::sanitize;
use super::{Operand, Operation, Program, Step};
use crate::expression::Input;

/// Separated programs.
#[derive(Clone, Debug)]
pub struct SeparatedPrograms {
    /// Program that depends on fields alone. Its results are the values that the others read.
    pub once: Program,
    /// Preferred names of these values, all different.
    pub names: Vec<String>,
    /// Rest of each program: it reads no field, and [`Input::Parameter`] with field 0 is a value of `once`.
    pub each: Vec<Program>,
}

/// Separates programs; `fields` has a name for each entry of each field.
#[must_use]
pub fn part(programs: &[&Program], fields: &[Vec<String>]) -> SeparatedPrograms {
    let mut once = Once::default();
    let each = programs.iter().map(|program| once.take(program)).collect();
    let names = once.names(fields);
    SeparatedPrograms {
        once: once.program(),
        names,
        each,
    }
}

/// Operand by its bits, for the search of equal ones.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum OperandKey {
    Literal(u64),
    Input(Input),
    Sin(u32),
    Cos(u32),
    Step(u32),
}

impl OperandKey {
    fn of(operand: Operand) -> Self {
        match operand {
            Operand::Literal(value) => Self::Literal(value.to_bits()),
            Operand::Input(input) => Self::Input(input),
            Operand::Sin(angle) => Self::Sin(angle),
            Operand::Cos(angle) => Self::Cos(angle),
            Operand::Step(step) => Self::Step(step),
        }
    }
}

/// State of the program of fields: its steps in the order in which they were added.
#[derive(Default)]
struct Once {
    steps: Vec<Step>,
    angles: Vec<Operand>,
    values: Vec<Operand>,
    known_steps: HashMap<(std::mem::Discriminant<Operation>, Vec<OperandKey>), u32>,
    known_angles: HashMap<OperandKey, u32>,
    known_values: HashMap<OperandKey, u16>,
}

/// New places of the steps and angles of one program: in the program of fields or in the rest.
struct NewPlaces {
    steps: Vec<NewPlace>,
    angles: Vec<NewPlace>,
}

#[derive(Clone, Copy)]
enum NewPlace {
    Once(u32),
    Left(u32),
}

impl NewPlaces {
    /// Operand in the program of fields; `None` if it depends on anything else.
    fn once(&self, operand: Operand) -> Option<Operand> {
        let place = |places: &[NewPlace], k: u32| match places[k as usize] {
            NewPlace::Once(k) => Some(k),
            NewPlace::Left(_) => None,
        };
        match operand {
            Operand::Literal(_) | Operand::Input(Input::Parameter(..)) => Some(operand),
            Operand::Input(Input::Variable(..)) => None,
            Operand::Sin(k) => place(&self.angles, k).map(Operand::Sin),
            Operand::Cos(k) => place(&self.angles, k).map(Operand::Cos),
            Operand::Step(k) => place(&self.steps, k).map(Operand::Step),
        }
    }

    /// Operand in the rest.
    fn left(&self, operand: Operand, once: &mut Once) -> Operand {
        let place = |places: &[NewPlace], k: u32| match places[k as usize] {
            NewPlace::Once(k) | NewPlace::Left(k) => k,
        };
        match (self.once(operand), operand) {
            (Some(literal @ Operand::Literal(_)), _) => literal,
            (Some(value), _) => Operand::Input(Input::Parameter(0, once.value(value))),
            (None, Operand::Sin(k)) => Operand::Sin(place(&self.angles, k)),
            (None, Operand::Cos(k)) => Operand::Cos(place(&self.angles, k)),
            (None, Operand::Step(k)) => Operand::Step(place(&self.steps, k)),
            (None, other) => other,
        }
    }
}

impl Once {
    /// Moves the steps that depend on fields alone, and returns the rest.
    fn take(&mut self, program: &Program) -> Program {
        let mut moved = NewPlaces {
            steps: Vec::with_capacity(program.steps.len()),
            angles: Vec::with_capacity(program.angles.len()),
        };
        let mut left = Program {
            angles: Vec::new(),
            before_angles: 0,
            steps: Vec::new(),
            results: Vec::new(),
            open: program.open.clone(),
        };
        let (before, after) = program.steps.split_at(program.before_angles);
        self.steps_of(before, &mut moved, &mut left);
        left.before_angles = left.steps.len();
        for &angle in &program.angles {
            let place = if let Some(angle) = moved.once(angle) {
                NewPlace::Once(self.angle(angle))
            } else {
                left.angles.push(moved.left(angle, self));
                NewPlace::Left(index(left.angles.len() - 1))
            };
            moved.angles.push(place);
        }
        self.steps_of(after, &mut moved, &mut left);
        let results = program.results.iter();
        left.results = results.map(|&result| moved.left(result, self)).collect();
        left
    }

    fn steps_of(&mut self, steps: &[Step], moved: &mut NewPlaces, left: &mut Program) {
        for step in steps {
            let operands = step.operation.operands().into_iter();
            let of_fields: Option<Vec<Operand>> =
                operands.map(|operand| moved.once(operand)).collect();
            let place = if let Some(operands) = of_fields {
                NewPlace::Once(self.step(step, &operands))
            } else {
                let operation = step.operation.map(|operand| moved.left(operand, self));
                left.steps.push(Step {
                    label: step.label,
                    operation,
                });
                NewPlace::Left(index(left.steps.len() - 1))
            };
            moved.steps.push(place);
        }
    }

    /// Step with this operation and these operands, added if it is new.
    fn step(&mut self, step: &Step, operands: &[Operand]) -> u32 {
        let keys = operands.iter().copied().map(OperandKey::of).collect();
        let key = (std::mem::discriminant(&step.operation), keys);
        let next = index(self.steps.len());
        let found = *self.known_steps.entry(key).or_insert(next);
        if found == next {
            let mut operands = operands.iter().copied();
            let operation = step.operation;
            self.steps.push(Step {
                label: step.label,
                operation: operation.map(|read| operands.next().unwrap_or(read)),
            });
        }
        found
    }

    fn angle(&mut self, angle: Operand) -> u32 {
        let next = index(self.angles.len());
        let found = *self
            .known_angles
            .entry(OperandKey::of(angle))
            .or_insert(next);
        if found == next {
            self.angles.push(angle);
        }
        found
    }

    fn value(&mut self, value: Operand) -> u16 {
        let next = u16::try_from(self.values.len()).expect("fewer than 2¹⁶ values of fields");
        let found = *self
            .known_values
            .entry(OperandKey::of(value))
            .or_insert(next);
        if found == next {
            self.values.push(value);
        }
        found
    }

    /// Preferred names of the values: those of the matrix entry or the field.
    fn names(&self, fields: &[Vec<String>]) -> Vec<String> {
        let mut taken = HashMap::new();
        let values = self.values.iter().map(|value| {
            let wish = match *value {
                Operand::Step(step) => self.steps[step as usize]
                    .label
                    .map(|label| label.to_string()),
                Operand::Input(Input::Parameter(field, entry)) => {
                    Some(fields[usize::from(field)][usize::from(entry)].clone())
                }
                Operand::Sin(_) => Some("sine".to_owned()),
                Operand::Cos(_) => Some("cosine".to_owned()),
                Operand::Input(_) | Operand::Literal(_) => None,
            };
            let wish = sanitize(&wish.unwrap_or_else(|| "prepared".to_owned()));
            let count: &mut usize = taken.entry(wish.clone()).or_default();
            *count += 1;
            match *count {
                1 => wish,
                several => format!("{wish}_{several}"),
            }
        });
        values.collect()
    }

    /// The program, with the steps that angles depend on first.
    fn program(self) -> Program {
        let mut early = vec![false; self.steps.len()];
        let mut waiting = self.angles.clone();
        while let Some(operand) = waiting.pop() {
            if let Operand::Step(step) = operand
                && !early[step as usize]
            {
                early[step as usize] = true;
                waiting.extend(self.steps[step as usize].operation.operands());
            }
        }
        // The sort is stable: both groups keep their order.
        let mut order: Vec<usize> = (0..self.steps.len()).collect();
        order.sort_by_key(|&step| !early[step]);
        let mut places = vec![0; order.len()];
        for (place, &step) in order.iter().enumerate() {
            places[step] = index(place);
        }
        let moved = |operand: Operand| match operand {
            Operand::Step(step) => Operand::Step(places[step as usize]),
            other => other,
        };
        let steps = order.iter().map(|&step| Step {
            label: self.steps[step].label,
            operation: self.steps[step].operation.map(moved),
        });
        Program {
            angles: self.angles.iter().copied().map(moved).collect(),
            before_angles: early.iter().filter(|early| **early).count(),
            steps: steps.collect(),
            results: self.values.iter().copied().map(moved).collect(),
            ..Program::default()
        }
    }
}

fn index(k: usize) -> u32 {
    u32::try_from(k).expect("fewer than 2³² steps")
}
