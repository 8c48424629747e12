//! Parts of long loops over columns.
//!
//! In: a [`Program`] and its loops, in order. Out: the same operations in another order, with loops over columns that are
//! no longer than a section and read and write few values, one after the other where one was longer. Results are the
//! same bits.
//!
//! Compilers keep a vector for each value that is the same for all columns, and their time grows with the square of the
//! number of values that a loop reads.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use super::limbs::{MOST_ROWS, best_end};
use super::readers::read_until;
use super::repeats::{Iterations, Over, Repeat, of_iterations};
use super::sections::Shared;
use super::{Operand, Program, Step, number};

/// The program with all loops over columns in parts of at most `longest` steps.
pub fn in_parts(program: &Program, repeats: &[Repeat], longest: usize) -> (Program, Vec<Repeat>) {
    let before = read_until(program, &program.results);
    let mut steps: Vec<u32> = Vec::with_capacity(program.steps.len());
    let mut loops = Iterations::new();
    for each in repeats {
        steps.extend(number(steps.len())..each.first.start);
        let parts = match each.over {
            Over::Columns => parts(program, each, &before, longest),
            Over::Limbs => vec![each.first.clone()],
        };
        for part in parts {
            let first = steps.len()..steps.len() + part.len();
            loops.push((each.over, first, each.iterations as usize));
            for iteration in 0..each.iterations {
                let distance = iteration * each.length();
                steps.extend(part.start + distance..part.end + distance);
            }
        }
    }
    steps.extend(number(steps.len())..number(program.steps.len()));
    let program = reordered(program, &steps);
    let repeats = of_iterations(&program, loops);
    (program, repeats)
}

/// The program with its steps in this order.
fn reordered(program: &Program, order: &[u32]) -> Program {
    let mut places = vec![0; order.len()];
    for (place, &step) in (0..).zip(order) {
        places[step as usize] = place;
    }
    let placed = |operand| match operand {
        Operand::Step(step) => Operand::Step(places[step as usize]),
        other => other,
    };
    let steps = order.iter().map(|&step| {
        let Step { label, operation } = program.steps[step as usize];
        let operation = operation.map(placed);
        Step { label, operation }
    });
    Program {
        angles: program.angles.iter().copied().map(placed).collect(),
        before_angles: program.before_angles,
        results: program.results.iter().copied().map(placed).collect(),
        steps: steps.collect(),
        open: program.open.clone(),
    }
}

/// The first iteration of a loop in parts.
fn parts(
    program: &Program,
    repeat: &Repeat,
    read_until: &[u32],
    longest: usize,
) -> Vec<Range<u32>> {
    let until = last_readers(program, repeat, read_until);
    let (mut parts, mut rest) = (Vec::new(), repeat.first.clone());
    while !rest.is_empty() {
        let end = rest.start + number(length(program, repeat, &rest, &until, longest));
        parts.push(rest.start..end);
        rest.start = end;
    }
    parts
}

/// For each step of the first iteration the last one that reads it; `u32::MAX` if it is read after the loop.
fn last_readers(program: &Program, repeat: &Repeat, read_until: &[u32]) -> HashMap<u32, u32> {
    let end = repeat.steps().end;
    let mut until = HashMap::new();
    for at in repeat.first.clone() {
        until.insert(at, at);
        for operand in program.steps[at as usize].operation.operands() {
            if let Operand::Step(step) = operand
                && repeat.first.contains(&step)
            {
                until.insert(step, at);
            }
        }
    }
    for step in repeat.first.clone() {
        let of_all = (0..repeat.iterations).map(|iteration| step + iteration * repeat.length());
        if of_all
            .into_iter()
            .any(|step| read_until[step as usize] >= end)
        {
            until.insert(step, u32::MAX);
        }
    }
    until
}

/// Number of steps of the first part of what is left of an iteration.
fn length(
    program: &Program,
    repeat: &Repeat,
    rest: &Range<u32>,
    until: &HashMap<u32, u32>,
    longest: usize,
) -> usize {
    let (mut values, mut rows) = (HashSet::new(), HashSet::new());
    // Number of values by last reader, and of those that are still read.
    let (mut ending, mut alive) = (HashMap::new(), 0);
    let mut allowed = Vec::new();
    for at in rest.clone() {
        let operands = program.steps[at as usize].operation.operands();
        for (slot, operand) in operands.into_iter().enumerate() {
            match (repeat.reads.get(&(at, slot)), operand) {
                (Some(row), _) => {
                    rows.insert(Err(*row));
                }
                (None, Operand::Step(step)) if repeat.first.contains(&step) => {
                    if step < rest.start {
                        rows.insert(Ok(step));
                    }
                }
                (None, operand) => values.extend(Shared::of(operand)),
            }
        }
        let length = (at + 1 - rest.start) as usize;
        *ending.entry(until[&at]).or_insert(0) += 1;
        alive += 1;
        alive -= ending.remove(&at).unwrap_or(0);
        if length > longest || values.len() + rows.len() > MOST_ROWS {
            break;
        }
        if values.len() + rows.len() + alive <= MOST_ROWS {
            allowed.push((length, alive));
        }
    }
    best_end(&allowed, rest.len())
}
