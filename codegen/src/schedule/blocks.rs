//! Which steps of a long program stand together in a block of their own.
//!
//! In: a [`Program`]. Out: its steps in the order in which they run, nested: a block hands on what
//! is read behind it, and nothing else. It never changes or moves a step, and knows no language.
//!
//! Each `let` of Rust is a scope for all that follow it in its block, and rustc describes scopes to
//! debuggers by recursion: between 2,800 and 3,000 of them, one within the other, take its whole
//! stack of 8 MiB (1.63 and 1.95 on x86-64 Linux, unoptimised and optimised, for `core` alone and
//! generic). What counts is the longest way inwards, since a block ends the scopes inside it: here
//! [`FLAT`] steps and angles in a short program, in others [`LONGEST_SCOPE`] for each level of
//! blocks. A tree of 39 joints, with 10,000 steps, stays below 300, a tenth of what there is.

use std::ops::Range;

use super::readers::{note_readers, read_until};
use super::repeats::Repeat;
use super::{Operand, Program};

/// A program of up to so many steps and angles is one scope: a third of what a compiler bears.
const FLAT: usize = 900;

/// The most bindings of one scope in a longer program: a block, or what comes before the sines or
/// after them outside of all blocks. Blocks are nested once from here on, twice from somewhere
/// below its square (22,500 steps), and a third time at some million, which is more than 1,000
/// joints need.
pub const LONGEST_SCOPE: usize = 150;

/// The fewest entries of a block; anything from here on can be divided into blocks.
const SHORTEST: usize = LONGEST_SCOPE / 2;

/// An entry of a scope.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// The step of that index, as [`Operand::Step`] has it.
    Step(u32),
    /// Several parts in a scope of their own.
    Block(Block),
}

/// A scope within a scope.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// What it consists of.
    pub parts: Vec<Part>,
    /// The steps inside that are read behind it, in their order.
    pub handed_on: Vec<u32>,
}

/// The steps of a program that stays whole.
pub struct Nested {
    /// Those before the sines and cosines.
    pub before: Vec<Part>,
    /// Those after them: before the first repeat, between two, and behind the last.
    pub after: Vec<Vec<Part>>,
}

/// The steps of a program whose repeats are loops, and of which these results are read at the end.
#[must_use]
pub fn nested(program: &Program, repeats: &[Repeat], results: &[Operand]) -> Nested {
    let steps = (0_u32..).take(program.steps.len()).map(Part::Step);
    let mut steps: Vec<_> = steps.collect();
    let mut after = Vec::new();
    for repeat in repeats.iter().rev() {
        let all = repeat.steps();
        after.push(steps.split_off(all.end as usize));
        steps.truncate(all.start as usize);
    }
    after.push(steps.split_off(program.before_angles));
    after.reverse();
    let mut nested = Nested {
        before: steps,
        after,
    };
    let stretches = std::iter::once(&mut nested.before).chain(&mut nested.after);
    let stretches: Vec<_> = stretches.collect();
    let written: usize = stretches.iter().map(|parts| parts.len()).sum();
    if written + program.angles.len() > FLAT {
        let read_until = read_until(program, results);
        for parts in stretches {
            *parts = in_blocks(std::mem::take(parts), &read_until);
        }
    }
    nested
}

/// The steps before the sines and cosines of a program in sections.
#[must_use]
pub fn before(program: &Program) -> Vec<Part> {
    let steps = (0_u32..).take(program.before_angles);
    in_blocks(
        steps.map(Part::Step).collect(),
        &read_until(program, &program.results),
    )
}

/// The steps of a section, or of the first round of a repeat: of these only some are read outside where they are
/// bound, the others where they wait.
#[must_use]
pub fn within(program: &Program, section: Range<u32>, bound: &[u32]) -> Vec<Part> {
    let parts = section.clone().map(Part::Step).collect();
    if section.len() <= FLAT {
        return parts;
    }
    let mut read_until = vec![0; program.steps.len()];
    let steps = &program.steps[section.start as usize..section.end as usize];
    note_readers(section.zip(steps), &mut read_until);
    for &step in bound {
        read_until[step as usize] = u32::MAX;
    }
    in_blocks(parts, &read_until)
}

/// The parts in no more bindings than a scope may have.
fn in_blocks(mut parts: Vec<Part>, read_until: &[u32]) -> Vec<Part> {
    while parts.len() > LONGEST_SCOPE {
        parts = grouped(parts, read_until);
    }
    parts
}

impl Part {
    /// The steps inside that are read behind it.
    fn handed_on(&self) -> &[u32] {
        match self {
            Self::Step(step) => std::slice::from_ref(step),
            Self::Block(block) => &block.handed_on,
        }
    }

    /// The step behind its last one.
    fn end(&self) -> u32 {
        match self {
            Self::Step(step) => step + 1,
            Self::Block(block) => block.parts.last().map_or(0, Self::end),
        }
    }
}

/// The parts in blocks of [`SHORTEST`] to [`LONGEST_SCOPE`], cut where the blocks hand on the fewest
/// values in all.
fn grouped(parts: Vec<Part>, read_until: &[u32]) -> Vec<Part> {
    let mut rest = parts.into_iter();
    let cuts = cuts(rest.as_slice(), read_until);
    let blocks = cuts.into_iter().map(|cut| {
        let parts: Vec<_> = rest.by_ref().take(cut.len()).collect();
        let end = parts.last().map_or(0, Part::end);
        let inside = parts.iter().flat_map(Part::handed_on).copied();
        let handed_on = inside
            .filter(|&step| read_until[step as usize] >= end)
            .collect();
        Part::Block(Block { parts, handed_on })
    });
    blocks.collect()
}

