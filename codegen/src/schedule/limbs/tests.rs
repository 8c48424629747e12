//! Loops over limbs: the same bits as the program, every common operation in a loop, and none where there is none.

use homogen_random::Random;

use super::cutting::MOST_ROWS;
use super::fused_alike;
use crate::expression::Input;
use crate::list::Id;
use crate::schedule::repeats::Over;
use crate::schedule::{Arranged, Length, Operand, Operation, Program, Step, run};
use crate::space::{Limbs, Variable};

/// Operations that the limbs of [`Builder::limbs`] have in common, in each of two stretches.
pub const COMMON: usize = 120;

fn input(variable: Variable, entry: usize) -> Operand {
    let entry = u16::try_from(entry).expect("few entries");
    Operand::Input(Input::Variable(variable, entry))
}

/// Limbs of two joints each, after a base with one.
pub fn limbs(count: usize) -> Limbs {
    let place = |first: usize| (0..count).map(move |limb| first + 2 * limb);
    Limbs {
        coordinates: [1, 2]
            .map(|first| place(first).map(Id::new).collect())
            .into(),
        velocities: [1, 2]
            .map(|first| place(first).map(Id::new).collect())
            .into(),
        actions: Vec::new(),
    }
}

struct Builder {
    random: Random,
    steps: Vec<Step>,
}

impl Builder {
    fn push(&mut self, operation: Operation) -> Operand {
        self.steps.push(Step {
            label: None,
            operation,
        });
        Operand::Step(u32::try_from(self.steps.len() - 1).expect("few steps"))
    }

    fn value(&mut self) -> f64 {
        self.random.unit()
    }

    /// A limb's literals differ in sign or in magnitude; sums have any signs and order.
    fn common(&mut self, kind: usize, [own, shared, other]: [Operand; 3]) -> Operand {
        let literal = Operand::Literal(self.value());
        let turned = self.random.below(2) == 0;
        let [a, b] = if turned { [own, shared] } else { [shared, own] };
        let operation = match (kind, self.random.below(3)) {
            (0, 0) => Operation::Add(a, b),
            (0, _) => Operation::Sub(a, b),
            (1, _) => Operation::Mul(literal, own),
            (2, _) => Operation::Div(own, literal),
            (3, 0) => Operation::MulAdd(literal, own, other),
            (3, 1) => Operation::MulSub(own, literal, other),
            (3, _) => Operation::NegMulAdd(literal, own, other),
            (_, 0) => Operation::MulAdd(a, b, other),
            (_, 1) => Operation::MulSub(a, b, other),
            _ => Operation::NegMulAdd(a, b, other),
        };
        self.push(operation)
    }

    /// The same operations in each limb, on their own values and those of the base, limb after limb. A value of the base
    /// may be turned for each limb.
    fn limbs(&mut self, values: &mut [Vec<Operand>], base: &[Operand]) {
        let turned = values.iter().map(|_| {
            let literal = Operand::Literal(self.value());
            self.push(Operation::Mul(literal, base[0]))
        });
        let turned: Vec<Operand> = turned.collect();
        let recipe: Vec<_> = (0..COMMON)
            .map(|k| {
                let own = [(); 2].map(|()| self.random.below(values[0].len() + k));
                (k % 9, own, self.random.below(base.len() + 1))
            })
            .collect();
        for (values, turned) in values.iter_mut().zip(turned) {
            for &(kind, [own, other], shared) in &recipe {
                let shared = base.get(shared).copied().unwrap_or(turned);
                let operands = [values[own], shared, values[other]];
                let found = self.common(kind, operands);
                values.push(found);
            }
        }
    }

    /// The sum of the last value of each limb.
    fn sum(&mut self, values: &[Vec<Operand>]) -> Operand {
        let last = values.iter().map(|values| *values.last().expect("values"));
        let last: Vec<Operand> = last.collect();
        let sums = last[1..].iter();
        sums.fold(last[0], |sum, &next| self.push(Operation::Add(sum, next)))
    }
}

/// Two stretches of operations of limbs, with a sum over limbs between them.
pub fn program(count: usize, seed: u64) -> Program {
    let mut builder = Builder {
        random: Random::new(seed),
        steps: Vec::new(),
    };
    let base = [input(Variable::Q, 0), input(Variable::Qd, 0)];
    let angles: Vec<Operand> = limbs(count).coordinates[0]
        .iter()
        .map(|k| input(Variable::Q, k.index()))
        .collect();
    let own = |limb: usize| {
        let angle = u32::try_from(limb).expect("few limbs");
        let velocities = [1, 2].map(|place| input(Variable::Qd, place + 2 * limb));
        [Operand::Sin(angle), Operand::Cos(angle)]
            .into_iter()
            .chain(velocities)
            .collect()
    };
    let mut values: Vec<Vec<Operand>> = (0..count).map(own).collect();
    builder.limbs(&mut values, &base);
    let sum = builder.sum(&values);
    builder.limbs(&mut values, &[base[0], sum]);
    let all = builder.sum(&values);
    let mut results = vec![all];
    results.extend(values.iter().map(|values| values[values.len() - 7]));
    Program {
        angles,
        steps: builder.steps,
        results,
        ..Program::default()
    }
}

