//! The functions, as matrices of expressions.
//!
//! In: the bodies of a chain with their frames. Out: the scalars that a function returns. One file
//! a function or family; all recursions run in the frames of the links (structure rules 1 to 3). It
//! never counts, orders or prints.

mod carry;
mod composite;
mod dense;
mod gravity;
mod jacobian;
mod newton_euler;
mod pose;
mod twist;

pub use dense::dense;

use crate::chain::frames::Bodies;
use crate::expression::{Graph, Input, Term};
use crate::function::{Argument, Function};

/// One of several ways to compute the same, between which only the count decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// Which two columns of a rotation are carried, the third being their product: the index of the
    /// third; or all three.
    pub by_product: Option<usize>,
}

impl Way {
    /// The ways that differ for a function.
    #[must_use]
    pub fn all(function: Function) -> &'static [Self] {
        const CARRY_ALL: Way = Way { by_product: None };
        match function {
            Function::ForwardKinematics => &[
                CARRY_ALL,
                Way {
                    by_product: Some(0),
                },
                Way {
                    by_product: Some(1),
                },
                Way {
                    by_product: Some(2),
                },
            ],
            _ => &[CARRY_ALL],
        }
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
        Function::ForwardKinematics => pose::forward_kinematics(&path(), way.by_product),
        Function::SpatialJacobian => jacobian::spatial(&path()),
        Function::BodyJacobian => jacobian::body(&path()),
        Function::GeometricJacobian => jacobian::geometric(&path()),
        Function::Velocity => twist::velocity(&path(), &state),
        Function::Acceleration => twist::acceleration(&path(), &state),
        Function::InverseDynamics => newton_euler::inverse_dynamics(bodies, &state, true),
        Function::Bias => newton_euler::inverse_dynamics(bodies, &state, false),
        Function::Gravity => gravity::gravity(bodies, &state),
        Function::MassMatrix => composite::mass_matrix(bodies, &state),
    }
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

    fn zero(&self) -> Term<'g> {
        self.graph.constant(0.0)
    }
}
