//! Derivatives of expressions, made on their own graph.
//!
//! In: expressions, and a direction of the inputs or a weight of each expression. Out: further expressions of the same
//! graph, in its canonical form, so that derivatives and values share nodes. [`along`] goes forward through the graph,
//! once a direction; [`gradient`] goes backward, once for all inputs. The derivative of a sign is zero everywhere, also
//! at its step.

use std::collections::BTreeMap;

use super::graph::{Expr, Graph, Input, Node};
use super::term::Term;

/// The derivative of each result along a direction of the inputs.
///
/// `direction` is the change of each input; `None` is no change.
///
/// # Panics
/// If an expression is not of this graph.
#[must_use]
pub fn along<'g>(
    graph: &'g Graph,
    results: &[Expr],
    direction: impl Fn(Input) -> Option<Term<'g>>,
) -> Vec<Term<'g>> {
    along_known(graph, results, |expr| match graph.node(expr) {
        Node::Input(input) => direction(input),
        _ => None,
    })
}

/// The same where the changes of some expressions are known: they are not those that their operands give them. An input
/// whose change is not known has none.
///
/// # Panics
/// If an expression is not of this graph.
#[must_use]
pub fn along_known<'g>(
    graph: &'g Graph,
    results: &[Expr],
    known: impl Fn(Expr) -> Option<Term<'g>>,
) -> Vec<Term<'g>> {
    let (needed, _) = graph.needed(results);
    let mut changes: Vec<Option<Term<'g>>> = vec![None; graph.len()];
    let mut turns: Vec<Option<Turn<'g>>> = vec![None; graph.len()];
    for expr in needed {
        let node = graph.node(expr);
        let change = if let Some(known) = known(expr) {
            Some(known)
        } else if let Some((change, turn)) = turned(graph, node, &changes, &turns) {
            turns[expr.index()] = turn;
            Some(change)
        } else {
            let slopes = slopes(graph, expr, node).into_iter();
            let parts = slopes.filter_map(|(of, slope)| Some(slope.times(changes[of.index()]?)));
            parts.reduce(|sum, part| sum + part)
        };
        changes[expr.index()] = change.filter(|change| !change.is_zero());
    }
    let results = results.iter();
    let zero = || graph.constant(0.0);
    results
        .map(|result| changes[result.index()].unwrap_or_else(zero))
        .collect()
}

/// A value that changes with an angle alone: a sine, a cosine, or either of a sum with a constant angle.
#[derive(Clone, Copy)]
struct Turn<'g> {
    /// Its derivative by the angle.
    slope: Term<'g>,
    /// The change of the angle.
    angle: Term<'g>,
}

impl<'g> Turn<'g> {
    fn change(self) -> Term<'g> {
        self.slope * self.angle
    }
}

