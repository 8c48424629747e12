//! Sections: division of a long program into functions.
//!
//! In: a [`Program`] and the maximum length of a function. Out: its steps after the sines in sections, in execution
//! order, and the index in a work array of each value that another section reads. A repeat is a section of its own.
//! Steps are neither changed nor moved.
//!
//! The time of compilers grows faster than linearly with the length of a function, since they compare all live values.
//! Sections make time and memory linear. A value in the work array would otherwise be spilled to the stack.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::readers::note_readers;
use super::repeats::{Over, Repeat};
use super::{Operand, Program};
use crate::expression::Input;

/// Length of functions in generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Length {
    /// Maximum number of steps of a program without sections; those of a repeat count once.
    whole: usize,
    /// Maximum number of steps of a section.
    section: usize,
}

impl Length {
    /// No sections.
    pub const UNBOUNDED: Self = Self {
        whole: usize::MAX,
        section: usize::MAX,
    };

    /// With batches. A compiler keeps every SIMD number in memory at first and then moves them into registers one by
    /// one, each time with a search through the function. Measured on a humanoid: forward dynamics of 7500 steps compile
    /// in more than 10 minutes whole, and in 20 s in sections of 500. Inverse dynamics of 2600 steps compile in 21 and
    /// 6 s, and take 0.8 of the time if they are whole.
    pub const OF_BATCHES: Self = Self {
        whole: 4000,
        section: 500,
    };

    /// Functions of at most this number of steps, which is at least one.
    #[must_use]
    pub const fn at_most(steps: usize) -> Self {
        let steps = if steps == 0 { 1 } else { steps };
        Self {
            whole: steps,
            section: steps,
        }
    }

    /// True if a program needs no sections, even without loops.
    #[must_use]
    pub fn holds(self, program: &Program) -> bool {
        program.steps.len() <= self.whole
    }

    /// True if an iteration of a repeat fits in a section.
    fn fits(self, repeat: &Repeat) -> bool {
        repeat.first.len() <= self.section
    }

    /// Maximum number of steps of a section.
    #[must_use]
    pub const fn of_section(self) -> usize {
        self.section
    }
}

impl Default for Length {
    /// Measured: longer functions compile faster in sections of this length, and run as fast. Shorter sections compile
    /// no faster and store more values.
    fn default() -> Self {
        Self {
            whole: 8000,
            section: 2000,
        }
    }
}

/// Value that a section reads and does not compute, or that the function's results read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shared {
    /// An argument or a field.
    Input(Input),
    /// The sine of the angle with this index.
    Sin(u32),
    /// The cosine of the angle with this index.
    Cos(u32),
    /// The result of a step.
    Step(u32),
}

impl Shared {
    /// The operand, unless it is a literal.
    #[must_use]
    pub const fn of(operand: Operand) -> Option<Self> {
        match operand {
            Operand::Literal(_) => None,
            Operand::Input(input) => Some(Self::Input(input)),
            Operand::Sin(angle) => Some(Self::Sin(angle)),
            Operand::Cos(angle) => Some(Self::Cos(angle)),
            Operand::Step(step) => Some(Self::Step(step)),
        }
    }

    /// The same value as an operand.
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

/// Program in sections.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Values that are stored in the work array before the first section, with their indices.
    pub initial: Vec<(Shared, usize)>,
    /// Sections of all steps after the sines.
    pub sections: Vec<Section>,
    /// For each result its index in the work array, if a section computes it.
    pub results: Vec<Option<usize>>,
    /// Length of the work array.
    pub work: usize,
}

/// Steps of one function.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Range of steps.
    pub steps: Range<u32>,
    /// Values that they read from the work array, without those in `rows`.
    pub loads: Vec<(Shared, usize)>,
    /// For each value of [`Repeat::loads`], the index of that of the first iteration in the work array, if those of the
    /// others follow it.
    pub rows: Vec<Option<usize>>,
    /// Entries of the work array that are copied before the steps, from the first index to the second: values of rows that
    /// several repeats read.
    pub copies: Vec<(usize, usize)>,
    /// Steps whose results are stored in the work array. Those of a repeat have consecutive places: each step of its
    /// first iteration is followed by that of all others.
    pub stores: Vec<(u32, usize)>,
    /// Repeat, if the section is one.
    pub repeat: Option<Repeat>,
}

/// True if a program with these repeats is too long for one function.
#[must_use]
pub fn are_needed(program: &Program, repeats: &[Repeat], length: Length) -> bool {
    if length.holds(program) {
        return false;
    }
    // Compilers take some twice as long for steps on vectors as for others.
    let saved = repeats.iter().filter(|repeat| length.fits(repeat));
    let saved = saved.map(|repeat| match repeat.over {
        Over::Columns => repeat.saved(),
        Over::Limbs => repeat.saved() - repeat.first.len(),
    });
    program.steps.len() - saved.sum::<usize>() > length.whole
}

