//! Program of a graph: the expressions that the results need, operands first.
//!
//! In: a graph and expressions. Out: a [`Program`]. Expressions are created after their operands, so that filtering the
//! graph keeps the order; nothing is sorted.

use std::collections::{BTreeMap, HashMap};

use super::fuse::{self, Fused, FusedForm};
use super::signs::Signs;
use super::{Operand, Operation, Program, Step};
use crate::expression::{Expr, Graph, Input, Label, Node};

/// Program that computes the given expressions.
///
/// # Panics
/// If an expression belongs to another graph, or if the angle of a sine depends on another sine.
#[must_use]
pub fn schedule(graph: &Graph, results: &[Expr]) -> Program {
    let (needed, uses) = graph.needed(results);
    let fused = fuse::choose(graph, &needed, &uses);
    place(graph, results, &needed, fused)
}

/// The same program without fused operations.
///
/// # Panics
/// As [`schedule`] does.
#[must_use]
pub fn schedule_unfused(graph: &Graph, results: &[Expr]) -> Program {
    let (needed, uses) = graph.needed(results);
    place(graph, results, &needed, Fused::nothing(uses.len()))
}

fn place(graph: &Graph, results: &[Expr], needed: &[Expr], fused: Fused) -> Program {
    let mut placing = Placing {
        graph,
        signs: Signs::choose(graph, needed, results, &fused),
        fused,
        operands: vec![None; graph.len()],
        steps: Vec::new(),
        opposites: HashMap::new(),
        open: BTreeMap::new(),
    };
    // True for each expression that an angle depends on.
    let mut early = vec![false; graph.len()];
    let turns = angles(graph, needed);
    for &angle in &turns {
        early[angle.index()] = true;
    }
    for &expr in needed.iter().rev() {
        if early[expr.index()] {
            for child in graph.node(expr).operands() {
                early[child.index()] = true;
            }
        }
    }

    for &expr in needed.iter().filter(|expr| early[expr.index()]) {
        placing.place(expr);
    }
    let before_angles = placing.steps.len();
    for (index, angle) in (0..).zip(&turns) {
        for (node, operand) in [
            (Node::Sin(*angle), Operand::Sin(index)),
            (Node::Cos(*angle), Operand::Cos(index)),
        ] {
            if let Some(expr) = graph.find(node) {
                placing.operands[expr.index()] = Some(operand);
            }
        }
    }
    for &expr in needed.iter().filter(|expr| !early[expr.index()]) {
        placing.place(expr);
    }
    Program {
        angles: turns.iter().map(|&angle| placing.at(angle)).collect(),
        before_angles,
        results: results
            .iter()
            .map(|&result| placing.positive(result))
            .collect(),
        steps: placing.steps,
        open: placing.open,
    }
}

/// State of the construction of a program.
struct Placing<'g> {
    graph: &'g Graph,
    fused: Fused,
    signs: Signs,
    /// Operand that holds each expression.
    operands: Vec<Option<Operand>>,
    steps: Vec<Step>,
    /// Operands that hold expressions with their own sign, beside those that hold the opposite.
    opposites: HashMap<Expr, Operand>,
    /// As [`Program::open`].
    open: BTreeMap<u64, f64>,
}

/// 2⁻³² of the unit roundoff of `f64`. Smaller errors of literals are covered by the factor that bounds include for the
/// rounding of their own computation.
const OPEN: f64 = f64::from_bits((1023 - 85) << 52);

