//! From a graph to a program: what the results need, children first.
//!
//! In: a graph and the expressions asked for. Out: a [`Program`]. Because children are older than
//! parents, this is a filter and not a sort. It never changes what is computed.

use super::fuse::{self, Form, Fused};
use super::{Operand, Operation, Program, Step};
use crate::expression::{Expr, Graph, Input, Node};

/// The program that computes the given expressions and nothing else.
///
/// # Panics
/// Where an expression is not of this graph, or where the angle of a sine depends on another sine.
#[must_use]
pub fn schedule(graph: &Graph, results: &[Expr]) -> Program {
    let (needed, uses) = graph.needed(results);
    let mut placing = Placing {
        graph,
        fused: fuse::choose(graph, &needed, &uses),
        turned: turned(graph, &needed, &uses),
        operands: vec![None; graph.len()],
        steps: Vec::new(),
    };
    // Whether each expression takes part in an angle.
    let mut early = vec![false; graph.len()];
    let turns = angles(graph, &needed);
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
        results: results.iter().map(|&result| placing.at(result)).collect(),
        steps: placing.steps,
    }
}

/// A program in the making.
struct Placing<'g> {
    graph: &'g Graph,
    fused: Fused,
    turned: Vec<bool>,
    /// Where the value of each expression is found.
    operands: Vec<Option<Operand>>,
    steps: Vec<Step>,
}

impl Placing<'_> {
    fn at(&self, expr: Expr) -> Operand {
        self.operands[expr.index()].expect("children come before parents")
    }

    fn place(&mut self, expr: Expr) {
        if !self.fused.vanishes(expr) && self.operands[expr.index()].is_none() {
            self.operands[expr.index()] = Some(self.found(expr));
        }
    }

    /// Where the value of an expression is found, after adding what computes it.
    fn found(&mut self, expr: Expr) -> Operand {
        if let Some(value) = self.graph.value(expr) {
            // Without the sign of a negative zero.
            return Operand::Literal(value.to_f64() + 0.0);
        }
        let operation = match (self.graph.node(expr), self.fused.product_of(expr)) {
            (_, Some((a, b, rest, form))) => {
                let (a, b, rest) = (self.at(a), self.at(b), self.at(rest));
                match form {
                    Form::Plus => Operation::MulAdd(a, b, rest),
                    Form::Minus => Operation::MulSub(a, b, rest),
                    Form::From => Operation::NegMulAdd(a, b, rest),
                }
            }
            (Node::Input(input), _) => return Operand::Input(input),
            (Node::Neg(a), _) if self.turned[a.index()] => return self.at(a),
            (Node::Neg(a), _) => Operation::Neg(self.at(a)),
            (Node::Add(a, b), _) => Operation::Add(self.at(a), self.at(b)),
            (Node::Sub(a, b), _) => Operation::Sub(self.at(a), self.at(b)),
            (Node::Mul(a, b), _) => Operation::Mul(self.at(a), self.at(b)),
            (Node::Div(a, b), _) => Operation::Div(self.at(a), self.at(b)),
            (Node::Sqrt(a), _) => Operation::Sqrt(self.at(a)),
            (Node::Literal(_) | Node::Atan2(..), _) => unreachable!("a number has a value"),
            (Node::Sin(_) | Node::Cos(_), _) => panic!("the sine of a sine"),
        };
        let turned = self.turned[expr.index()];
        let operation = if turned {
            opposite(operation)
        } else {
            operation
        };
        let label = self.graph.label(expr);
        self.steps.push(Step { label, operation });
        let last = u32::try_from(self.steps.len() - 1).expect("fewer than 2³² steps");
        Operand::Step(last)
    }
}

/// The operation that gives −a for the price of a.
fn opposite(operation: Operation) -> Operation {
    match operation {
        Operation::Sub(a, b) => Operation::Sub(b, a),
        Operation::MulSub(a, b, c) => Operation::NegMulAdd(a, b, c),
        Operation::NegMulAdd(a, b, c) => Operation::MulSub(a, b, c),
        Operation::Mul(Operand::Literal(k), a) => Operation::Mul(Operand::Literal(-k), a),
        _ => unreachable!("only differences and multiples are turned"),
    }
}

/// The differences and multiples that are used once, under a minus: they are computed the other way
/// round, and the minus costs nothing.
fn turned(graph: &Graph, needed: &[Expr], uses: &[u32]) -> Vec<bool> {
    let mut turned = vec![false; graph.len()];
    for &expr in needed {
        let Node::Neg(a) = graph.node(expr) else {
            continue;
        };
        let free = match graph.node(a) {
            Node::Sub(..) => true,
            Node::Mul(k, _) => graph.value(k).is_some(),
            _ => false,
        };
        turned[a.index()] = free && uses[a.index()] == 1 && graph.value(a).is_none();
    }
    turned
}

/// The arguments of all sines and cosines, in the order of the joints they belong to.
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

/// The coordinate of a joint that an angle is, or is a sum with.
fn coordinate(graph: &Graph, angle: Expr) -> Option<Input> {
    let inputs = |expr: Expr| match graph.node(expr) {
        Node::Input(input) => Some(input),
        _ => None,
    };
    inputs(angle).or_else(|| graph.node(angle).operands().into_iter().find_map(inputs))
}
