//! Loops over limbs: the groups of each.
//!
//! In: the groups of a program, and its loops over columns, which stay as they are. Out: the place of each operation:
//! in a loop over limbs, or in a stretch of single steps between two of them.

use std::collections::BTreeMap;

use super::groups::Groups;
use crate::schedule::repeats::Repeat;
use crate::schedule::{Operand, Program, number};

/// Minimum number of groups of a loop: values that differ between limbs are moved into a table and out of it.
const SHORTEST: usize = 24;

/// Maximum number of visits of all steps for their places. Two suffice unless a loop over columns and a group read each
/// other's results.
const VISITS: usize = 20;

/// Operations that are executed together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unit {
    /// Step with this index.
    Step(u32),
    /// All lanes of a group.
    Group(usize),
    /// All iterations of a loop over columns.
    Columns(usize),
}

/// Order of execution: a stretch of single steps and loops over columns, then for each number from 1 on the loops over
/// limbs with this number and the stretch with this number.
#[derive(Debug)]
pub struct Loops {
    /// Groups of the loop with this number over this set of limbs.
    pub loops: BTreeMap<(u32, usize), Vec<usize>>,
    /// Units of the stretch with this number, in the order of their first steps.
    pub stretches: BTreeMap<u32, Vec<Unit>>,
}

/// Loops of a program; `None` if none is long enough.
pub fn loops(program: &Program, groups: &Groups, columns: &[Repeat]) -> Option<Loops> {
    let mut search = Search::of(program, groups, columns);
    let found = loop {
        search.early()?;
        search.late();
        let found = search.loops();
        let short = found.values().filter(|groups| groups.len() < SHORTEST);
        let short: Vec<usize> = short.flatten().copied().collect();
        if short.is_empty() {
            break found;
        }
        search.dissolve(&short);
    };
    (!found.is_empty()).then(|| Loops {
        loops: found,
        stretches: search.stretches(),
    })
}

/// State of the search.
struct Search<'p> {
    program: &'p Program,
    groups: &'p Groups,
    /// Unit of each step; `None` before the sines.
    units: Vec<Option<Unit>>,
    /// Number of the loop or stretch of each unit.
    places: BTreeMap<Unit, u32>,
}

impl<'p> Search<'p> {
    fn of(program: &'p Program, groups: &'p Groups, columns: &[Repeat]) -> Self {
        let mut units: Vec<Option<Unit>> = Vec::with_capacity(program.steps.len());
        for step in (0_u32..).take(program.steps.len()) {
            let grouped = groups.find(Operand::Step(step));
            let unit = grouped.map_or(Unit::Step(step), |(group, _)| Unit::Group(group));
            units.push((step as usize >= program.before_angles).then_some(unit));
        }
        let mut search = Self {
            program,
            groups,
            units,
            places: BTreeMap::new(),
        };
        let mut broken = Vec::new();
        for (index, repeat) in columns.iter().enumerate() {
            for step in repeat.steps() {
                let unit = search.units[step as usize].replace(Unit::Columns(index));
                if let Some(Unit::Group(group)) = unit {
                    broken.push(group);
                }
            }
        }
        search.dissolve(&broken);
        search
    }

    /// Computes the lanes of some groups one by one.
    fn dissolve(&mut self, groups: &[usize]) {
        for &group in groups {
            for &lane in &self.groups.all[group].lanes {
                if let Operand::Step(step) = lane
                    && let Some(unit) = &mut self.units[step as usize]
                    && *unit == Unit::Group(group)
                {
                    *unit = Unit::Step(step);
                }
            }
        }
    }

    /// Set of limbs of a group.
    fn set(&self, unit: Unit) -> Option<usize> {
        match unit {
            Unit::Group(group) => Some(self.groups.all[group].set),
            Unit::Step(_) | Unit::Columns(_) => None,
        }
    }

    /// Each step after the sines with its unit.
    fn steps(&self) -> impl DoubleEndedIterator<Item = (u32, Unit)> {
        let units = self.units.iter().enumerate();
        units.filter_map(|(step, unit)| Some((number(step), (*unit)?)))
    }

