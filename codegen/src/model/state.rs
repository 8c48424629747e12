//! The arguments of the generated functions, as expressions.

use crate::expression::{Graph, Input, Term};
use crate::space::Variable;

/// The arguments of the generated functions.
pub(crate) struct State<'g> {
    pub(super) graph: &'g Graph,
    /// Whether all rates are zero, whatever the arguments.
    pub(super) rest: bool,
}

impl<'g> State<'g> {
    pub(super) const fn of(graph: &'g Graph) -> Self {
        Self { graph, rest: false }
    }

    /// Entry `k` of an argument.
    fn entry(&self, variable: Variable, k: usize) -> Term<'g> {
        let k = u16::try_from(k).expect("fewer than 65536 joints");
        self.graph.input(Input::Variable(variable, k))
    }

    pub(super) fn q(&self, k: usize) -> Term<'g> {
        self.entry(Variable::Q, k)
    }

    pub(crate) fn qd(&self, k: usize) -> Term<'g> {
        if self.rest {
            self.zero()
        } else {
            self.entry(Variable::Qd, k)
        }
    }

    pub(super) fn qdd(&self, k: usize) -> Term<'g> {
        self.entry(Variable::Qdd, k)
    }

    pub(crate) fn tau(&self, k: usize) -> Term<'g> {
        self.entry(Variable::Tau, k)
    }

    pub(crate) fn qdds(&self, count: usize) -> Vec<Term<'g>> {
        (0..count).map(|k| self.qdd(k)).collect()
    }

    /// A number.
    pub(crate) fn constant(&self, value: f64) -> Term<'g> {
        self.graph.constant(value)
    }

    pub(crate) fn zero(&self) -> Term<'g> {
        self.graph.constant(0.0)
    }
}
