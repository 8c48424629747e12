//! What a program costs, counted exactly.
//!
//! In: a program. Out: its [`Price`]. It never estimates time: a unit is an operation of the source,
//! and what the machine makes of it is for the benchmarks.

use std::collections::BTreeSet;

use super::{Operand, Operation, Program};

/// Operations of one call.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Price {
    /// Multiplications, those inside fused operations included.
    pub mul: usize,
    /// Additions and subtractions, those inside fused operations included.
    pub add: usize,
    /// Divisions.
    pub div: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Sines.
    pub sin: usize,
    /// Cosines.
    pub cos: usize,
    /// Sign changes that are operations of their own.
    pub neg: usize,
    /// Multiplications that are one operation with the addition that follows.
    pub fused: usize,
    /// Operations on the longest way from an input to a result.
    pub depth: usize,
    /// Different numbers written in the code.
    pub literals: usize,
}

impl Price {
    /// Counts a program.
    #[must_use]
    pub fn of(program: &Program) -> Self {
        let mut price = Self::default();
        let mut sines = BTreeSet::new();
        let mut cosines = BTreeSet::new();
        let mut literals = BTreeSet::new();
        let mut depths: Vec<usize> = Vec::with_capacity(program.steps.len());
        let mut angle_depths: Vec<usize> = Vec::new();
        for (k, step) in program.steps.iter().enumerate() {
            if k == program.before_angles {
                angle_depths = program.angles.iter().map(|&angle| depth(angle, &depths, &[])).collect();
            }
            match step.operation {
                Operation::Add(..) | Operation::Sub(..) => price.add += 1,
                Operation::Mul(..) => price.mul += 1,
                Operation::Div(..) => price.div += 1,
                Operation::Sqrt(..) => price.sqrt += 1,
                Operation::Neg(..) => price.neg += 1,
                Operation::MulAdd(..) | Operation::MulSub(..) | Operation::NegMulAdd(..) => {
                    price.mul += 1;
                    price.add += 1;
                    price.fused += 1;
                }
            }
            let operands = step.operation.operands();
            note(&operands, &mut sines, &mut cosines, &mut literals);
            let deepest = operands.iter().map(|&operand| depth(operand, &depths, &angle_depths)).max();
            depths.push(1 + deepest.unwrap_or(0));
        }
        note(&program.angles, &mut sines, &mut cosines, &mut literals);
        note(&program.results, &mut sines, &mut cosines, &mut literals);
        price.sin = sines.len();
        price.cos = cosines.len();
        price.literals = literals.len();
        price.depth = (program.results.iter())
            .map(|&result| depth(result, &depths, &angle_depths))
            .max()
            .unwrap_or(0);
        price
    }

    /// One number to compare two programs for the same function by. A unit is roughly one
    /// addition; only the order is meaningful.
    #[must_use]
    pub fn weight(&self) -> usize {
        self.mul + self.add + self.neg + 15 * (self.div + self.sqrt) + 10 * (self.sin + self.cos)
    }
}

fn depth(operand: Operand, steps: &[usize], angles: &[usize]) -> usize {
    match operand {
        Operand::Literal(_) | Operand::Input(_) => 0,
        // Sine and cosine count as one operation behind their angle.
        Operand::Sin(k) | Operand::Cos(k) => 1 + angles.get(k as usize).copied().unwrap_or(0),
        Operand::Step(k) => steps[k as usize],
    }
}

fn note(
    operands: &[Operand],
    sines: &mut BTreeSet<u32>,
    cosines: &mut BTreeSet<u32>,
    literals: &mut BTreeSet<u64>,
) {
    for operand in operands {
        match *operand {
            Operand::Sin(k) => {
                sines.insert(k);
            }
            Operand::Cos(k) => {
                cosines.insert(k);
            }
            Operand::Literal(value) => {
                literals.insert(value.abs().to_bits());
            }
            Operand::Input(_) | Operand::Step(_) => {}
        }
    }
}
