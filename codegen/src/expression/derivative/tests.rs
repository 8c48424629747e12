//! Tests of each rule of differentiation, forward and backward, against known derivatives.

use super::{along, along_known, gradient};
use crate::expression::{Double, Graph, Input, Term, evaluate};
use crate::space::Variable;

const X: Input = Input::Variable(Variable::Q, 0);
const Y: Input = Input::Variable(Variable::Q, 1);

/// The point at which all rules are tested.
const AT: [f64; 2] = [0.7, -1.3];

fn number(graph: &Graph, term: Term<'_>) -> f64 {
    let at = |input| Double::from(if input == X { AT[0] } else { AT[1] });
    evaluate(graph, &[term.expr()], at)[0].to_f64()
}

/// Asserts both derivatives of a function of x and y, found forward and backward.
#[track_caller]
fn assert_derivatives(
    function: impl for<'g> Fn(Term<'g>, Term<'g>) -> Term<'g>,
    expected: [f64; 2],
) {
    let graph = Graph::new();
    let [x, y] = [X, Y].map(|input| graph.input(input));
    let result = function(x, y);
    let backward = gradient(&graph, &[(result.expr(), graph.constant(1.0))]);
    for (input, expected) in [X, Y].into_iter().zip(expected) {
        let direction = |of| (of == input).then(|| graph.constant(1.0));
        let forward = number(&graph, along(&graph, &[result.expr()], direction)[0]);
        let backward = backward.get(&input).map_or(0.0, |&by| number(&graph, by));
        for found in [forward, backward] {
            let off = (found - expected).abs();
            assert!(
                off <= 4e-16 * expected.abs(),
                "{input:?}: {found} {expected}"
            );
        }
    }
}

#[test]
fn sums_and_differences() {
    assert_derivatives(|x, y| x + y, [1.0, 1.0]);
    assert_derivatives(|x, y| y - x, [-1.0, 1.0]);
    assert_derivatives(|x, _| -x, [-1.0, 0.0]);
    assert_derivatives(|x, _| x - x.graph().constant(3.0), [1.0, 0.0]);
}

#[test]
fn products_and_quotients() {
    let [x, y] = AT;
    assert_derivatives(|x, y| x * y, [y, x]);
    assert_derivatives(|x, _| x * x, [2.0 * x, 0.0]);
    assert_derivatives(|x, y| x / y, [1.0 / y, -x / (y * y)]);
    assert_derivatives(|x, _| x / x, [0.0, 0.0]);
    assert_derivatives(|x, _| x.graph().constant(3.0) / x, [-3.0 / (x * x), 0.0]);
}

#[test]
fn roots() {
    assert_derivatives(|x, _| x.sqrt(), [0.5 / AT[0].sqrt(), 0.0]);
}

#[test]
fn sines_and_cosines() {
    let (sine, cosine) = AT[0].sin_cos();
    assert_derivatives(|x, _| x.sin_cos().0, [cosine, 0.0]);
    assert_derivatives(|x, _| x.sin_cos().1, [-sine, 0.0]);
    assert_derivatives(|_, y| (y + y).sin_cos().0, [0.0, 2.0 * (2.0 * AT[1]).cos()]);
}

#[test]
fn signs_are_constant() {
    assert_derivatives(|x, y| x.sign() * y, [0.0, 1.0]);
}

#[test]
fn several_equal_computations_are_distinct_and_have_equal_derivatives() {
    assert_derivatives(|x, y| x.taken_by(3) * y, [AT[1], AT[0]]);
}

#[test]
fn constants_and_unchanged_inputs_have_the_derivative_zero() {
    let graph = Graph::new();
    let three = graph.constant(3.0);
    let x = graph.input(X);
    let found = along(&graph, &[three.expr(), x.expr()], |_| None);
    assert!(found.iter().all(|change| change.is_zero()));
    assert!(gradient(&graph, &[(three.expr(), three)]).is_empty());
    assert!(gradient(&graph, &[(x.expr(), graph.constant(0.0))]).is_empty());
}

#[test]
fn a_direction_may_be_an_expression() {
    let graph = Graph::new();
    let [x, y] = [X, Y].map(|input| graph.input(input));
    let found = along(&graph, &[(x * x).expr()], |input| (input == X).then_some(y));
    assert_eq!(number(&graph, found[0]), 2.0 * AT[0] * AT[1]);
}

#[test]
fn a_contraction_sums_the_gradients_of_its_parts() {
    let graph = Graph::new();
    let [x, y] = [X, Y].map(|input| graph.input(input));
    let weights = [2.0, -5.0].map(|weight| graph.constant(weight));
    let parts = [((x * y).expr(), weights[0]), (x.expr(), weights[1])];
    let found = gradient(&graph, &parts);
    assert_eq!(number(&graph, found[&X]), 2.0 * AT[1] - 5.0);
    assert_eq!(number(&graph, found[&Y]), 2.0 * AT[0]);
}

#[test]
fn the_second_derivative_is_the_derivative_of_the_first() {
    let graph = Graph::new();
    let x = graph.input(X);
    let unit = |input| (input == X).then(|| graph.constant(1.0));
    let first = along(&graph, &[(x.sin_cos().0 * x).expr()], unit)[0];
    let second = along(&graph, &[first.expr()], unit)[0];
    let expected = 2.0 * AT[0].cos() - AT[0] * AT[0].sin();
    assert!((number(&graph, second) - expected).abs() < 1e-15);
}

/// An entry of a rotated vector takes the entry beside it, with an offset of the angle, too.
#[test]
fn rotated_vectors_turn_into_the_entry_beside() {
    let [q, d, a, b] = [0, 1, 2, 3].map(|k| Input::Variable(Variable::Q, k));
    for offset in [None, Some(0.3_f64)] {
        let graph = Graph::new();
        let [angle, turn, x, y] = [q, d, a, b].map(|input| graph.input(input));
        let (sine, cosine) = angle.sin_cos();
        let (sine, cosine) = match offset {
            None => (sine, cosine),
            Some(offset) => {
                let [s, c] = [offset.sin(), offset.cos()].map(|value| graph.constant(value));
                (sine * c + cosine * s, cosine * c - sine * s)
            }
        };
        let (first, second) = (cosine * x + sine * y, cosine * y - sine * x);
        let results = [first.expr(), second.expr()];
        let found = along(&graph, &results, |input| (input == q).then_some(turn));
        for (found, expected) in found.into_iter().zip([second * turn, -(first * turn)]) {
            assert_eq!(found.expr(), expected.expr(), "{offset:?}");
        }
        // A change of the vector is rotated with it.
        let moved = along(&graph, &results, |input| match input {
            _ if input == q => Some(turn),
            _ if input == a => Some(graph.constant(2.0)),
            _ => None,
        });
        let expected = cosine * graph.constant(2.0) + second * turn;
        assert_eq!(moved[0].expr(), expected.expr());
    }
}

#[test]
fn known_changes_of_expressions_replace_those_of_their_operands() {
    let graph = Graph::new();
    let [x, y] = [X, Y].map(|input| graph.input(input));
    let square = x * x;
    let result = square * y;
    let found = along_known(&graph, &[result.expr()], |expr| match expr {
        _ if expr == square.expr() => Some(graph.constant(5.0)),
        _ if expr == x.expr() || expr == y.expr() => Some(graph.constant(1.0)),
        _ => None,
    });
    let expected = graph.constant(5.0) * y + square;
    assert!((number(&graph, found[0]) - number(&graph, expected)).abs() < 1e-15);
}