impl Placing<'_> {
    fn at(&self, expr: Expr) -> Operand {
        self.operands[expr.index()].expect("children come before parents")
    }

    fn place(&mut self, expr: Expr) {
        if !self.fused.vanishes(expr) && self.operands[expr.index()].is_none() {
            self.operands[expr.index()] = Some(self.found(expr));
        }
    }

    /// Adds the steps that compute an expression, or its negative if [`Signs`] chose that, and returns its operand.
    fn found(&mut self, expr: Expr) -> Operand {
        if let Some(value) = self.graph.value(expr) {
            if !value.is_known() {
                return Operand::Literal(f64::NAN);
            }
            // Turns −0 into 0.
            let literal = value.to_f64() + 0.0;
            if value.radius() > OPEN * literal.abs() {
                let open = self.open.entry(literal.abs().to_bits()).or_default();
                *open = open.max(value.radius());
            }
            return Operand::Literal(literal);
        }
        let operation = match self.graph.node(expr) {
            Node::Input(input) => return Operand::Input(input),
            Node::Neg(a) | Node::Made(a) => return self.at(a),
            Node::Taken(a, _) => return self.positive(a),
            Node::Add(a, b) => self.sum(expr, a, (b, false)),
            Node::Sub(a, b) => self.sum(expr, a, (b, true)),
            Node::Mul(a, b) => match (self.at(a), self.signs.of_product(a, b, expr)) {
                (Operand::Literal(k), true) => Operation::Mul(Operand::Literal(-k), self.at(b)),
                (factor, _) => Operation::Mul(factor, self.at(b)),
            },
            Node::Div(a, b) => Operation::Div(self.at(a), self.at(b)),
            Node::Sqrt(a) => Operation::Sqrt(self.positive(a)),
            Node::Sign(a) => Operation::Sign(self.positive(a)),
            Node::Literal(_) => unreachable!("a number has a value"),
            Node::Sin(_) | Node::Cos(_) => panic!("the sine of a sine"),
        };
        let label = self.graph.label(expr);
        let label = if self.signs.turned(expr) {
            label.map(Label::opposite)
        } else {
            label
        };
        self.push(label, operation)
    }

    /// Operation for a ± b, by the signs with which the operands are computed.
    fn sum(&self, expr: Expr, a: Expr, (b, minus): (Expr, bool)) -> Operation {
        let turned = self.signs.turned(expr);
        if let Some((x, y, rest, form)) = self.fused.product_of(expr) {
            // The terms as ± x y ± rest.
            let (product, other) = match form {
                FusedForm::Plus => (false, false),
                FusedForm::Minus => (false, true),
                FusedForm::From => (true, false),
            };
            let mut product = (product != turned) != self.signs.of_factors(x, y);
            let mut x = self.at(x);
            let (rest, other) = self.term(rest, other != turned);
            if let (Operand::Literal(k), true) = (x, product) {
                (x, product) = (Operand::Literal(-k), false);
            }
            let y = self.at(y);
            return match (product, other) {
                (false, false) => Operation::MulAdd(x, y, rest),
                (false, true) => Operation::MulSub(x, y, rest),
                (true, _) => Operation::NegMulAdd(x, y, rest),
            };
        }
        let ((a, a_minus), (b, b_minus)) = (self.term(a, turned), self.term(b, minus != turned));
        match (a_minus, b_minus) {
            (false, false) => Operation::Add(a, b),
            (false, true) => Operation::Sub(a, b),
            (true, _) => Operation::Sub(b, a),
        }
    }

    /// Operand of a term and whether it still has to be negated; a literal is negated itself.
    fn term(&self, expr: Expr, minus: bool) -> (Operand, bool) {
        match (self.at(expr), minus != self.signs.turned(expr)) {
            (Operand::Literal(k), true) => (Operand::Literal(-k), false),
            found => found,
        }
    }

    /// Operand of the value with its own sign.
    fn positive(&mut self, expr: Expr) -> Operand {
        let (operand, is_opposite) = self.term(expr, false);
        if !is_opposite {
            return operand;
        }
        if let Some(&known) = self.opposites.get(&expr) {
            return known;
        }
        let operand = self.push(self.graph.label(expr), Operation::Neg(operand));
        self.opposites.insert(expr, operand);
        operand
    }

    fn push(&mut self, label: Option<Label>, operation: Operation) -> Operand {
        self.steps.push(Step { label, operation });
        let last = u32::try_from(self.steps.len() - 1).expect("fewer than 2³² steps");
        Operand::Step(last)
    }
}

/// Angles of all sines and cosines, in the order of their joints.
fn angles(graph: &Graph, needed: &[Expr]) -> Vec<Expr> {
    let mut angles: Vec<Expr> = (needed.iter())
        .filter(|&&expr| graph.value(expr).is_none())
        .filter_map(|&expr| match graph.node(expr) {
            Node::Sin(angle) | Node::Cos(angle) => Some(angle),
            _ => None,
        })
        .collect();
    angles.sort_by_key(|&angle| (coordinate(graph, angle), angle));
    angles.dedup();
    angles
}

/// Coordinate in an angle: the angle itself, or a term of its sum.
fn coordinate(graph: &Graph, angle: Expr) -> Option<Input> {
    let inputs = |expr: Expr| match graph.node(expr) {
        Node::Input(input) => Some(input),
        _ => None,
    };
    inputs(angle).or_else(|| graph.node(angle).operands().find_map(inputs))
}
