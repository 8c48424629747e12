//! Results of sections compared with those of the whole program, and their lengths.

use std::collections::BTreeMap;

use homogen_random::Random;

use super::{Length, Section, Sections, Shared};
use crate::expression::Input;
use crate::schedule::repeats::repeats;
use crate::schedule::{Operand, Operation, Program, Step, run};
use crate::space::Variable;

/// Steps that read mostly recent values, and sometimes any: an input, a sine, an old step.
fn tangled(steps: usize, before_angles: usize, random: &mut Random) -> Program {
    let input = |random: &mut Random| {
        let entry = u16::try_from(random.below(40)).expect("few inputs");
        Operand::Input(Input::Variable(Variable::Q, entry))
    };
    let index = |step: usize| u32::try_from(step).expect("few steps");
    let mut program = Program {
        angles: Vec::new(),
        before_angles,
        steps: Vec::new(),
        results: Vec::new(),
        ..Program::default()
    };
    for k in 0..steps {
        if k == before_angles {
            program.angles = vec![input(random), Operand::Step(index(k - 1)), input(random)];
        }
        let mut operand = || match random.below(12) {
            0 => input(random),
            1 => Operand::Literal(random.unit()),
            2 if k >= before_angles => Operand::Sin(index(random.below(3))),
            3 if k >= before_angles => Operand::Cos(index(random.below(3))),
            4 if k > 0 => Operand::Step(index(random.below(k))),
            _ if k > 0 => Operand::Step(index(k - 1 - random.below(k.min(20)))),
            _ => input(random),
        };
        let [a, b, c] = [operand(), operand(), operand()];
        let operation = match k % 4 {
            0 => Operation::Sub(a, b),
            // Repeated squares overflow.
            1 => Operation::Mul(a, Operand::Literal(0.5)),
            2 => Operation::Add(a, b),
            _ => Operation::NegMulAdd(Operand::Literal(0.25), b, c),
        };
        program.steps.push(Step {
            label: None,
            operation,
        });
    }
    let mut results: Vec<Operand> = (0..30)
        .map(|_| Operand::Step(index(random.below(steps))))
        .collect();
    results.extend([Operand::Sin(1), Operand::Literal(2.0), input(random)]);
    program.results = results;
    program
}

fn sections(program: &Program, length: Length) -> Option<Sections> {
    super::sections(program, &repeats(program), length)
}

/// Results of sections; each reads its own values and those that it loads.
fn in_sections(program: &Program, length: Length, q: &dyn Fn(Input) -> f64) -> Vec<f64> {
    let cut = sections(program, length).expect("it is long");
    // Values before the sections are those of the whole program.
    let whole = |operand| {
        let results = vec![operand];
        run(
            &Program {
                results,
                ..program.clone()
            },
            q,
        )[0]
    };
    let mut work = vec![f64::NAN; cut.work];
    for &(value, place) in &cut.initial {
        work[place] = whole(value.operand());
    }
    for Section {
        steps,
        loads,
        stores,
        ..
    } in &cut.sections
    {
        let mut known: BTreeMap<Shared, f64> = loads
            .iter()
            .map(|&(value, place)| (value, work[place]))
            .collect();
        for step in steps.clone() {
            let operation = program.steps[step as usize]
                .operation
                .map(|operand| match Shared::of(operand) {
                    Some(value) => known[&value],
                    None => whole(operand),
                });
            known.insert(Shared::Step(step), computed(operation));
        }
        for &(step, place) in stores {
            work[place] = known[&Shared::Step(step)];
        }
    }
    let results = program.results.iter().zip(&cut.results);
    results
        .map(|(&result, place)| place.map_or_else(|| whole(result), |place| work[place]))
        .collect()
}

fn computed(operation: Operation<f64>) -> f64 {
    match operation {
        Operation::Add(a, b) => a + b,
        Operation::Sub(a, b) => a - b,
        Operation::Mul(a, b) => a * b,
        Operation::NegMulAdd(a, b, c) => c - a * b,
        _ => unreachable!("no other is made"),
    }
}

#[test]
fn sections_compute_the_same_as_the_whole() {
    let mut random = Random::new(1);
    for (steps, before, most) in [(600, 5, 40), (500, 30, 77), (300, 1, 1), (301, 2, 300)] {
        let program = tangled(steps, before, &mut random);
        let q: Vec<f64> = (0..40).map(|_| random.unit()).collect();
        let input = |input| match input {
            Input::Variable(Variable::Q, k) => q[usize::from(k)],
            _ => unreachable!("no other is read"),
        };
        let bits = |found: Vec<f64>| found.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(
            bits(in_sections(&program, Length::at_most(most), &input)),
            bits(run(&program, input)),
        );
    }
}

#[test]
fn every_step_is_in_a_section_of_allowed_length() {
    let program = tangled(2000, 10, &mut Random::new(2));
    for most in [1, 2, 99, 1999] {
        let cut = sections(&program, Length::at_most(most)).expect("it is long");
        let mut next = 10;
        for section in &cut.sections {
            assert_eq!(section.steps.start, next);
            assert!((1..=most).contains(&section.steps.len()));
            next = section.steps.end;
        }
        assert_eq!(next as usize, program.steps.len());
    }
    assert_eq!(sections(&program, Length::at_most(2000)), None);
    assert_eq!(sections(&program, Length::UNBOUNDED), None);
}

/// An entry of the array is reused after its last reader: for a chain of values, each of which the next few read, the
/// length of the array is bounded by that number.
#[test]
fn the_array_has_only_values_that_are_read_later() {
    let step = |k: u32| Step {
        label: None,
        operation: Operation::Add(
            Operand::Step(k.saturating_sub(1)),
            Operand::Step(k.saturating_sub(3)),
        ),
    };
    let first = Step {
        label: None,
        operation: Operation::Neg(Operand::Input(Input::Variable(Variable::Q, 0))),
    };
    let program = Program {
        angles: Vec::new(),
        before_angles: 0,
        steps: std::iter::once(first).chain((1..5000).map(step)).collect(),
        results: vec![Operand::Step(4999)],
        ..Program::default()
    };
    let cut = sections(&program, Length::at_most(50)).expect("it is long");
    assert!(cut.work <= 8, "{}", cut.work);
}
