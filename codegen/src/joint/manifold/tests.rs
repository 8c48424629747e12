//! Rates of coordinates: along a velocity in the body's frame, the rate of M is M L.

use super::Manifold;
use crate::expression::{Double, Expr, Graph, Input, Term, along, evaluate};
use crate::space::Variable;

/// Coordinates of a configuration; the last four are a unit quaternion.
const Q: [f64; 7] = [0.7, -0.4, 0.2, 0.1, -0.5, 0.7, 0.5];

fn input(k: usize) -> Input {
    Input::Variable(Variable::Q, u16::try_from(k).expect("seven"))
}

/// Compares M L of each velocity with the derivative of M along the rates.
fn assert_rates(manifold: Manifold, q: &[f64], screws: &[([f64; 3], [f64; 3])]) {
    let graph = Graph::new();
    let coordinate = |k: usize| graph.input(input(k));
    let pose = manifold.displacement(coordinate);
    let entries: Vec<Expr> = pose.entries().map(Term::expr).into();
    let numbers = |terms: &[Term<'_>]| -> Vec<f64> {
        let exprs: Vec<Expr> = terms.iter().map(|term| term.expr()).collect();
        let at = |input: Input| match input {
            Input::Variable(_, k) => Double::from(q[usize::from(k)]),
            Input::Parameter(..) => unreachable!("there are no fields"),
        };
        let found = evaluate(&graph, &exprs, at).into_iter();
        found.map(Double::to_f64).collect()
    };
    let m = numbers(&pose.entries());
    assert_eq!(manifold.velocities(), screws.len());
    for (k, (u, b)) in screws.iter().enumerate() {
        let rates = manifold.rates(k, coordinate);
        let rate = |of: Input| (0..q.len()).find(|&k| input(k) == of).map(|k| rates[k]);
        let found = numbers(&along(&graph, &entries, rate));
        // Columns of L: u × e, and b.
        let columns = [
            [0.0, u[2], -u[1]],
            [-u[2], 0.0, u[0]],
            [u[1], -u[0], 0.0],
            *b,
        ];
        for row in 0..3 {
            for (place, column) in columns.iter().enumerate() {
                let expected: f64 = (0..3).map(|k| m[4 * row + k] * column[k]).sum();
                let found = found[4 * row + place];
                assert!(
                    (found - expected).abs() < 1e-15,
                    "{manifold:?}, velocity {k}"
                );
            }
        }
    }
}

const NONE: [f64; 3] = [0.0; 3];
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[test]
fn a_planar_joint_moves_along_its_own_axes() {
    let [x, y, z] = AXES;
    assert_rates(
        Manifold::Planar,
        &Q[..3],
        &[(NONE, x), (NONE, y), (z, NONE)],
    );
}

#[test]
fn a_spherical_joint_rotates_about_its_own_axes() {
    assert_rates(Manifold::Spherical, &Q[3..], &AXES.map(|axis| (axis, NONE)));
}

#[test]
fn a_floating_joint_moves_along_its_own_axes_and_rotates_about_them() {
    let along = AXES.map(|axis| (NONE, axis));
    let about = AXES.map(|axis| (axis, NONE));
    assert_rates(Manifold::Floating, &Q, &[along, about].concat());
}
