//! Tests of sums in the canonical form.

use super::{Graph, Input, Node};
use crate::expression::Term;
use crate::space::Variable;

fn x(graph: &Graph) -> Term<'_> {
    graph.input(Input::Variable(Variable::Q, 0))
}

/// The constant of an expression that is a multiple of x, to the last of 106 bits.
fn times_x(graph: &Graph, term: Term<'_>) -> Option<f64> {
    let (sign, expr) = match graph.node(term.expr()) {
        Node::Neg(inner) => (-1.0, inner),
        _ => (1.0, term.expr()),
    };
    match graph.node(expr) {
        Node::Mul(k, of) if of == x(graph).expr() => Some(sign * graph.value(k)?.to_f64()),
        _ => None,
    }
}

#[test]
fn multiples_of_one_expression_are_collected_whatever_else_uses_them() {
    let graph = Graph::new();
    let x = x(&graph);
    let [k, l] = [2.5, 0.75].map(|k| graph.constant(k));
    assert_eq!(times_x(&graph, k * x + l * x), Some(3.25));
    assert_eq!(times_x(&graph, k * x - l * x), Some(1.75));
    assert_eq!(times_x(&graph, l * x - k * x), Some(-1.75));
    assert_eq!(times_x(&graph, -(k * x) - l * x), Some(-3.25));
    assert_eq!(times_x(&graph, x + k * x), Some(3.5));
    assert_eq!(times_x(&graph, x - k * x), Some(-1.5));
    assert!((k * x - k * x).is_zero());
    // Two equal terms are a sum, which costs no more.
    assert!(matches!(graph.node((x + x).expr()), Node::Add(..)));
}

#[test]
fn constants_that_cancel_keep_all_their_digits() {
    let graph = Graph::new();
    let x = x(&graph);
    let third = graph.constant(1.0) / graph.constant(3.0);
    let close = third + graph.constant(1e-12);
    let found = times_x(&graph, close * x - third * x).expect("a multiple");
    // With constants rounded to 64 bits four digits would be left.
    assert!((found / 1e-12 - 1.0).abs() < 1e-15, "{found:e}");
}

#[test]
fn equal_operations_are_one_expression_and_others_are_not() {
    let graph = Graph::new();
    let input = |k| graph.input(Input::Variable(Variable::Q, k));
    let all = || {
        let pairs = (0..40).flat_map(|i| (0..i).map(move |j| (input(i), input(j))));
        let made = pairs.flat_map(|(a, b)| [a + b, a - b, a * b, a / b, (a * b).sin_cos().0]);
        made.map(Term::expr).collect::<Vec<_>>()
    };
    let first = all();
    let nodes = graph.len();
    assert_eq!(all(), first);
    assert_eq!(graph.len(), nodes, "nothing is made twice");
    let mut different = first.clone();
    different.sort_unstable();
    different.dedup();
    assert_eq!(different.len(), first.len());
}

#[test]
fn needed_expressions_are_counted_by_their_readers() {
    let graph = Graph::new();
    let x = x(&graph);
    let square = x * x;
    let unused = square + x;
    let sum = square + square * square;
    let (needed, uses) = graph.needed(&[sum.expr(), sum.expr()]);
    assert!(needed.is_sorted() && !needed.contains(&unused.expr()));
    let of = |term: Term<'_>| uses[term.expr().index()];
    assert_eq!([of(x), of(square), of(sum), of(unused)], [2, 3, 2, 0]);
}
