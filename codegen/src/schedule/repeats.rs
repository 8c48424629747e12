//! Stretches of a long program that compute the same again and again, of other values.
//!
//! In: a [`Program`]. Out: its [`Repeat`]s, which a language can write as loops. It never changes or moves a step:
//! what a program computes does not depend on what is found here.
//!
//! A core reads instructions as fast as it computes only as long as it holds them all, and boards have little room
//! for them; the columns of a solution are the same instructions for each. What differs between rounds goes through
//! a table, so that a loop pays only where rounds compute several times what they read and leave.

#[cfg(test)]
pub mod tests;

use std::collections::HashMap;
use std::mem::discriminant;
use std::ops::Range;

use super::readers::read_until;
use super::{Operand, Program};

/// Shorter programs are read as they are.
const SHORTEST: usize = 900;

/// Rounds are looked for where so many operations are of the same kinds.
const ALIKE: usize = 16;

/// How many stretches of such kinds are tried as the next round.
const TRIED: usize = 4;

/// The fewest rounds: of fewer a processor with vectors can do none at a time.
const ROUNDS: usize = 4;

/// The fewest steps that need not be written any more.
const SAVED: usize = 300;

/// The fewest steps of a round for each value that it reads from the table or leaves there.
const EACH: usize = 3;

/// Rounds of the same operations, one behind the other, none of which reads a result of another.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeat {
    /// The steps of the first round.
    pub first: Range<u32>,
    /// How many rounds there are.
    pub rounds: u32,
    /// What differs between rounds, with its operand in each of them.
    pub taken: Vec<Vec<Operand>>,
    /// Which of these a step of the first round reads as which of its operands.
    pub reads: HashMap<(u32, usize), usize>,
    /// The steps of the first round whose results are read behind all rounds, in this one or in others.
    pub left: Vec<u32>,
}

impl Repeat {
    /// The steps of all rounds.
    #[must_use]
    pub fn steps(&self) -> Range<u32> {
        self.first.start..self.first.start + self.length() * self.rounds
    }

    /// How many steps a round has.
    #[must_use]
    pub fn length(&self) -> u32 {
        self.first.end - self.first.start
    }

    /// How many steps need not be written.
    #[must_use]
    pub fn saved(&self) -> usize {
        self.steps().len() - self.first.len()
    }

    fn pays(&self) -> bool {
        let crossing = self.taken.len() + self.left.len();
        self.saved() >= SAVED && self.first.len() >= EACH * crossing && !self.taken.is_empty()
    }
}

/// The repeats behind the sines of a program, in their order.
#[must_use]
pub fn repeats(program: &Program) -> Vec<Repeat> {
    let mut found: Vec<Repeat> = Vec::new();
    if program.steps.len() < SHORTEST {
        return found;
    }
    let next = next_alike(program);
    let read_until = read_until(program, &program.results);
    let mut at = program.before_angles;
    while at < next.len() {
        let starts = std::iter::successors(next[at], |&start| next[start]).take(TRIED);
        let mut tried = starts.filter_map(|start| repeat(program, at..start, &read_until));
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

/// For each step, as far as enough follow it, the next one from which on operations are of the same kinds.
fn next_alike(program: &Program) -> Vec<Option<usize>> {
    let kinds: Vec<_> = (program.steps.iter())
        .map(|step| discriminant(&step.operation))
        .collect();
    let mut seen: HashMap<&[_], usize> = HashMap::with_capacity(kinds.len());
    let windows = kinds.windows(ALIKE).enumerate().rev();
    let mut next: Vec<_> = windows
        .map(|(at, window)| seen.insert(window, at))
        .collect();
    next.reverse();
    next
}

/// As many rounds as there are like the first one.
fn repeat(program: &Program, first: Range<usize>, read_until: &[u32]) -> Option<Repeat> {
    let length = first.len();
    let most = (program.steps.len() - first.start) / length;
    let rounds = 1
        + (1..most)
            .take_while(|round| is_alike(program, &first, round * length))
            .count();
    if rounds < ROUNDS {
        return None;
    }
    let number = |k: usize| u32::try_from(k).expect("fewer than 2³² steps");
    let of_round = |at: usize| (0..rounds).map(move |round| at + round * length);
    let mut taken: Vec<Vec<Operand>> = Vec::new();
    let mut reads = HashMap::new();
    for at in first.clone() {
        let operands: Vec<_> = of_round(at)
            .map(|at| program.steps[at].operation.operands())
            .collect();
        for (slot, &operand) in operands[0].iter().enumerate() {
            let is_own = matches!(operand, Operand::Step(step) if step as usize >= first.start);
            let column: Vec<Operand> = operands.iter().map(|operands| operands[slot]).collect();
            if is_own || column.iter().all(|other| *other == operand) {
                continue;
            }
            let known = taken.iter().position(|known| *known == column);
            let row = known.unwrap_or_else(|| {
                taken.push(column);
                taken.len() - 1
            });
            reads.insert((number(at), slot), row);
        }
    }
    let end = number(first.start + rounds * length);
    let is_left = |at: &usize| of_round(*at).any(|at| read_until[at] >= end);
    let left = first.clone().filter(is_left).map(number);
    Some(Repeat {
        rounds: number(rounds),
        taken,
        reads,
        left: left.collect(),
        first: number(first.start)..number(first.end),
    })
}

/// Whether the steps so far behind the first round are one: the same operations of its own results, and of what is
/// older than all rounds.
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
