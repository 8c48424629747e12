//! Loops in a long program: consecutive stretches with the same operations on different values.
//!
//! In: a [`Program`]. Out: its [`Repeat`]s, which languages print as loops. Steps are neither changed nor moved, so
//! results do not depend on the loops.
//!
//! Straight-line code is slow once it exceeds the instruction cache, and small processors have little program memory.
//! The columns of a solution are the same instructions. Values that differ between iterations pass through a table, so
//! a loop pays only if an iteration computes several times the values that it reads from the table or writes to it.

#[cfg(test)]
pub mod tests;

use std::collections::HashMap;
use std::hash::Hash;
use std::mem::discriminant;
use std::ops::Range;

use super::readers::read_until;
use super::{Operand, Program, number};
use crate::space::Limbs;

/// Minimum number of steps of a program with loops.
const SHORTEST: usize = 900;

/// Number of consecutive operations that must be of the same kinds at a candidate for the next iteration.
const ALIKE: usize = 16;

/// Number of such stretches, one after the other, that must be alike at a candidate for the next one of long
/// iterations. In a product of matrices, the nearest candidates of a shorter stretch are rows of the same iteration.
const FAR: usize = 6;

/// Maximum number of candidates of each kind for the length of an iteration.
const TRIED: usize = 4;

/// Minimum number of steps saved.
const SAVED: usize = 300;

/// Minimum number of steps of an iteration for each value in the table.
const EACH: usize = 3;

/// Kind of the iterations of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Columns of a matrix.
    Columns,
    /// Equal limbs. Values have the names of the first limb.
    Limbs,
}

impl Over {
    /// Minimum number of iterations.
    const fn fewest(self) -> usize {
        match self {
            Self::Columns => 4,
            Self::Limbs => Limbs::FEWEST,
        }
    }
}

/// Iterations of the same operations, one after the other; none reads a result of another.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeat {
    /// Iterations.
    pub over: Over,
    /// Steps of the first iteration.
    pub first: Range<u32>,
    /// Number of iterations.
    pub iterations: u32,
    /// Values that differ between iterations, with the operand of each iteration.
    pub loads: Vec<Vec<Operand>>,
    /// Index into `loads` of the value that a step of the first iteration reads as one of its operands.
    pub reads: HashMap<(u32, usize), usize>,
    /// Steps of the first iteration whose results are read after the loop, in any of its iterations.
    pub stores: Vec<u32>,
}

impl Repeat {
    /// Steps of all iterations.
    #[must_use]
    pub fn steps(&self) -> Range<u32> {
        self.first.start..self.first.start + self.length() * self.iterations
    }

    /// Number of steps of an iteration.
    #[must_use]
    pub fn length(&self) -> u32 {
        self.first.end - self.first.start
    }

    /// Operands of the first iteration that are in no row: its own results, and values that are the same for all.
    pub fn in_no_row<'a>(&'a self, program: &'a Program) -> impl Iterator<Item = Operand> + 'a {
        self.first.clone().flat_map(move |at| {
            let operands = program.steps[at as usize].operation.operands();
            let operands = operands.into_iter().enumerate();
            let others = operands.filter(move |&(slot, _)| !self.reads.contains_key(&(at, slot)));
            others.map(|(_, operand)| operand)
        })
    }

    /// Steps whose results are stored, each in all iterations.
    #[must_use]
    pub fn stored(&self) -> Vec<u32> {
        let of_all = |store: &u32| {
            let store = *store;
            (0..self.iterations).map(move |iteration| store + iteration * self.length())
        };
        self.stores.iter().flat_map(of_all).collect()
    }

    /// Number of steps saved.
    #[must_use]
    pub fn saved(&self) -> usize {
        self.steps().len() - self.first.len()
    }

    fn pays(&self) -> bool {
        let crossing = self.loads.len() + self.stores.len();
        self.saved() >= SAVED && self.first.len() >= EACH * crossing && !self.loads.is_empty()
    }
}

/// Repeats after the sines of a program, in order.
#[must_use]
pub fn repeats(program: &Program) -> Vec<Repeat> {
    let mut found: Vec<Repeat> = Vec::new();
    if program.steps.len() < SHORTEST {
        return found;
    }
    let [near, far] = next_alike(program);
    let read_until = read_until(program, &program.results);
    let mut at = program.before_angles;
    while at < near.len() {
        let starts = [&near, &far].into_iter().flat_map(|next| {
            let next = |at: usize| next.get(at).copied().flatten();
            std::iter::successors(next(at), move |&start| next(start)).take(TRIED)
        });
        let mut tried = starts.filter_map(|start| {
            let most = (program.steps.len() - at) / (start - at);
            repeat(program, Over::Columns, at..start, most, &read_until)
        });
        match tried.find(Repeat::pays) {
            Some(repeat) => {
                at = repeat.steps().end as usize;
                found.push(repeat);
            }
            None => at += 1,
        }
    }
    found
}

