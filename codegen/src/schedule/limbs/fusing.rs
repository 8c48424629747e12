//! Fused operations that equal limbs have in common.
//!
//! In: a program. Out: the same with fewer fused operations: where the same product and sum are fused in one limb and
//! not in another, such as a sum in one and a difference that can cancel in its mirror image, they are fused in none.
//! Columns of a matrix that a loop computes stay alike.
//! Nothing changes where there is no loop over limbs.

use super::groups::Groups;
use super::loops::loops;
use crate::schedule::repeats::repeats;
use crate::schedule::{Operand, Operation, Program, Step, number};
use crate::space::Limbs;

/// The program with the same fused operations in equal limbs.
#[must_use]
pub fn fused_alike(program: Program, limbs: &[Limbs]) -> Program {
    if limbs.is_empty() {
        return program;
    }
    let all = apart(&program, |_| true);
    let groups = Groups::of(&all.program, limbs);
    // For each step the product that was fused into it.
    let mut product = vec![None; all.program.steps.len()];
    for &(fused, sum) in &all.sums {
        product[sum as usize] = Some(fused);
    }
    let is_fused = |operand: &Operand| match operand {
        Operand::Step(step) => product[*step as usize].is_some(),
        _ => false,
    };
    let is_mixed = |sum: u32| {
        let group = groups.find(Operand::Step(sum));
        group.is_some_and(|(group, _)| !groups.all[group].lanes.iter().all(is_fused))
    };
    let columns = repeats(&program);
    let is_in_columns = |step: u32| {
        let after = columns.partition_point(|repeat| repeat.steps().end <= step);
        columns
            .get(after)
            .is_some_and(|repeat| repeat.steps().contains(&step))
    };
    let mixed: Vec<u32> = all
        .sums
        .iter()
        .filter(|(fused, sum)| !is_in_columns(*fused) && is_mixed(*sum))
        .map(|(fused, _)| *fused)
        .collect();
    if mixed.is_empty() {
        return program;
    }
    let mut mixed = mixed.into_iter().peekable();
    let alike = apart(&program, |step| mixed.next_if_eq(&step).is_some()).program;
    // Two operations are slower than one, unless a loop makes up for it.
    let groups = Groups::of(&alike, limbs);
    if loops(&alike, &groups, &repeats(&alike)).is_some() {
        alike
    } else {
        program
    }
}

/// A program with fused operations taken apart.
struct Apart {
    program: Program,
    /// Steps that were taken apart, and the new steps of their sums.
    sums: Vec<(u32, u32)>,
}

/// Takes some fused operations apart.
fn apart(program: &Program, mut is_chosen: impl FnMut(u32) -> bool) -> Apart {
    let mut places = Vec::with_capacity(program.steps.len());
    let mut found = Apart {
        program: Program {
            steps: Vec::new(),
            ..program.clone()
        },
        sums: Vec::new(),
    };
    for (at, Step { label, operation }) in (0_u32..).zip(&program.steps) {
        if at as usize == program.before_angles {
            found.program.before_angles = found.program.steps.len();
        }
        let place = |operand: Operand| match operand {
            Operand::Step(step) => Operand::Step(places[step as usize]),
            other => other,
        };
        let operation = operation.map(place);
        let steps = &mut found.program.steps;
        let operation = if operation.is_fused() && is_chosen(at) {
            let [a, b, c] = operation.operands()[..] else {
                unreachable!("fused operations have three operands")
            };
            steps.push(Step {
                label: None,
                operation: Operation::Mul(a, b),
            });
            let product = Operand::Step(number(steps.len() - 1));
            found.sums.push((at, number(steps.len())));
            match operation {
                Operation::MulAdd(..) => Operation::Add(product, c),
                Operation::MulSub(..) => Operation::Sub(product, c),
                _ => Operation::Sub(c, product),
            }
        } else {
            operation
        };
        places.push(number(steps.len()));
        steps.push(Step {
            label: *label,
            operation,
        });
    }
    if program.before_angles == program.steps.len() {
        found.program.before_angles = found.program.steps.len();
    }
    let place = |operand: &Operand| match *operand {
        Operand::Step(step) => Operand::Step(places[step as usize]),
        other => other,
    };
    found.program.angles = program.angles.iter().map(place).collect();
    found.program.results = program.results.iter().map(place).collect();
    found
}
