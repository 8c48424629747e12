//! The nodes, and their canonical form.
//!
//! Canonical form, relied on by every later stage:
//! * no operation on 0, no product with 1, no difference of equals;
//! * signs float outwards: no operand of +, − or × is a [`Node::Neg`] or a negative literal, so a
//!   sign change is left only under a result or an angle;
//! * a sum or product has its constant first, then the older operand; of a − b and b − a only the
//!   one that starts with the older operand exists, the other is its `Neg`;
//! * a product holds at most one constant factor, folded at 106 bits;
//! * k x ± l x is (k ± l) x, and so where one of k and l is 1;
//! * no rule applies across a [`Node::Taken`] or a [`Node::Made`]: the nodes between them are the same, whatever the
//!   former holds and whoever reads the latter.

mod sparse;
#[cfg(test)]
mod tests;

use std::cell::RefCell;

use super::double::Double;
use super::label::Label;
use super::term::Term;
use crate::index::{Index, spread};
use crate::space::Variable;
use sparse::Sparse;

/// The number of a node in a graph.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(u32);

impl std::fmt::Debug for Expr {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{}", self.0)
    }
}

/// A value that is known only when the generated code runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Input {
    /// An entry of an argument.
    Variable(Variable, u16),
    /// An entry of a struct field: index of the field among the parameters, index within it.
    Parameter(u16, u16),
}

/// A scalar as an operation on older nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number, never negative, as the bits of an `f64`.
    Literal(u64),
    /// An argument or a run-time parameter.
    Input(Input),
    /// −a.
    Neg(Expr),
    /// a + b.
    Add(Expr, Expr),
    /// a − b.
    Sub(Expr, Expr),
    /// a b.
    Mul(Expr, Expr),
    /// a / b.
    Div(Expr, Expr),
    /// √a.
    Sqrt(Expr),
    /// The sign of a: −1, 0 or 1.
    Sign(Expr),
    /// sin a.
    Sin(Expr),
    /// cos a.
    Cos(Expr),
    /// a, marked with the number of one of several equal computations.
    Taken(Expr, u16),
    /// a, marked as a result of one of these.
    Made(Expr),
}

/// Scalars in the order in which they were made.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    inner: RefCell<Inner>,
}

#[derive(Clone, Debug, Default)]
struct Inner {
    nodes: Vec<Node>,
    /// The value of each constant node.
    values: Sparse<Double>,
    labels: Sparse<Label>,
    /// The nodes that depend on an input.
    varying: Index,
    /// The constants by their value, so that 0.5 × 0.5 and 0.25 are one node.
    constants: Index,
}

impl Graph {
    /// An empty graph.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The node of an expression.
    #[must_use]
    pub fn node(&self, expr: Expr) -> Node {
        self.inner.borrow().nodes[expr.index()]
    }

    /// The expression of a node, if it has been made.
    #[must_use]
    pub fn find(&self, node: Node) -> Option<Expr> {
        self.inner.borrow().find(node)
    }

    /// The value of a constant expression.
    #[must_use]
    pub fn value(&self, expr: Expr) -> Option<Double> {
        self.inner.borrow().value(expr)
    }

