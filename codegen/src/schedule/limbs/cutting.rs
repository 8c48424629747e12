//! Parts of a loop over limbs that compilers compute in vectors.
//!
//! In: the groups of all loops. Out: the groups of one, cut into loops that are no longer than a section and read and
//! write few rows. Each cut is in the last quarter of the allowed length, where the fewest values pass from one part
//! to the next.

use std::collections::{HashMap, HashSet};

use super::groups::Groups;
use super::iteration::{Iteration, IterationRow, LoopOperand};
use super::loops::Loops;
use crate::schedule::sections::Shared;
use crate::schedule::{Operand, Program};

/// Maximum number of rows that a loop reads and writes. LLVM distinguishes 250 addresses in a loop
/// (`alias-set-saturation-threshold`). It assumes that all of more are the same, and vectorizes no such loop.
pub const MOST_ROWS: usize = 240;

/// Readers of the groups of loops, which decide where a loop is cut.
pub struct Cutting<'p> {
    program: &'p Program,
    groups: &'p Groups,
    /// For each group its last reader as an index into the groups of its loop; `usize::MAX` if it is read elsewhere.
    until: Vec<usize>,
}

impl<'p> Cutting<'p> {
    /// The readers of all groups that loops compute.
    pub fn of(program: &'p Program, groups: &'p Groups, loops: &Loops) -> Self {
        let mut place = HashMap::new();
        for (number, members) in loops.loops.values().enumerate() {
            place.extend((0..).zip(members).map(|(at, &group)| (group, (number, at))));
        }
        let place = |operand| Some(*place.get(&groups.find(operand)?.0)?);
        let mut until = vec![0; groups.all.len()];
        let mut read = |operand: Operand, reader: Option<(usize, usize)>| {
            let Some((group, _)) = groups.find(operand) else {
                return;
            };
            let last = match (place(operand), reader) {
                (Some((of, _)), Some((by, at))) if of == by => at,
                _ => usize::MAX,
            };
            until[group] = until[group].max(last);
        };
        for (at, step) in (0_u32..).zip(&program.steps) {
            let reader = place(Operand::Step(at));
            for operand in step.operation.operands() {
                read(operand, reader);
            }
        }
        for &operand in program.angles.iter().chain(&program.results) {
            read(operand, None);
        }
        Self {
            program,
            groups,
            until,
        }
    }

    /// The groups of a loop in parts of at most `longest` rows.
    pub fn cut<'m>(&self, mut members: &'m [usize], longest: usize) -> Vec<&'m [usize]> {
        let (mut parts, mut start) = (Vec::new(), 0);
        while !members.is_empty() {
            let (part, rest) = members.split_at(self.end(members, start, longest));
            start += part.len();
            members = rest;
            parts.push(part);
        }
        parts
    }

    /// Length of the first part of these groups, the first of which has the index `start` in its loop.
    fn end(&self, members: &[usize], start: usize, longest: usize) -> usize {
        let mut iteration = Iteration::new(self.groups);
        let mut loads = HashSet::new();
        // Number of values by last reader, and of those that are still read.
        let (mut ending, mut alive) = (HashMap::new(), 0);
        // Each allowed length with the number of values that are still read.
        let mut allowed = Vec::new();
        for (length, &group) in (1..).zip(members) {
            let known = iteration.rows.len();
            iteration.push(self.program, group);
            loads.extend(iteration.rows[known..].iter().flat_map(loaded));
            if iteration.rows.len() > longest || loads.len() > MOST_ROWS {
                break;
            }
            let at = start + length - 1;
            *ending.entry(self.until[group]).or_insert(0) += 1;
            alive += 1;
            alive -= ending.remove(&at).unwrap_or(0);
            if loads.len() + alive <= MOST_ROWS {
                allowed.push((length, alive));
            }
        }
        best_end(&allowed, members.len())
    }
}

/// The best of the allowed lengths, each with the number of values that are still read there: all, or in the last
/// quarter the one with the fewest.
pub fn best_end(allowed: &[(usize, usize)], all: usize) -> usize {
    let farthest = allowed.last().map_or(1, |&(length, _)| length);
    if farthest == all {
        return farthest;
    }
    let late = allowed.iter().rev();
    let late = late.take_while(|(length, _)| *length > farthest - farthest / 4);
    late.min_by_key(|(_, alive)| alive)
        .map_or(farthest, |&(length, _)| length)
}

/// The values from outside that an operation reads and that differ between lanes, one for each lane; of a literal its
/// bits.
fn loaded(row: &IterationRow) -> Vec<Vec<Result<Shared, u64>>> {
    let lanes = row.iter().map(|(_, operation)| operation.operands());
    let lanes: Vec<Vec<LoopOperand>> = lanes.collect();
    let columns = (0..lanes[0].len()).filter_map(|k| {
        let values = lanes.iter().map(|operands| match operands[k] {
            LoopOperand::Outside(Operand::Literal(value)) => Some(Err(value.to_bits())),
            LoopOperand::Outside(operand) => Shared::of(operand).map(Ok),
            LoopOperand::Inside(_) => None,
        });
        let values: Vec<_> = values.collect::<Option<_>>()?;
        let is_same = values.iter().all(|value| *value == values[0]);
        (!is_same).then_some(values)
    });
    columns.collect()
}
