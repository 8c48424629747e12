//! Detection of loops in a program with known ones, and of none in similar programs.

use homogen_random::Random;

use super::{Repeat, SAVED, SHORTEST, repeats};
use crate::expression::Input;
use crate::schedule::{Operand, Operation, Program, Step};
use crate::space::Variable;

/// Number of steps before the first iteration.
pub const HEAD: u32 = 900;
const ITERATIONS: u32 = 9;
/// Number of steps of an iteration.
pub const LENGTH: u32 = 60;
/// Number of results of an iteration that are read after it, and of values that differ between iterations.
const CROSSING: u32 = 4;

/// Arbitrary steps, iterations of equal operations, and steps that read their results.
pub fn program(head: u32, length: u32) -> Program {
    let mut random = Random::new(3);
    let mut below = move |end: u32| {
        let drawn = random.below(end as usize);
        u32::try_from(drawn).expect("below a u32")
    };
    let q = Operand::Input(Input::Variable(Variable::Q, 0));
    let operation = |kind, a, b| match kind {
        0 => Operation::Add(a, b),
        1 => Operation::Sub(a, b),
        // Repeated products overflow.
        2 => Operation::Mul(a, Operand::Literal(0.5)),
        _ => Operation::MulSub(Operand::Literal(0.25), a, b),
    };
    let mut operations = vec![Operation::Neg(q)];
    for k in 1..head {
        let [a, b] = [(); 2].map(|()| Operand::Step(below(k)));
        operations.push(operation(below(4), a, b));
    }
    let body: Vec<_> = (0..length)
        .map(|k| (below(4), below(k.max(1)), below(head)))
        .collect();
    for iteration in 0..ITERATIONS {
        let start = head + iteration * length;
        for (k, &(kind, own, shared)) in (0..).zip(&body) {
            let own = match k {
                0..CROSSING => Operand::Step(10 * k + iteration),
                _ => Operand::Step(start + own),
            };
            operations.push(operation(kind, own, Operand::Step(shared)));
        }
    }
    let output = |k| Operand::Step(head + length - 1 - k % CROSSING + length * (k % ITERATIONS));
    for k in 0..30 {
        operations.push(operation(0, output(k), output(k + 7)));
    }
    let last = u32::try_from(operations.len() - 1).expect("few steps");
    let step = |operation| Step {
        label: None,
        operation,
    };
    Program {
        angles: Vec::new(),
        before_angles: 0,
        steps: operations.into_iter().map(step).collect(),
        results: vec![Operand::Step(last), Operand::Step(last - 1), output(2)],
        ..Program::default()
    }
}

#[test]
fn iterations_are_found_with_their_inputs() {
    let found = repeats(&program(HEAD, LENGTH));
    let [repeat] = &*found else {
        panic!("{} repeats", found.len());
    };
    assert_eq!(repeat.first, HEAD..HEAD + LENGTH);
    assert_eq!(repeat.iterations, ITERATIONS);
    assert_eq!(repeat.loads.len(), CROSSING as usize);
    assert_eq!(repeat.stores.len(), CROSSING as usize);
    assert!(repeat.saved() >= SAVED);
}

/// Rows of a matrix times columns: within the first row, stretches of operations are as alike as columns are.
#[test]
fn columns_are_found_behind_the_rows_of_a_product() {
    const TERMS: u32 = 40;
    const ROWS: u32 = 6;
    let mut program = program(HEAD, LENGTH);
    program.steps.truncate(HEAD as usize);
    let mut random = Random::new(5);
    let kinds: Vec<bool> = (0..ROWS * TERMS)
        .map(|k| k >= TERMS && random.below(2) == 0)
        .collect();
    program.results.clear();
    for column in 0..ITERATIONS {
        for (k, &plus) in (0..).zip(&kinds) {
            let (entry, of_column) = (Operand::Step(k), Operand::Step(2 * (k % 4) + 10 * column));
            let last = u32::try_from(program.steps.len() - 1).expect("few steps");
            let operation = match (k % TERMS, plus) {
                (0, _) => Operation::Mul(entry, of_column),
                (_, true) => Operation::MulAdd(entry, of_column, Operand::Step(last)),
                (_, false) => Operation::NegMulAdd(entry, of_column, Operand::Step(last)),
            };
            program.steps.push(Step {
                label: None,
                operation,
            });
            if k % TERMS == TERMS - 1 {
                program.results.push(Operand::Step(last + 1));
            }
        }
    }
    let found = repeats(&program);
    let lengths = found
        .iter()
        .map(|repeat| (repeat.length(), repeat.iterations));
    assert_eq!(lengths.collect::<Vec<_>>(), [(ROWS * TERMS, ITERATIONS)]);
}

#[test]
fn an_iteration_that_reads_another_is_rejected() {
    let mut program = program(HEAD, LENGTH);
    let [reads, of] = [3, 2].map(|iteration| HEAD + iteration * LENGTH + 20);
    let operation = &mut program.steps[reads as usize].operation;
    *operation = operation.map(|operand| match operand {
        Operand::Step(step) if step >= HEAD => Operand::Step(of),
        shared => shared,
    });
    let across = |repeat: &Repeat| [reads, of].iter().all(|step| repeat.steps().contains(step));
    assert!(!repeats(&program).iter().any(across));
}

#[test]
fn short_repeats_are_not_loops() {
    let mut all_read = program(HEAD, LENGTH);
    let steps = 0..u32::try_from(all_read.steps.len()).expect("few steps");
    all_read.results = steps.map(Operand::Step).collect();
    assert_eq!(repeats(&all_read), []);
    let short = program(100, LENGTH);
    assert!(short.steps.len() < SHORTEST);
    assert_eq!(repeats(&short), []);
}
