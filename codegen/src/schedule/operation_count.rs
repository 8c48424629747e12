//! Operation counts of programs.
//!
//! In: a [`Program`]. Out: its [`OperationCount`], which comments and `homogen count` print, and its cycles on a [`Processor`],
//! by which formulations are compared.

use std::collections::BTreeSet;
use std::fmt;

use super::{Operand, Operation, Program};
use crate::processor::{Costs, Processor};
use crate::real::Real;

/// Numbers of operations of a program.
///
/// A fused operation counts as a product and a sum, so that the counts do not depend on the target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OperationCount {
    /// Products.
    pub mul: usize,
    /// Sums and differences.
    pub add: usize,
    /// Quotients.
    pub div: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Signs of numbers: −1, 0 or 1.
    pub sign: usize,
    /// Separate negations.
    pub neg: usize,
    /// Sines that are read.
    pub sin: usize,
    /// Cosines that are read.
    pub cos: usize,
    /// Products and sums that a fused operation combines.
    pub fused: usize,
    /// Length of the longest chain of dependent operations.
    pub depth: usize,
    /// Number of different literals, signs ignored.
    pub literals: usize,
    /// Products by dense 4×4 matrices; 0 if not counted.
    pub naive_mul: usize,
    /// Sums and differences by dense 4×4 matrices.
    pub naive_add: usize,
    /// Processor that the program was chosen for, if any, and cycles of its arithmetic there without sines and cosines.
    pub cycles: Option<(Processor, usize)>,
}

impl OperationCount {
    /// Counts of a program, without those of dense matrices.
    #[must_use]
    pub fn of(program: &Program) -> Self {
        let mut operation_count = Self::default();
        let mut literals = BTreeSet::new();
        let mut sines = BTreeSet::new();
        let mut cosines = BTreeSet::new();
        let operations = program.steps.iter().map(|step| step.operation);
        let operands = operations
            .clone()
            .flat_map(|operation| operation.operands());
        for operand in operands.chain(program.angles.iter().copied()) {
            if let Operand::Literal(value) = operand {
                literals.insert(value.abs().to_bits());
            }
        }
        for operand in program.operands() {
            match operand {
                Operand::Sin(angle) => drop(sines.insert(angle)),
                Operand::Cos(angle) => drop(cosines.insert(angle)),
                Operand::Literal(_) | Operand::Input(_) | Operand::Step(_) => {}
            }
        }
        for operation in operations {
            operation_count.charge(operation);
        }
        operation_count.literals = literals.len();
        operation_count.sin = sines.len();
        operation_count.cos = cosines.len();
        operation_count.depth = depth(program);
        operation_count
    }

    /// The same counts with those of dense 4×4 matrices.
    #[must_use]
    pub const fn beside_dense(self, naive_mul: usize, naive_add: usize) -> Self {
        Self {
            naive_mul,
            naive_add,
            ..self
        }
    }

    /// The same counts with the cycles on a processor; [`Processor::Portable`] has none.
    #[must_use]
    pub fn on(self, processor: Processor, scalar: Real) -> Self {
        let chosen = processor != Processor::Portable;
        let cycles = chosen.then(|| (processor, self.cycles_on(processor, scalar)));
        Self { cycles, ..self }
    }

    /// Cost for the comparison of programs for the same function; only the order is meaningful.
    #[must_use]
    pub const fn weight(&self, processor: Processor, scalar: Real) -> usize {
        let costs = processor.costs(scalar);
        self.arithmetic(&costs) + costs.turn * (self.sin + self.cos)
    }

    /// Cycles for which the arithmetic units of a processor are busy, without sines and cosines. Loads, stores and
    /// latencies come on top.
    const fn cycles_on(&self, processor: Processor, scalar: Real) -> usize {
        let costs = processor.costs(scalar);
        self.arithmetic(&costs).div_ceil(costs.units)
    }

    const fn arithmetic(&self, costs: &Costs) -> usize {
        let fused = match costs.fused {
            Some(fused) => fused,
            None => costs.mul + costs.add,
        };
        // A sign is two comparisons and their difference.
        costs.mul * (self.mul - self.fused)
            + costs.add * (self.add - self.fused + self.neg + 3 * self.sign)
            + fused * self.fused
            + costs.div * self.div
            + costs.sqrt * self.sqrt
    }

    const fn charge(&mut self, operation: Operation) {
        match operation {
            Operation::Add(..) | Operation::Sub(..) => self.add += 1,
            Operation::Mul(..) => self.mul += 1,
            Operation::Div(..) => self.div += 1,
            Operation::Sqrt(_) => self.sqrt += 1,
            Operation::Sign(_) => self.sign += 1,
            Operation::Neg(_) => self.neg += 1,
            Operation::MulAdd(..) | Operation::MulSub(..) | Operation::NegMulAdd(..) => {
                self.mul += 1;
                self.add += 1;
                self.fused += 1;
            }
        }
    }
}

impl fmt::Display for OperationCount {
    /// One line: `308 mul, 291 add, 0 div, 12 sin and cos; depth 44; dense 4×4 products: …`.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} mul, {} add, {} div", self.mul, self.add, self.div)?;
        if self.sqrt > 0 {
            write!(out, ", {} sqrt", self.sqrt)?;
        }
        if self.sign > 0 {
            write!(out, ", {} sign", self.sign)?;
        }
        write!(out, ", {} sin and cos", self.sin + self.cos)?;
        write!(out, "; depth {}", self.depth)?;
        if self.naive_mul > 0 {
            let (mul, add) = (self.naive_mul, self.naive_add);
            write!(out, "; dense 4×4 products: {mul} mul, {add} add")?;
        }
        if let Some((processor, cycles)) = self.cycles {
            let name = processor.name();
            write!(
                out,
                "; on {name} {cycles} cycles of arithmetic without sines and cosines"
            )?;
        }
        Ok(())
    }
}

