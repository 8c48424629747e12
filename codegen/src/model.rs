//! The functions, as matrices of expressions.
//!
//! In: the bodies of a chain with their frames. Out: the scalars that a function returns. One file
//! a function or family, whose recursions run in the frames of the links (structure rules 1 to 3),
//! and one for all of them in frame 0. It never counts, orders or prints.

mod articulated;
mod base_frame;
mod carry;
mod composite;
mod dense;
mod factor;
mod forward_dynamics;
mod gravity;
mod jacobian;
mod newton_euler;
mod pose;
mod turn;
mod twist;

pub(crate) use self::articulated::{MOTION as ARTICULATED_MOTION, STEP as ARTICULATED_STEP};
pub use crate::formulation::{Angles, Forward, Frame};
pub use dense::dense;

use crate::expression::{Graph, Input, Term};
use crate::function::{Argument, Function};
use crate::layout::Bodies;
use crate::matrix::Vector;

/// One of several ways to compute the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// The frame in which the recursions run; the articulated bodies' are those of the links.
    pub frame: Frame,
    /// Whether the angles of parallel axes are summed.
    pub angles: Angles,
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
        frame: Frame::Link,
        angles: Angles::Apart,
        pose: Carried::Inwards { by_product: None },
        forward: Forward::UNREFINED,
    };

    /// Everything in frame 0, accelerations by the mass matrix.
    pub const IN_FRAME_0: Self = Self {
        frame: Frame::Base,
        pose: Carried::Outwards,
        ..Self::PLAIN
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
    let state = State::of(graph);
    let path = || carry::path(bodies, frame, &state, way.angles);
    let joints = || carry::joints(bodies, &state, way.angles);
    let gravity = bodies.gravity;
    let needed = |gravity: Vector<Term<'g>>, state: &State<'g>, qdd: &[Term<'g>]| match way.frame {
        Frame::Link => newton_euler::inverse_dynamics(&joints(), gravity, state, qdd),
        Frame::Base => base_frame::inverse_dynamics(&joints(), gravity, state, qdd),
    };
    let torques = |qdd: &[Term<'g>]| needed(gravity, &state, qdd);
    let inertial = |qdd: &[Term<'g>]| {
        needed(
            Vector::zero(graph),
            &State {
                rest: true,
                ..state
            },
            qdd,
        )
    };
    let mass_matrix = || match way.frame {
        Frame::Link => composite::mass_matrix(&joints(), &state),
        Frame::Base => base_frame::mass_matrix(&joints(), &state),
    };
    let parents = || parents(bodies);
    let count = bodies.bodies.len();
    match (function, way.frame) {
        (Function::ForwardKinematics, _) => pose::forward_kinematics(&path(), way.pose),
        (Function::SpatialJacobian, _) => jacobian::spatial(&path()),
        (Function::GeometricJacobian, _) => jacobian::geometric(&path()),
        (Function::BodyJacobian, Frame::Link) => jacobian::body(&path()),
        (Function::BodyJacobian, Frame::Base) => base_frame::body_jacobian(&path()),
        (Function::Velocity, Frame::Link) => twist::velocity(&path(), &state),
        (Function::Velocity, Frame::Base) => base_frame::velocity(&path(), &state),
        (Function::Acceleration, Frame::Link) => twist::acceleration(&path(), &state),
        (Function::Acceleration, Frame::Base) => base_frame::acceleration(&path(), &state),
        (Function::InverseDynamics, _) => torques(&state.qdds(count)),
        (Function::Bias, _) => torques(&vec![state.zero(); count]),
        (Function::Gravity, Frame::Link) => gravity::gravity(&joints(), gravity, &state),
        (Function::Gravity, Frame::Base) => base_frame::gravity(&joints(), gravity, &state),
        (Function::MassMatrix, _) => mass_matrix(),
        (Function::MassMatrixInverse, _) => match way.forward {
            Forward::MassMatrix { refinements } => forward_dynamics::mass_matrix_inverse(
                &mass_matrix(),
                &parents(),
                inertial,
                refinements,
            ),
            Forward::Articulated => articulated::mass_matrix_inverse(&joints(), &state),
        },
        (Function::ForwardDynamics, _) => match way.forward {
            Forward::MassMatrix { refinements } => forward_dynamics::forward_dynamics(
                &mass_matrix(),
                &parents(),
                |k| state.tau(k),
                torques,
                refinements,
            ),
            Forward::Articulated => articulated::forward_dynamics(&joints(), gravity, &state),
        },
    }
}

/// For each joint the diagonal entry of the mass matrix and the pivot that its factors leave of it.
#[must_use]
pub fn pivots<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    let state = State::of(graph);
    let matrix = composite::mass_matrix(&carry::joints(bodies, &state, Angles::Apart), &state);
    forward_dynamics::pivots(&matrix, &parents(bodies))
}

fn parents(bodies: &Bodies<'_>) -> Vec<Option<usize>> {
    bodies.bodies.iter().map(|body| body.parent).collect()
}

/// What the articulated-body recursion takes from a motion: see [`articulated::motion`].
pub(crate) fn articulated_motion<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    way: Way,
) -> Vec<Term<'g>> {
    let state = State::of(graph);
    let joints = carry::joints(bodies, &state, way.angles);
    articulated::motion(&joints, bodies.gravity, &state)
}

/// One step inwards of the articulated-body recursion from each joint: see [`articulated::step`].
pub(crate) fn articulated_steps<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    way: Way,
    entries: &[Term<'g>; ARTICULATED_STEP],
) -> Vec<Vec<Term<'g>>> {
    let joints = carry::joints(bodies, &State::of(graph), way.angles);
    let steps = joints.iter().map(|joint| articulated::step(joint, entries));
    steps.collect()
}

/// The arguments of the generated functions.
struct State<'g> {
    graph: &'g Graph,
    /// Whether all rates are zero, whatever the arguments.
    rest: bool,
}

impl<'g> State<'g> {
    const fn of(graph: &'g Graph) -> Self {
        Self { graph, rest: false }
    }

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
        if self.rest {
            self.zero()
        } else {
            self.entry(Argument::Qd, k)
        }
    }

    fn qdd(&self, k: usize) -> Term<'g> {
        self.entry(Argument::Qdd, k)
    }

    fn tau(&self, k: usize) -> Term<'g> {
        self.entry(Argument::Tau, k)
    }

    fn qdds(&self, count: usize) -> Vec<Term<'g>> {
        (0..count).map(|k| self.qdd(k)).collect()
    }

    fn zero(&self) -> Term<'g> {
        self.graph.constant(0.0)
    }
}
