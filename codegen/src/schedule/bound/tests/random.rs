//! Random programs with many of the structures that bounds recognise: rotations, shifted angles, constant rotations and
//! offsets.
//!
//! Checks that the value of every step is in its range and its error within its bound, in both types, with and without
//! fused operations. The reference is the same program in 106 bits.

use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen_random::Random;

use super::quaternion::{QUATERNIONS, entry, rotation, times};
use super::{A, B, Conditions, Value, program, results, step};
use crate::expression::{Arithmetic, Block, Component, Double, Input, LabelledBodies, Numeral};
use crate::real::Real;
use crate::schedule::{Operand, Operation, Program, run};
use crate::space::Variable;

/// Program under construction.
struct Draft {
    random: Random,
    operations: Vec<Operation>,
    /// Values that later steps may read.
    values: Vec<Operand>,
    /// The rotation matrix of a quaternion.
    rotation: [[Operand; 3]; 3],
}

impl Draft {
    fn any(&mut self) -> Operand {
        // Later values are chosen more often.
        let count = self.values.len();
        let at = self.random.below(count).max(self.random.below(count));
        self.values[at]
    }

    fn add(&mut self, operation: Operation) -> Operand {
        self.operations.push(operation);
        let last = u32::try_from(self.operations.len() - 1).expect("few");
        step(last)
    }

    /// a x + b y.
    fn sum(&mut self, [a, x]: [Operand; 2], [b, y]: [Operand; 2], minus: bool) -> Operand {
        let product = self.add(Operation::Mul(b, y));
        let sum = match (minus, self.random.below(2)) {
            (false, _) => Operation::MulAdd(a, x, product),
            (true, 0) => Operation::MulSub(a, x, product),
            (true, _) => {
                let first = self.add(Operation::Mul(a, x));
                Operation::Sub(first, product)
            }
        };
        self.add(sum)
    }

    /// Two entries, rotated by values that may be sine and cosine of one angle.
    fn turned(&mut self, [c, s]: [Operand; 2], [x, y]: [Operand; 2]) -> [Operand; 2] {
        let first = self.sum([c, x], [s, y], false);
        let second = self.sum([c, y], [s, x], true);
        [first, second]
    }

    /// A vector rotated by the quaternion or its inverse; in one case of three with exchanged entries of the matrix,
    /// one of which may be another value.
    fn carried(&mut self, vector: [Operand; 3]) -> [Operand; 3] {
        let mut matrix = self.rotation;
        if self.random.below(2) == 0 {
            matrix = [0, 1, 2].map(|column| self.rotation.map(|row| row[column]));
        }
        if self.random.below(3) == 0 {
            let [i, j, k, l] = [(); 4].map(|()| self.random.below(3));
            matrix[i][j] = match self.random.below(4) {
                0 => self.any(),
                1 => self.add(Operation::Sub(Operand::Literal(0.0), matrix[i][j])),
                _ => matrix[k][l],
            };
        }
        times(&mut self.operations, matrix, vector)
    }

    fn grow(&mut self) {
        let number = Operand::Literal(1.5 * self.random.unit());
        let angle = self.random.unit() * 3.0;
        let (s, c) = Double::from(angle).sin_cos();
        let constant = [c, s].map(|entry| Operand::Literal(entry.to_f64()));
        let given = [Operand::Cos(0), Operand::Sin(0)];
        let [a, b, d] = [(); 3].map(|()| self.any());
        let grown = match self.random.below(13) {
            0 => self.turned(given, [a, b]).to_vec(),
            1 => self.turned(constant, [a, b]).to_vec(),
            2 => {
                let shifted = self.turned(constant, given);
                self.turned(shifted, [a, b]).to_vec()
            }
            // Three entries, about two axes.
            3 => {
                let [x, y] = self.turned(constant, [a, b]);
                let [y, z] = self.turned(given, [y, d]);
                let [x, z] = self.turned(constant, [x, z]);
                vec![x, y, z]
            }
            4 => vec![self.add(Operation::Add(a, b))],
            5 => vec![self.add(Operation::Sub(a, b))],
            6 => vec![self.add(Operation::MulAdd(number, a, b))],
            7 => vec![self.add(Operation::NegMulAdd(a, number, b))],
            8 => {
                let half = self.add(Operation::Mul(a, Operand::Literal(0.5)));
                vec![self.add(Operation::Mul(half, b))]
            }
            9 => self.carried([a, b, d]).to_vec(),
            // An offset of literals, and its sum with a rotated vector, rotated by literals.
            10 => {
                let lever = [(); 3].map(|()| Operand::Literal(self.random.unit()));
                let [x, y, z] = self.carried(lever);
                let [u, v, w] = self.carried([b, a, d]);
                let [x, y, z] =
                    [(x, u), (y, v), (z, w)].map(|(x, u)| self.add(Operation::Add(x, u)));
                let [x, y] = self.turned(constant, [x, y]);
                vec![x, y, z]
            }
            11 => {
                let [i, k] = [(); 2].map(|()| self.random.below(3));
                let entry = self.rotation[i][k];
                vec![entry, self.add(Operation::Mul(entry, a))]
            }
            _ => {
                // Similar to a rotation, and not orthogonal.
                let [x, _] = self.turned(given, [a, b]);
                vec![self.sum([given[0], x], [given[1], b], false)]
            }
        };
        self.values.extend(grown);
    }
}