/// Sections of a program with these repeats; `None` if it is short enough for one function.
#[must_use]
pub fn sections(program: &Program, repeats: &[Repeat], length: Length) -> Option<Sections> {
    if !are_needed(program, repeats, length) {
        return None;
    }
    let repeats = repeats.iter().filter(|repeat| length.fits(repeat));
    let repeats = repeats.cloned().collect();
    let (ranges, repeats) = ranges(program, repeats, length.section);
    // Section that computes each step; `None` before the sines.
    let mut home: Vec<Option<usize>> = vec![None; program.steps.len()];
    for (number, range) in ranges.iter().enumerate() {
        home[range.start as usize..range.end as usize].fill(Some(number));
    }
    let home = |value: &Shared| match *value {
        Shared::Step(step) => home[step as usize],
        _ => None,
    };
    // Last section that reads each value.
    let mut until: BTreeMap<Shared, usize> = BTreeMap::new();
    let mut loads: Vec<BTreeSet<Shared>> = vec![BTreeSet::new(); ranges.len()];
    for (number, range) in ranges.iter().enumerate() {
        let steps = &program.steps[range.start as usize..range.end as usize];
        let read = steps.iter().flat_map(|step| step.operation.operands());
        for value in read.filter_map(Shared::of) {
            if home(&value) != Some(number) {
                loads[number].insert(value);
                until.insert(value, number);
            }
        }
    }
    let result = |&operand: &Operand| Shared::of(operand).filter(|value| home(value).is_some());
    for value in program.results.iter().filter_map(result) {
        until.insert(value, usize::MAX);
    }

    let mut places = Places::of_repeats(&repeats);
    let initial = until.keys().filter(|value| home(value).is_none());
    let initial = places.take_all(&initial.copied().collect::<Vec<_>>());
    let sections = ranges.into_iter().zip(loads).zip(repeats).enumerate();
    let sections = sections.map(|(number, ((steps, mut loads), repeat))| {
        let stores = if let Some(repeat) = &repeat {
            let stored = repeat.stored().into_iter().map(Shared::Step);
            places.take_in_a_row(&stored.collect::<Vec<_>>())
        } else {
            let stored = steps.clone().map(Shared::Step);
            let stored = stored.filter(|value| until.contains_key(value));
            places.take_all(&stored.collect::<Vec<_>>())
        };
        let stores = stores.into_iter().map(|(value, place)| match value {
            Shared::Step(step) => (step, place),
            _ => unreachable!("sections compute steps"),
        });
        let stores = stores.collect();
        let copies = repeat.as_ref();
        let copies = copies.map_or_else(Vec::new, |repeat| places.copy_rows(repeat, number));
        // A section may read and write the array in any order, so its own values need other entries.
        for value in &loads {
            if until[value] == number {
                places.free.insert(places.of[value]);
            }
        }
        let mut rows = Vec::new();
        if let Some(repeat) = &repeat {
            rows.extend(repeat.loads.iter().map(|row| places.first_of(row)));
            let named = named(program, repeat, &rows);
            loads.retain(|value| named.contains(value));
            places.free_rows(repeat, number);
        }
        Section {
            steps,
            loads: loads
                .into_iter()
                .map(|value| (value, places.of[&value]))
                .collect(),
            rows,
            copies,
            stores,
            repeat,
        }
    });
    let sections = sections.collect();
    let results = program.results.iter().map(result);
    Some(Sections {
        initial,
        sections,
        results: results.map(|value| Some(places.of[&value?])).collect(),
        work: places.len,
    })
}

/// Values that a repeat reads by name: those that are the same for all iterations, and those of rows without a place.
fn named(program: &Program, repeat: &Repeat, rows: &[Option<usize>]) -> BTreeSet<Shared> {
    let rows = repeat.loads.iter().zip(rows);
    let without_place = rows.filter(|(_, place)| place.is_none());
    let without_place = without_place.flat_map(|(row, _)| row.iter().copied());
    let read = repeat.in_no_row(program).chain(without_place);
    read.filter_map(Shared::of).collect()
}

/// The values of a row without literals.
fn values_of(row: &[Operand]) -> Option<Vec<Shared>> {
    row.iter().copied().map(Shared::of).collect()
}

/// Allocation of the work array.
struct Places {
    of: BTreeMap<Shared, usize>,
    free: BTreeSet<usize>,
    len: usize,
    /// For the value of the first iteration of a repeat, those of all of them, if they are different.
    rows: BTreeMap<Shared, Vec<Shared>>,
    /// Rows that several repeats read.
    read_again: BTreeMap<Vec<Shared>, ReadAgain>,
}

/// Row of values that several repeats read.
#[derive(Default)]
struct ReadAgain {
    /// Number of these repeats.
    readers: usize,
    /// Section of the last one.
    until: usize,
    /// Place of its copy, if there is one.
    copy: Option<usize>,
}

