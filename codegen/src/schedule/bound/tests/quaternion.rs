//! Programs that rotate vectors by quaternions, and similar programs that do not.
//!
//! Checks that R v and Rᵗ v are bounded by the length of v, that no other matrix of the same entries is recognised as
//! R, and that ranges are those of polynomials in unit quaternions.

use std::f64::consts::SQRT_2;

use super::{A, B, Conditions, U, Value, program, results, step};
use crate::expression::Input;
use crate::real::Real;
use crate::schedule::{Operand, Operation};
use crate::space::Variable;

/// The first coordinate of the quaternion, after those of `A` and `B`.
const FIRST: u16 = 2;

/// Entry of the quaternion.
pub fn entry(k: usize) -> Operand {
    let k = u16::try_from(k).expect("there are four");
    Operand::Input(Input::Variable(Variable::Q, FIRST + k))
}

/// First coordinates of quaternions.
pub const QUATERNIONS: [Input; 1] = [Input::Variable(Variable::Q, FIRST)];

/// Adds an operation.
pub fn add(operations: &mut Vec<Operation>, operation: Operation) -> Operand {
    operations.push(operation);
    step(u32::try_from(operations.len() - 1).expect("few"))
}

/// Adds the steps of R = 1 + 2 w v̲ + 2 v̲² as the engine has them.
pub fn rotation(operations: &mut Vec<Operation>) -> [[Operand; 3]; 3] {
    let mut add = |operation| add(operations, operation);
    let [x, y, z, w] = [0, 1, 2, 3].map(entry);
    let twice = [x, y, z].map(|a| add(Operation::Add(a, a)));
    let [xx, yy, zz] = [(0, x), (1, y), (2, z)].map(|(k, a)| add(Operation::Mul(a, twice[k])));
    let [xy, xz, yz] = [(1, x), (2, x), (2, y)].map(|(k, a)| add(Operation::Mul(a, twice[k])));
    let [wx, wy, wz] = [0, 1, 2].map(|k| add(Operation::Mul(w, twice[k])));
    let one = Operand::Literal(1.0);
    let diagonal = [(yy, zz), (xx, zz), (xx, yy)].map(|(a, b)| {
        let both = add(Operation::Add(a, b));
        add(Operation::Sub(one, both))
    });
    [
        [
            diagonal[0],
            add(Operation::Sub(xy, wz)),
            add(Operation::Add(xz, wy)),
        ],
        [
            add(Operation::Add(xy, wz)),
            diagonal[1],
            add(Operation::Sub(yz, wx)),
        ],
        [
            add(Operation::Sub(xz, wy)),
            add(Operation::Add(yz, wx)),
            diagonal[2],
        ],
    ]
}

/// Adds a matrix times a vector.
pub fn times(
    operations: &mut Vec<Operation>,
    matrix: [[Operand; 3]; 3],
    [x, y, z]: [Operand; 3],
) -> [Operand; 3] {
    matrix.map(|[a, b, c]| {
        let first = add(operations, Operation::Mul(a, x));
        let second = add(operations, Operation::MulAdd(b, y, first));
        add(operations, Operation::MulAdd(c, z, second))
    })
}

const fn transposed([a, b, c]: [[Operand; 3]; 3]) -> [[Operand; 3]; 3] {
    [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]]
}

/// Last value, for a unit quaternion and all other inputs in [−2, 3] and [1, 2].
fn last(operations: &[Operation]) -> Value {
    let range = |input| match input {
        Input::Variable(Variable::Q, 0) => Value::between(-2.0, 3.0),
        Input::Variable(Variable::Q, 1) => Value::between(1.0, 2.0),
        _ => Value::between(-1.0, 1.0),
    };
    let conditions = Conditions {
        scalar: Real::F64,
        angles: 1e5,
        range: &range,
        quaternions: &QUATERNIONS,
    };
    results(&program(&[], operations), &conditions)[0].value
}

/// Value of (a, b, a) after this number of products with matrices made from R.
fn after(
    count: u32,
    of: impl Fn(&mut Vec<Operation>, [[Operand; 3]; 3]) -> [[Operand; 3]; 3],
) -> Value {
    let mut operations = Vec::new();
    let rotation = rotation(&mut operations);
    let matrix = of(&mut operations, rotation);
    let mut vector = [A, B, A];
    for _ in 0..count {
        vector = times(&mut operations, matrix, vector);
    }
    last(&operations)
}

/// −a as a separate step.
fn opposite(operations: &mut Vec<Operation>, a: Operand) -> Operand {
    add(operations, Operation::Sub(Operand::Literal(0.0), a))
}

