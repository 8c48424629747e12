//! The program of one layout and one way, whatever it costs.

use crate::chain::Chain;
use crate::expression::{Expr, Graph, Term};
use crate::function::Function;
use crate::layout::{Bodies, Layout, arrange};
use crate::model::{Way, equation, equation_at_rest};
use crate::schedule::{Program, schedule};
use crate::simplify::simplify;
use crate::space::FrameId;

/// The program that a layout and a way give.
#[must_use]
pub fn program_by(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    layout: Layout,
    way: Way,
) -> Program {
    let (graph, results) = expressions_by(chain, functions, frame, layout, way);
    schedule(&graph, &results)
}

/// The program of what accelerations are solved from: the mass matrix, and the torques at q̈ = 0, under actions
/// from outside where there are any; and those of given accelerations, where a residual is made of them.
pub(super) fn equation_by(chain: &Chain, layout: Layout, way: Way, has_residual: bool) -> Program {
    compiled(chain, layout, |graph, bodies| {
        equation(graph, bodies, way, has_residual)
    })
}

/// The same of what the inverse of the mass matrix is refined from.
pub(super) fn equation_at_rest_by(chain: &Chain, layout: Layout, way: Way) -> Program {
    compiled(chain, layout, |graph, bodies| {
        equation_at_rest(graph, bodies, way)
    })
}

fn compiled(
    chain: &Chain,
    layout: Layout,
    results: impl for<'g> FnOnce(&'g Graph, &Bodies<'g>) -> Vec<Term<'g>>,
) -> Program {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, layout);
    let results = results(&graph, &bodies).into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    let (graph, results) = simplify(&graph, &results);
    schedule(&graph, &results)
}

/// What that program computes, with all its numbers as they came about.
#[must_use]
pub fn expressions_by(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    layout: Layout,
    way: Way,
) -> (Graph, Vec<Expr>) {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, layout);
    let results: Vec<Expr> = (functions.iter())
        .flat_map(|&function| function.build(&graph, &bodies, frame, way))
        .map(Term::expr)
        .collect();
    simplify(&graph, &results)
}