/// The cheapest cuts: those of the parts up to each place come from those of the parts up to the
/// place where the block that ends there begins.
fn cuts(parts: &[Part], read_until: &[u32]) -> Vec<Range<usize>> {
    // What all blocks up to a place hand on, and where the last one begins.
    let mut best = vec![None; parts.len() + 1];
    best[0] = Some((0, 0));
    for end in SHORTEST..=parts.len() {
        let behind = parts[end - 1].end();
        let mut handed_on = 0;
        let mut found = None;
        for start in (end.saturating_sub(LONGEST_SCOPE)..end).rev() {
            for &step in parts[start].handed_on() {
                handed_on += u32::from(read_until[step as usize] >= behind);
            }
            if let (true, Some((before, _))) = (end - start >= SHORTEST, best[start]) {
                let all = before + handed_on;
                if found.is_none_or(|(least, _)| all < least) {
                    found = Some((all, start));
                }
            }
        }
        best[end] = found;
    }
    let mut cuts = Vec::new();
    let mut end = parts.len();
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

    use super::{Block, FLAT, LONGEST_SCOPE, Nested, Part, SHORTEST, nested};
    use crate::expression::Input;
    use crate::schedule::{Operand, Operation, Program, Step};
    use crate::space::Variable;

    /// A program in which `read` says the two steps that each one reads; the first reads none.
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

    /// One of the 300 steps before mostly, any other one step in ten.
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

    /// Programs that are cut, with values before the sines and after them.
    fn long() -> [Program; 2] {
        let mut program = tangled(5000);
        program.angles = vec![Operand::Step(3), Operand::Step(398)];
        program.before_angles = 400;
        [program, tangled(LONGEST_SCOPE * LONGEST_SCOPE + 1)]
    }

    /// Goes through scopes as a compiler does.
    struct Walk<'p> {
        program: &'p Program,
        /// The step that comes next.
        next: u32,
        /// Whether each step has a name in the scopes that are open.
        visible: Vec<bool>,
    }

    impl Walk<'_> {
        /// What a scope binds, and how many bindings one within the other there are at most.
        fn scope(&mut self, parts: &[Part]) -> (Vec<u32>, usize) {
            let (mut bound, mut deepest) = (Vec::new(), parts.len());
            for (before, part) in parts.iter().enumerate() {
                let new = match part {
                    Part::Step(step) => {
                        self.step(*step);
                        vec![*step]
                    }
                    Part::Block(Block { parts, handed_on }) => {
                        assert!((SHORTEST..=LONGEST_SCOPE).contains(&parts.len()));
                        let (inside, depth) = self.scope(parts);
                        deepest = deepest.max(before + depth);
                        for step in &inside {
                            self.visible[*step as usize] = false;
                        }
                        assert!(handed_on.iter().all(|step| inside.contains(step)));
                        handed_on.clone()
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
    fn everything_that_is_read_can_be_seen() {
        for (program, levels) in long().iter().zip([2, 3]) {
            let mut walk = Walk {
                program,
                next: 0,
                visible: vec![false; program.steps.len()],
            };
            let Nested { before, after } = nested(program, &[], &program.results);
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
    fn nothing_is_handed_on_that_nobody_reads() {
        fn check(parts: &[Part], program: &Program) {
            for part in parts {
                if let Part::Block(Block { parts, handed_on }) = part {
                    let end = part.end() as usize;
                    let behind = program.steps[end..].iter();
                    let behind = behind.flat_map(|step| step.operation.operands());
                    let mut behind: Vec<_> = behind.chain(program.results.clone()).collect();
                    if end <= program.before_angles {
                        behind.extend(&program.angles);
                    }
                    let read = |step: &u32| behind.contains(&Operand::Step(*step));
                    assert!(handed_on.iter().all(read));
                    check(parts, program);
                }
            }
        }
        let [program, _] = long();
        let Nested { before, after } = nested(&program, &[], &program.results);
        for parts in [before, after.concat()] {
            check(&parts, &program);
        }
    }

    #[test]
    fn a_short_program_is_one_scope() {
        let is_step = |part: &Part| matches!(part, Part::Step(_));
        let nested = |steps: usize| {
            let program = tangled(steps);
            nested(&program, &[], &program.results)
        };
        let Nested { before, after } = nested(FLAT);
        let after = after.concat();
        assert_eq!((before.len(), after.len()), (0, FLAT));
        assert!(after.iter().all(is_step));
        let after = nested(FLAT + 1).after.concat();
        assert!(!after.iter().any(is_step));
    }

    /// Stretches that all read the first of their steps, and of the stretch before the last one.
    #[test]
    fn cuts_are_where_one_value_is_left() {
        let stretch = 110;
        let program = program(1100, |k| match k % stretch {
            0 => [k - 1, k - 1],
            1 if k > 1 => [k - 2, k - 1],
            since => [k - since, k - 1],
        });
        let after = nested(&program, &[], &program.results).after.concat();
        let handed_on: Vec<_> = after.iter().map(|part| part.handed_on().to_vec()).collect();
        let last_of_each = (1..=10).map(|k| vec![k * stretch - 1]);
        assert_eq!(handed_on, last_of_each.collect::<Vec<_>>());
    }
}
