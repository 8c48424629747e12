//! The recursions that functions share, as matrices of expressions.
//!
//! In: the bodies of a chain with their frames, in a [`Scene`]. Out: scalars. Recursions run in the
//! frames of the links (structure rules 1 to 3), or, with joints whose matrices are all there, in frame
//! 0. It knows no function, and never counts, orders or prints.

mod alike;
pub(crate) mod articulated;
mod carry;
mod composite;
mod constrained;
mod derivatives;
mod direction;
mod factor;
pub(crate) mod forward_dynamics;
pub(crate) mod gravity;
pub(crate) mod jacobian;
pub(crate) mod jacobian_rate;
pub(crate) mod loops;
mod mass_center;
pub(crate) mod momentum;
pub(crate) mod moving;
mod newton_euler;
mod outside;
pub(crate) mod pose;
pub(crate) mod regressor;
mod state;
mod turn;
pub(crate) mod twist;
mod velocities;
mod way;

pub(crate) use self::alike::alike;
pub(crate) use self::articulated::{
    INERTIA as ARTICULATED_INERTIA, MOTION as ARTICULATED_MOTION, STEP as ARTICULATED_STEP,
};

pub use self::direction::coordinate_rates;
pub(crate) use self::mass_center::MassCenter;
pub(crate) use self::state::State;
pub use self::way::{Angles, Carried, Congruence, Forward, Frame, Way};

use crate::chain::BodyId;
use crate::expression::{Graph, Term};
use crate::layout::Bodies;
use crate::list::{self, List, Square};
use crate::matrix::{Action, Inertia, Screw, Vector};
use crate::space::{FrameId, ParameterId, Variable, VelocityId};

/// What a function is built from: bodies with their frames, a state, and the way.
pub struct Scene<'s, 'g> {
    graph: &'g Graph,
    frame: FrameId,
    pub(crate) bodies: &'s Bodies<'g>,
    pub(crate) way: Way,
    pub(crate) state: State<'g>,
}

impl<'s, 'g> Scene<'s, 'g> {
    /// Of that frame, where a function is of one.
    pub(crate) fn new(graph: &'g Graph, bodies: &'s Bodies<'g>, frame: FrameId, way: Way) -> Self {
        Self {
            graph,
            frame,
            bodies,
            way,
            state: State::of(graph, bodies),
        }
    }

    /// For each velocity the one that it is eliminated into: that of the joint which carries the body it
    /// moves, or, where joints follow others, the nearest that any of its bodies has to do with.
    pub(crate) fn parents(&self) -> List<VelocityId, Option<VelocityId>> {
        velocities::parents(self.bodies)
    }