/// For each step, the next one at which the same kinds of operations begin: one stretch of them, and [`FAR`].
fn next_alike(program: &Program) -> [Vec<Option<usize>>; 2] {
    let kinds: Vec<_> = (program.steps.iter())
        .map(|step| discriminant(&step.operation))
        .collect();
    let near = next_equal(kinds.windows(ALIKE));
    // For each step, the last one at which the same stretch begins.
    let mut last: Vec<usize> = (0..near.len()).collect();
    for at in (0..near.len()).rev() {
        if let Some(next) = near[at] {
            last[at] = last[next];
        }
    }
    let stretches = last.windows(ALIKE * (FAR - 1) + 1);
    let far = stretches
        .map(|window| -> [usize; FAR] { std::array::from_fn(|stretch| window[ALIKE * stretch]) });
    let far = next_equal(far);
    [near, far]
}

/// For each key, the index of the next equal one.
fn next_equal<K: Eq + Hash>(
    keys: impl DoubleEndedIterator<Item = K> + ExactSizeIterator,
) -> Vec<Option<usize>> {
    let mut seen = HashMap::with_capacity(keys.len());
    let mut next: Vec<_> = (keys.enumerate().rev())
        .map(|(at, key)| seen.insert(key, at))
        .collect();
    next.reverse();
    next
}

/// For each loop its first iteration, and the number of iterations.
pub type Iterations = Vec<(Over, Range<usize>, usize)>;

/// The repeats of known loops of a program.
pub fn of_iterations(program: &Program, iterations: Iterations) -> Vec<Repeat> {
    let read_until = read_until(program, &program.results);
    let repeats = iterations.into_iter().map(|(over, first, count)| {
        let repeat = repeat(program, over, first, count, &read_until);
        repeat.expect("iterations are alike")
    });
    repeats.collect()
}

/// The repeat that begins with this first iteration, with as many iterations as are alike, of this number.
fn repeat(
    program: &Program,
    over: Over,
    first: Range<usize>,
    most: usize,
    read_until: &[u32],
) -> Option<Repeat> {
    let length = first.len();
    let iterations = 1
        + (1..most)
            .take_while(|iteration| is_alike(program, &first, iteration * length))
            .count();
    if iterations < over.fewest() {
        return None;
    }
    let of_iteration = |at: usize| (0..iterations).map(move |iteration| at + iteration * length);
    let mut loads: Vec<Vec<Operand>> = Vec::new();
    let mut reads = HashMap::new();
    for at in first.clone() {
        let operands: Vec<_> = of_iteration(at)
            .map(|at| program.steps[at].operation.operands())
            .collect();
        for (slot, &operand) in operands[0].iter().enumerate() {
            let is_own = matches!(operand, Operand::Step(step) if step as usize >= first.start);
            let column: Vec<Operand> = operands.iter().map(|operands| operands[slot]).collect();
            if is_own || column.iter().all(|other| *other == operand) {
                continue;
            }
            let known = loads.iter().position(|known| *known == column);
            let row = known.unwrap_or_else(|| {
                loads.push(column);
                loads.len() - 1
            });
            reads.insert((number(at), slot), row);
        }
    }
    let end = number(first.start + iterations * length);
    let is_read_later = |at: &usize| of_iteration(*at).any(|at| read_until[at] >= end);
    let stores = first.clone().filter(is_read_later).map(number);
    Some(Repeat {
        over,
        iterations: number(iterations),
        loads,
        reads,
        stores: stores.collect(),
        first: number(first.start)..number(first.end),
    })
}

/// True if the steps at this distance are an iteration: the same operations on its own results and on values from
/// before the loop.
fn is_alike(program: &Program, first: &Range<usize>, behind: usize) -> bool {
    first.clone().all(|at| {
        let [one, other] = [at, at + behind].map(|at| program.steps[at].operation);
        let operands = one.operands().into_iter().zip(other.operands());
        let mut operands = operands.map(|(one, other)| {
            let own = |operand| match operand {
                Operand::Step(step) if step as usize >= first.start => Some(step as usize),
                _ => None,
            };
            own(one).map(|step| step + behind) == own(other)
        });
        discriminant(&one) == discriminant(&other) && operands.all(|alike| alike)
    })
}