impl Places {
    /// Places of values, which these repeats read.
    fn of_repeats(repeats: &[Option<Repeat>]) -> Self {
        let mut rows = BTreeMap::new();
        let mut read_again: BTreeMap<Vec<Shared>, ReadAgain> = BTreeMap::new();
        for (number, repeat) in repeats.iter().enumerate() {
            for row in repeat.iter().flat_map(|repeat| &repeat.loads) {
                let Some(row) = values_of(row) else { continue };
                let again = read_again.entry(row.clone()).or_default();
                again.readers += 1;
                again.until = number;
                let different: BTreeSet<&Shared> = row.iter().collect();
                if different.len() == row.len() {
                    rows.entry(row[0]).or_insert(row);
                }
            }
        }
        read_again.retain(|_, row| row.readers > 1);
        Self {
            of: BTreeMap::new(),
            free: BTreeSet::new(),
            len: 0,
            rows,
            read_again,
        }
    }

    /// Places for copies of the rows that later repeats read, too, and whose values are apart; the copies that this
    /// repeat makes.
    fn copy_rows(&mut self, repeat: &Repeat, number: usize) -> Vec<(usize, usize)> {
        let mut copies = Vec::new();
        for row in &repeat.loads {
            let Some(values) = values_of(row).filter(|_| self.first_of(row).is_none()) else {
                continue;
            };
            let again = self.read_again.get(&values);
            if again.is_none_or(|again| again.until == number) {
                continue;
            }
            let first = self.in_a_row(values.len());
            let from = values.iter().map(|value| self.of[value]);
            copies.extend(from.zip(first..));
            if let Some(again) = self.read_again.get_mut(&values) {
                again.copy = Some(first);
            }
        }
        copies
    }

    /// Frees the copies that this repeat reads last.
    fn free_rows(&mut self, repeat: &Repeat, number: usize) {
        for values in repeat.loads.iter().filter_map(|row| values_of(row)) {
            let again = self.read_again.get_mut(&values);
            let last = again.filter(|again| again.until == number);
            if let Some(first) = last.and_then(|again| again.copy.take()) {
                self.free.extend(first..first + values.len());
            }
        }
    }

    fn take(&mut self, value: Shared) -> usize {
        let place = self.free.pop_first().unwrap_or_else(|| {
            self.len += 1;
            self.len - 1
        });
        self.of.insert(value, place);
        place
    }

    /// Places of some values, consecutive ones for those of all iterations of a repeat.
    fn take_all(&mut self, values: &[Shared]) -> Vec<(Shared, usize)> {
        let all: BTreeSet<Shared> = values.iter().copied().collect();
        for value in values {
            let is_new = |value: &Shared| all.contains(value) && !self.of.contains_key(value);
            let row = self.rows.get(value).filter(|row| row.iter().all(is_new));
            if let Some(row) = row.cloned() {
                self.take_in_a_row(&row);
            }
        }
        let places = values.iter().map(|&value| {
            let known = self.of.get(&value).copied();
            (value, known.unwrap_or_else(|| self.take(value)))
        });
        places.collect()
    }

    /// Consecutive places.
    fn take_in_a_row(&mut self, values: &[Shared]) -> Vec<(Shared, usize)> {
        let first = self.in_a_row(values.len());
        let places = values.iter().zip(first..).map(|(&value, place)| {
            self.of.insert(value, place);
            (value, place)
        });
        places.collect()
    }

    /// The first of so many consecutive places, which are taken.
    fn in_a_row(&mut self, count: usize) -> usize {
        let is_free = |first: &usize| (*first..first + count).all(|at| self.free.contains(&at));
        let first = self.free.iter().copied().find(is_free);
        let first = first.unwrap_or(self.len);
        self.len = self.len.max(first + count);
        for place in first..first + count {
            self.free.remove(&place);
        }
        first
    }

    /// The place of the first of some values, if those of the others, or their copies, follow it.
    fn first_of(&self, values: &[Operand]) -> Option<usize> {
        let again = values_of(values).and_then(|values| self.read_again.get(&values));
        if let Some(copy) = again.and_then(|again| again.copy) {
            return Some(copy);
        }
        let place = |value: &Operand| self.of.get(&Shared::of(*value)?).copied();
        let first = place(values.first()?)?;
        let mut places = values.iter().map(place).zip(first..);
        places
            .all(|(place, expected)| place == Some(expected))
            .then_some(first)
    }
}

/// Ranges of the steps after the sines, and the repeats among them; other ranges have at most `most` steps.
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

/// Cuts a stretch into sections: each cut is in the second half of the allowed length, where the fewest earlier values
/// are still read.
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

/// Number of live values before each step: results of steps from `first` on that are read at this step or later.
fn crossing(program: &Program, first: u32) -> Vec<usize> {
    let steps = (0_u32..).zip(&program.steps);
    // A value that is not read lives for one step.
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
