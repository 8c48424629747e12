//! Scopes: nested blocks of the steps of a long program.
//!
//! In: a [`Program`]. Out: its steps in execution order, nested in blocks; each block returns the values that are read
//! after it. Steps are neither changed nor moved.
//!
//! In Rust, each `let` opens a scope for the rest of its block, and rustc describes scopes to debuggers by recursion:
//! between 2,800 and 3,000 nested scopes exhaust its stack of 8 MiB (1.63 and 1.95 on x86-64 Linux, unoptimised and
//! optimised, for `core` alone and generic). A block ends the scopes inside it, so only the longest chain of open
//! scopes counts: at most [`FLAT`] steps and angles in a short program, and [`LONGEST_SCOPE`] for each level of blocks
//! in a longer one. A tree of 39 joints, with 10,000 steps, stays below 300, a tenth of the limit.

use std::ops::Range;

use super::inlined::Inlined;
use super::readers::{note_readers, read_until};
use super::repeats::Repeat;
use super::{Operand, Program, number};

/// Maximum number of steps and angles of a program in one scope: a third of the limit of rustc.
const FLAT: usize = 900;

/// Maximum number of bindings of one scope in a longer program: a block, or the steps before or after the sines outside
/// of blocks. Beyond it, blocks are nested once; beyond about its square (22,500 steps) twice; beyond some millions,
/// more than 1,000 joints need, three times.
pub const LONGEST_SCOPE: usize = 150;

/// Minimum number of entries of a block; any number from here on can be divided into blocks.
const SHORTEST: usize = LONGEST_SCOPE / 2;

/// Entry of a scope.
#[derive(Clone, Debug, PartialEq)]
pub enum ScopeEntry {
    /// Step with this index, as in [`Operand::Step`], and the steps before it that are inlined.
    Step(u32),
    /// Inner scope.
    Block(Block),
}

/// Inner scope.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Contents.
    pub entries: Vec<ScopeEntry>,
    /// Steps inside that are read after the block, in order.
    pub outputs: Vec<u32>,
}

/// Steps of a program without sections.
pub struct Nested {
    /// Steps before the sines and cosines.
    pub before: Vec<ScopeEntry>,
    /// Steps after them: before the first repeat, between two, and after the last.
    pub after: Vec<Vec<ScopeEntry>>,
}

/// Steps of a program with loops; `results` are read at the end.
#[must_use]
pub fn nested(
    program: &Program,
    repeats: &[Repeat],
    results: &[Operand],
    inlined: &Inlined,
) -> Nested {
    let [first, end] = [program.before_angles, program.steps.len()].map(number);
    let ends = repeats.iter().map(|repeat| repeat.steps().start);
    let starts = repeats.iter().map(|repeat| repeat.steps().end);
    let stretches = std::iter::once(first).chain(starts).zip(ends.chain([end]));
    let mut nested = Nested {
        before: entries(0..first, inlined),
        after: stretches
            .map(|(start, end)| entries(start..end, inlined))
            .collect(),
    };
    let stretches = std::iter::once(&mut nested.before).chain(&mut nested.after);
    let stretches: Vec<_> = stretches.collect();
    let written: usize = stretches.iter().map(|entries| entries.len()).sum();
    if written + program.angles.len() > FLAT {
        let read_until = read_until(program, results);
        for entries in stretches {
            *entries = in_blocks(std::mem::take(entries), &read_until);
        }
    }
    nested
}

/// Steps before the sines and cosines of a program with sections.
#[must_use]
pub fn before(program: &Program, inlined: &Inlined) -> Vec<ScopeEntry> {
    in_blocks(
        entries(0..number(program.before_angles), inlined),
        &read_until(program, &program.results),
    )
}

/// Steps of a section, or of the first iteration of a repeat; after it, they are read from the work array or the table.
#[must_use]
pub fn within(program: &Program, section: Range<u32>, inlined: &Inlined) -> Vec<ScopeEntry> {
    let entries = entries(section.clone(), inlined);
    if entries.len() <= FLAT {
        return entries;
    }
    let mut read_until = vec![0; program.steps.len()];
    let steps = &program.steps[section.start as usize..section.end as usize];
    note_readers(section.zip(steps), &mut read_until);
    in_blocks(entries, &read_until)
}

/// Steps that are statements of their own.
fn entries(steps: Range<u32>, inlined: &Inlined) -> Vec<ScopeEntry> {
    let statements = steps.filter(|&step| !inlined.in_reader(step));
    statements.map(ScopeEntry::Step).collect()
}