/// The change of a value that an angle turns: of a sine or cosine, or of an entry c x + s y of a rotated vector. With the
/// entry beside it, c y − s x, which most often is computed already, the latter is c δx + s δy + (c y − s x) δα: fewer
/// operations than by the changes of c and s, and rotated vectors that bounds know as such. `None` of other values.
fn turned<'g>(
    graph: &'g Graph,
    node: Node,
    changes: &[Option<Term<'g>>],
    turns: &[Option<Turn<'g>>],
) -> Option<(Term<'g>, Option<Turn<'g>>)> {
    let (first, second, sign) = match node {
        Node::Sin(a) | Node::Cos(a) => {
            let angle = changes[a.index()]?;
            let (sine, cosine) = graph.term(a).sin_cos();
            let is_sine = matches!(node, Node::Sin(_));
            let slope = if is_sine { cosine } else { -sine };
            let turn = Turn { slope, angle };
            return Some((turn.change(), Some(turn)));
        }
        Node::Add(a, b) => (a, b, graph.constant(1.0)),
        Node::Sub(a, b) => (a, b, graph.constant(-1.0)),
        _ => return None,
    };
    // A product with what turns: its factor, and the turn with the factor that it has itself.
    let product = |of: Expr| {
        let Node::Mul(a, b) = graph.node(of) else {
            return None;
        };
        let by = |turned: Expr, other: Expr| Some((turned, turns[turned.index()]?, other));
        by(a, b).or_else(|| by(b, a))
    };
    let (by_first, turn, x) = product(first)?;
    let (by_second, other, y) = product(second)?;
    if turn.angle.expr() != other.angle.expr() {
        return None;
    }
    let beside = turn.slope * graph.term(x) + sign * (other.slope * graph.term(y));
    let whole = Turn {
        slope: beside,
        angle: turn.angle,
    };
    let part = |by: Expr, of: Expr| Some(graph.term(by) * changes[of.index()]?);
    let parts = [
        part(by_first, x),
        part(by_second, y).map(|part| sign * part),
    ];
    let moved = parts.into_iter().flatten().reduce(|sum, part| sum + part);
    match moved {
        Some(moved) => Some((moved + whole.change(), None)),
        None => Some((whole.change(), Some(whole))),
    }
}

/// The gradient of a contraction Σ wᵢ xᵢ of expressions xᵢ, whose weights wᵢ are taken for constants: its derivative by
/// each input that enters it. An input that is missing has the derivative zero.
///
/// # Panics
/// If an expression is not of this graph.
#[must_use]
pub fn gradient<'g>(
    graph: &'g Graph,
    contraction: &[(Expr, Term<'g>)],
) -> BTreeMap<Input, Term<'g>> {
    let results: Vec<Expr> = contraction.iter().map(|(result, _)| *result).collect();
    let (needed, _) = graph.needed(&results);
    // The derivative of the contraction by each node.
    let mut weights: Vec<Option<Term<'g>>> = vec![None; graph.len()];
    let add = |weights: &mut Vec<Option<Term<'g>>>, expr: Expr, part: Term<'g>| {
        let weight = &mut weights[expr.index()];
        *weight = Some(weight.map_or(part, |sum| sum + part));
    };
    for &(result, weight) in contraction {
        add(&mut weights, result, weight);
    }
    let mut gradient = BTreeMap::new();
    for expr in needed.into_iter().rev() {
        let weight = weights[expr.index()].filter(|weight| !weight.is_zero());
        let Some(weight) = weight else { continue };
        match graph.node(expr) {
            Node::Input(input) => {
                gradient.insert(input, weight);
            }
            node => {
                for (of, slope) in slopes(graph, expr, node) {
                    add(&mut weights, of, slope.times(weight));
                }
            }
        }
    }
    gradient
}

/// The derivative of a node by one of its operands.
#[derive(Clone, Copy)]
enum Slope<'g> {
    One,
    MinusOne,
    Of(Term<'g>),
}

impl<'g> Slope<'g> {
    fn times(self, change: Term<'g>) -> Term<'g> {
        match self {
            Self::One => change,
            Self::MinusOne => -change,
            Self::Of(slope) => slope * change,
        }
    }
}

/// The derivatives of a node by its operands: one entry for each operand that changes it.
fn slopes(graph: &Graph, expr: Expr, node: Node) -> Vec<(Expr, Slope<'_>)> {
    let term = |expr: Expr| graph.term(expr);
    if graph.value(expr).is_some() {
        return Vec::new();
    }
    match node {
        Node::Literal(_) | Node::Input(_) | Node::Sign(_) => Vec::new(),
        Node::Neg(a) => vec![(a, Slope::MinusOne)],
        Node::Add(a, b) => vec![(a, Slope::One), (b, Slope::One)],
        Node::Sub(a, b) => vec![(a, Slope::One), (b, Slope::MinusOne)],
        Node::Mul(a, b) => vec![(a, Slope::Of(term(b))), (b, Slope::Of(term(a)))],
        // (a/b)′ = a′/b − (a/b) b′/b.
        Node::Div(a, b) => {
            let reciprocal = graph.constant(1.0) / term(b);
            let by_divisor = -(term(expr) * reciprocal);
            vec![(a, Slope::Of(reciprocal)), (b, Slope::Of(by_divisor))]
        }
        Node::Sqrt(a) => vec![(a, Slope::Of(graph.constant(0.5) / term(expr)))],
        Node::Sin(a) => vec![(a, Slope::Of(term(a).sin_cos().1))],
        Node::Cos(a) => vec![(a, Slope::Of(-term(a).sin_cos().0))],
        Node::Taken(a, _) | Node::Made(a) => vec![(a, Slope::One)],
    }
}

#[cfg(test)]
mod tests;
