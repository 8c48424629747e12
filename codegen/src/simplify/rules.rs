//! Rules of simplification: a table of named equations by which sums become cheaper.
//!
//! In: a sum of the graph being made. Out: an equal expression with fewer operations, or `None`. Rules rely on the
//! canonical form of the graph (constants first, signs outermost) and go in one direction. Each has its equation beside
//! it and its own test.

use super::Site;
use crate::expression::{Node, Term};

/// A directional equation.
pub struct Rule {
    /// Its name in tests.
    pub name: &'static str,
    /// Its equation.
    pub equation: &'static str,
    apply: for<'g> fn(&Site<'g>, &Sum<'g>) -> Option<Term<'g>>,
}

/// The rules in the order in which they are tried.
#[rustfmt::skip]
pub const RULES: &[Rule] = &[
    Rule { name: "pythagoras",        equation: "sin² x + cos² x = 1",       apply: pythagoras },
    Rule { name: "cancel",            equation: "(a ± b) ∓ b = a",           apply: cancel },
    Rule { name: "gather_constants",  equation: "k ± (l ± x) = (k ± l) ± x", apply: gather_constants },
    Rule { name: "common_factor",     equation: "a b ± a c = a (b ± c)",     apply: common_factor },
];

/// a + b, or a − b, of operands without sign.
struct Sum<'g> {
    a: Term<'g>,
    b: Term<'g>,
    minus: bool,
}

/// The result of the first rule that fits, or the term itself.
pub(super) fn apply<'g>(site: &Site<'g>, term: Term<'g>) -> Term<'g> {
    let Some(sum) = sum(site, term) else {
        return term;
    };
    RULES
        .iter()
        .find_map(|rule| (rule.apply)(site, &sum))
        .unwrap_or(term)
}

/// The term as a sum; constants are folded already.
fn sum<'g>(site: &Site<'g>, term: Term<'g>) -> Option<Sum<'g>> {
    if term.value().is_some() {
        return None;
    }
    let at = |expr| site.graph.term(expr);
    match site.graph.node(term.expr()) {
        Node::Add(a, b) => Some(Sum {
            a: at(a),
            b: at(b),
            minus: false,
        }),
        Node::Sub(a, b) => Some(Sum {
            a: at(a),
            b: at(b),
            minus: true,
        }),
        _ => None,
    }
}

impl<'g> Sum<'g> {
    /// Both operands, each with true if a minus stands before it.
    const fn signed(&self) -> [(bool, Term<'g>); 2] {
        [(false, self.a), (self.minus, self.b)]
    }

    fn of(&self, a: Term<'g>, b: Term<'g>) -> Term<'g> {
        if self.minus { a - b } else { a + b }
    }
}

/// The factors of a product.
fn factors<'g>(site: &Site<'g>, term: Term<'g>) -> Option<(Term<'g>, Term<'g>)> {
    match site.graph.node(term.expr()) {
        Node::Mul(a, b) => Some((site.graph.term(a), site.graph.term(b))),
        _ => None,
    }
}

fn pythagoras<'g>(site: &Site<'g>, sum: &Sum<'g>) -> Option<Term<'g>> {
    let square = |term| match factors(site, term) {
        Some((a, b)) if a.expr() == b.expr() => Some(site.graph.node(a.expr())),
        _ => None,
    };
    match (square(sum.a)?, square(sum.b)?) {
        (Node::Sin(x), Node::Cos(y)) | (Node::Cos(y), Node::Sin(x)) if x == y && !sum.minus => {
            Some(site.graph.constant(1.0))
        }
        _ => None,
    }
}

fn cancel<'g>(site: &Site<'g>, outer: &Sum<'g>) -> Option<Term<'g>> {
    let [a, b] = outer.signed();
    [(a, b), (b, a)]
        .into_iter()
        .find_map(|((minus, group), (other_minus, other))| {
            let [x, y] = sum(site, group)?.signed();
            [(x, y), (y, x)]
                .into_iter()
                .find_map(|((x_minus, x), (y_minus, y))| {
                    let opposite = (minus != x_minus) != other_minus;
                    let rest = if minus == y_minus { y } else { -y };
                    (opposite && x.expr() == other.expr()).then_some(rest)
                })
        })
}

fn gather_constants<'g>(site: &Site<'g>, outer: &Sum<'g>) -> Option<Term<'g>> {
    outer.a.value().or_else(|| outer.b.value())?;
    let constant_first = outer.a.value().is_some();
    let (constant, rest) = if constant_first {
        (outer.a, outer.b)
    } else {
        (outer.b, outer.a)
    };
    let inner = sum(site, rest).filter(|_| site.once(rest))?;
    // rest = l ± x or x − l
    let (number, x, x_minus) = match (inner.a.value(), inner.b.value()) {
        (Some(_), None) => (inner.a, inner.b, inner.minus),
        (None, Some(_)) if inner.minus => (-inner.b, inner.a, false),
        (None, Some(_)) => (inner.b, inner.a, false),
        _ => return None,
    };
    let signed = if x_minus { -x } else { x };
    Some(match (outer.minus, constant_first) {
        (false, _) => constant + number + signed,
        (true, true) => (constant - number) - signed,
        (true, false) => (number - constant) + signed,
    })
}

