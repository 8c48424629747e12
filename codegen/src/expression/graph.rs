//! The nodes, and the form they are brought into when they are made.
//!
//! Canonical form, relied on by every later stage:
//! * no operation on 0, no product with 1, no difference of equals;
//! * signs float outwards: no operand of +, − or × is a [`Node::Neg`] or a negative literal, so a
//!   sign change is left only under a result or an angle;
//! * a sum or product has its constant first, then the older operand; of a − b and b − a only the
//!   one that starts with the older operand exists, the other is its `Neg`;
//! * a product holds at most one constant factor, folded at 106 bits;
//! * k x ± l x is (k ± l) x, and so where one of k and l is 1;
//! * nothing looks through a [`Node::Taken`]: what is made of it is the same, whatever it holds.

#[cfg(test)]
mod tests;

use std::cell::RefCell;
use std::collections::HashMap;

use super::double::Double;
use super::label::Label;
use super::term::Term;
use crate::space::Variable;

/// A node of a graph.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expr(u32);

impl std::fmt::Debug for Expr {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{}", self.0)
    }
}

/// What is known only when the generated code runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Input {
    /// An entry of an argument.
    Variable(Variable, u16),
    /// An entry of a struct field: index of the field among the parameters, index within it.
    Parameter(u16, u16),
}

/// A scalar and how it comes about. Children are older than parents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number that stands for itself, never negative, as the bits of an `f64`.
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
    /// a, as the one of several equal computations takes it that has this number.
    Taken(Expr, u16),
}

/// Scalars in the order in which they were made.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    inner: RefCell<Inner>,
}

#[derive(Clone, Debug, Default)]
struct Inner {
    nodes: Vec<Node>,
    /// The value of each node that no input enters.
    values: Vec<Option<Double>>,
    labels: Vec<Option<Label>>,
    /// The nodes that an input enters.
    memo: HashMap<Node, Expr>,
    /// All others, by their value, so that 0.5 × 0.5 and 0.25 are one.
    constants: HashMap<(u64, u64), Expr>,
}

impl Graph {
    /// No nodes yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The node behind an expression.
    #[must_use]
    pub fn node(&self, expr: Expr) -> Node {
        self.inner.borrow().nodes[expr.index()]
    }

    /// The expression of a node, where it has been made.
    #[must_use]
    pub fn find(&self, node: Node) -> Option<Expr> {
        self.inner.borrow().memo.get(&node).copied()
    }

    /// The value of an expression that no input enters.
    #[must_use]
    pub fn value(&self, expr: Expr) -> Option<Double> {
        self.inner.borrow().values[expr.index()]
    }

    /// How many nodes there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.inner.borrow().nodes.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// What the expression is an entry of, if anything.
    #[must_use]
    pub fn label(&self, expr: Expr) -> Option<Label> {
        self.inner.borrow().labels[expr.index()]
    }

    /// Says what the expression is an entry of. The first label stays; inputs and numbers, which
    /// have their own, take none; what stands behind a sign is the [opposite](Label::opposite).
    pub fn set_label(&self, expr: Expr, label: Label) {
        let mut inner = self.inner.borrow_mut();
        let (negative, expr) = inner.strip(expr);
        let named = matches!(
            inner.nodes[expr.index()],
            Node::Input(_) | Node::Literal(_) | Node::Sin(_) | Node::Cos(_)
        ) || inner.values[expr.index()].is_some();
        let slot = &mut inner.labels[expr.index()];
        if !named && slot.is_none() {
            *slot = Some(if negative { label.opposite() } else { label });
        }
    }

    /// A handle that computes.
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
        let mut waiting = results.to_vec();
        let mut needed = Vec::new();
        while let Some(expr) = waiting.pop() {
            uses[expr.index()] += 1;
            if uses[expr.index()] == 1 {
                needed.push(expr);
                waiting.extend(inner.nodes[expr.index()].operands());
            }
        }
        needed.sort_unstable();
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
}

impl Node {
    /// What it acts on.
    #[must_use]
    pub fn operands(self) -> Vec<Expr> {
        match self {
            Self::Literal(_) | Self::Input(_) => Vec::new(),
            Self::Neg(a)
            | Self::Sqrt(a)
            | Self::Sign(a)
            | Self::Sin(a)
            | Self::Cos(a)
            | Self::Taken(a, _) => vec![a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
        }
    }
}

impl Expr {
    /// Its place in the order of the graph.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl Inner {
    /// The expression of that node: a number is known by its 106 bits, however it came about and as
    /// well as where it came about first, and everything else by what it acts on.
    fn intern(&mut self, node: Node, value: Option<Double>) -> Expr {
        let known = match value {
            Some(value) => self.constants.get(&value.bits()),
            None => self.memo.get(&node),
        };
        if let Some(&known) = known {
            return known;
        }
        let expr = Expr(u32::try_from(self.nodes.len()).expect("a graph of fewer than 2³² nodes"));
        self.nodes.push(node);
        self.values.push(value);
        self.labels.push(None);
        match value {
            Some(value) => self.constants.insert(value.bits(), expr),
            None => self.memo.insert(node, expr),
        };
        expr
    }

    fn literal(&mut self, value: f64) -> Expr {
        let size = value.abs();
        let expr = self.intern(Node::Literal(size.to_bits()), Some(Double::from(size)));
        if value < 0.0 { self.neg(expr) } else { expr }
    }

    fn value(&self, expr: Expr) -> Option<Double> {
        self.values[expr.index()]
    }

    fn is_zero(&self, expr: Expr) -> bool {
        self.value(expr).is_some_and(Double::is_zero)
    }

    fn is_one(&self, expr: Expr) -> bool {
        self.value(expr).is_some_and(Double::is_one)
    }

    /// Whether a minus stands before the expression, and what it stands before.
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

    /// Two constants and what both are factors of, in a and in b, of which one may be 1: k x and l x.
    /// Gathered before anything else uses them, constants keep digits that a sum of products loses.
    fn multiples(&mut self, a: Expr, b: Expr) -> Option<(Expr, Expr, Expr)> {
        let split = |inner: &Self, expr: Expr| match inner.nodes[expr.index()] {
            _ if inner.value(expr).is_some() => None,
            Node::Mul(factor, rest) if inner.value(factor).is_some() => Some((Some(factor), rest)),
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
            (Some(_), None, Node::Mul(factor, rest)) if self.value(factor).is_some() => {
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

    /// A constant factor does nothing but turn it.
    fn sign(&mut self, a: Expr) -> Expr {
        let (negative, a) = self.strip(a);
        if let Some(value) = self.value(a) {
            let sign = self.literal(value.sign().to_f64());
            return self.signed(negative, sign);
        }
        let of = match self.nodes[a.index()] {
            // Constants are never negative here.
            Node::Mul(factor, of) if self.value(factor).is_some() => of,
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

    /// Zero is taken for what it is; other numbers are not known any more.
    fn taken(&mut self, a: Expr, by: u16) -> Expr {
        if self.is_zero(a) {
            a
        } else {
            self.intern(Node::Taken(a, by), None)
        }
    }

    /// A node whose value may be anything: zero becomes the literal.
    fn intern_signed(&mut self, node: Node, value: Option<Double>) -> Expr {
        if value.is_some_and(Double::is_zero) {
            self.literal(0.0)
        } else {
            self.intern(node, value)
        }
    }

    /// Constants first, then by age.
    fn ordered(&self, a: Expr, b: Expr) -> (Expr, Expr) {
        let key = |expr: Expr| (self.value(expr).is_none(), expr);
        if key(b) < key(a) { (b, a) } else { (a, b) }
    }
}