    /// The way to the frame, in the frames of the links.
    pub(crate) fn link_path(&self) -> carry::Path<'g> {
        carry::path(self.bodies, self.frame, &self.state, self.way)
    }

    /// The way to the frame, in the frame in which recursions run.
    pub(crate) fn path(&self) -> carry::Path<'g> {
        match self.way.frame {
            Frame::Link => self.link_path(),
            Frame::Base => self.link_path().in_frame_0(),
        }
    }

    /// The joints at work, in the frames of the links.
    pub(crate) fn link_joints(&self) -> carry::Joints<'g> {
        carry::joints(self.bodies, &self.state, self.way)
    }

    /// The same with what is left to the base, but seen from the root: for what is the same wherever the origin of
    /// frame 0 is. So nothing is lost of a robot that is far from there, and its way there is not computed.
    pub(crate) fn seen_from_root(&self) -> (carry::Joints<'g>, Inertia<Term<'g>>) {
        let base = self.bodies.base;
        match self.way.frame {
            Frame::Link => carry::from_root(self.link_joints(), base),
            Frame::Base => (self.joints(), base),
        }
    }

    /// The joints at work, in the frame in which recursions run.
    pub(crate) fn joints(&self) -> carry::Joints<'g> {
        match self.way.frame {
            Frame::Link => self.link_joints(),
            Frame::Base => carry::in_frame_0(&self.link_joints()),
        }
    }

    /// The numbers of all velocities.
    pub(crate) fn velocities(&self) -> impl ExactSizeIterator<Item = VelocityId> + use<> {
        list::ids(velocities::count(self.bodies))
    }

    /// q̈, one entry a velocity.
    pub(crate) fn qdd(&self) -> List<VelocityId, Term<'g>> {
        let entry = |k| self.state.of_velocity(Variable::Qdd, k);
        self.velocities().map(entry).collect()
    }

    /// The same where no velocity changes.
    pub(crate) fn coasting(&self) -> List<VelocityId, Term<'g>> {
        List::filled(self.state.zero(), self.velocities().len())
    }

    /// H of the frame without gravity, where `second` is the second rate of a body.
    pub(crate) fn acceleration(&self, second: impl Fn(BodyId) -> Term<'g>) -> Vec<Term<'g>> {
        match (self.way.frame, self.way.pose) {
            (Frame::Link, Carried::Outwards) => {
                let (path, gravity) = (self.link_path(), self.bodies.gravity);
                twist::acceleration_with_dynamics(&path, gravity, &self.state, second)
            }
            _ => twist::acceleration(&self.path(), &self.state, second),
        }
    }

    /// τ of a motion with the given q̈, one entry a velocity each, less what the surroundings do: τ − Σ Jᵗ Φ.
    pub(crate) fn driving(&self, qdd: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let outside = self.outside(self.way.frame);
        self.against(self.bodies.gravity, &self.state, qdd, &outside)
    }

    /// The actions of the surroundings on bodies, in the frames of the links or in frame 0.
    pub(crate) fn outside(&self, frame: Frame) -> Vec<(BodyId, Action<Term<'g>>)> {
        let way = Way { frame, ..self.way };
        outside::outside(self.bodies, &self.state, way)
    }

    /// τ of a motion with the given q̈, one entry a velocity each.
    pub(crate) fn torques(&self, qdd: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        self.against(self.bodies.gravity, &self.state, qdd, &[])
    }

    /// M q̈: τ at rest and without gravity.
    pub(crate) fn inertial(&self, qdd: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        self.against(Vector::zero(self.graph), &self.state.at_rest(), qdd, &[])
    }

    fn against(
        &self,
        gravity: Vector<Term<'g>>,
        state: &State<'g>,
        qdd: &List<VelocityId, Term<'g>>,
        outside: &[(BodyId, Action<Term<'g>>)],
    ) -> List<VelocityId, Term<'g>> {
        let qdd = velocities::shared(state, self.bodies, qdd);
        let joints = self.joints();
        let driving = newton_euler::inverse_dynamics(&joints, gravity, state, &qdd, outside);
        self.forces(&driving)
    }

    /// τ of what drives each body.
    pub(crate) fn forces(&self, driving: &List<BodyId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        velocities::gathered(&self.state, self.bodies, driving)
    }

    /// The columns of a Jacobian, of those for each body.
    pub(crate) fn columns(&self, screws: &List<BodyId, Screw<Term<'g>>>) -> Vec<Term<'g>> {
        self.gathered(&screws.map(|screw| screw.entries()))
    }

    /// The columns of any matrix with a row for each of some entries, of those for each body.
    pub(crate) fn gathered<const M: usize>(
        &self,
        entries: &List<BodyId, [Term<'g>; M]>,
    ) -> Vec<Term<'g>> {
        let row = |entry: usize| self.forces(&entries.map(|column| column[entry]));
        let rows: [List<VelocityId, Term<'g>>; M] = std::array::from_fn(row);
        self.velocities()
            .flat_map(|k| rows.each_ref().map(|row| row[k]))
            .collect()
    }

    /// Y of τ = Y π by its columns; in the frames of the links, whatever the way.
    pub(crate) fn regressor(&self) -> List<ParameterId, List<VelocityId, Term<'g>>> {
        let joints = carry::joints(self.bodies, &self.state, Way::PLAIN);
        let links = self.bodies.bodies.map(|body| body.link);
        let columns = regressor::regressor(&joints, &links, self.bodies.gravity, &self.state);
        let drives = self.bodies.identifies_drives;
        let drives = drives.then(|| regressor::of_drives(&joints, &self.state));
        let columns = columns.iter().chain(drives.iter().flatten());
        columns.map(|column| self.forces(column)).collect()
    }

    /// A matrix row by row, of columns that have an entry for each velocity.
    pub(crate) fn rows_of(&self, columns: &[&List<VelocityId, Term<'g>>]) -> Vec<Term<'g>> {
        let row = |row: VelocityId| columns.iter().map(move |column| column[row]);
        self.velocities().flat_map(row).collect()
    }

    /// ∂τ/∂q and ∂τ/∂q̇ of a motion with the given q̈, under the actions from outside.
    pub(crate) fn torque_derivatives(
        &self,
        qdd: &List<VelocityId, Term<'g>>,
    ) -> [Square<VelocityId, Term<'g>>; 2] {
        let qdd = velocities::shared(&self.state, self.bodies, qdd);
        let (joints, gravity) = (self.joints(), self.bodies.gravity);
        let outside = self.outside(self.way.frame);
        let (standing, turning) = if self.bodies.external_in_frame_0 {
            (outside, Vec::new())
        } else {
            (Vec::new(), outside)
        };
        let [mut by_coordinate, by_rate] =
            derivatives::inverse_dynamics(&joints, gravity, &self.state, &qdd, &turning);
        derivatives::add_standing(&mut by_coordinate, &joints, &standing);
        [by_coordinate, by_rate].map(|matrix| self.by_velocities(matrix))
    }

    /// ∂τ/∂q at rest, row by row.
    pub(crate) fn gravity_derivative(&self) -> Square<VelocityId, Term<'g>> {
        let gravity = self.bodies.gravity;
        self.by_velocities(gravity::derivative(&self.joints(), gravity, &self.state))
    }

    /// C, row by row.
    pub(crate) fn coriolis_matrix(&self) -> Square<VelocityId, Term<'g>> {
        self.by_velocities(derivatives::coriolis_matrix(&self.joints(), &self.state))
    }

    /// A matrix that has a row and a column for each velocity, of one that has them for each body.
    fn by_velocities(&self, matrix: Square<BodyId, Term<'g>>) -> Square<VelocityId, Term<'g>> {
        velocities::gathered_by_both(&self.state, self.bodies, matrix)
    }

    /// M, row by row.
    pub(crate) fn mass_matrix(&self) -> Square<VelocityId, Term<'g>> {
        let matrix = composite::mass_matrix(&self.joints(), &self.state);
        velocities::gathered_twice(&self.state, self.bodies, matrix)
    }
}

impl<'g> Scene<'_, 'g> {
    /// q̈ that τ produces against gravity where loops are held together, and what holds them: λ.
    pub(crate) fn constrained(&self) -> [Vec<Term<'g>>; 2] {
        let bias = self.torques(&self.coasting());
        let forces = bias.numbered();
        let forces = forces.map(|(k, &bias)| self.state.of_velocity(Variable::Tau, k) - bias);
        let forces: List<VelocityId, _> = forces.collect();
        let loops = constrained::Loops {
            jacobian: loops::jacobian(self),
            bias: loops::bias(self),
            alike: loops::alike(self.bodies),
            vanishing: self.way.scalar.vanishing(),
        };
        constrained::accelerations(&self.mass_matrix(), &self.parents(), &forces, &loops)
    }

    /// τ of the joints that are driven in a motion which keeps loops closed.
    pub(crate) fn driven(&self) -> List<VelocityId, Term<'g>> {
        let loops = constrained::Loops {
            jacobian: loops::jacobian(self),
            bias: Vec::new(),
            alike: loops::alike(self.bodies),
            vanishing: self.way.scalar.vanishing(),
        };
        let needed = self.torques(&self.qdd());
        constrained::driven(&needed, &self.bodies.actuated, &loops)
    }
}

