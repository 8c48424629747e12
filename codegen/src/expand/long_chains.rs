//! Tests of chains that are too long for a computation for each pair of joints.
//!
//! In: chains of revolute joints with skew axes and full inertias. Out: operation counts, which are pinned, and pivots
//! of their mass matrices, by articulated bodies and by factors.

use std::fmt::Write;

use homogen_random::Random;

use super::understand;
use crate::chain::Chain;
use crate::description::read_text;
use crate::error::Errors;
use crate::expression::{Arithmetic, Double, Evaluation, Expr, Input, Term};
use crate::function::Function;
use crate::layout::{Layout, arrange};
use crate::model;
use crate::plan::{Programs, plan};
use crate::real::Real;
use crate::request::Request;
use crate::schedule::{Arranged, Length, OperationCount};
use crate::space::{FrameId, Variable};

fn chain(joints: usize, function: Function) -> Chain {
    let mut random = Random::new(64);
    let mut text = String::from("<robot name=\"chain\"><link name=\"l0\"/>");
    for joint in 1..=joints {
        let parent = joint - 1;
        let mut triple = |size: f64| {
            let [x, y, z] = [(); 3].map(|()| size * random.unit());
            format!("{x} {y} {z}")
        };
        let (at, turned, center) = (triple(0.3), triple(1.5), triple(0.1));
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "<joint name=\"j{joint}\" type=\"revolute\"><parent link=\"l{parent}\"/><child link=\"l{joint}\"/>\
             <origin xyz=\"{at}\" rpy=\"{turned}\"/><axis xyz=\"0 0 1\"/>\
             <limit lower=\"-1\" upper=\"1\" velocity=\"5\" effort=\"1\"/></joint>\
             <link name=\"l{joint}\"><inertial><origin xyz=\"{center}\"/><mass value=\"1\"/>\
             <inertia ixx=\"0.01\" ixy=\"0.001\" ixz=\"-0.002\" iyy=\"0.012\" iyz=\"0.0015\" izz=\"0.008\"/>\
             </inertial></link>"
        );
    }
    text.push_str("</robot>");
    let description = read_text(&text, "chain.urdf", None, &mut Errors::new()).expect("URDF");
    let request = Request {
        functions: vec![vec![function]],
        scalar: Real::F64,
        ..Request::default()
    };
    understand(&description, &request).expect("a chain")
}

/// Operations, and the number of sections.
fn cost(joints: usize, function: Function) -> (usize, usize) {
    let chain = chain(joints, function);
    let plan = plan(&Programs::of(&chain), vec![function], FrameId::FIRST).expect("it moves");
    let OperationCount { mul, add, .. } = plan.operation_count;
    let arranged = Arranged::of(&plan.program, &[], Length::default());
    (
        mul + add,
        arranged.sections.map_or(1, |cut| cut.sections.len()),
    )
}

#[test]
fn operations_are_in_proportion_to_the_joints() {
    let found = [64, 256].map(|joints| {
        [Function::InverseDynamics, Function::ForwardDynamics]
            .map(|function| cost(joints, function))
    });
    // Four times the joints: 4.06 and 4.08 times the operations, since the first joints cost less than the others.
    assert_eq!(
        found,
        [[(10_406, 1), (31_610, 14)], [(42_278, 26), (128_872, 58)]]
    );
}

#[test]
fn pivots_are_those_of_the_factors() {
    let chain = chain(50, Function::ForwardDynamics);
    assert!(chain.is_long());
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
    let mut random = Random::new(5);
    let q: Vec<f64> = (0..50).map(|_| random.unit()).collect();
    let values = |pivots: Vec<Term<'_>>| {
        let pivots: Vec<Expr> = pivots.into_iter().map(Term::expr).collect();
        Evaluation::of(&graph, &pivots).at(|input| match input {
            Input::Variable(Variable::Q, k) => Double::from(q[usize::from(k)]),
            _ => Double::literal(0.0),
        })
    };
    let by_factors = values(model::pivots(&graph, &bodies));
    let by_bodies = values(model::articulated_pivots(&graph, &bodies));
    assert_eq!(by_factors.len(), 100);
    for (a, b) in by_factors.into_iter().zip(by_bodies) {
        let (off, size) = ((a - b).to_f64().abs(), a.to_f64());
        assert!(off <= 1e-22 * size, "{off:e} of {size}");
    }
}
