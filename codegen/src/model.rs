//! The functions, as matrices of expressions.
//!
//! In: the bodies of a chain with their frames. Out: the scalars that a function returns. One file
//! a function or family; all recursions run in the frames of the links (structure rules 1 to 3). It
//! never counts, orders or prints.

mod articulated;
mod carry;
mod composite;
mod dense;
mod factor;
mod forward_dynamics;
mod gravity;
mod jacobian;
mod newton_euler;
mod pose;
mod twist;

pub use crate::formulation::Forward;
pub use dense::dense;

use crate::chain::frames::Bodies;
use crate::expression::{Graph, Input, Term};
use crate::function::{Argument, Function};

/// One of several ways to compute the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// How the pose of a frame is found.
    pub pose: Carried,
    /// How accelerations are found from forces.
    pub forward: Forward,
}

/// How the pose of a frame is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried {
    /// From the frame to the base, column by column.
    Inwards {
        /// Which column is made from the two others, which alone are carried; none where all are.
        by_product: Option<usize>,
    },
    /// From the base to the frame, as the Jacobians are, with which it then shares the work.
    Outwards,
}

impl Way {
    /// Columns all carried inwards, accelerations by the mass matrix.
    pub const PLAIN: Self = Self {
        pose: Carried::Inwards { by_product: None },
        forward: Forward::MassMatrix { refinements: 0 },
    };

    /// The ways of a function between which only the count decides.
    #[must_use]
    pub fn all(function: Function) -> Vec<Self> {
        let mut ways = vec![Self::PLAIN];
        if function == Function::ForwardKinematics {
            let carried = (0..3).map(|column| Carried::Inwards {
                by_product: Some(column),
            });
            ways.extend(carried.chain([Carried::Outwards]).map(|pose| Self {
                pose,
                ..Self::PLAIN
            }));
        }
        ways
    }
}

/// The results of a function in the order of its shape; of the frame of that index where it is of
/// one.
#[must_use]
pub fn build<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    function: Function,
    frame: usize,
    way: Way,
) -> Vec<Term<'g>> {
    let state = State { graph };
    let path = || carry::path(bodies, frame, &state);
    match function {
        Function::ForwardKinematics => pose::forward_kinematics(&path(), way.pose),
        Function::SpatialJacobian => jacobian::spatial(&path()),
        Function::BodyJacobian => jacobian::body(&path()),
        Function::GeometricJacobian => jacobian::geometric(&path()),
        Function::Velocity => twist::velocity(&path(), &state),
        Function::Acceleration => twist::acceleration(&path(), &state),
        Function::InverseDynamics => {
            newton_euler::inverse_dynamics(bodies, &state, &state.qdds(bodies))
        }
        Function::Bias => newton_euler::bias(bodies, &state),
        Function::ForwardDynamics => match way.forward {
            Forward::MassMatrix { refinements } => {
                forward_dynamics::forward_dynamics(bodies, &state, refinements)
            }
            Forward::Articulated => articulated::forward_dynamics(bodies, &state),
        },
        Function::MassMatrixInverse => forward_dynamics::mass_matrix_inverse(bodies, &state),
        Function::Gravity => gravity::gravity(bodies, &state),
        Function::MassMatrix => composite::mass_matrix(bodies, &state),
    }
}

/// For each joint the diagonal entry of the mass matrix and the pivot that its factors leave of it.
#[must_use]
pub fn pivots<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    forward_dynamics::pivots(bodies, &State { graph })
}

/// The arguments of the generated functions.
struct State<'g> {
    graph: &'g Graph,
}

impl<'g> State<'g> {
    /// Entry `k` of an argument.
    fn entry(&self, argument: Argument, k: usize) -> Term<'g> {
        let k = u16::try_from(k).expect("fewer than 65536 joints");
        self.graph.input(match argument {
            Argument::Q => Input::Q(k),
            Argument::Qd => Input::Qd(k),
            Argument::Qdd => Input::Qdd(k),
            Argument::Tau => Input::Tau(k),
        })
    }

    fn q(&self, k: usize) -> Term<'g> {
        self.entry(Argument::Q, k)
    }

    fn qd(&self, k: usize) -> Term<'g> {
        self.entry(Argument::Qd, k)
    }

    fn qdd(&self, k: usize) -> Term<'g> {
        self.entry(Argument::Qdd, k)
    }

    fn tau(&self, k: usize) -> Term<'g> {
        self.entry(Argument::Tau, k)
    }

    fn qdds(&self, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
        (0..bodies.bodies.len()).map(|k| self.qdd(k)).collect()
    }

    fn zero(&self) -> Term<'g> {
        self.graph.constant(0.0)
    }
}
