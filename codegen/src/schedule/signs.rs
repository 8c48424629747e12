//! Signs: values that are computed with the opposite sign, which is free and saves a negation or gives a matrix entry
//! its own name.
//!
//! In: a graph, its needed expressions, and its fused sums. Out: a sign for each expression. No operation is added:
//! a − b and b − a cost the same, and literals are negated during generation.

use super::fuse::{Fused, FusedForm};
use crate::expression::{Expr, Graph, Node};

/// Signs with which expressions are computed.
pub struct Signs {
    turned: Vec<bool>,
    /// Expressions that are literals, which may have any sign.
    numbers: Vec<bool>,
}

impl Signs {
    /// True if the negative of an expression is computed.
    pub fn turned(&self, expr: Expr) -> bool {
        self.turned[expr.index()]
    }

    /// True if the product of the operands that hold the factors is −x y.
    pub fn of_factors(&self, x: Expr, y: Expr) -> bool {
        self.turned(x) != self.turned(y)
    }

    /// True if the product of the operands that hold the factors is the negative of the operand that holds the product.
    pub fn of_product(&self, x: Expr, y: Expr, product: Expr) -> bool {
        self.of_factors(x, y) != self.turned(product)
    }

    /// Chooses from the leaves to the results: if both signs are free, the preferred one.
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
                        FusedForm::Plus => sum(product, rest),
                        FusedForm::Minus => sum(product, rest.map(|minus| !minus)),
                        FusedForm::From => sum(product.map(|minus| !minus), rest),
                    }
                }
                (Node::Neg(a), _) => Some(!signs.turned(a)),
                (Node::Add(a, b), _) => sum(signs.term(a), signs.term(b)),
                (Node::Sub(a, b), _) => sum(signs.term(a), signs.term(b).map(|minus| !minus)),
                (Node::Mul(a, _), _) if signs.numbers[a.index()] => None,
                (Node::Mul(a, b) | Node::Div(a, b), _) => Some(signs.of_factors(a, b)),
                // sin(−a) = −sin a and cos(−a) = cos a.
                (Node::Made(a) | Node::Sin(a), _) => Some(signs.turned(a)),
                _ => Some(false),
            };
            signs.turned[expr.index()] = forced.unwrap_or(wishes[expr.index()] == Some(true));
        }
        signs
    }

    /// True if a term is computed with the opposite sign; `None` for a literal, which may have either.
    fn term(&self, expr: Expr) -> Option<bool> {
        (!self.numbers[expr.index()]).then(|| self.turned(expr))
    }
}

/// Preferred signs: results and labelled matrix entries prefer their own sign; operands prefer the sign of the value
/// that reads them, if that saves a negation.
fn wishes(graph: &Graph, needed: &[Expr], results: &[Expr]) -> Vec<Option<bool>> {
    let mut wishes = vec![None; graph.len()];
    for &result in results {
        wishes[result.index()].get_or_insert(false);
    }
    for &expr in needed.iter().rev() {
        // The sign of what is made by equal computations does not depend on its reader.
        if let Node::Made(a) = graph.node(expr) {
            wishes[a.index()].get_or_insert(false);
            continue;
        }
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

/// Common sign of both terms, which the sum inherits; `None` if a sum with either sign costs the same.
fn sum(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    match (a, b) {
        (Some(a), Some(b)) if a == b => Some(a),
        _ => None,
    }
}