    /// The number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.inner.borrow().nodes.len()
    }

    /// True if there are no nodes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The label of an expression, if it is an entry of a quantity.
    #[must_use]
    pub fn label(&self, expr: Expr) -> Option<Label> {
        self.inner.borrow().labels.get(expr.index())
    }

    /// Labels an expression as an entry of a quantity. The first label stays. Inputs and numbers take none; the
    /// operand of a sign gets the [opposite](Label::opposite).
    pub fn set_label(&self, expr: Expr, label: Label) {
        let mut inner = self.inner.borrow_mut();
        let (negative, expr) = inner.strip(expr);
        let named = matches!(
            inner.nodes[expr.index()],
            Node::Input(_) | Node::Literal(_) | Node::Sin(_) | Node::Cos(_)
        ) || inner.is_constant(expr);
        if !named && !inner.labels.has(expr.index()) {
            let label = if negative { label.opposite() } else { label };
            inner.labels.set(expr.index(), label);
        }
    }

    /// A handle for computations.
    #[must_use]
    pub fn term(&self, expr: Expr) -> Term<'_> {
        Term::new(self, expr)
    }

    /// A number.
    #[must_use]
    pub fn constant(&self, value: f64) -> Term<'_> {
        let expr = self.inner.borrow_mut().literal(value);
        self.term(expr)
    }

    /// A number of 106 bits.
    #[must_use]
    pub fn number(&self, value: Double) -> Term<'_> {
        let first = value.to_f64();
        let rest = value - Double::from(first);
        self.constant(first) + self.constant(rest.to_f64())
    }

    /// An argument or a run-time parameter.
    #[must_use]
    pub fn input(&self, input: Input) -> Term<'_> {
        let expr = self.inner.borrow_mut().intern(Node::Input(input), None);
        self.term(expr)
    }

    /// The expressions that the results need, children first, and how often each node is used.
    #[must_use]
    pub fn needed(&self, results: &[Expr]) -> (Vec<Expr>, Vec<u32>) {
        let inner = self.inner.borrow();
        let mut uses = vec![0; inner.nodes.len()];
        for result in results {
            uses[result.index()] += 1;
        }
        // Operands are older than what is made of them.
        for (index, node) in inner.nodes.iter().enumerate().rev() {
            if uses[index] > 0 {
                for operand in node.operands() {
                    uses[operand.index()] += 1;
                }
            }
        }
        let used = (0..).map(Expr).zip(&uses).filter(|(_, uses)| **uses > 0);
        let needed = used.map(|(expr, _)| expr).collect();
        (needed, uses)
    }

    pub(super) fn neg(&self, a: Expr) -> Expr {
        self.inner.borrow_mut().neg(a)
    }

    pub(super) fn add(&self, a: Expr, b: Expr) -> Expr {
        self.inner.borrow_mut().add(a, b)
    }

    pub(super) fn mul(&self, a: Expr, b: Expr) -> Expr {
        self.inner.borrow_mut().mul(a, b)
    }

    pub(super) fn div(&self, a: Expr, b: Expr) -> Expr {
        self.inner.borrow_mut().div(a, b)
    }

    pub(super) fn sqrt(&self, a: Expr) -> Expr {
        self.inner.borrow_mut().sqrt(a)
    }

    pub(super) fn sign(&self, a: Expr) -> Expr {
        self.inner.borrow_mut().sign(a)
    }

    pub(super) fn sin_cos(&self, a: Expr) -> (Expr, Expr) {
        self.inner.borrow_mut().sin_cos(a)
    }

    pub(super) fn taken(&self, a: Expr, by: u16) -> Expr {
        self.inner.borrow_mut().taken(a, by)
    }

    pub(super) fn made(&self, a: Expr) -> Expr {
        self.inner.borrow_mut().made(a)
    }
}

impl Node {
    /// Its operands.
    #[must_use]
    pub const fn operands(self) -> Operands {
        match self {
            Self::Literal(_) | Self::Input(_) => Operands(None, None),
            Self::Neg(a)
            | Self::Sqrt(a)
            | Self::Sign(a)
            | Self::Sin(a)
            | Self::Cos(a)
            | Self::Taken(a, _)
            | Self::Made(a) => Operands(Some(a), None),
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => {
                Operands(Some(a), Some(b))
            }
        }
    }

    /// A hash for the index.
    fn spread(self) -> u32 {
        let (kind, a, b): (u64, u32, u32) = match self {
            // Numbers are found by their value.
            Self::Literal(_) => (0, 0, 0),
            Self::Input(Input::Variable(variable, k)) => (1, variable as u32, k.into()),
            Self::Input(Input::Parameter(field, k)) => (2, field.into(), k.into()),
            Self::Neg(a) => (3, a.0, 0),
            Self::Add(a, b) => (4, a.0, b.0),
            Self::Sub(a, b) => (5, a.0, b.0),
            Self::Mul(a, b) => (6, a.0, b.0),
            Self::Div(a, b) => (7, a.0, b.0),
            Self::Sqrt(a) => (8, a.0, 0),
            Self::Sign(a) => (9, a.0, 0),
            Self::Sin(a) => (10, a.0, 0),
            Self::Cos(a) => (11, a.0, 0),
            Self::Taken(a, by) => (12, a.0, by.into()),
            Self::Made(a) => (13, a.0, 0),
        };
        spread((u64::from(a) << 32) | u64::from(b), kind << 56)
    }
}

/// A hash of a number for the index.
fn spread_of(value: Double) -> u32 {
    let (hi, lo) = value.bits();
    spread(hi, lo)
}

/// The operands of a node, one after the other.
#[derive(Clone, Debug)]
pub struct Operands(Option<Expr>, Option<Expr>);

