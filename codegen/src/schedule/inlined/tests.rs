//! Places of inlined values.

use homogen_random::Random;

use super::{Inlined, OPERANDS, Place};
use crate::expression::Input;
use crate::schedule::repeats::tests::{HEAD, LENGTH, program as of_columns};
use crate::schedule::{Arranged, Length, Operand, Operation, Program, Step};
use crate::space::Variable;

const Q: Operand = Operand::Input(Input::Variable(Variable::Q, 0));

fn step(step: u32) -> Operand {
    Operand::Step(step)
}

/// A program whose last step is its result.
fn of_steps(operations: &[Operation]) -> Program {
    let last = u32::try_from(operations.len() - 1).expect("few steps");
    let steps = operations.iter().map(|&operation| Step {
        label: None,
        operation,
    });
    Program {
        steps: steps.collect(),
        results: vec![step(last)],
        ..Program::default()
    }
}

/// Places of a program in functions of at most some steps, in which these have a meaning.
fn places(program: &Program, length: Length, named: &[u32]) -> Vec<Place> {
    let arranged = Arranged::of(program, &[], length);
    Inlined::of(&arranged, |step| named.contains(&step)).0
}

/// Steps that are written in their reader.
fn inlined(operations: &[Operation], named: &[u32]) -> Vec<usize> {
    let places = places(&of_steps(operations), Length::UNBOUNDED, named).into_iter();
    let places = places
        .enumerate()
        .filter(|(_, place)| *place == Place::Reader);
    places.map(|(step, _)| step).collect()
}

#[test]
fn a_value_that_the_next_statement_alone_reads_is_inlined() {
    let products = [Operation::Mul(Q, Q), Operation::Mul(Q, Q)];
    let [a, b] = products;
    assert_eq!(
        inlined(&[a, b, Operation::Add(step(0), step(1))], &[]),
        [0, 1]
    );
    assert_eq!(
        inlined(&[a, b, Operation::Add(step(0), step(1))], &[0]),
        [1]
    );
    // Twice, by one operation or by two.
    assert!(inlined(&[a, Operation::Mul(step(0), step(0))], &[]).is_empty());
    let twice = [a, Operation::Neg(step(0)), Operation::Add(step(0), step(1))];
    assert_eq!(inlined(&twice, &[]), [1]);
    // Both comparisons of a sign read its operand.
    assert!(inlined(&[a, Operation::Sign(step(0))], &[]).is_empty());
    assert_eq!(inlined(&[a, Operation::Sqrt(step(0))], &[]), [0]);
}

/// Statements are in the order of their steps: a value that is read only after another statement has a name.
#[test]
fn a_value_before_another_statement_has_a_name() {
    let last = Operation::Add(step(0), step(1));
    let between = [Operation::Mul(Q, Q), Operation::Neg(Q), last];
    assert_eq!(inlined(&between, &[]), [0, 1]);
    assert_eq!(inlined(&between, &[1]), [] as [usize; 0]);
    // The sum that is written in the last step reads the first, across the second.
    let across = [
        Operation::Mul(Q, Q),
        Operation::Neg(Q),
        Operation::Add(step(0), Q),
        Operation::Add(step(1), step(2)),
    ];
    assert_eq!(inlined(&across, &[]), [2]);
}

#[test]
fn expressions_have_few_operands() {
    let chain = (0..20).map(|k| match k {
        0 => Operation::Add(Q, Q),
        k => Operation::Add(step(k - 1), Q),
    });
    let chain: Vec<_> = chain.collect();
    let names: Vec<_> = (0..20)
        .filter(|k| !inlined(&chain, &[]).contains(k))
        .collect();
    let each = OPERANDS - 1;
    assert_eq!(names, [each - 1, 2 * each - 1, 3 * each - 1, 19]);
}

#[test]
fn what_others_read_is_computed_where_it_is_stored() {
    let square_of = |of| Operation::Mul(step(of), step(of));
    let last = Operation::Add(step(2), step(1));
    let program = of_steps(&[
        Operation::Neg(Q),
        square_of(0),
        Operation::Neg(step(1)),
        last,
    ]);
    let stored = places(&program, Length::at_most(1), &[1]);
    assert_eq!(
        stored,
        [Place::Store, Place::Statement, Place::Store, Place::Store]
    );
    // Sections of two steps: the second step of each reads the first.
    let stored = places(&program, Length::at_most(2), &[]);
    assert_eq!(
        stored,
        [Place::Statement, Place::Store, Place::Reader, Place::Store]
    );
    // A section of three steps reads what it has stored.
    let [sum, last] = [(0, Q), (2, step(0))].map(|(a, b)| Operation::Add(step(a), b));
    let program = of_steps(&[Operation::Neg(Q), sum, square_of(1), last]);
    let stored = places(&program, Length::at_most(3), &[]);
    assert_eq!(
        stored,
        [Place::Store, Place::Statement, Place::Store, Place::Store]
    );
}

/// Random programs: every inlined value has one reader, its statement is the next one, and it is short.
#[test]
fn statements_hold_consecutive_steps() {
    let mut random = Random::new(7);
    let mut inlined = 0;
    for _ in 0..200 {
        let operations = (0..60_u32).map(|k| {
            let mut operand = || match u32::try_from(random.below(6)).expect("few") {
                back @ 1..=4 if back <= k => step(k - back),
                _ => Q,
            };
            Operation::MulAdd(operand(), operand(), operand())
        });
        let program = of_steps(&operations.collect::<Vec<_>>());
        let places = places(&program, Length::UNBOUNDED, &[]);
        // Operands of each step, with those of the steps inside.
        let mut sizes = vec![0; 60];
        let mut open: Vec<u32> = Vec::new();
        for (k, of) in program.steps.iter().enumerate() {
            let mut size = 0;
            for operand in of.operation.operands() {
                match operand {
                    Operand::Step(part) if places[part as usize] == Place::Reader => {
                        assert_eq!(open.iter().filter(|&&of| of == part).count(), 1);
                        open.retain(|&of| of != part);
                        size += sizes[part as usize];
                    }
                    _ => size += 1,
                }
            }
            assert!(size <= OPERANDS);
            sizes[k] = size;
            if places[k] == Place::Reader {
                open.push(u32::try_from(k).expect("few steps"));
                inlined += 1;
            } else {
                assert!(open.is_empty(), "a statement before the reader of {open:?}");
            }
        }
    }
    assert!(inlined > 500, "{inlined}");
}

#[test]
fn iterations_are_written_once() {
    let program = of_columns(HEAD, LENGTH);
    let arranged = Arranged::of(&program, &[], Length::UNBOUNDED);
    let [repeat] = &*arranged.repeats else {
        unreachable!("one loop")
    };
    let inlined = Inlined::of(&arranged, |_| false);
    let others = repeat.first.end..repeat.steps().end;
    assert!(
        others
            .clone()
            .all(|step| !inlined.in_reader(step) && !inlined.in_store(step))
    );
    let stored = |&step: &u32| inlined.in_store(step);
    assert!(repeat.stores.iter().any(stored));
    assert!(repeat.stores.iter().all(|&step| !inlined.in_reader(step)));
}
