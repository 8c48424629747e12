//! Terms in place of inputs.
//!
//! In: expressions, and a term for some of their inputs. Out: the same expressions of these terms, on the same graph and
//! in its canonical form. What does not depend on these inputs stays as it is.

use super::graph::{Expr, Graph, Input, Node};
use super::term::Term;

/// Each result with terms in place of inputs; `None` leaves an input.
///
/// # Panics
/// If an expression is not of this graph.
#[must_use]
pub fn substitute<'g>(
    graph: &'g Graph,
    results: &[Expr],
    term: impl Fn(Input) -> Option<Term<'g>>,
) -> Vec<Term<'g>> {
    let (needed, _) = graph.needed(results);
    // The terms of the expressions that depend on these inputs.
    let mut changed: Vec<Option<Term<'g>>> = vec![None; graph.len()];
    for expr in needed {
        let node = graph.node(expr);
        changed[expr.index()] = if let Node::Input(input) = node {
            term(input)
        } else {
            let depends = node.operands().any(|of| changed[of.index()].is_some());
            let at = |of: Expr| changed[of.index()].unwrap_or_else(|| graph.term(of));
            depends.then(|| Term::of_node(graph, node, at))
        };
    }
    let results = results.iter();
    results
        .map(|result| changed[result.index()].unwrap_or_else(|| graph.term(*result)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::substitute;
    use crate::expression::{Graph, Input, Term};
    use crate::space::Variable;

    fn entry(k: u16) -> Input {
        Input::Variable(Variable::Q, k)
    }

    /// A sum of products with an input, by the root of the input.
    fn of([first, second, input]: [Term<'_>; 3]) -> Term<'_> {
        (first * input + second) / input.sqrt()
    }

    #[test]
    fn what_does_not_depend_on_an_input_is_the_same_node() {
        let graph = Graph::new();
        let [x, y, z] = [0, 1, 2].map(|k| graph.input(entry(k)));
        let (sine, cosine) = x.sin_cos();
        let kept = sine * z;
        let results = [of([cosine, kept, y]).expr(), kept.expr()];
        let found = substitute(&graph, &results, |input| (input == entry(1)).then(|| z + z));
        assert_eq!(found[0].expr(), of([cosine, kept, z + z]).expr());
        assert_eq!(found[1].expr(), kept.expr());
    }
}
