//! Steps in the order of loops over limbs.
//!
//! In: a program, its groups, and their places. Out: the program in that order, with the first iteration of each loop
//! over limbs or columns.

use super::cutting::Cutting;
use super::groups::Groups;
use super::iteration::{Iteration, LoopOperand};
use super::loops::{Loops, Unit};
use crate::schedule::repeats::{Iterations, Over, Repeat};
use crate::schedule::{Operand, Program, Step, number};

/// The program in another order, and all its loops.
pub fn ordered(
    program: &Program,
    groups: &Groups,
    loops: &Loops,
    columns: &[Repeat],
    longest: usize,
) -> (Program, Iterations) {
    let cutting = Cutting::of(program, groups, loops);
    let mut order = Order {
        program,
        groups,
        columns,
        steps: program.steps[..program.before_angles].to_vec(),
        places: (0_u32..).take(program.before_angles).map(Some).collect(),
        iterations: Vec::new(),
    };
    order.places.resize(program.steps.len(), None);
    let last_loop = loops.loops.keys().map(|(at, _)| *at).max();
    let last = last_loop.max(loops.stretches.keys().next_back().copied());
    for at in 0..=last.unwrap_or_default() {
        for (_, groups) in loops.loops.range((at, 0)..=(at, usize::MAX)) {
            for part in cutting.cut(groups, longest) {
                order.iterations(part);
            }
        }
        for &unit in loops.stretches.get(&at).into_iter().flatten() {
            order.unit(unit);
        }
    }
    let results = program.results.iter().map(|&result| order.outside(result));
    let ordered = Program {
        results: results.collect(),
        angles: program.angles.clone(),
        open: program.open.clone(),
        before_angles: program.before_angles,
        steps: order.steps,
    };
    (ordered, order.iterations)
}

struct Order<'p> {
    program: &'p Program,
    groups: &'p Groups,
    columns: &'p [Repeat],
    /// Steps in the new order.
    steps: Vec<Step>,
    /// New index of each step.
    places: Vec<Option<u32>>,
    iterations: Iterations,
}

impl Order<'_> {
    /// An operand in the new order.
    fn outside(&self, operand: Operand) -> Operand {
        match operand {
            Operand::Step(step) => {
                let place = self.places[step as usize];
                Operand::Step(place.expect("operands come before their readers"))
            }
            other => other,
        }
    }

    fn unit(&mut self, unit: Unit) {
        match unit {
            Unit::Step(step) => self.step(step),
            Unit::Columns(index) => {
                let (repeat, first) = (&self.columns[index], self.steps.len());
                let count = repeat.iterations as usize;
                let first = first..first + repeat.first.len();
                self.iterations.push((Over::Columns, first, count));
                repeat.steps().for_each(|step| self.step(step));
            }
            Unit::Group(_) => unreachable!("groups are in loops"),
        }
    }

    fn step(&mut self, step: u32) {
        let Step { label, operation } = self.program.steps[step as usize];
        let operation = operation.map(|operand| self.outside(operand));
        self.places[step as usize] = Some(number(self.steps.len()));
        self.steps.push(Step { label, operation });
    }

    /// All iterations of a loop over limbs.
    fn iterations(&mut self, groups: &[usize]) {
        let rows = Iteration::of(self.program, self.groups, groups).rows;
        let (start, lanes) = (self.steps.len(), rows[0].len());
        let all = start..start + rows.len();
        self.iterations.push((Over::Limbs, all, lanes));
        for lane in 0..lanes {
            let first = self.steps.len();
            for row in &rows {
                let (step, operation) = &row[lane];
                let operation = operation.map(|read| match read {
                    LoopOperand::Outside(operand) => self.outside(operand),
                    LoopOperand::Inside(row) => Operand::Step(number(first + row)),
                });
                let label = step.and_then(|step| {
                    self.places[step as usize] = Some(number(self.steps.len()));
                    self.program.steps[step as usize].label
                });
                self.steps.push(Step { label, operation });
            }
        }
    }
}
