//! Simplification: fewer operations for the same function.
//!
//! In: a graph and the requested expressions. Out: another graph with equal expressions, made once from the leaves to
//! the results, with the rules of [`rules`] tried at every sum. No rule adds operations, and none searches. The time is
//! in proportion to the graph, since cargo builds procedural macros without optimization.

pub mod rules;

use crate::expression::{Expr, Graph, Term};

/// The graph being made, and the number of future uses of its nodes.
pub struct Site<'g> {
    graph: &'g Graph,
    uses: Vec<u32>,
}

impl<'g> Site<'g> {
    /// True if only the current node uses an expression, so that it need not be computed if a rule takes it apart.
    fn once(&self, term: Term<'g>) -> bool {
        self.uses
            .get(term.expr().index())
            .is_none_or(|&uses| uses <= 1)
    }

    fn note(&mut self, term: Term<'g>, uses: u32) {
        let index = term.expr().index();
        if self.uses.len() <= index {
            self.uses.resize(index + 1, 0);
        }
        self.uses[index] += uses;
    }
}

/// Makes the expressions anew with fewer operations.
///
/// # Panics
/// If an expression is not of this graph.
#[must_use]
pub fn simplify(graph: &Graph, results: &[Expr]) -> (Graph, Vec<Expr>) {
    let made = Graph::new();
    let mut site = Site {
        graph: &made,
        uses: Vec::new(),
    };
    let (needed, uses) = graph.needed(results);
    let mut terms: Vec<Option<Term<'_>>> = vec![None; graph.len()];
    for expr in needed {
        let at = |expr: Expr| terms[expr.index()].expect("children come before parents");
        let plain = Term::of_node(&made, graph.node(expr), at);
        let term = rules::apply(&site, plain);
        if let Some(label) = graph.label(expr) {
            made.set_label(term.expr(), label);
        }
        site.note(term, uses[expr.index()]);
        terms[expr.index()] = Some(term);
    }
    let results = results
        .iter()
        .map(|result| {
            terms[result.index()]
                .expect("every result is needed")
                .expr()
        })
        .collect();
    (made, results)
}