fn common_factor<'g>(site: &Site<'g>, sum: &Sum<'g>) -> Option<Term<'g>> {
    if !site.once(sum.a) || !site.once(sum.b) {
        return None;
    }
    let ((a, b), (c, d)) = (factors(site, sum.a)?, factors(site, sum.b)?);
    [(a, b, c, d), (a, b, d, c), (b, a, c, d), (b, a, d, c)]
        .into_iter()
        .find(|(common, _, other, _)| common.expr() == other.expr())
        .map(|(common, left, _, right)| common * sum.of(left, right))
}

#[cfg(test)]
mod tests {
    use homogen_random::Random;

    use super::RULES;
    use crate::expression::{Double, Graph, Input, Term};
    use crate::schedule::{OperationCount, Program, run, schedule};
    use crate::simplify::simplify;
    use crate::space::Variable;

    fn input(graph: &Graph, k: u16) -> Term<'_> {
        graph.input(Input::Variable(Variable::Q, k))
    }

    fn evaluate(program: &Program) -> Double {
        run(program, |input| match input {
            Input::Variable(Variable::Q, k) => Double::from([0.3, -1.7, 2.9, 0.45][usize::from(k)]),
            _ => unreachable!("only q is used"),
        })[0]
    }

    /// The numbers of operations before and after, of an expression whose value must stay.
    fn operations(make: impl for<'g> Fn(&'g Graph) -> Term<'g>) -> (usize, usize) {
        let graph = Graph::new();
        let result = [make(&graph).expr()];
        let before = schedule(&graph, &result);
        let (made, result) = simplify(&graph, &result);
        let after = schedule(&made, &result);
        let (x, y) = (evaluate(&before), evaluate(&after));
        assert!((x - y).is_zero(), "{x:?} became {y:?}");
        let count = |program| {
            let operation_count = OperationCount::of(program);
            operation_count.mul + operation_count.add + operation_count.neg
        };
        (count(&before), count(&after))
    }

    #[test]
    fn every_rule_has_a_name_and_an_equation_of_its_own() {
        for (k, rule) in RULES.iter().enumerate() {
            assert!(rule.equation.contains('='), "{}", rule.name);
            assert!(
                RULES[..k].iter().all(|other| other.name != rule.name),
                "{}",
                rule.name
            );
        }
    }

    #[test]
    fn pythagoras() {
        let (before, after) = operations(|graph| {
            let (sine, cosine) = input(graph, 0).sin_cos();
            (sine * sine + cosine * cosine) * input(graph, 1)
        });
        assert_eq!((before, after), (4, 0));
    }

    #[test]
    fn cancel() {
        for [outer, inner] in [[0, 1], [1, 0], [1, 1]] {
            let (before, after) = operations(|graph| {
                let (a, b) = (input(graph, 0), input(graph, 1));
                let sum = if inner == 0 { a + b } else { a - b };
                let around = if inner == outer { a } else { b };
                (if outer == 0 {
                    sum + around
                } else {
                    sum - around
                }) * input(graph, 2)
            });
            assert!(after < before && after <= 2, "{outer} {inner}: {after}");
        }
    }

    #[test]
    fn gather_constants() {
        type Make = for<'g> fn(&'g Graph, Term<'g>, Term<'g>) -> Term<'g>;
        let makes: [Make; 4] = [
            |graph, k, l| k + (l + input(graph, 0)),
            |graph, k, l| k + (l - input(graph, 0)),
            |graph, k, l| k - (l - input(graph, 0)),
            |graph, k, l| (input(graph, 0) - l) - k,
        ];
        for make in makes {
            let counts = operations(|graph| make(graph, graph.constant(0.25), graph.constant(4.0)));
            assert!(counts.0 >= 2 && counts.1 == 1, "{counts:?}");
        }
    }

    #[test]
    fn common_factor() {
        let (before, after) = operations(|graph| {
            input(graph, 0) * input(graph, 1) - input(graph, 2) * input(graph, 0)
        });
        assert_eq!((before, after), (3, 2));
    }

    #[test]
    fn a_product_that_is_used_elsewhere_is_not_taken_apart() {
        let (before, after) = operations(|graph| {
            let product = input(graph, 0) * input(graph, 1);
            (product - input(graph, 2) * input(graph, 0)) * product
        });
        assert_eq!((before, after), (4, 4));
    }

    #[test]
    fn random_expressions_keep_their_value_and_cost_no_more() {
        let mut random = Random::new(7);
        for _ in 0..300 {
            let choices: Vec<[usize; 3]> = (0..30)
                .map(|k| [5, k + 6, k + 6].map(|end| random.below(end)))
                .collect();
            let (before, after) = operations(|graph| {
                let mut terms: Vec<Term<'_>> = (0..3).map(|k| input(graph, k)).collect();
                let (sine, cosine) = terms[0].sin_cos();
                terms.extend([sine, cosine, graph.constant(0.5)]);
                for &[operation, a, b] in &choices {
                    let (a, b) = (terms[a], terms[b]);
                    terms.push(match operation {
                        0 | 1 => a + b,
                        2 | 3 => a - b,
                        _ => a * b,
                    });
                }
                *terms.last().expect("not empty")
            });
            assert!(after <= before, "{before} became {after}");
        }
    }
}