/// Length of the longest chain of operations; a sine or cosine counts as one.
fn depth(program: &Program) -> usize {
    let (before, after) = program.steps.split_at(program.before_angles);
    let mut depths = Depths::default();
    for step in before {
        depths.push(step.operation);
    }
    depths.angles = program
        .angles
        .iter()
        .map(|angle| depths.of(*angle))
        .collect();
    for step in after {
        depths.push(step.operation);
    }
    let results = program.results.iter();
    results.map(|result| depths.of(*result)).max().unwrap_or(0)
}

#[derive(Default)]
struct Depths {
    steps: Vec<usize>,
    angles: Vec<usize>,
}

impl Depths {
    fn of(&self, operand: Operand) -> usize {
        match operand {
            Operand::Literal(_) | Operand::Input(_) => 0,
            Operand::Sin(angle) | Operand::Cos(angle) => self.angles[angle as usize] + 1,
            Operand::Step(step) => self.steps[step as usize],
        }
    }

    fn push(&mut self, operation: Operation) {
        let ready = match operation {
            // Two operations, of which only the second waits for the term.
            Operation::MulAdd(a, b, c)
            | Operation::MulSub(a, b, c)
            | Operation::NegMulAdd(a, b, c) => (self.of(a).max(self.of(b)) + 1).max(self.of(c)),
            _ => {
                let operands = operation.operands();
                operands
                    .iter()
                    .map(|operand| self.of(*operand))
                    .max()
                    .unwrap_or(0)
            }
        };
        self.steps.push(ready + 1);
    }
}

#[cfg(test)]
mod tests {
    use super::OperationCount;
    use crate::expression::Input;
    use crate::processor::Processor;
    use crate::real::Real;
    use crate::schedule::{Operand, Operation, Program, Step};
    use crate::space::Variable;

    fn program(operations: Vec<Operation>, results: Vec<Operand>) -> Program {
        let steps = operations.into_iter();
        Program {
            angles: vec![Operand::Input(Input::Variable(Variable::Q, 0))],
            before_angles: 0,
            steps: steps
                .map(|operation| Step {
                    label: None,
                    operation,
                })
                .collect(),
            results,
            ..Program::default()
        }
    }

    #[test]
    fn fused_operations_count_as_their_parts() {
        let (s, c, two) = (Operand::Sin(0), Operand::Cos(0), Operand::Literal(2.0));
        let plain = program(
            vec![
                Operation::Mul(two, s),
                Operation::Mul(two, c),
                Operation::Add(Operand::Step(0), Operand::Step(1)),
            ],
            vec![Operand::Step(2)],
        );
        let fused = program(
            vec![
                Operation::Mul(two, s),
                Operation::MulAdd(two, c, Operand::Step(0)),
            ],
            vec![Operand::Step(1)],
        );
        let (plain, fused) = (OperationCount::of(&plain), OperationCount::of(&fused));
        assert_eq!(
            plain.to_string(),
            "2 mul, 1 add, 0 div, 2 sin and cos; depth 3"
        );
        assert_eq!(fused.to_string(), plain.to_string());
        assert_eq!((fused.fused, fused.literals), (1, 1));
    }

    #[test]
    fn only_used_values_count() {
        let sine = program(vec![], vec![Operand::Sin(0), Operand::Literal(0.0)]);
        let operation_count = OperationCount::of(&sine).beside_dense(64, 48);
        assert_eq!(
            (
                operation_count.sin,
                operation_count.cos,
                operation_count.literals
            ),
            (1, 0, 0)
        );
        assert_eq!(
            operation_count.to_string(),
            "0 mul, 0 add, 0 div, 1 sin and cos; depth 1; dense 4×4 products: 64 mul, 48 add"
        );
    }

    const PRICE: OperationCount = OperationCount {
        mul: 30,
        add: 20,
        div: 2,
        sqrt: 0,
        sign: 0,
        neg: 1,
        sin: 4,
        cos: 3,
        fused: 10,
        depth: 9,
        literals: 5,
        naive_mul: 0,
        naive_add: 0,
        cycles: None,
    };

    #[test]
    fn cycles_count_busy_units() {
        for (processor, scalar, cycles) in [
            (Processor::CortexM4, Real::F32, 30 + 21 + 2 * 14),
            (Processor::CortexM7, Real::F32, 30 + 21 + 2 * 16),
            (Processor::CortexM7, Real::F64, 3 * 30 + 21 + 2 * 31),
            // Two units, and ten products that a sum takes with it where it can.
            (
                Processor::X86_64,
                Real::F64,
                (30 + 21 + 2 * 4_usize).div_ceil(2),
            ),
            (
                Processor::X86_64V3,
                Real::F64,
                (20 + 11 + 10 + 2 * 4_usize).div_ceil(2),
            ),
            (
                Processor::AArch64,
                Real::F64,
                (20 + 11 + 10 + 2 * 7_usize).div_ceil(2),
            ),
        ] {
            assert_eq!(PRICE.cycles_on(processor, scalar), cycles, "{processor:?}");
        }
    }
}