/// For each velocity the diagonal entry of the mass matrix and the pivot that its factors leave of it.
#[must_use]
pub fn pivots<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, Way::PLAIN);
    forward_dynamics::pivots(&scene.mass_matrix(), &scene.parents())
}

/// The same by articulated bodies, where each has a velocity of its own: without the other entries, of which there
/// are as many as pairs of joints.
#[must_use]
pub fn articulated_pivots<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, Way::PLAIN);
    let pivots = articulated::pivots(&scene.link_joints()).into_iter();
    pivots.flatten().collect()
}

/// What accelerations are solved from: M, row by row, the torques at q̈ = 0 and, where a residual is made of
/// them, those of q̈.
pub(crate) fn equation<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    way: Way,
    has_residual: bool,
) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, way);
    let mut terms = Vec::from(scene.mass_matrix());
    terms.extend(scene.driving(&scene.coasting()));
    if has_residual {
        terms.extend(scene.driving(&scene.qdd()));
    }
    terms
}

/// What the inverse of M is refined from: M, row by row, and M q̈ of no q̈ and of any.
pub(crate) fn equation_at_rest<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    way: Way,
) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, way);
    let mut terms = Vec::from(scene.mass_matrix());
    terms.extend(scene.coasting());
    terms.extend(scene.inertial(&scene.qdd()));
    terms
}

/// What the articulated-body recursion takes from a motion: see [`articulated::motion`].
pub(crate) fn articulated_motion<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    way: Way,
) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, way);
    let outside = scene.outside(Frame::Link);
    articulated::motion(&scene.link_joints(), bodies.gravity, &scene.state, &outside)
}

/// One step inwards of the articulated-body recursion from each joint: see [`articulated::step`].
pub(crate) fn articulated_steps<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    way: Way,
    entries: &[Term<'g>; ARTICULATED_STEP],
) -> Vec<Vec<Term<'g>>> {
    let joints = Scene::new(graph, bodies, FrameId::FIRST, way).link_joints();
    let steps = joints.iter().map(|joint| articulated::step(joint, entries));
    steps.collect()
}
