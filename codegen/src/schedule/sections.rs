//! Which steps of a long program become functions of their own.
//!
//! In: a [`Program`], and how long a function may be. Out: its steps behind the sines in sections, in the
//! order in which they run, and where in a work array each value waits that is read in another section
//! than its own. A repeat is a section by itself. It never changes or moves a step, and knows no language.
//!
//! Compilers take more than twice as long for a function twice as long: they look at all values that are
//! alive at a time, and at all pairs of some. Sections make time and memory linear. A value that waits in
//! an array was going to wait on the stack anyhow.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::readers::note_readers;
use super::repeats::{Repeat, repeats};
use super::{Operand, Program};
use crate::expression::Input;

/// How long a function is that compilers see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Length {
    /// The most steps of a program that stays whole, those of a repeat counted once.
    whole: usize,
    /// The most steps of a section of one that does not.
    section: usize,
}

impl Length {
    /// Whatever it is, it stays whole.
    pub const UNBOUNDED: Self = Self {
        whole: usize::MAX,
        section: usize::MAX,
    };

    /// No function has more steps than this, of which there is at least one.
    #[must_use]
    pub const fn at_most(steps: usize) -> Self {
        let steps = if steps == 0 { 1 } else { steps };
        Self {
            whole: steps,
            section: steps,
        }
    }

    /// The most steps of a section.
    #[must_use]
    pub const fn of_section(self) -> usize {
        self.section
    }
}

impl Default for Length {
    /// What was measured to be best: from here on a function compiles faster in sections, and runs as fast;
    /// shorter sections compile no faster, and store more.
    fn default() -> Self {
        Self {
            whole: 8000,
            section: 2000,
        }
    }
}

/// A value that is read in another section than its own, or in one without being of any.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Waiting {
    /// An argument or a field.
    Input(Input),
    /// The sine of the angle of that index.
    Sin(u32),
    /// The cosine of the angle of that index.
    Cos(u32),
    /// The result of a step.
    Step(u32),
}

impl Waiting {
    const fn of(operand: Operand) -> Option<Self> {
        match operand {
            Operand::Literal(_) => None,
            Operand::Input(input) => Some(Self::Input(input)),
            Operand::Sin(angle) => Some(Self::Sin(angle)),
            Operand::Cos(angle) => Some(Self::Cos(angle)),
            Operand::Step(step) => Some(Self::Step(step)),
        }
    }

    /// The same as an operand.
    #[must_use]
    pub const fn operand(self) -> Operand {
        match self {
            Self::Input(input) => Operand::Input(input),
            Self::Sin(angle) => Operand::Sin(angle),
            Self::Cos(angle) => Operand::Cos(angle),
            Self::Step(step) => Operand::Step(step),
        }
    }
}

/// A program in sections.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// What is put into the work array before the first section, and where.
    pub given: Vec<(Waiting, usize)>,
    /// The sections, of all steps behind the sines.
    pub sections: Vec<Section>,
    /// For each result its place in the work array, where it is the result of a section.
    pub results: Vec<Option<usize>>,
    /// How long the work array is.
    pub work: usize,
}

/// Steps that become a function.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Which steps.
    pub steps: Range<u32>,
    /// What they read of the work array.
    pub taken: Vec<(Waiting, usize)>,
    /// The steps whose results they put into it.
    pub left: Vec<(u32, usize)>,
    /// The repeat that they are, if they are one.
    pub repeat: Option<Repeat>,
}