/// Groups the entries until a scope has at most [`LONGEST_SCOPE`] bindings.
fn in_blocks(mut entries: Vec<ScopeEntry>, read_until: &[u32]) -> Vec<ScopeEntry> {
    while entries.len() > LONGEST_SCOPE {
        entries = grouped(entries, read_until);
    }
    entries
}

impl ScopeEntry {
    /// Steps inside that are read after it.
    fn outputs(&self) -> &[u32] {
        match self {
            Self::Step(step) => std::slice::from_ref(step),
            Self::Block(block) => &block.outputs,
        }
    }

    /// Index after its last step.
    fn end(&self) -> u32 {
        match self {
            Self::Step(step) => step + 1,
            Self::Block(block) => block.entries.last().map_or(0, Self::end),
        }
    }
}

/// Entries in blocks of [`SHORTEST`] to [`LONGEST_SCOPE`], cut such that the blocks return the fewest values.
fn grouped(entries: Vec<ScopeEntry>, read_until: &[u32]) -> Vec<ScopeEntry> {
    let mut rest = entries.into_iter();
    let cuts = cuts(rest.as_slice(), read_until);
    let blocks = cuts.into_iter().map(|cut| {
        let entries: Vec<_> = rest.by_ref().take(cut.len()).collect();
        let end = entries.last().map_or(0, ScopeEntry::end);
        let inside = entries.iter().flat_map(ScopeEntry::outputs).copied();
        let outputs = inside
            .filter(|&step| read_until[step as usize] >= end)
            .collect();
        ScopeEntry::Block(Block { entries, outputs })
    });
    blocks.collect()
}

/// Best cuts by dynamic programming: those up to an index extend those up to the start of the last block.
fn cuts(entries: &[ScopeEntry], read_until: &[u32]) -> Vec<Range<usize>> {
    // For each index: number of values returned by all blocks before it, and start of the last one.
    let mut best = vec![None; entries.len() + 1];
    best[0] = Some((0, 0));
    for end in SHORTEST..=entries.len() {
        let behind = entries[end - 1].end();
        let mut outputs = 0;
        let mut found = None;
        for start in (end.saturating_sub(LONGEST_SCOPE)..end).rev() {
            for &step in entries[start].outputs() {
                outputs += u32::from(read_until[step as usize] >= behind);
            }
            if let (true, Some((before, _))) = (end - start >= SHORTEST, best[start]) {
                let all = before + outputs;
                if found.is_none_or(|(least, _)| all < least) {
                    found = Some((all, start));
                }
            }
        }
        best[end] = found;
    }
    let mut cuts = Vec::new();
    let mut end = entries.len();
    while let Some((_, start)) = best[end].filter(|_| end > 0) {
        cuts.push(start..end);
        end = start;
    }
    cuts.reverse();
    cuts
}

#[cfg(test)]
mod tests {
    use homogen_random::Random;

    use super::{Block, FLAT, LONGEST_SCOPE, Nested, SHORTEST, ScopeEntry};
    use crate::expression::Input;
    use crate::schedule::inlined::Inlined;
    use crate::schedule::{Operand, Operation, Program, Step};
    use crate::space::Variable;

    /// Program in which `read` gives the two steps that each step reads; the first reads none.
    fn program(steps: usize, mut read: impl FnMut(u32) -> [u32; 2]) -> Program {
        let operation = |k: u32| {
            let [a, b] = read(k).map(Operand::Step);
            Operation::Add(a, b)
        };
        let first = Operation::Neg(Operand::Input(Input::Variable(Variable::Q, 0)));
        let operations = (1..).map(operation);
        let operations = std::iter::once(first).chain(operations).take(steps);
        let steps: Vec<_> = operations
            .map(|operation| Step {
                label: None,
                operation,
            })
            .collect();
        let last = u32::try_from(steps.len() - 1).expect("few steps");
        Program {
            angles: Vec::new(),
            before_angles: 0,
            steps,
            results: vec![Operand::Step(last)],
            ..Program::default()
        }
    }

    /// Reads mostly from the last 300 steps, and any other step at every tenth one.
    fn tangled(steps: usize) -> Program {
        let mut random = Random::new(1);
        let mut below =
            |end: u32| u32::try_from(random.bits() % u64::from(end)).expect("below a u32");
        program(steps, |k| {
            [(); 2].map(|()| match below(10) {
                0 => below(k),
                _ => k - 1 - below(k.min(300)),
            })
        })
    }

    /// Long programs, with values before and after the sines.
    fn long() -> [Program; 2] {
        let mut program = tangled(5000);
        program.angles = vec![Operand::Step(3), Operand::Step(398)];
        program.before_angles = 400;
        [program, tangled(LONGEST_SCOPE * LONGEST_SCOPE + 1)]
    }

