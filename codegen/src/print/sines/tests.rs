//! The statements in both precisions, compared with the platform.

use std::collections::BTreeMap;

use super::{ANGLE, COSINE, SHIFTED, SINE, statements};
use crate::real::Real;
use crate::schedule::{Operation, Statement, Value};

/// Sine, cosine and the shifted number by the statements for a scalar type, each operation rounded to it.
pub(in crate::print) fn computed(real: Real, angle: f64, round: fn(f64) -> f64) -> [f64; 3] {
    let mut bound = BTreeMap::from([(ANGLE.to_owned(), angle)]);
    for statement in statements(real) {
        let Statement::Operation(name, operation) = statement else {
            unreachable!("nothing else is written");
        };
        let read = |value: Value| match value {
            Value::Literal(value) => value,
            Value::Name(name) => bound[&name],
            _ => unreachable!("nothing waits"),
        };
        let value = match operation.map(read) {
            Operation::Add(a, b) => a + b,
            Operation::Sub(a, b) => a - b,
            Operation::Mul(a, b) => a * b,
            Operation::MulAdd(a, b, c) => round(a * b) + c,
            Operation::MulSub(a, b, c) => round(a * b) - c,
            Operation::NegMulAdd(a, b, c) => c - round(a * b),
            other => unreachable!("{other:?}"),
        };
        bound.insert(name, round(value));
    }
    [SINE, COSINE, SHIFTED].map(|name| bound[name])
}

/// The last step: sine and cosine of the angle from those of the reduced angle and its quadrant.
pub(in crate::print) fn turned(sine: f64, cosine: f64, quadrant: u64) -> (f64, f64) {
    match quadrant & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

#[test]
fn sines_agree_with_the_platform() {
    for angle in (-4000..4000).map(|i| f64::from(i) * 0.37) {
        let [sine, cosine, shifted] = computed(Real::F64, angle, |value| value);
        let (sine, cosine) = turned(sine, cosine, shifted.to_bits());
        let off = (sine - angle.sin()).abs().max((cosine - angle.cos()).abs());
        assert!(off <= f64::EPSILON, "{angle}: {off}");
    }
}