impl Iterator for Operands {
    type Item = Expr;

    fn next(&mut self) -> Option<Expr> {
        let first = self.0;
        self.0 = self.1.take();
        first
    }
}

impl Expr {
    /// Its index in the graph.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl Inner {
    /// The expression of a node that depends on an input.
    fn find(&self, node: Node) -> Option<Expr> {
        let is = |number: u32| self.nodes[number as usize] == node;
        self.varying.find(node.spread(), is).map(Expr)
    }

    /// The expression of a node. A number is identified by its 106 bits, however it was computed, and keeps its first
    /// expression; every other node is identified by its operands.
    fn intern(&mut self, node: Node, value: Option<Double>) -> Expr {
        let known = match value {
            Some(value) => self.constant(value),
            None => self.find(node),
        };
        if let Some(known) = known {
            return known;
        }
        let expr = Expr(u32::try_from(self.nodes.len()).expect("a graph of fewer than 2³² nodes"));
        self.nodes.push(node);
        self.values.push(value);
        self.labels.push(None);
        if let Some(value) = value {
            self.constants.insert(expr.0, spread_of(value));
        } else {
            self.varying.insert(expr.0, node.spread());
        }
        expr
    }

    fn literal(&mut self, value: f64) -> Expr {
        let size = value.abs();
        let expr = self.intern(Node::Literal(size.to_bits()), Some(Double::from(size)));
        if value < 0.0 { self.neg(expr) } else { expr }
    }

    /// The expression of a number.
    fn constant(&self, value: Double) -> Option<Expr> {
        let is = |number: u32| {
            let other = self.values.get(number as usize);
            other.is_some_and(|other| other.bits() == value.bits())
        };
        self.constants.find(spread_of(value), is).map(Expr)
    }

    fn value(&self, expr: Expr) -> Option<Double> {
        self.values.get(expr.index())
    }

    fn is_constant(&self, expr: Expr) -> bool {
        self.values.has(expr.index())
    }

    fn is_zero(&self, expr: Expr) -> bool {
        self.value(expr).is_some_and(Double::is_zero)
    }

    fn is_one(&self, expr: Expr) -> bool {
        self.value(expr).is_some_and(Double::is_one)
    }

    /// True if a minus stands before the expression, and the expression without it.
    fn strip(&self, expr: Expr) -> (bool, Expr) {
        match self.nodes[expr.index()] {
            Node::Neg(inner) => (true, inner),
            _ => (false, expr),
        }
    }

    fn signed(&mut self, negative: bool, expr: Expr) -> Expr {
        if negative { self.neg(expr) } else { expr }
    }

    fn neg(&mut self, a: Expr) -> Expr {
        match self.nodes[a.index()] {
            Node::Neg(inner) => inner,
            _ if self.is_zero(a) => a,
            _ => {
                let value = self.value(a).map(|value| -value);
                self.intern(Node::Neg(a), value)
            }
        }
    }

    fn add(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        let (a_negative, a) = self.strip(a);
        let (b_negative, b) = self.strip(b);
        match (a_negative, b_negative) {
            (false, false) => self.sum(a, b),
            (true, true) => {
                let sum = self.sum(a, b);
                self.neg(sum)
            }
            (false, true) => self.difference(a, b),
            (true, false) => self.difference(b, a),
        }
    }

    fn sum(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = self.ordered(a, b);
        if let Some((k, l, of)) = self.multiples(a, b) {
            let factor = self.sum(k, l);
            return self.product(factor, of);
        }
        let value = self.value(a).zip(self.value(b)).map(|(a, b)| a + b);
        self.intern(Node::Add(a, b), value)
    }

    /// a − b of two operands without signs.
    fn difference(&mut self, a: Expr, b: Expr) -> Expr {
        let value = self.value(a).zip(self.value(b)).map(|(a, b)| a - b);
        if a == b || value.is_some_and(Double::is_zero) {
            return self.literal(0.0);
        }
        if let Some((k, l, of)) = self.multiples(a, b) {
            let factor = self.difference(k, l);
            return self.mul(factor, of);
        }
        let swapped = match value {
            Some(value) => value.to_f64() < 0.0,
            None => self.ordered(a, b) != (a, b),
        };
        if swapped {
            let opposite = self.intern(Node::Sub(b, a), value.map(|value| -value));
            self.neg(opposite)
        } else {
            self.intern(Node::Sub(a, b), value)
        }
    }

