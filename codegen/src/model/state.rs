//! The arguments of generated functions as expressions, for each body.

use crate::chain::{BodyId, Position};
use crate::expression::{Expr, Graph, Input, Term};
use crate::layout::Bodies;
use crate::list::{Id, List};
use crate::matrix::{Action, Vector};
use crate::space::{ACTION, CoordinateId, Variable, VelocityId};

/// The arguments of the generated functions.
#[derive(Clone)]
pub(crate) struct State<'g> {
    pub(super) graph: &'g Graph,
    /// The velocities that are zero, whatever the arguments.
    still: Still,
    /// For each body, the index of its velocity, and the factor of that velocity.
    rates: List<BodyId, (VelocityId, Option<Expr>)>,
    /// For each body, the coordinates that determine its displacement.
    positions: List<BodyId, Position>,
}

/// Velocities that are zero.
#[derive(Clone)]
enum Still {
    None,
    These([VelocityId; 3]),
    All,
}

impl<'g> State<'g> {
    pub(super) fn of(graph: &'g Graph, bodies: &Bodies<'g>) -> Self {
        let bodies = &bodies.bodies;
        Self {
            graph,
            still: Still::None,
            rates: bodies.map(|body| (body.velocity, body.factor())),
            positions: bodies.map(|body| body.position),
        }
    }

    /// The same at rest.
    pub(crate) fn at_rest(&self) -> Self {
        self.with(Still::All)
    }

    /// The same with three velocities of zero.
    pub(super) fn without(&self, velocities: [VelocityId; 3]) -> Self {
        self.with(Still::These(velocities))
    }

    fn with(&self, still: Still) -> Self {
        Self {
            still,
            ..self.clone()
        }
    }

    /// Entry `k` of an argument.
    pub(crate) fn entry(&self, variable: Variable, k: usize) -> Term<'g> {
        let k = u16::try_from(k).expect("fewer than 65536 joints");
        self.graph.input(Input::Variable(variable, k))
    }

    /// An entry of q.
    pub(super) fn coordinate(&self, k: CoordinateId) -> Term<'g> {
        self.entry(Variable::Q, k.index())
    }

    /// The entry of an argument for a velocity.
    pub(crate) fn of_velocity(&self, variable: Variable, k: VelocityId) -> Term<'g> {
        self.entry(variable, k.index())
    }

    /// The displacement of body `k` along its own axis; zero if it has none.
    pub(super) fn q(&self, k: BodyId) -> Term<'g> {
        match self.positions[k] {
            Position::Along { coordinate, factor } => {
                self.coordinate(coordinate) * self.graph.term(factor)
            }
            Position::Manifold(..) | Position::Taken => self.zero(),
        }
    }

    /// The entry of body `k` in an argument over velocities; a force only if no other body has its velocity.
    pub(crate) fn own(&self, variable: Variable, k: BodyId) -> Term<'g> {
        let (velocity, _) = self.rates[k];
        self.times_factor(k, self.of_velocity(variable, velocity))
    }

    /// An entry for the velocity of body `k`, times the factor of the body.
    pub(crate) fn times_factor(&self, k: BodyId, entry: Term<'g>) -> Term<'g> {
        match self.rates[k].1 {
            Some(factor) => entry * self.graph.term(factor),
            None => entry,
        }
    }

    /// The index of body `k`'s velocity.
    pub(crate) fn velocity(&self, k: BodyId) -> VelocityId {
        self.rates[k].0
    }

    /// The velocity of body `k`.
    pub(crate) fn qd(&self, k: BodyId) -> Term<'g> {
        let is_still = match &self.still {
            Still::None => false,
            Still::These(velocities) => velocities.contains(&self.velocity(k)),
            Still::All => true,
        };
        if is_still {
            self.zero()
        } else {
            self.own(Variable::Qd, k)
        }
    }

    /// Its acceleration.
    pub(crate) fn qdd(&self, k: BodyId) -> Term<'g> {
        self.own(Variable::Qdd, k)
    }

    /// An external wrench.
    pub(super) fn action(&self, k: usize) -> Action<Term<'g>> {
        self.wrench(Variable::Actions, k)
    }

    /// The wrench that weights the twist of a frame.
    pub(crate) fn weights_of_twist(&self) -> Action<Term<'g>> {
        self.wrench(Variable::Wrench, 0)
    }

    fn wrench(&self, of: Variable, k: usize) -> Action<Term<'g>> {
        let entry = |entry: usize| self.entry(of, ACTION.len() * k + entry);
        Action {
            c: Vector([entry(0), entry(1), entry(2)]),
            f: Vector([entry(3), entry(4), entry(5)]),
        }
    }

    /// A constant.
    pub(crate) fn constant(&self, value: f64) -> Term<'g> {
        self.graph.constant(value)
    }

    pub(crate) fn zero(&self) -> Term<'g> {
        self.graph.constant(0.0)
    }
}