#[test]
fn a_rotation_by_a_quaternion_does_not_lengthen_a_vector() {
    let length = 22.0_f64.sqrt();
    for times in [1, 2, 10, 40] {
        let there = after(times, |_, rotation| rotation);
        let back = after(times, |_, rotation| transposed(rotation));
        // A negated third column makes it a reflection as well.
        let mirrored = after(times, |operations, rotation| {
            rotation.map(|[a, b, c]| [a, b, opposite(operations, c)])
        });
        for found in [there, back, mirrored] {
            assert!(found.hi <= length * (1.0 + 1e-6), "{times}: {found:?}");
            // R has errors of at most 8 u on its diagonal and 4 u elsewhere; products and sums add 9 u in each of three
            // entries.
            let expected = (288.0_f64.sqrt() + 9.0 * 3.0_f64.sqrt()) * length * f64::from(times);
            assert!(found.error <= expected * U, "{times}: {found:?}");
        }
    }
}

#[test]
fn a_matrix_with_entries_of_a_rotation_may_lengthen_a_vector() {
    // About z by π/4 the first two rows of R are (√½, −√½) and (√½, √½), and these rows together have norm √2.
    let mixed = after(20, |_, [a, b, c]| [a, [a[1], b[1], b[2]], c]);
    let repeated = after(20, |_, [a, _, c]| [a, a, c]);
    let opposed = after(20, |operations, [a, b, c]| {
        [[a[0], opposite(operations, a[1]), a[2]], b, c]
    });
    for found in [mixed, repeated, opposed] {
        assert!(found.hi >= 2.0_f64.powi(10), "{found:?}");
    }
}

/// A rotated vector, and one of its entries rotated a second time by separate steps.
#[test]
fn an_entry_that_is_rotated_twice_counts_twice() {
    let mut operations = Vec::new();
    let rotation = rotation(&mut operations);
    let rotated = times(&mut operations, rotation, [A, B, A]);
    let again = opposite(&mut operations, rotation[2][1]);
    let again = opposite(&mut operations, again);
    add(&mut operations, Operation::MulAdd(again, B, rotated[2]));
    // The length of (3, 2 + 2, 3).
    assert!(last(&operations).hi >= 34.0_f64.sqrt());
}

#[test]
fn an_undeclared_quaternion_may_lengthen_a_vector() {
    let mut operations = Vec::new();
    let rotation = rotation(&mut operations);
    times(&mut operations, rotation, [A, B, A]);
    let conditions = Conditions {
        scalar: Real::F64,
        angles: 1e5,
        range: &|_| Value::between(-1.0, 1.0),
        quaternions: &[],
    };
    let found = results(&program(&[], &operations), &conditions)[0].value;
    // The quaternion (1, 1, 1, −1) gives 6 for (−1, 1, −1).
    assert!(found.hi >= 6.0 || found.lo <= -6.0, "{found:?}");
}

#[test]
fn polynomials_in_unit_quaternions_have_their_ranges() {
    let keeps = |operations: &dyn Fn(&mut Vec<Operation>), [lo, hi]: [f64; 2]| {
        let mut all = Vec::new();
        operations(&mut all);
        let found = last(&all);
        let is_near = (found.lo - lo).abs() < 1e-6 && (found.hi - hi).abs() < 1e-6;
        assert!(is_near, "{found:?}, not {lo} to {hi}");
    };
    let product = |all: &mut Vec<Operation>| {
        add(all, Operation::Mul(entry(0), entry(3)));
    };
    keeps(&product, [-0.5, 0.5]);
    let square = |all: &mut Vec<Operation>| {
        add(all, Operation::Mul(entry(1), entry(1)));
    };
    keeps(&square, [0.0, 1.0]);
    let of_three = |all: &mut Vec<Operation>| {
        let one = add(all, Operation::Mul(entry(0), entry(0)));
        let two = add(all, Operation::MulAdd(entry(1), entry(1), one));
        let three = add(all, Operation::MulAdd(entry(2), entry(2), two));
        add(all, Operation::Sub(three, Operand::Literal(3.0)));
    };
    keeps(&of_three, [-3.0, -2.0]);
    let linear = |all: &mut Vec<Operation>| {
        add(all, Operation::Sub(entry(0), entry(3)));
    };
    keeps(&linear, [-SQRT_2, SQRT_2]);
}

#[test]
fn an_entry_is_doubled_without_an_error() {
    let mut operations = Vec::new();
    let twice = add(&mut operations, Operation::Add(entry(0), entry(0)));
    assert!(last(&operations).error < 1e-300);
    add(&mut operations, Operation::Mul(entry(0), twice));
    let error = last(&operations).error / U;
    assert!((2.0..2.0 + 1e-8).contains(&error), "{error} u");
}