    /// Two constants and their common factor in a and in b: k x and l x, where one of k and l may be 1. Collected
    /// before other rules, constants keep digits that a sum of products loses.
    fn multiples(&mut self, a: Expr, b: Expr) -> Option<(Expr, Expr, Expr)> {
        let split = |inner: &Self, expr: Expr| match inner.nodes[expr.index()] {
            _ if inner.is_constant(expr) => None,
            Node::Mul(factor, rest) if inner.is_constant(factor) => Some((Some(factor), rest)),
            _ => Some((None, expr)),
        };
        let ((k, x), (l, y)) = (split(self, a)?, split(self, b)?);
        // x + x is cheaper than 2 x.
        if x != y || k.or(l).is_none() {
            return None;
        }
        let one = self.literal(1.0);
        Some((k.unwrap_or(one), l.unwrap_or(one), x))
    }

    fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        let (a_negative, a) = self.strip(a);
        let (b_negative, b) = self.strip(b);
        let product = self.product(a, b);
        self.signed(a_negative != b_negative, product)
    }

    fn product(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = self.ordered(a, b);
        if self.is_zero(a) {
            return a;
        }
        if self.is_one(a) {
            return b;
        }
        match (self.value(a), self.value(b), self.nodes[b.index()]) {
            (Some(x), Some(y), _) => self.intern(Node::Mul(a, b), Some(x * y)),
            // A constant times a product that has one already.
            (Some(_), None, Node::Mul(factor, rest)) if self.is_constant(factor) => {
                let factor = self.product(a, factor);
                self.product(factor, rest)
            }
            _ => self.intern(Node::Mul(a, b), None),
        }
    }

    fn div(&mut self, a: Expr, b: Expr) -> Expr {
        let (a_negative, a) = self.strip(a);
        let (b_negative, b) = self.strip(b);
        let negative = a_negative != b_negative;
        let quotient = match (self.value(a), self.value(b)) {
            _ if self.is_zero(a) || self.is_one(b) => a,
            (Some(x), Some(y)) => self.intern(Node::Div(a, b), Some(x / y)),
            _ => self.intern(Node::Div(a, b), None),
        };
        self.signed(negative, quotient)
    }

    fn sqrt(&mut self, a: Expr) -> Expr {
        let value = self.value(a).map(Double::sqrt);
        self.intern(Node::Sqrt(a), value)
    }

    /// A constant factor only changes the sign.
    fn sign(&mut self, a: Expr) -> Expr {
        let (negative, a) = self.strip(a);
        if let Some(value) = self.value(a) {
            let sign = self.literal(value.sign().to_f64());
            return self.signed(negative, sign);
        }
        let of = match self.nodes[a.index()] {
            // Constants are never negative here.
            Node::Mul(factor, of) if self.is_constant(factor) => of,
            _ => a,
        };
        let sign = self.intern(Node::Sign(of), None);
        self.signed(negative, sign)
    }

    fn sin_cos(&mut self, a: Expr) -> (Expr, Expr) {
        let (negative, a) = self.strip(a);
        let values = self.value(a).map(Double::sin_cos);
        let sine = self.intern_signed(Node::Sin(a), values.map(|(sine, _)| sine));
        let cosine = self.intern_signed(Node::Cos(a), values.map(|(_, cosine)| cosine));
        (self.signed(negative, sine), cosine)
    }

    /// Zero stays zero; other numbers become opaque.
    fn taken(&mut self, a: Expr, by: u16) -> Expr {
        if self.is_zero(a) {
            a
        } else {
            self.intern(Node::Taken(a, by), None)
        }
    }

    /// Numbers stay numbers.
    fn made(&mut self, a: Expr) -> Expr {
        if self.is_constant(a) {
            a
        } else {
            self.intern(Node::Made(a), None)
        }
    }

    /// A node that may be negative; zero becomes the literal.
    fn intern_signed(&mut self, node: Node, value: Option<Double>) -> Expr {
        if value.is_some_and(Double::is_zero) {
            self.literal(0.0)
        } else {
            self.intern(node, value)
        }
    }

    /// Constants first, then by age.
    fn ordered(&self, a: Expr, b: Expr) -> (Expr, Expr) {
        let key = |expr: Expr| (!self.is_constant(expr), expr);
        if key(b) < key(a) { (b, a) } else { (a, b) }
    }
}