fn drawn(seed: u64) -> Program {
    let mut operations = Vec::new();
    let mut draft = Draft {
        random: Random::new(seed),
        rotation: rotation(&mut operations),
        operations,
        values: vec![
            A,
            B,
            Operand::Sin(0),
            Operand::Cos(0),
            Operand::Literal(0.3),
            entry(0),
            entry(3),
        ],
    };
    for _ in 0..14 {
        draft.grow();
    }
    let omega = Block::AngularVelocity
        .of(LabelledBodies::FromBase(Numeral(1)))
        .seen_in(Numeral(1));
    let labels = [0, 1, 2].map(|k| omega.entry(Component::Along(k)));
    let mut program = program(&[A], &draft.operations);
    let mut random = draft.random;
    for step in &mut program.steps {
        // Meaningless labels may only increase bounds.
        step.label = (random.below(3) == 0).then(|| labels[random.below(3)]);
    }
    let count = u32::try_from(program.steps.len()).expect("few");
    program.results = (0..count).map(step).collect();
    program
}

/// Double precision with fused operations.
#[derive(Clone, Copy)]
struct Fused(f64);

macro_rules! by {
    ($($of:ident $name:ident),*) => {$(
        impl $of for Fused {
            type Output = Self;

            fn $name(self, other: Self) -> Self {
                Self($of::$name(self.0, other.0))
            }
        }
    )*};
}

by!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Fused {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Arithmetic for Fused {
    fn literal(value: f64) -> Self {
        Self(value)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.mul_add(factor.0, term.0))
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn sign(self) -> Self {
        Self(Arithmetic::sign(self.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Arithmetic::sin_cos(self.0);
        (Self(sine), Self(cosine))
    }
}

/// A quaternion of a type, often about an axis or by a right angle, rounded and lengthened within the tolerance.
fn of_length_1(random: &mut Random, near: impl Fn(f64) -> f64, scalar: Real) -> [f64; 4] {
    let drawn = [(); 4].map(|()| match random.below(4) {
        0 => 0.0,
        1 => 1.0,
        _ => random.unit(),
    });
    let length = drawn.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length == 0.0 {
        return [0.0, 0.0, 0.0, 1.0];
    }
    let longer = [
        1.0,
        1.0 + 2.0 * scalar.roundoff(),
        1.0 + 6.0 * scalar.roundoff(),
    ];
    let longer = longer[random.below(3)];
    drawn.map(|x| near(longer * (x / length)))
}

/// Runs a program in a type and compares every step with its bound.
fn check<T: Arithmetic>(program: &Program, scalar: Real, seed: u64, to_f64: impl Fn(T) -> f64) {
    let size = [3.0, 1e-20, 1e-3, 40.0][usize::try_from(seed % 4).expect("small")];
    let range = |input| match input {
        Input::Variable(Variable::Q, 0) => Value::between(-3.0, 3.0),
        Input::Variable(Variable::Q, 2..) => Value::between(-1.0, 1.0),
        _ => Value::between(-size, size),
    };
    let conditions = Conditions {
        scalar,
        angles: 1e3,
        range: &range,
        quaternions: &QUATERNIONS,
    };
    let found = results(program, &conditions);
    let mut random = Random::new(seed);
    for _ in 0..8 {
        let [q, other] = [3.0, size].map(|most| match random.below(3) {
            0 => most,
            1 => -most,
            _ => most * random.unit(),
        });
        let near = |x: f64| to_f64(T::literal(x));
        let [q, other] = [q, other].map(|x| {
            if near(x).abs() > x.abs() {
                near(x / 2.0)
            } else {
                near(x)
            }
        });
        let quaternion = of_length_1(&mut random, near, scalar);
        let at = |input| match input {
            Input::Variable(Variable::Q, 0) => q,
            Input::Variable(Variable::Q, k @ 2..) => quaternion[usize::from(k) - 2],
            _ => other,
        };
        let exact = run(program, |input| Double::from(at(input)));
        let computed = run(program, |input| T::literal(at(input)));
        for (k, ((exact, computed), found)) in exact.iter().zip(computed).zip(&found).enumerate() {
            let (value, exact) = (found.value, *exact);
            let slack = 1e-12 * value.lo.abs().max(value.hi.abs());
            let inside = (value.lo - slack..=value.hi + slack).contains(&exact.to_f64());
            assert!(inside, "seed {seed}, step {k}: {exact:?} of {value:?}");
            let error = (Double::from(to_f64(computed)) - exact).to_f64().abs();
            assert!(
                error <= value.error,
                "seed {seed}, step {k}: {error:e} of {value:?}"
            );
        }
    }
}

#[test]
fn every_value_is_within_its_bound() {
    for seed in 0..300 {
        let program = drawn(seed);
        check::<f64>(&program, Real::F64, seed, |x| x);
        check::<Fused>(&program, Real::F64, seed, |x| x.0);
        check::<f32>(&program, Real::F32, seed, f64::from);
    }
}

#[test]
fn bounds_in_single_precision_scale_to_double() {
    let ratio = Real::F64.roundoff() / Real::F32.roundoff();
    for seed in 0..300 {
        let program = drawn(seed);
        // Up to angles of many turns, whose errors exceed any sine.
        let size = [3.0, 1e-20, 1e9][usize::try_from(seed % 3).expect("small")];
        let range = |_| Value::between(-size, size);
        let [single, double] = [Real::F32, Real::F64].map(|scalar| {
            let conditions = Conditions {
                scalar,
                angles: f64::INFINITY,
                range: &range,
                quaternions: &QUATERNIONS,
            };
            results(&program, &conditions)
        });
        for (k, (single, double)) in single.iter().zip(&double).enumerate() {
            let bound = ratio * single.value.error * (1.0 + 1e-9);
            assert!(double.value.error <= bound, "seed {seed}, step {k}");
        }
    }
}
