//! Evaluation of expressions in any arithmetic.
//!
//! In: a graph, the requested expressions, and the values of the inputs. Out: their values, computed from the literals:
//! a constant is as exact as the arithmetic, not as the 106 bits that [`Graph::value`] keeps of it. Operations are
//! evaluated as they are, without rounding, reordering or simplification of their own.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::double::Double;
use super::graph::{Expr, Graph, Input, Node};

/// A type of numbers for the evaluation of expressions and programs; it may own memory.
pub trait Arithmetic:
    Clone
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to a literal.
    fn literal(value: f64) -> Self;
    /// `self · factor + term`, rounded once if the arithmetic fuses; the default rounds twice.
    #[must_use]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    /// √x.
    #[must_use]
    fn sqrt(self) -> Self;
    /// −1, 0 or 1.
    #[must_use]
    fn sign(self) -> Self;
    /// Sine and cosine.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);
}

/// Expressions whose constants are computed, ready for any number of inputs.
#[derive(Clone, Debug)]
pub struct Evaluation<T> {
    results: Vec<Expr>,
    /// The nodes that depend on an input, children first.
    varying: Vec<(Expr, Node)>,
    known: Values<T>,
}

/// Computed values of a graph's nodes.
#[derive(Clone, Debug)]
struct Values<T> {
    /// The value of each node.
    nodes: Vec<Option<T>>,
    /// Sine and cosine of each node that is an angle: computed together, used one by one.
    turns: Vec<Option<(T, T)>>,
}

/// The values of expressions, for one input.
///
/// # Panics
/// If an expression is not of this graph.
pub fn evaluate<T: Arithmetic>(
    graph: &Graph,
    results: &[Expr],
    input: impl Fn(Input) -> T,
) -> Vec<T> {
    Evaluation::of(graph, results).at(input)
}

impl<T: Arithmetic> Evaluation<T> {
    /// Computes the constants that the expressions need.
    ///
    /// # Panics
    /// If an expression is not of this graph.
    #[must_use]
    pub fn of(graph: &Graph, results: &[Expr]) -> Self {
        let (needed, _) = graph.needed(results);
        let nodes = needed.into_iter().map(|expr| (expr, graph.node(expr)));
        let (constant, varying): (Vec<_>, Vec<_>) =
            nodes.partition(|(expr, _)| graph.value(*expr).is_some());
        let mut known = Values {
            nodes: vec![None; graph.len()],
            turns: vec![None; graph.len()],
        };
        for (expr, node) in constant {
            known.find(expr, node, |_| unreachable!("no input enters a constant"));
        }
        Self {
            results: results.to_vec(),
            varying,
            known,
        }
    }

    /// The values of the expressions, in the order of the request.
    pub fn at(&self, input: impl Fn(Input) -> T) -> Vec<T> {
        let mut values = self.known.clone();
        for &(expr, node) in &self.varying {
            values.find(expr, node, &input);
        }
        let results = self.results.iter();
        results.map(|&result| values.at(result)).collect()
    }
}

impl<T: Arithmetic> Values<T> {
    fn at(&self, expr: Expr) -> T {
        let value = self.nodes[expr.index()].clone();
        value.expect("children come before parents")
    }

    fn find(&mut self, expr: Expr, node: Node, input: impl Fn(Input) -> T) {
        let value = match node {
            Node::Literal(bits) => T::literal(f64::from_bits(bits)),
            Node::Input(of) => input(of),
            Node::Neg(a) => -self.at(a),
            Node::Add(a, b) => self.at(a) + self.at(b),
            Node::Sub(a, b) => self.at(a) - self.at(b),
            Node::Mul(a, b) => self.at(a) * self.at(b),
            Node::Div(a, b) => self.at(a) / self.at(b),
            Node::Sqrt(a) => self.at(a).sqrt(),
            Node::Sign(a) => self.at(a).sign(),
            Node::Sin(a) => self.turn(a).0,
            Node::Cos(a) => self.turn(a).1,
            Node::Taken(a, _) => self.at(a),
        };
        self.nodes[expr.index()] = Some(value);
    }

    fn turn(&mut self, angle: Expr) -> (T, T) {
        let value = self.at(angle);
        self.turns[angle.index()]
            .get_or_insert_with(|| value.sin_cos())
            .clone()
    }
}

impl Arithmetic for f64 {
    fn literal(value: f64) -> Self {
        value
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sign(self) -> Self {
        Self::from(i8::from(self > 0.0) - i8::from(self < 0.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

impl Arithmetic for f32 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "rounding is what is asked for"
    )]
    fn literal(value: f64) -> Self {
        value as Self
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sign(self) -> Self {
        Self::from(i8::from(self > 0.0) - i8::from(self < 0.0))
    }

    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

impl Arithmetic for Double {
    fn literal(value: f64) -> Self {
        Self::from(value)
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sign(self) -> Self {
        self.sign()
    }

    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

#[cfg(test)]
mod tests {
    use super::{Evaluation, evaluate};
    use crate::expression::{Double, Graph, Input};
    use crate::space::Variable;

    #[test]
    fn constants_are_computed_in_the_arithmetic_and_not_taken_from_the_graph() {
        let graph = Graph::new();
        let [one, three] = [1.0, 3.0].map(|x| graph.constant(x));
        let x = graph.input(Input::Variable(Variable::Q, 0));
        let result = (one / three) * x - (one / three).sqrt();
        // In single precision, with one rounding an operation.
        let third = 1.0_f32 / 3.0;
        let expected = third * 0.7 - third.sqrt();
        assert_eq!(evaluate(&graph, &[result.expr()], |_| 0.7_f32), [expected]);
    }

    #[test]
    fn one_evaluation_serves_many_inputs() {
        let graph = Graph::new();
        let x = graph.input(Input::Variable(Variable::Q, 0));
        let (sine, cosine) = x.sin_cos();
        let tenth = graph.constant(0.1).sin_cos().0;
        let results = [
            (sine * sine + cosine * cosine).expr(),
            (sine / cosine * tenth).expr(),
        ];
        let evaluation = Evaluation::of(&graph, &results);
        for angle in [-2.0, 0.0, 0.3, 1e3] {
            let found = evaluation.at(|_| Double::from(angle));
            assert!((found[0] - Double::from(1.0)).is_zero());
            let expected = angle.tan() * 0.1_f64.sin();
            assert!((found[1].to_f64() - expected).abs() <= 1e-13 * expected.abs());
        }
    }
}
