//! Bounds of small programs against bounds by hand. Values and errors of random programs against their bounds.

mod quaternion;
mod random;

use super::{Conditions, Reason, Value, results};
use crate::expression::Input;
use crate::real::Real;
use crate::schedule::{Operand, Operation, Program, Step};
use crate::space::Variable;

/// The unit roundoff of `f64`.
const U: f64 = f64::EPSILON / 2.0;

const A: Operand = Operand::Input(Input::Variable(Variable::Q, 0));
const B: Operand = Operand::Input(Input::Variable(Variable::Q, 1));

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
        ..Program::default()
    }
}

/// The bound of the last step, in u, for a in [−2, 3] and b in [1, 2].
fn bound(angles: &[Operand], operations: &[Operation]) -> f64 {
    let range = |input| match input {
        Input::Variable(Variable::Q, 0) => Value::between(-2.0, 3.0),
        _ => Value::between(1.0, 2.0),
    };
    found(&program(angles, operations), Real::F64, &range).0 / U
}

/// Bound of the first result, and the reason for its lack.
fn found(program: &Program, scalar: Real, range: &dyn Fn(Input) -> Value) -> (f64, Option<Reason>) {
    let conditions = Conditions {
        scalar,
        angles: 1e5,
        range,
        quaternions: &[],
    };
    let found = results(program, &conditions)[0];
    (found.value.error, found.reason)
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
    // b − (a + b): ranges do not show that it is −a.
    close(bound(&[], &[sum, Operation::Sub(B, step(0))]), 5.0 + 4.0);
    // a / (b + b): an error of 4 u of a divisor between 2 and 4.
    let twice = Operation::Add(B, B);
    close(
        bound(&[], &[twice, Operation::Div(A, step(0))]),
        3.0 * 4.0 / 4.0 + 1.5,
    );
}

