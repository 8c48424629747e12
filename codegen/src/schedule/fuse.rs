//! Choice of the sums that combine with a product to a fused operation.
//!
//! In: a graph and its needed expressions. Out: a choice for each sum. A difference of two products that may cancel at
//! run time is not fused: with one product rounded and the other not, it would return the rounding error.

use crate::expression::{Expr, Graph, Node};

/// Form of a fused operation.
#[derive(Clone, Copy)]
pub enum FusedForm {
    /// a b + c.
    Plus,
    /// a b − c.
    Minus,
    /// c − a b.
    From,
}

/// Fused sums, and the products that only they read.
pub struct Fused {
    product_of: Vec<Option<(Expr, Expr, Expr, FusedForm)>>,
    vanishes: Vec<bool>,
}

impl Fused {
    /// No fused sums, in a graph with this number of nodes.
    pub fn nothing(nodes: usize) -> Self {
        Self {
            product_of: vec![None; nodes],
            vanishes: vec![false; nodes],
        }
    }

    /// Factors, other term and form of a fused sum.
    pub fn product_of(&self, sum: Expr) -> Option<(Expr, Expr, Expr, FusedForm)> {
        self.product_of[sum.index()]
    }

    /// True if a product is computed only inside a fused sum.
    pub fn vanishes(&self, product: Expr) -> bool {
        self.vanishes[product.index()]
    }
}

/// Chooses at most one product for each sum, among those that no other expression reads.
pub fn choose(graph: &Graph, needed: &[Expr], uses: &[u32]) -> Fused {
    let mut fused = Fused::nothing(uses.len());
    let product = |expr: Expr| match graph.node(expr) {
        Node::Mul(a, b) if uses[expr.index()] == 1 && graph.value(expr).is_none() => Some((a, b)),
        _ => None,
    };
    for &sum in needed {
        let (a, b, forms) = match graph.node(sum) {
            Node::Add(a, b) => (a, b, [FusedForm::Plus, FusedForm::Plus]),
            Node::Sub(a, b) => (a, b, [FusedForm::Minus, FusedForm::From]),
            _ => continue,
        };
        if graph.value(sum).is_some()
            || (matches!(forms[1], FusedForm::From) && can_cancel(graph, a, b))
        {
            continue;
        }
        // The product that is computed later has the longer latency; fusing it shortens the chain.
        let candidates = [(a, b, forms[0]), (b, a, forms[1])];
        let best = candidates
            .into_iter()
            .filter(|&(p, ..)| product(p).is_some())
            .max_by_key(|&(p, ..)| p);
        if let Some((p, rest, form)) = best
            && let Some((x, y)) = product(p)
        {
            fused.product_of[sum.index()] = Some((x, y, rest, form));
            fused.vanishes[p.index()] = true;
        }
    }
    fused
}

/// True if both are products of values that depend on the state. A literal, sine or cosine as a factor excludes that
/// the two products are equal.
fn can_cancel(graph: &Graph, a: Expr, b: Expr) -> bool {
    let free = |expr: Expr| match graph.node(expr) {
        Node::Mul(x, y) => [x, y].into_iter().all(|factor| {
            graph.value(factor).is_none()
                && !matches!(graph.node(factor), Node::Sin(_) | Node::Cos(_))
        }),
        _ => false,
    };
    free(a) && free(b)
}

#[cfg(test)]
mod tests {
    use crate::expression::{Graph, Input, Term};
    use crate::schedule::{Operation, schedule};
    use crate::space::Variable;

    /// Operations of a ○ b, with a and b products of values that depend on the state.
    fn operations(combine: for<'g> fn(Term<'g>, Term<'g>) -> Term<'g>) -> Vec<Operation> {
        let graph = Graph::new();
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| graph.input(Input::Variable(Variable::Qd, k)));
        let program = schedule(&graph, &[combine(a * b, c * d).expr()]);
        program.steps.iter().map(|step| step.operation).collect()
    }

    /// Fused on one side, a b − b a would be the rounding error of one product and not zero.
    #[test]
    fn a_difference_of_products_that_can_cancel_is_not_fused() {
        let operations = operations(|x, y| x - y);
        assert_eq!(operations.len(), 3, "{operations:?}");
        assert!(
            !operations.iter().any(Operation::is_fused),
            "{operations:?}"
        );
    }

    #[test]
    fn a_sum_of_products_fuses_with_one() {
        let operations = operations(|x, y| x + y);
        assert_eq!(operations.len(), 2, "{operations:?}");
        assert!(operations[1].is_fused(), "{operations:?}");
    }
}