    /// All steps as statements of their own.
    fn nested(program: &Program) -> Nested {
        let inlined = Inlined::none(program.steps.len());
        super::nested(program, &[], &program.results, &inlined)
    }

    /// Visits scopes as a compiler does.
    struct Walk<'p> {
        program: &'p Program,
        /// Next step.
        next: u32,
        /// True for each step with a name in an open scope.
        visible: Vec<bool>,
    }

    impl Walk<'_> {
        /// Steps that a scope binds, and the maximum number of nested bindings.
        fn scope(&mut self, entries: &[ScopeEntry]) -> (Vec<u32>, usize) {
            let (mut bound, mut deepest) = (Vec::new(), entries.len());
            for (before, entry) in entries.iter().enumerate() {
                let new = match entry {
                    ScopeEntry::Step(step) => {
                        self.step(*step);
                        vec![*step]
                    }
                    ScopeEntry::Block(Block { entries, outputs }) => {
                        assert!((SHORTEST..=LONGEST_SCOPE).contains(&entries.len()));
                        let (inside, depth) = self.scope(entries);
                        deepest = deepest.max(before + depth);
                        for step in &inside {
                            self.visible[*step as usize] = false;
                        }
                        assert!(outputs.iter().all(|step| inside.contains(step)));
                        outputs.clone()
                    }
                };
                for step in &new {
                    self.visible[*step as usize] = true;
                }
                bound.extend(new);
            }
            (bound, deepest)
        }

        fn step(&mut self, step: u32) {
            assert_eq!(step, self.next, "steps stay in their order");
            self.next += 1;
            let step = &self.program.steps[step as usize];
            self.read(&step.operation.operands());
        }

        fn read(&self, operands: &[Operand]) {
            for operand in operands {
                if let Operand::Step(step) = *operand {
                    assert!(self.visible[step as usize], "{step} cannot be seen");
                }
            }
        }
    }

    #[test]
    fn values_are_in_scope_where_they_are_read() {
        for (program, levels) in long().iter().zip([2, 3]) {
            let mut walk = Walk {
                program,
                next: 0,
                visible: vec![false; program.steps.len()],
            };
            let Nested { before, after } = nested(program);
            let after = after.concat();
            walk.scope(&before);
            walk.read(&program.angles);
            let (_, deepest) = walk.scope(&after);
            walk.read(&program.results);
            assert_eq!(walk.next as usize, program.steps.len());
            assert!(deepest <= levels * LONGEST_SCOPE, "{deepest}");
        }
    }

    #[test]
    fn blocks_return_only_values_that_are_read() {
        fn check(entries: &[ScopeEntry], program: &Program) {
            for entry in entries {
                if let ScopeEntry::Block(Block { entries, outputs }) = entry {
                    let end = entry.end() as usize;
                    let behind = program.steps[end..].iter();
                    let behind = behind.flat_map(|step| step.operation.operands());
                    let mut behind: Vec<_> = behind.chain(program.results.clone()).collect();
                    if end <= program.before_angles {
                        behind.extend(&program.angles);
                    }
                    let read = |step: &u32| behind.contains(&Operand::Step(*step));
                    assert!(outputs.iter().all(read));
                    check(entries, program);
                }
            }
        }
        let [program, _] = long();
        let Nested { before, after } = nested(&program);
        for entries in [before, after.concat()] {
            check(&entries, &program);
        }
    }

    #[test]
    fn a_short_program_is_one_scope() {
        let is_step = |entry: &ScopeEntry| matches!(entry, ScopeEntry::Step(_));
        let nested = |steps: usize| {
            let program = tangled(steps);
            nested(&program)
        };
        let Nested { before, after } = nested(FLAT);
        let after = after.concat();
        assert_eq!((before.len(), after.len()), (0, FLAT));
        assert!(after.iter().all(is_step));
        let after = nested(FLAT + 1).after.concat();
        assert!(!after.iter().any(is_step));
    }

    /// Stretches of steps that all read their first step, and one step of the stretch before the last.
    #[test]
    fn cuts_are_where_blocks_return_one_value() {
        let stretch = 110;
        let program = program(1100, |k| match k % stretch {
            0 => [k - 1, k - 1],
            1 if k > 1 => [k - 2, k - 1],
            since => [k - since, k - 1],
        });
        let after = nested(&program).after.concat();
        let outputs: Vec<_> = after.iter().map(|entry| entry.outputs().to_vec()).collect();
        let last_of_each = (1..=10).map(|k| vec![k * stretch - 1]);
        assert_eq!(outputs, last_of_each.collect::<Vec<_>>());
    }
}
