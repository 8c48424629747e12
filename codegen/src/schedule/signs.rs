//! Which values are computed with the opposite sign, because that is free and saves a sign change
//! later or gives a matrix entry its own name instead of its negative's.
//!
//! In: a graph, what is needed of it, and what is fused. Out: a sign for each expression. It never
//! costs an operation: a − b and b − a are one each, and a number takes a sign in.

use super::fuse::{Form, Fused};
use crate::expression::{Expr, Graph, Node};

/// The signs under which expressions are computed.
pub struct Signs {
    turned: Vec<bool>,
    /// Numbers, which take any sign.
    numbers: Vec<bool>,
}

impl Signs {
    /// Whether the opposite of an expression is what is computed.
    pub fn turned(&self, expr: Expr) -> bool {
        self.turned[expr.index()]
    }

    /// Whether a minus stands before the product of what is computed for the factors.
    pub fn of_factors(&self, x: Expr, y: Expr) -> bool {
        self.turned(x) != self.turned(y)
    }

    /// Whether the product of the factors as found is the opposite of the product as computed.
    pub fn of_product(&self, x: Expr, y: Expr, product: Expr) -> bool {
        self.of_factors(x, y) != self.turned(product)
    }

    /// Chooses from the leaves to the results: where both signs are free, the one that is wished.
    pub fn choose(graph: &Graph, needed: &[Expr], results: &[Expr], fused: &Fused) -> Self {
        let wishes = wishes(graph, needed, results);
        let mut signs = Self {
            turned: vec![false; graph.len()],
            numbers: vec![false; graph.len()],
        };
        for &expr in needed {
            if graph.value(expr).is_some() {
                signs.numbers[expr.index()] = true;
                continue;
            }
            let forced = match (graph.node(expr), fused.product_of(expr)) {
                (_, Some((x, y, rest, form))) => {
                    let product = if signs.numbers[x.index()] {
                        None
                    } else {
                        Some(signs.of_factors(x, y))
                    };
                    let (product, rest) = (product, signs.term(rest));
                    match form {
                        Form::Plus => sum(product, rest),
                        Form::Minus => sum(product, rest.map(|minus| !minus)),
                        Form::From => sum(product.map(|minus| !minus), rest),
                    }
                }
                (Node::Neg(a), _) => Some(!signs.turned(a)),
                (Node::Add(a, b), _) => sum(signs.term(a), signs.term(b)),
                (Node::Sub(a, b), _) => sum(signs.term(a), signs.term(b).map(|minus| !minus)),
                (Node::Mul(a, _), _) if signs.numbers[a.index()] => None,
                (Node::Mul(a, b) | Node::Div(a, b), _) => Some(signs.of_factors(a, b)),
                // Of the opposite angle it is the opposite; the cosine is the same.
                (Node::Sin(a), _) => Some(signs.turned(a)),
                _ => Some(false),
            };
            signs.turned[expr.index()] = forced.unwrap_or(wishes[expr.index()] == Some(true));
        }
        signs
    }

    /// The sign of a term; none where it is a number and may have either.
    fn term(&self, expr: Expr) -> Option<bool> {
        (!self.numbers[expr.index()]).then(|| self.turned(expr))
    }
}

/// Whether a value had better be turned: a result by the sign it is wanted with, an entry of a
/// matrix by its name, and what a sum of equal signs is made of like the sum.
fn wishes(graph: &Graph, needed: &[Expr], results: &[Expr]) -> Vec<Option<bool>> {
    let mut wishes = vec![None; graph.len()];
    for &result in results {
        wishes[result.index()].get_or_insert(false);
    }
    for &expr in needed.iter().rev() {
        let named = || graph.label(expr).map(|label| label.negative);
        let Some(wish) = wishes[expr.index()].or_else(named) else {
            continue;
        };
        wishes[expr.index()] = Some(wish);
        let mut pass_on = |child: Expr, wish| {
            wishes[child.index()].get_or_insert(wish);
        };
        match graph.node(expr) {
            Node::Add(a, b) => {
                pass_on(a, wish);
                pass_on(b, wish);
            }
            Node::Neg(a) => pass_on(a, !wish),
            Node::Taken(a, _) => pass_on(a, false),
            Node::Mul(_, b) => pass_on(b, wish),
            _ => {}
        }
    }
    wishes
}

/// The sign that a sum must have because both terms have it; none where both are free.
fn sum(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    match (a, b) {
        (Some(a), Some(b)) if a == b => Some(a),
        _ => None,
    }
}
