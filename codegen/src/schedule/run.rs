//! Interpreter of programs.
//!
//! In: a program and its inputs. Out: its results, in any arithmetic. The order of operations is that of the generated
//! code, and the arithmetic decides whether fused operations round once, so that results are those of a target with or
//! without them.

use super::{Operand, Operation, Program};
use crate::expression::{Arithmetic, Input};

/// Runs a program on the values of `input`.
pub fn run<T: Arithmetic>(program: &Program, input: impl Fn(Input) -> T) -> Vec<T> {
    let mut steps: Vec<T> = Vec::with_capacity(program.steps.len());
    let mut angles: Vec<(T, T)> = Vec::new();
    for (k, step) in program.steps.iter().enumerate() {
        if k == program.before_angles {
            angles = turn(program, &steps, &input);
        }
        let at = |operand| value(operand, &steps, &angles, &input);
        steps.push(match step.operation {
            Operation::Add(a, b) => at(a) + at(b),
            Operation::Sub(a, b) => at(a) - at(b),
            Operation::Mul(a, b) => at(a) * at(b),
            Operation::Div(a, b) => at(a) / at(b),
            Operation::Sqrt(a) => at(a).sqrt(),
            Operation::Sign(a) => at(a).sign(),
            Operation::Neg(a) => -at(a),
            Operation::MulAdd(a, b, c) => at(a).mul_add(at(b), at(c)),
            Operation::MulSub(a, b, c) => at(a).mul_add(at(b), -at(c)),
            Operation::NegMulAdd(a, b, c) => (-at(a)).mul_add(at(b), at(c)),
        });
    }
    if program.before_angles == program.steps.len() {
        angles = turn(program, &steps, &input);
    }
    program
        .results
        .iter()
        .map(|&result| value(result, &steps, &angles, &input))
        .collect()
}

fn turn<T: Arithmetic>(program: &Program, steps: &[T], input: &impl Fn(Input) -> T) -> Vec<(T, T)> {
    program
        .angles
        .iter()
        .map(|&angle| value(angle, steps, &[], input).sin_cos())
        .collect()
}

fn value<T: Arithmetic>(
    operand: Operand,
    steps: &[T],
    angles: &[(T, T)],
    input: &impl Fn(Input) -> T,
) -> T {
    match operand {
        Operand::Literal(value) => T::literal(value),
        Operand::Input(of) => input(of),
        Operand::Sin(k) => angles[k as usize].0.clone(),
        Operand::Cos(k) => angles[k as usize].1.clone(),
        Operand::Step(k) => steps[k as usize].clone(),
    }
}