    /// Other units that a step of a unit reads.
    fn reads(&self, step: u32, unit: Unit) -> impl Iterator<Item = Unit> {
        let operands = self.program.steps[step as usize].operation.operands();
        let read = operands.into_iter().filter_map(|operand| match operand {
            Operand::Step(step) => self.units[step as usize],
            _ => None,
        });
        read.filter(move |read| *read != unit)
    }

    /// Executes each unit as early as its operands allow; `None` if two would have to wait for each other.
    fn early(&mut self) -> Option<()> {
        let mut places = BTreeMap::new();
        for _ in 0..VISITS {
            let mut is_settled = true;
            for (step, unit) in self.steps() {
                let set = self.set(unit);
                let earliest = self.reads(step, unit).map(|read| {
                    let place: u32 = places.get(&read).copied().unwrap_or_default();
                    // Loops with the same number run before the stretch with this number.
                    place + u32::from(set.is_some() && self.set(read) != set)
                });
                let earliest = earliest.max().unwrap_or_default();
                let place = places
                    .entry(unit)
                    .or_insert_with(|| u32::from(set.is_some()));
                if *place < earliest {
                    *place = earliest;
                    is_settled = false;
                }
            }
            if is_settled {
                self.places = places;
                return Some(());
            }
        }
        None
    }

    /// Moves groups into later loops where that keeps fewer values from one loop to another.
    fn late(&mut self) {
        // For each group the latest loop that its readers allow, and the last loop that reads it; after those, steps
        // and results do.
        let mut latest = vec![u32::MAX; self.groups.all.len()];
        let mut until = vec![0; self.groups.all.len()];
        for result in &self.program.results {
            if let Some((group, _)) = self.groups.find(*result) {
                until[group] = u32::MAX;
            }
        }
        let mut steps: Vec<(u32, Unit)> = self.steps().collect();
        steps.sort_by_key(|&(step, unit)| (self.groups.depths[step as usize], unit));
        for of_unit in steps.chunk_by(|(_, one), (_, other)| one == other).rev() {
            let unit = of_unit[0].1;
            let reads = of_unit
                .iter()
                .flat_map(|&(step, unit)| self.reads(step, unit));
            let reads: Vec<Unit> = reads.collect();
            if let Unit::Group(group) = unit {
                let other = latest[group];
                let mut kept: Vec<Unit> = reads.clone();
                kept.retain(|&read| matches!(read, Unit::Group(read) if until[read] < other));
                kept.sort_unstable();
                kept.dedup();
                if other < u32::MAX && until[group] < u32::MAX && kept.len() <= 1 {
                    self.places.insert(unit, other);
                }
            }
            let (place, set) = (self.places[&unit], self.set(unit));
            for read in reads {
                let Unit::Group(group) = read else { continue };
                let (allowed, last) = if set.is_none() {
                    (place, u32::MAX)
                } else if self.set(read) == set {
                    (place, place)
                } else {
                    (place - 1, u32::MAX)
                };
                latest[group] = latest[group].min(allowed);
                until[group] = until[group].max(last);
            }
        }
    }

    fn loops(&self) -> BTreeMap<(u32, usize), Vec<usize>> {
        let mut loops: BTreeMap<_, Vec<usize>> = BTreeMap::new();
        let present = self.steps().filter_map(|(step, unit)| match unit {
            Unit::Group(group) => {
                let is_first = self.groups.all[group].lanes[0] == Operand::Step(step);
                is_first.then_some((group, self.places[&unit]))
            }
            Unit::Step(_) | Unit::Columns(_) => None,
        });
        for (group, place) in present {
            let set = self.groups.all[group].set;
            loops.entry((place, set)).or_default().push(group);
        }
        loops
    }

    fn stretches(&self) -> BTreeMap<u32, Vec<Unit>> {
        let mut stretches: BTreeMap<_, Vec<Unit>> = BTreeMap::new();
        for (_, unit) in self.steps().filter(|(_, unit)| self.set(*unit).is_none()) {
            let stretch = stretches.entry(self.places[&unit]).or_default();
            if stretch.last() != Some(&unit) {
                stretch.push(unit);
            }
        }
        stretches
    }
}
