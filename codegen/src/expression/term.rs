//! Handles of expressions with the usual operators, so that formulas over matrices read as in mathematics.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::double::Double;
use super::graph::{Expr, Graph, Node};
use super::label::Label;

/// An expression together with its graph.
#[derive(Clone, Copy)]
pub struct Term<'g> {
    graph: &'g Graph,
    expr: Expr,
}

impl<'g> Term<'g> {
    pub(super) const fn new(graph: &'g Graph, expr: Expr) -> Self {
        Self { graph, expr }
    }

    /// The node.
    #[must_use]
    pub const fn expr(self) -> Expr {
        self.expr
    }

    /// Its graph.
    #[must_use]
    pub const fn graph(self) -> &'g Graph {
        self.graph
    }

    /// The value, if it is constant.
    #[must_use]
    pub fn value(self) -> Option<Double> {
        self.graph.value(self.expr)
    }

    /// True if it is a constant that is zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.value().is_some_and(Double::is_zero)
    }

    /// The same value, marked with the number of one of several computations, so that these become equal, step by
    /// step: no rule applies across it, and no sign moves out of it. Zero stays zero.
    #[must_use]
    pub fn taken_by(self, number: u16) -> Self {
        Self::new(self.graph, self.graph.taken(self.expr, number))
    }

    /// The same value, marked as a result of a computation that takes marked terms, so that its readers do not change
    /// its steps: no rule applies across it, and it has the sign in which it is computed.
    #[must_use]
    pub fn made(self) -> Self {
        Self::new(self.graph, self.graph.made(self.expr))
    }

    /// Labels it as an entry of a quantity.
    pub fn label(self, label: Label) {
        self.graph.set_label(self.expr, label);
    }

    /// A node's operation on other terms, of which `at` has one for each operand. The node may be of another graph.
    #[must_use]
    pub fn of_node(graph: &'g Graph, node: Node, at: impl Fn(Expr) -> Self) -> Self {
        match node {
            Node::Literal(bits) => graph.constant(f64::from_bits(bits)),
            Node::Input(input) => graph.input(input),
            Node::Neg(a) => -at(a),
            Node::Add(a, b) => at(a) + at(b),
            Node::Sub(a, b) => at(a) - at(b),
            Node::Mul(a, b) => at(a) * at(b),
            Node::Div(a, b) => at(a) / at(b),
            Node::Sqrt(a) => at(a).sqrt(),
            Node::Sign(a) => at(a).sign(),
            Node::Sin(a) => at(a).sin_cos().0,
            Node::Cos(a) => at(a).sin_cos().1,
            Node::Taken(a, by) => at(a).taken_by(by),
            Node::Made(a) => at(a).made(),
        }
    }

    /// Sine and cosine.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.graph.sin_cos(self.expr);
        (Self::new(self.graph, sine), Self::new(self.graph, cosine))
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(self) -> Self {
        Self::new(self.graph, self.graph.sign(self.expr))
    }

    /// √x.
    #[must_use]
    pub fn sqrt(self) -> Self {
        Self::new(self.graph, self.graph.sqrt(self.expr))
    }
}

impl std::fmt::Debug for Term<'_> {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.expr.fmt(out)
    }
}

impl Add for Term<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.graph, self.graph.add(self.expr, other.expr))
    }
}

impl Neg for Term<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(self.graph, self.graph.neg(self.expr))
    }
}

impl Sub for Term<'_> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Term<'_> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(self.graph, self.graph.mul(self.expr, other.expr))
    }
}

impl Div for Term<'_> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::new(self.graph, self.graph.div(self.expr, other.expr))
    }
}
