//! Tiny programs whose bounds are worked by hand.

use super::{Value, errors};
use crate::expression::Input;
use crate::request::Real;
use crate::schedule::{Operand, Operation, Program, Step};

/// The unit roundoff of `f64`.
const U: f64 = f64::EPSILON / 2.0;

const A: Operand = Operand::Input(Input::Q(0));
const B: Operand = Operand::Input(Input::Q(1));

fn program(angles: &[Operand], operations: &[Operation]) -> Program {
    let steps = operations.iter().map(|&operation| Step {
        label: None,
        operation,
    });
    let last = u32::try_from(operations.len() - 1).expect("few operations");
    Program {
        angles: angles.to_vec(),
        before_angles: 0,
        steps: steps.collect(),
        results: vec![Operand::Step(last)],
    }
}

/// The bound of the last step, in u, for a in [−2, 3] and b in [1, 2].
fn bound(angles: &[Operand], operations: &[Operation]) -> f64 {
    let range = |input| match input {
        Input::Q(0) => Value::between(-2.0, 3.0),
        _ => Value::between(1.0, 2.0),
    };
    errors(&program(angles, operations), Real::F64, &range)[0] / U
}

fn close(found: f64, expected: f64) {
    let off = found / expected - 1.0;
    assert!((0.0..1e-8).contains(&off), "{found} u, not {expected} u");
}

fn step(k: u32) -> Operand {
    Operand::Step(k)
}

#[test]
fn an_operation_rounds_its_result() {
    close(bound(&[], &[Operation::Add(A, B)]), 5.0);
    close(bound(&[], &[Operation::Sub(A, B)]), 4.0);
    close(bound(&[], &[Operation::Mul(A, B)]), 6.0);
    close(bound(&[], &[Operation::Div(A, B)]), 3.0);
    close(bound(&[], &[Operation::Sqrt(B)]), 2.0_f64.sqrt());
}

#[test]
fn errors_grow_by_what_they_are_multiplied_with() {
    let sum = Operation::Add(A, B);
    // (a + b) b: an error of 5 u, times 2, and the rounding of 10.
    close(bound(&[], &[sum, Operation::Mul(step(0), B)]), 20.0);
    // b − (a + b), of which ranges do not know that it is −a.
    close(bound(&[], &[sum, Operation::Sub(B, step(0))]), 5.0 + 4.0);
    // a / (b + b): an error of 4 u of what is between 2 and 4.
    let twice = Operation::Add(B, B);
    close(
        bound(&[], &[twice, Operation::Div(A, step(0))]),
        3.0 * 4.0 / 4.0 + 1.5,
    );
}

#[test]
fn a_fused_product_is_taken_as_two_roundings() {
    let apart = [Operation::Mul(A, B), Operation::Add(step(0), A)];
    let fused = [Operation::MulAdd(A, B, A)];
    close(bound(&[], &apart), 6.0 + 9.0);
    close(bound(&[], &fused), 6.0 + 9.0);
    close(bound(&[], &[Operation::MulSub(A, B, A)]), 6.0 + 8.0);
    close(bound(&[], &[Operation::NegMulAdd(A, B, B)]), 6.0 + 6.0);
}

#[test]
fn a_square_is_not_negative() {
    let [square, more] = [Operation::Mul(A, A), Operation::Add(step(0), B)];
    let of_square = bound(&[], &[square, more, Operation::Div(B, step(1))]);
    // Between 1 and 11, with an error of 9 u + 11 u: times 2 / 1², and the rounding of 2.
    close(of_square, 2.0 * 20.0 + 2.0);
}

#[test]
fn what_may_be_zero_divides_without_bound() {
    assert_eq!(bound(&[], &[Operation::Div(B, A)]), f64::INFINITY);
    assert_eq!(bound(&[], &[Operation::Sqrt(A)]), f64::INFINITY);
}

#[test]
fn numbers_are_rounded_when_they_are_printed_and_when_they_are_read() {
    let product = |number| [Operation::Mul(Operand::Literal(number), B)];
    // 0.75 b: an error of 0.75 u, times 2, and the rounding of 1.5.
    close(bound(&[], &product(0.75)), 3.0);
    let single = |number: f64| {
        let program = program(&[], &product(number));
        errors(&program, Real::F32, &|_| Value::between(1.0, 2.0))[0]
    };
    let u = Real::F32.roundoff();
    close(single(0.75) / u, 1.5 + 1.5 * U / u);
    let off = f64::from(0.1_f32) - 0.1 + 0.1 * U;
    close(single(0.1), 2.0 * off + u * 2.0 * (0.1 + off));
}

#[test]
fn sines_and_cosines_are_within_a_unit_in_the_last_place() {
    let (s, c) = (Operand::Sin(0), Operand::Cos(0));
    // 2 s of the whole circle: an error of 1 u, times 2, and the rounding of 2.
    let twice = |x| [Operation::Mul(Operand::Input(Input::Q(1)), x)];
    close(bound(&[A], &twice(s)), 4.0);
    // The cosine of 1 to 2 rad is at most 0.54.
    close(bound(&[B], &twice(c)), 2.0 + 2.0 * 1.0_f64.cos());
}

/// c x + s y and c y − s x, turn after turn about the same angle.
fn spun(turns: u32) -> Vec<Operation> {
    let (s, c) = (Operand::Sin(0), Operand::Cos(0));
    let (mut x, mut y) = (A, B);
    let mut operations = Vec::new();
    for k in 0..turns {
        operations.extend([
            Operation::Mul(s, y),
            Operation::MulAdd(c, x, step(4 * k)),
            Operation::Mul(s, x),
            Operation::MulSub(c, y, step(4 * k + 2)),
        ]);
        (x, y) = (step(4 * k + 1), step(4 * k + 3));
    }
    operations
}

#[test]
fn a_turn_does_not_lengthen_a_vector() {
    let length = 13.0_f64.sqrt();
    for turns in [1, 2, 10, 40] {
        let found = bound(&[A], &spun(turns));
        // Sine and cosine √2 u, two roundings in each of two entries: 3 √2 u of the length a turn.
        let expected = 3.0 * 2.0_f64.sqrt() * length * f64::from(turns);
        assert!(found <= expected * (1.0 + 1e-8), "{turns}: {found} u");
    }
}

#[test]
fn what_looks_like_a_turn_and_is_none_may_lengthen() {
    let mut operations = spun(20);
    // c y + s x: not at right angles to c x + s y.
    for operation in &mut operations {
        if let Operation::MulSub(c, y, rest) = *operation {
            *operation = Operation::MulAdd(c, y, rest);
        }
    }
    let found = bound(&[A], &operations);
    // At an angle of π/4 the vector (1, 1) grows by √2 each time.
    assert!(found >= 2.0_f64.powi(10), "{found} u");
}
