//! From a graph to a program: what the results need, children first.
//!
//! In: a graph and the expressions asked for. Out: a [`Program`]. Because children are older than
//! parents, this is a filter and not a sort. It never changes what is computed.

use super::{Operand, Operation, Program, Step, fuse};
use crate::expression::{Expr, Graph, Node};

/// The program that computes the given expressions and nothing else.
///
/// # Panics
/// Where an expression is not of this graph.
#[must_use]
pub fn schedule(graph: &Graph, results: &[Expr]) -> Program {
    let (needed, uses) = graph.needed(results);
    let fused = fuse::choose(graph, &needed, &uses);
    let before = angles_first(graph, &needed);
    let turned = turned(graph, &needed, &uses);

    let mut program = Program {
        angles: Vec::new(),
        before_angles: 0,
        steps: Vec::new(),
        results: Vec::new(),
    };
    let mut operands: Vec<Option<Operand>> = vec![None; graph.len()];
    for phase in [true, false] {
        for &expr in &needed {
            if fused.vanishes(expr) || before[expr.index()] != phase {
                continue;
            }
            let operand = match graph.node(expr) {
                Node::Neg(a) if turned[a.index()] => operands[a.index()],
                _ => {
                    let turned = turned[expr.index()];
                    Some(place(graph, expr, turned, &fused, &operands, &mut program))
                }
            };
            operands[expr.index()] = operand;
        }
        if phase {
            program.before_angles = program.steps.len();
        }
    }
    let at = |expr: &Expr| operands[expr.index()].expect("what is needed has been placed");
    program.results = results.iter().map(at).collect();
    program
}

/// Where the value of an expression is found, after adding what computes it, or its opposite where
/// it is turned.
fn place(
    graph: &Graph,
    expr: Expr,
    turned: bool,
    fused: &fuse::Fused,
    operands: &[Option<Operand>],
    program: &mut Program,
) -> Operand {
    if let Some(value) = graph.value(expr) {
        return Operand::Literal(value.to_f64() + 0.0);
    }
    let at = |expr: Expr| operands[expr.index()].expect("children come before parents");
    let node = graph.node(expr);
    let operation = match node {
        Node::Input(input) => return Operand::Input(input),
        Node::Sin(angle) => return Operand::Sin(angle_index(at(angle), program)),
        Node::Cos(angle) => return Operand::Cos(angle_index(at(angle), program)),
        Node::Neg(a) => Operation::Neg(at(a)),
        Node::Add(..) | Node::Sub(..) if fused.product_of(expr).is_some() => {
            let (a, b, rest, form) = fused.product_of(expr).expect("just seen");
            match form {
                fuse::Form::Plus => Operation::MulAdd(at(a), at(b), at(rest)),
                fuse::Form::Minus => Operation::MulSub(at(a), at(b), at(rest)),
                fuse::Form::From => Operation::NegMulAdd(at(a), at(b), at(rest)),
            }
        }
        Node::Add(a, b) => Operation::Add(at(a), at(b)),
        Node::Sub(a, b) => Operation::Sub(at(a), at(b)),
        Node::Mul(a, b) => Operation::Mul(at(a), at(b)),
        Node::Div(a, b) => Operation::Div(at(a), at(b)),
        Node::Sqrt(a) => Operation::Sqrt(at(a)),
        Node::Literal(_) | Node::Atan2(..) => unreachable!("a number has a value"),
    };
    let operation = if turned {
        opposite(operation)
    } else {
        operation
    };
    program.steps.push(Step {
        label: graph.label(expr),
        operation,
    });
    Operand::Step(index(program.steps.len() - 1))
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

fn angle_index(angle: Operand, program: &mut Program) -> u32 {
    let known = program.angles.iter().position(|&known| known == angle);
    index(known.unwrap_or_else(|| {
        program.angles.push(angle);
        program.angles.len() - 1
    }))
}

fn index(k: usize) -> u32 {
    u32::try_from(k).expect("fewer than 2³² steps")
}

/// Whether each needed expression takes part in an angle.
fn angles_first(graph: &Graph, needed: &[Expr]) -> Vec<bool> {
    let mut before = vec![false; graph.len()];
    for &expr in needed.iter().rev() {
        let node = graph.node(expr);
        if before[expr.index()] || matches!(node, Node::Sin(_) | Node::Cos(_)) {
            for child in node.operands() {
                before[child.index()] = true;
            }
        }
        if matches!(node, Node::Input(_)) || graph.value(expr).is_some() {
            before[expr.index()] = true;
        }
    }
    before
}