#[test]
fn a_fused_product_counts_as_two_roundings() {
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

/// Near zero the root of a sum has none, but a vector is not lengthened more than it is changed.
#[test]
fn the_length_of_a_vector_has_a_bound_at_zero() {
    let length = [
        Operation::Add(A, B),
        Operation::Mul(B, B),
        Operation::MulAdd(step(0), step(0), step(1)),
        Operation::MulAdd(A, A, step(2)),
        Operation::Sqrt(step(3)),
    ];
    // The sum is 5 at most, with an error of 5; the vector has the length √(5² + 2² + 3²).
    let size = 38.0_f64.sqrt();
    close(bound(&[], &length), 5.0 + 1.5 * size + size);
    let apart = [
        Operation::Mul(A, A),
        Operation::Mul(B, B),
        Operation::Add(step(0), step(1)),
        Operation::Sqrt(step(2)),
    ];
    close(bound(&[], &apart), 2.5 * 13.0_f64.sqrt());
    // No square of a vector.
    let other = [
        Operation::MulAdd(A, A, B),
        Operation::Sub(step(0), B),
        Operation::Sqrt(step(1)),
    ];
    assert_eq!(bound(&[], &other), f64::INFINITY);
}

#[test]
fn division_by_possible_zero_has_no_bound() {
    assert_eq!(bound(&[], &[Operation::Div(B, A)]), f64::INFINITY);
    assert_eq!(bound(&[], &[Operation::Sqrt(A)]), f64::INFINITY);
}

#[test]
fn literals_are_rounded_when_printed_and_when_read() {
    let product = |number| [Operation::Mul(Operand::Literal(number), B)];
    // 0.75 b: an error of 0.75 u, times 2, and the rounding of 1.5.
    close(bound(&[], &product(0.75)), 3.0);
    let single = |number: f64| {
        let program = program(&[], &product(number));
        found(&program, Real::F32, &|_| Value::between(1.0, 2.0)).0
    };
    let u = Real::F32.roundoff();
    let off = 0.75 * (u + U);
    close(single(0.75), 2.0 * off + u * 2.0 * (0.75 + off));
}

#[test]
fn sines_and_cosines_are_within_a_unit_in_the_last_place() {
    let (s, c) = (Operand::Sin(0), Operand::Cos(0));
    // 2 s of the whole circle: an error of 1 u, times 2, and the rounding of 2.
    let twice = |x| {
        [Operation::Mul(
            Operand::Input(Input::Variable(Variable::Q, 1)),
            x,
        )]
    };
    close(bound(&[A], &twice(s)), 4.0);
    // The cosine of 1 to 2 rad is at most 0.54.
    close(bound(&[B], &twice(c)), 2.0 + 2.0 * 1.0_f64.cos());
}

/// Bound of the last step in single precision, with both inputs in a range.
fn single(range: [f64; 2], angles: &[Operand], operations: &[Operation]) -> (f64, Option<Reason>) {
    let [lo, hi] = range;
    let program = program(angles, operations);
    found(&program, Real::F32, &|_| Value::between(lo, hi))
}

#[test]
fn possible_overflow_has_no_bound() {
    let square = [Operation::Mul(A, B)];
    assert_eq!(
        single([0.0, 1e20], &[], &square),
        (f64::INFINITY, Some(Reason::Overflow))
    );
    assert!(single([0.0, 1e19], &[], &square).0.is_finite());
    // A value with a smaller bound from elsewhere may still overflow while it is computed.
    let product = [Operation::MulSub(A, B, A)];
    assert_eq!(single([0.0, 1e20], &[], &product).1, Some(Reason::Overflow));
    let number = [Operation::Mul(Operand::Literal(1e39), B)];
    let reason = single([1e-10, 1e-9], &[], &number).1;
    assert_eq!(reason, Some(Reason::Overflow));
}

#[test]
fn underflow_is_within_the_bound() {
    let least = f64::from(f32::MIN_POSITIVE);
    // The product is subnormal: it may be flushed to zero, and so may the operands.
    let product = [Operation::Mul(A, B)];
    let (bound, _) = single([1e-22, 1e-20], &[], &product);
    assert!((least..2.0 * least).contains(&bound), "{bound:e}");
    let large = [Operation::Mul(A, Operand::Literal(1e30))];
    let (bound, _) = single([-1e-40, 1e-40], &[], &large);
    assert!(bound >= 1e-40 * 1e30, "{bound:e}");
}

#[test]
fn an_angle_beyond_its_sines_has_no_bound() {
    let sine = [Operation::Mul(Operand::Sin(0), Operand::Literal(2.0))];
    assert!(single([-1e5, 1e4], &[A], &sine).0.is_finite());
    assert_eq!(
        single([-1.1e5, 1e4], &[A], &sine),
        (f64::INFINITY, Some(Reason::Angle))
    );
}

#[test]
fn an_angle_of_many_turns_has_any_sine() {
    let sine = [Operation::Mul(Operand::Sin(0), Operand::Literal(2.0))];
    let program = program(&[A], &sine);
    let range = |_| Value::between(1e4, 1e4);
    let conditions = Conditions {
        scalar: Real::F64,
        angles: 1e5,
        range: &range,
        quaternions: &[],
    };
    let value = results(&program, &conditions)[0].value;
    assert!(value.lo <= -2.0 && value.hi >= 2.0, "{value:?}");
}

#[test]
fn an_unknown_input_gives_no_reason() {
    let program = program(&[], &[Operation::Mul(A, B)]);
    let (bound, reason) = found(&program, Real::F64, &|_| Value::UNKNOWN);
    assert_eq!((bound, reason), (f64::INFINITY, None));
}

#[test]
fn a_divisor_that_may_be_zero_is_the_reason_of_all_that_follows() {
    let quotient = [Operation::Div(B, A), Operation::Add(step(0), B)];
    let program = program(&[], &quotient);
    let range = |_| Value::between(-1.0, 1.0);
    assert_eq!(found(&program, Real::F64, &range).1, Some(Reason::Divisor));
}

/// c x + s y and c y − s x, repeatedly, with the same angle.
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
fn a_planar_rotation_does_not_lengthen_a_vector() {
    let length = 13.0_f64.sqrt();
    for turns in [1, 2, 10, 40] {
        let found = bound(&[A], &spun(turns));
        // Sine and cosine √2 u, two roundings in each of two entries: 3 √2 u of the length for each rotation.
        let expected = 3.0 * 2.0_f64.sqrt() * length * f64::from(turns);
        assert!(found <= expected * (1.0 + 1e-8), "{turns}: {found} u");
    }
}

/// Constant rotations about two axes alternately, of (a, b, a).
fn rotated(times: u32) -> Vec<Operation> {
    let [c, s] = [0.8, 0.6].map(Operand::Literal);
    let mut entries = [A, B, A];
    let mut operations = Vec::new();
    for k in 0..times {
        let (x, y) = if k % 2 == 0 { (0, 1) } else { (1, 2) };
        let at = 4 * k;
        operations.extend([
            Operation::Mul(s, entries[y]),
            Operation::MulAdd(c, entries[x], step(at)),
            Operation::Mul(s, entries[x]),
            Operation::MulSub(c, entries[y], step(at + 2)),
        ]);
        (entries[x], entries[y]) = (step(at + 1), step(at + 3));
    }
    operations
}

#[test]
fn a_constant_rotation_does_not_lengthen_a_vector() {
    let length = 22.0_f64.sqrt();
    for times in [1, 2, 10, 40] {
        let found = bound(&[], &rotated(times));
        // Rounded literals, and three roundings in each of two entries, all with the same sign.
        let expected = 8.0 * length * f64::from(times);
        assert!(found <= expected, "{times}: {found} u");
    }
}

#[test]
fn a_shifted_angle_is_a_rotation() {
    let (s, c) = (Operand::Sin(0), Operand::Cos(0));
    let [p, r] = [0.8, 0.6].map(Operand::Literal);
    // Cosine and sine of q + φ, and a vector that they rotate repeatedly.
    let mut operations = vec![
        Operation::Mul(r, s),
        Operation::MulSub(p, c, step(0)),
        Operation::Mul(r, c),
        Operation::MulAdd(p, s, step(2)),
    ];
    let (mut x, mut y) = (A, B);
    for k in 0..40 {
        let at = 4 + 4 * k;
        operations.extend([
            Operation::Mul(step(3), y),
            Operation::MulAdd(step(1), x, step(at)),
            Operation::Mul(step(3), x),
            Operation::MulSub(step(1), y, step(at + 2)),
        ]);
        (x, y) = (step(at + 1), step(at + 3));
    }
    let found = bound(&[A], &operations);
    assert!(found <= 40.0 * 12.0 * 13.0_f64.sqrt(), "{found} u");
}

#[test]
fn an_apparent_rotation_may_lengthen_a_vector() {
    let mut operations = spun(20);
    // c y + s x: not orthogonal to c x + s y.
    for operation in &mut operations {
        if let Operation::MulSub(c, y, rest) = *operation {
            *operation = Operation::MulAdd(c, y, rest);
        }
    }
    let found = bound(&[A], &operations);
    // At an angle of π/4 the vector (1, 1) grows by √2 each time.
    assert!(found >= 2.0_f64.powi(10), "{found} u");
}

/// A computed angle that is off by more than a full turn leaves its sine unknown in single precision, and its bound
/// must still scale with that in double precision.
#[test]
fn bounds_of_angles_that_are_off_by_turns_scale() {
    let mut program = program(
        &[step(0)],
        &[
            Operation::Mul(A, B),
            Operation::Mul(Operand::Sin(0), Operand::Literal(2.0)),
        ],
    );
    program.before_angles = 1;
    let range = |_| Value::between(-1e5, 1e5);
    let of = |scalar: Real| {
        let conditions = Conditions {
            scalar,
            angles: f64::INFINITY,
            range: &range,
            quaternions: &[],
        };
        results(&program, &conditions)[0].value.error
    };
    let ratio = Real::F64.roundoff() / Real::F32.roundoff();
    assert!(of(Real::F64) <= ratio * of(Real::F32) * (1.0 + 1e-9));
}

/// The result of a cancellation, such as the cosine of two halves of a right angle, is known to fewer bits than a
/// literal has.
#[test]
fn errors_of_literals_beyond_106_bits_count() {
    let (small, open) = (6.1e-17, 1e-32);
    let of_one = [Operation::Mul(
        Operand::Literal(small),
        Operand::Literal(-small),
    )];
    let error = |open: Option<f64>, scalar: Real| {
        let mut program = program(&[], &of_one);
        let literals = open.map(|open| (f64::to_bits(small), open));
        program.open.extend(literals);
        let conditions = Conditions {
            scalar,
            angles: f64::INFINITY,
            range: &|_| Value::UNKNOWN,
            quaternions: &[],
        };
        results(&program, &conditions)[0].value.error
    };
    let more = error(Some(open), Real::F64) - error(None, Real::F64);
    let expected = 2.0 * small * open;
    assert!((expected..1.01 * expected).contains(&more), "{more:e}");
    // Bounds scale with the unit roundoff of the type.
    let ratio = Real::F32.roundoff() / Real::F64.roundoff();
    assert!(error(Some(open), Real::F32) >= ratio * more);
}
