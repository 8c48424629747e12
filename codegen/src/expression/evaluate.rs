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
    varying: Vec<Node>,
    /// The place of each node of the graph among the values, if it is needed.
    places: Vec<usize>,
    /// The place of each node of the graph among the angles, if its sine or cosine is needed.
    angles: Vec<usize>,
    /// The values of the constants.
    known: Values<T>,
}

/// Computed values of the needed nodes, children first: those alone, since a graph may have many more, and the values
/// are copied for each input.
#[derive(Clone, Debug)]
struct Values<T> {
    nodes: Vec<T>,
    /// Sine and cosine of each angle, in the order of first use: computed together, used one by one.
    turns: Vec<(T, T)>,
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
        let is_constant = |expr: &Expr| graph.value(*expr).is_some();
        let (constant, varying): (Vec<_>, Vec<_>) = needed.into_iter().partition(is_constant);
        let mut places = vec![usize::MAX; graph.len()];
        for (place, expr) in constant.iter().chain(&varying).enumerate() {
            places[expr.index()] = place;
        }
        let [constant, varying] =
            [constant, varying].map(|exprs| exprs.into_iter().map(|expr| graph.node(expr)));
        let (constant, varying): (Vec<Node>, Vec<Node>) = (constant.collect(), varying.collect());
        let (mut angles, mut count) = (vec![usize::MAX; graph.len()], 0);
        for node in constant.iter().chain(&varying) {
            if let Node::Sin(angle) | Node::Cos(angle) = node
                && angles[angle.index()] == usize::MAX
            {
                angles[angle.index()] = count;
                count += 1;
            }
        }
        let mut known = Values {
            nodes: Vec::with_capacity(constant.len()),
            turns: Vec::new(),
        };
        for node in constant {
            known.find(node, [&places, &angles], |_| {
                unreachable!("no input enters a constant")
            });
        }
        Self {
            results: results.to_vec(),
            varying,
            places,
            angles,
            known,
        }
    }

    /// The values of the expressions, in the order of the request.
    pub fn at(&self, input: impl Fn(Input) -> T) -> Vec<T> {
        let mut values = self.known.clone();
        values.nodes.reserve(self.varying.len());
        for &node in &self.varying {
            values.find(node, [&self.places, &self.angles], &input);
        }
        let results = self.results.iter();
        let places = results.map(|result| self.places[result.index()]);
        places.map(|place| values.nodes[place].clone()).collect()
    }
}

impl<T: Arithmetic> Values<T> {
    /// Adds the value of the next node.
    fn find(&mut self, node: Node, [places, angles]: [&[usize]; 2], input: impl Fn(Input) -> T) {
        if let Node::Sin(angle) | Node::Cos(angle) = node
            && angles[angle.index()] == self.turns.len()
        {
            let angle = self.nodes[places[angle.index()]].clone();
            self.turns.push(angle.sin_cos());
        }
        let at = |expr: Expr| self.nodes[places[expr.index()]].clone();
        let turn = |angle: Expr| &self.turns[angles[angle.index()]];
        let value = match node {
            Node::Literal(bits) => T::literal(f64::from_bits(bits)),
            Node::Input(of) => input(of),
            Node::Neg(a) => -at(a),
            Node::Add(a, b) => at(a) + at(b),
            Node::Sub(a, b) => at(a) - at(b),
            Node::Mul(a, b) => at(a) * at(b),
            Node::Div(a, b) => at(a) / at(b),
            Node::Sqrt(a) => at(a).sqrt(),
            Node::Sign(a) => at(a).sign(),
            Node::Sin(a) => turn(a).0.clone(),
            Node::Cos(a) => turn(a).1.clone(),
            Node::Taken(a, _) | Node::Made(a) => at(a),
        };
        self.nodes.push(value);
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
