//! The number of inertial parameters that a robot's dynamics depend on.
//!
//! In: a chain, and whether parameters are regrouped. Out: how many of the numbers of all inertias, in the frames of
//! bodies, inverse dynamics reads.

use super::program::arranged;
use crate::chain::Chain;
use crate::expression::{Expr, Input, Node, Term};
use crate::formulation::Parameters;
use crate::function::Function;
use crate::layout::Layout;
use crate::model::Algorithm;
use crate::space::FrameId;

/// The number of inertial parameters that inverse dynamics reads.
#[must_use]
pub fn inertial_parameters(chain: &Chain, parameters: Parameters) -> usize {
    let graph = chain.graph.clone();
    let layout = Layout {
        regroup: parameters == Parameters::Regrouped,
        ..Layout::DESCRIBED
    };
    let mut bodies = arranged(&graph, chain, layout);
    // Each becomes an input of its own, numbered after the struct's fields, so that those read can be counted.
    let fields = chain.nominal.len();
    for (body, field) in bodies.bodies.iter_mut().zip(fields..) {
        let field = u16::try_from(field).expect("fewer than 65536 joints and fields");
        let mut entries = 0..;
        body.inertia = body.inertia.map(|entry| match entries.next() {
            Some(k) if !entry.is_zero() => graph.input(Input::Parameter(field, k)),
            _ => entry,
        });
    }
    let torques =
        Function::InverseDynamics.build(&graph, &bodies, FrameId::FIRST, Algorithm::PLAIN);
    let torques: Vec<Expr> = torques.into_iter().map(Term::expr).collect();
    let (needed, _) = graph.needed(&torques);
    let is_read = |expr: &Expr| match graph.node(*expr) {
        Node::Input(Input::Parameter(field, _)) => usize::from(field) >= fields,
        _ => false,
    };
    needed.iter().filter(|expr| is_read(expr)).count()
}