fn bits(program: &Program) -> Vec<u64> {
    let value = |input| match input {
        Input::Variable(variable, entry) => {
            0.3 + f64::from(entry) / 7.0 + if variable == Variable::Q { 0.1 } else { 0.0 }
        }
        Input::Parameter(..) => 0.0,
    };
    let results = run::<f64>(program, value);
    results.into_iter().map(f64::to_bits).collect()
}

#[test]
fn operations_that_limbs_have_in_common_are_loops_with_the_same_bits() {
    for (count, seed) in [(2, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6)] {
        let program = program(count, seed);
        let arranged = Arranged::of(&program, &[limbs(count)], Length::UNBOUNDED);
        assert_eq!(bits(&arranged.program), bits(&program));
        let loops = arranged.repeats.iter();
        let loops = loops.map(|repeat| (repeat.over, repeat.iterations as usize));
        assert_eq!(loops.collect::<Vec<_>>(), [(Over::Limbs, count); 2]);
        // All but the sums over limbs, and what is turned for each, are in the loops.
        let inside: usize = arranged
            .repeats
            .iter()
            .map(|repeat| repeat.steps().len())
            .sum();
        let single = arranged.program.steps.len() - inside;
        assert_eq!(single, 2 * (count - 1) + 2 * count);
    }
}

#[test]
fn limbs_without_common_operations_have_no_loops() {
    let mut program = program(4, 5);
    // The first limb reads another coordinate in every operation.
    let strange = input(Variable::Q, 20);
    for step in &mut program.steps[..COMMON] {
        let operands = step.operation.operands();
        step.operation = Operation::MulAdd(operands[0], operands[1], strange);
    }
    program.results.truncate(1);
    let arranged = Arranged::of(&program, &[limbs(4)], Length::UNBOUNDED);
    assert_eq!(bits(&arranged.program), bits(&program));
    assert!(arranged.repeats.is_empty());
    let none = Arranged::of(&program, &[], Length::UNBOUNDED);
    assert_eq!(*none.program, program);
}

#[test]
fn loops_are_not_longer_than_a_section() {
    let program = program(4, 1);
    let longest = COMMON / 2;
    let arranged = Arranged::of(&program, &[limbs(4)], Length::at_most(longest));
    assert_eq!(bits(&arranged.program), bits(&program));
    assert!(arranged.repeats.len() > 2);
    let mut lengths = arranged.repeats.iter().map(|repeat| repeat.first.len());
    assert!(lengths.all(|length| length <= longest));
    assert!(arranged.sections.is_some());
}

#[test]
fn loops_have_few_rows() {
    let mut program = program(4, 1);
    let loops = Arranged::of(&program, &[limbs(4)], Length::UNBOUNDED).repeats;
    program.results = (0..program.steps.len())
        .map(|step| Operand::Step(u32::try_from(step).expect("few steps")))
        .collect();
    let arranged = Arranged::of(&program, &[limbs(4)], Length::UNBOUNDED);
    assert_eq!(bits(&arranged.program), bits(&program));
    assert!(arranged.repeats.len() > loops.len());
    let mut rows = arranged
        .repeats
        .iter()
        .map(|repeat| repeat.loads.len() + repeat.stores.len());
    assert!(rows.all(|rows| rows <= MOST_ROWS));
}

/// A value of each limb, and `length` fused operations on it. In the fourth limb the last is not fused if `is_mixed`.
fn chains(length: usize, is_mixed: bool) -> Program {
    let mut builder = Builder {
        random: Random::new(6),
        steps: Vec::new(),
    };
    let shared = input(Variable::Q, 0);
    let mut results = Vec::new();
    for limb in 0..4 {
        let [mut value, factor] = [1, 2].map(|place| input(Variable::Qd, place + 2 * limb));
        for k in 1..=length {
            value = if is_mixed && limb == 3 && k == length {
                let product = builder.push(Operation::Mul(value, factor));
                builder.push(Operation::Sub(shared, product))
            } else {
                builder.push(Operation::MulAdd(value, factor, shared))
            };
        }
        results.push(value);
    }
    Program {
        steps: builder.steps,
        results,
        ..Program::default()
    }
}

/// A sum in three limbs, a difference that may cancel in the fourth.
#[test]
fn a_sum_is_fused_in_all_limbs_or_in_none() {
    let fused = |program: &Program| {
        let fused = program.steps.iter();
        fused.filter(|step| step.operation.is_fused()).count()
    };
    let alike = chains(30, false);
    assert_eq!(fused_alike(alike.clone(), &[limbs(4)]), alike);
    let mixed = chains(30, true);
    assert_eq!(fused_alike(mixed.clone(), &[]), mixed);
    let found = fused_alike(mixed.clone(), &[limbs(4)]);
    assert_eq!((fused(&mixed), fused(&found)), (4 * 30 - 1, 4 * 29));
    assert_eq!(found.steps.len(), 4 * 31);
    assert_eq!(bits(&found), bits(&mixed));
    // Too short for a loop.
    let short = chains(10, true);
    assert_eq!(fused_alike(short.clone(), &[limbs(4)]), short);
}