/// The sections of a program; none where it is short enough to stay whole.
#[must_use]
pub fn sections(program: &Program, length: Length) -> Option<Sections> {
    if program.steps.len() <= length.whole {
        return None;
    }
    let mut repeats = repeats(program);
    repeats.retain(|repeat| repeat.first.len() <= length.section);
    let saved: usize = repeats.iter().map(Repeat::saved).sum();
    if program.steps.len() - saved <= length.whole {
        return None;
    }
    let (ranges, repeats) = ranges(program, repeats, length.section);
    // The section that computes a step; none before the sines.
    let mut home: Vec<Option<usize>> = vec![None; program.steps.len()];
    for (number, range) in ranges.iter().enumerate() {
        home[range.start as usize..range.end as usize].fill(Some(number));
    }
    let home = |value: &Waiting| match *value {
        Waiting::Step(step) => home[step as usize],
        _ => None,
    };
    // The section behind which nobody reads a value that waits.
    let mut until: BTreeMap<Waiting, usize> = BTreeMap::new();
    let mut taken: Vec<BTreeSet<Waiting>> = vec![BTreeSet::new(); ranges.len()];
    for (number, range) in ranges.iter().enumerate() {
        let steps = &program.steps[range.start as usize..range.end as usize];
        let read = steps.iter().flat_map(|step| step.operation.operands());
        for value in read.filter_map(Waiting::of) {
            if home(&value) != Some(number) {
                taken[number].insert(value);
                until.insert(value, number);
            }
        }
    }
    let result = |&operand: &Operand| Waiting::of(operand).filter(|value| home(value).is_some());
    for value in program.results.iter().filter_map(result) {
        until.insert(value, usize::MAX);
    }

    let mut places = Places::default();
    let given = until.keys().filter(|value| home(value).is_none());
    let given = given.map(|&value| (value, places.take(value))).collect();
    let sections = ranges.into_iter().zip(taken).zip(repeats).enumerate();
    let sections = sections.map(|(number, ((steps, taken), repeat))| {
        let left = steps
            .clone()
            .filter(|&step| until.contains_key(&Waiting::Step(step)));
        let left = left
            .map(|step| (step, places.take(Waiting::Step(step))))
            .collect();
        let taken: Vec<_> = (taken.into_iter())
            .map(|value| (value, places.of[&value]))
            .collect();
        // Only what comes later may stand there: a section takes and leaves in any order.
        for (value, place) in &taken {
            if until[value] == number {
                places.free.insert(*place);
            }
        }
        Section {
            steps,
            taken,
            left,
            repeat,
        }
    });
    let sections = sections.collect();
    let results = program.results.iter().map(result);
    Some(Sections {
        given,
        sections,
        results: results.map(|value| Some(places.of[&value?])).collect(),
        work: places.len,
    })
}

/// Where values wait.
#[derive(Default)]
struct Places {
    of: BTreeMap<Waiting, usize>,
    free: BTreeSet<usize>,
    len: usize,
}

impl Places {
    fn take(&mut self, value: Waiting) -> usize {
        let place = self.free.pop_first().unwrap_or_else(|| {
            self.len += 1;
            self.len - 1
        });
        self.of.insert(value, place);
        place
    }
}

/// The steps behind the sines in ranges, and which of these are repeats; others hold at most so many.
fn ranges(
    program: &Program,
    repeats: Vec<Repeat>,
    most: usize,
) -> (Vec<Range<u32>>, Vec<Option<Repeat>>) {
    let crossing = crossing(program, index(program.before_angles));
    let (mut ranges, mut of) = (Vec::new(), Vec::new());
    let mut start = program.before_angles;
    for repeat in repeats {
        let steps = repeat.steps();
        cut(start..steps.start as usize, most, &crossing, &mut ranges);
        start = steps.end as usize;
        of.resize(ranges.len(), None);
        ranges.push(steps);
        of.push(Some(repeat));
    }
    cut(start..program.steps.len(), most, &crossing, &mut ranges);
    of.resize(ranges.len(), None);
    (ranges, of)
}

/// Cuts a stretch where the fewest values are read behind the cut that were computed before it, in the second half
/// of what a section can be.
fn cut(stretch: Range<usize>, most: usize, crossing: &[usize], ranges: &mut Vec<Range<u32>>) {
    let mut start = stretch.start;
    while start < stretch.end {
        let farthest = start.saturating_add(most);
        let end = if farthest >= stretch.end {
            stretch.end
        } else {
            let ends = (start + most.div_ceil(2)..=farthest).rev();
            ends.min_by_key(|&end| crossing[end]).unwrap_or(farthest)
        };
        ranges.push(index(start)..index(end));
        start = end;
    }
}

/// How many results of steps from the first one on are computed before each step, and read by it or behind it.
fn crossing(program: &Program, first: u32) -> Vec<usize> {
    let steps = (0_u32..).zip(&program.steps);
    // What nobody reads ends where it is computed.
    let mut last_read: Vec<u32> = steps.clone().map(|(at, _)| at).collect();
    note_readers(steps, &mut last_read);
    let mut ending = vec![0; program.steps.len() + 1];
    let (mut crossing, mut alive) = (Vec::with_capacity(ending.len()), 0);
    for (at, &last) in (0_u32..).zip(&last_read) {
        crossing.push(alive);
        if at >= first && last > at {
            alive += 1;
            ending[last as usize] += 1;
        }
        alive -= ending[at as usize];
    }
    crossing.push(alive);
    crossing
}

fn index(step: usize) -> u32 {
    u32::try_from(step).expect("fewer than 2³² steps")
}

#[cfg(test)]
mod tests;
