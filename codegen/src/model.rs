//! The recursions that functions share, as matrices of expressions.
//!
//! In: the bodies of a chain with their frames, in a [`Scene`]. Out: scalars. Recursions run in the frames of the links
//! (structure rules 1 to 3), or with all matrices in frame 0.

mod algorithm;
mod alike;
pub(crate) mod articulated;
mod axis_rotation;
mod carry;
pub(crate) mod change;
mod composite;
mod constrained;
mod derivatives;
mod direction;
mod external;
mod factor;
pub(crate) mod forward_dynamics;
mod free_fall;
mod gradient;
pub(crate) mod gravity;
mod hessian;
pub(crate) mod jacobian;
pub(crate) mod jacobian_derivative;
pub(crate) mod jacobian_rate;
pub(crate) mod loops;
mod mass_center;
pub(crate) mod momentum;
pub(crate) mod moving;
mod newton_euler;
pub(crate) mod pose;
pub(crate) mod regressor;
pub mod spheres;
mod state;
pub(crate) mod twist;
mod velocities;

pub(crate) use self::alike::alike;
pub(crate) use self::articulated::{
    INERTIA as ARTICULATED_INERTIA, MOTION as ARTICULATED_MOTION, STEP as ARTICULATED_STEP,
};

pub use self::algorithm::{Algorithm, Angles, Carried, Congruence, Forward, Frame};
pub use self::direction::coordinate_rates;
pub(crate) use self::free_fall::FreeFall;
pub(crate) use self::mass_center::MassCenter;
pub(crate) use self::state::State;

use std::iter::successors;

use crate::chain::BodyId;
use crate::expression::{Graph, Term};
use crate::layout::Bodies;
use crate::list::{self, List, Square};
use crate::matrix::{Action, Inertia, Pose, Screw, Vector};
use crate::space::{FrameId, ParameterId, Variable, VelocityId};

/// The data of a function: bodies with their frames, a state, and the algorithm.
#[derive(Clone)]
pub struct Scene<'s, 'g> {
    graph: &'g Graph,
    frame: FrameId,
    pub(crate) bodies: &'s Bodies<'g>,
    pub(crate) algorithm: Algorithm,
    pub(crate) state: State<'g>,
    /// Acceleration of gravity in frame 0 \[m/s²\].
    pub(crate) gravity: Vector<Term<'g>>,
}

impl<'s, 'g> Scene<'s, 'g> {
    /// A scene with a frame, for functions of a frame.
    pub(crate) fn new(
        graph: &'g Graph,
        bodies: &'s Bodies<'g>,
        frame: FrameId,
        algorithm: Algorithm,
    ) -> Self {
        Self {
            graph,
            frame,
            bodies,
            algorithm,
            state: State::of(graph, bodies),
            gravity: bodies.gravity,
        }
    }

    /// For each velocity the next one in the elimination: that of the joint that carries the body it moves or, with
    /// mimic joints, the nearest one coupled with any of its bodies.
    pub(crate) fn parents(&self) -> List<VelocityId, Option<VelocityId>> {
        velocities::parents(self.bodies)
    }

    /// The largest number of velocities of which each carries the next.
    pub(crate) fn longest_path(&self) -> usize {
        let parents = self.parents();
        let lengths = parents
            .ids()
            .map(|k| successors(Some(k), |&k| parents[k]).count());
        lengths.max().unwrap_or(0)
    }

    /// The path to the frame, in the frames of the links.
    pub(crate) fn link_path(&self) -> carry::Path<'g> {
        self.link_path_to(self.frame)
    }

    /// The path to another frame, in the frames of the links.
    pub(crate) fn link_path_to(&self, frame: FrameId) -> carry::Path<'g> {
        carry::path(self.bodies, frame, &self.state, self.algorithm)
    }

    /// The requested frames, which come before those of loops and spheres.
    pub(crate) fn frames(&self) -> impl Iterator<Item = FrameId> + use<> {
        let others = 2 * self.bodies.loops.len() + self.bodies.spheres.len();
        list::ids(self.bodies.frames.len() - others)
    }

    /// The path to the frame, in the frame of the recursions.
    pub(crate) fn path(&self) -> carry::Path<'g> {
        match self.algorithm.frame {
            Frame::Link => self.link_path(),
            Frame::Base => self.link_path().in_frame_0(),
        }
    }

    /// The joints with their displacements, in the frames of the links.
    pub(crate) fn link_joints(&self) -> carry::Joints<'g> {
        carry::joints(self.bodies, &self.state, self.algorithm)
    }

    /// The same with the inertia of the base, but with the origin of frame 0 at the root: for functions that do not
    /// depend on that origin. A robot far from it then loses no digits, and the path to it is not computed.
    pub(crate) fn seen_from_root(&self) -> (carry::Joints<'g>, Inertia<Term<'g>>) {
        let base = self.bodies.base;
        match self.algorithm.frame {
            Frame::Link => carry::from_root(self.link_joints(), base),
            Frame::Base => (self.joints(), base),
        }
    }

    /// The joints with their displacements, in the frame of the recursions.
    pub(crate) fn joints(&self) -> carry::Joints<'g> {
        match self.algorithm.frame {
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
        self.entries(Variable::Qdd)
    }

    /// q̈ = 0, one entry a velocity.
    pub(crate) fn coasting(&self) -> List<VelocityId, Term<'g>> {
        List::filled(self.state.zero(), self.velocities().len())
    }

    /// H of the frame without gravity, where `second` is the joint acceleration of a body.
    pub(crate) fn acceleration(&self, second: impl Fn(BodyId) -> Term<'g>) -> Vec<Term<'g>> {
        match (self.algorithm.frame, self.algorithm.pose) {
            (Frame::Link, Carried::Outwards) => {
                let (path, gravity) = (self.link_path(), self.gravity);
                twist::acceleration_with_dynamics(&path, gravity, &self.state, second)
            }
            _ => twist::acceleration(&self.path(), &self.state, second),
        }
    }

    /// τ of a motion with the given q̈, one entry a velocity, less the torques of external wrenches: τ − Σ Jᵗ Φ.
    pub(crate) fn driving(&self, qdd: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let external = self.external(self.algorithm.frame);
        self.against(self.gravity, &self.state, qdd, &external)
    }

    /// The external wrenches on bodies, in the frames of the links or in frame 0.
    pub(crate) fn external(&self, frame: Frame) -> Vec<(BodyId, Action<Term<'g>>)> {
        let algorithm = Algorithm {
            frame,
            ..self.algorithm
        };
        external::external(self.bodies, &self.state, algorithm)
    }

    /// τ of a motion with the given q̈, one entry a velocity each.
    pub(crate) fn torques(&self, qdd: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        self.against(self.gravity, &self.state, qdd, &[])
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
        external: &[(BodyId, Action<Term<'g>>)],
    ) -> List<VelocityId, Term<'g>> {
        let qdd = velocities::shared(state, self.bodies, qdd);
        let joints = self.joints();
        let driving = newton_euler::inverse_dynamics(&joints, gravity, state, &qdd, external);
        self.forces(&driving)
    }

    /// τ from the torques on each body.
    pub(crate) fn forces(&self, driving: &List<BodyId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        velocities::gathered(&self.state, self.bodies, driving)
    }

    /// The columns of a Jacobian, from the screws of each body.
    pub(crate) fn columns(&self, screws: &List<BodyId, Screw<Term<'g>>>) -> Vec<Term<'g>> {
        self.gathered(&screws.map(|screw| screw.entries()))
    }

    /// The columns of any matrix with a row for each of some entries, from those of each body.
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

    /// Y of τ = Y π by its columns; in the frames of the links, for every algorithm.
    pub(crate) fn regressor(&self) -> List<ParameterId, List<VelocityId, Term<'g>>> {
        // q̈ is read only when it is needed, because older terms come first in a sum.
        let second = |k| self.state.qdd(k);
        let columns = self.regressor_of_links(second).into_iter();
        columns.chain(self.regressor_of_actuators(second)).collect()
    }

    /// The columns of inertial parameters, where `second` is the joint acceleration of a body.
    fn regressor_of_links(
        &self,
        second: impl Fn(BodyId) -> Term<'g>,
    ) -> Vec<List<VelocityId, Term<'g>>> {
        let (joints, state) = (self.plain_joints(), &self.state);
        let columns = regressor::regressor(&joints, &self.links(), self.gravity, state, second);
        columns.iter().map(|column| self.forces(column)).collect()
    }

    /// λᵗ Y of the inertial parameters for each of some λ, where `second` is the joint acceleration of a body.
    fn regressor_of_links_along(
        &self,
        second: impl Fn(BodyId) -> Term<'g>,
        weights: &[List<VelocityId, Term<'g>>],
    ) -> Vec<Vec<Term<'g>>> {
        let (joints, state) = (self.plain_joints(), &self.state);
        let links = regressor::motions(&joints, &self.links(), self.gravity, state, second);
        // A twist is carried to each link, and each of its powers has two products or more.
        let operations = 2 * regressor::PARAMETERS * joints.len();
        alike(weights, operations, |weights| {
            let weights = velocities::shared(state, self.bodies, weights);
            regressor::along(&joints, &links, state, &weights)
        })
    }

    /// The columns of armature, damping and friction, if they are parameters.
    fn regressor_of_actuators(
        &self,
        second: impl Fn(BodyId) -> Term<'g>,
    ) -> Vec<List<VelocityId, Term<'g>>> {
        if !self.bodies.identifies_actuators {
            return Vec::new();
        }
        let columns = regressor::of_actuators(&self.plain_joints(), &self.state, &second);
        columns.iter().map(|column| self.forces(column)).collect()
    }

    /// The kinetic energy of each inertial parameter at 1.
    pub(crate) fn kinetic_energy_regressor(&self) -> Vec<Term<'g>> {
        let (joints, state) = (self.plain_joints(), &self.state);
        let mut energies = regressor::kinetic_energy(&joints, &self.links(), state);
        if self.bodies.identifies_actuators {
            energies.extend(regressor::kinetic_energy_of_actuators(&joints, state));
        }
        energies
    }

    /// The potential energy of each inertial parameter at 1.
    pub(crate) fn potential_energy_regressor(&self) -> Vec<Term<'g>> {
        let (joints, gravity) = (self.plain_joints(), self.gravity);
        let mut energies =
            regressor::potential_energy(&joints, &self.links(), gravity, &self.state);
        if self.bodies.identifies_actuators {
            energies.extend(vec![self.state.zero(); 3 * joints.len()]);
        }
        energies
    }

    /// The pose of each link's frame in its body's; `None` for bodies that are no links.
    fn links(&self) -> List<BodyId, Option<Pose<Term<'g>>>> {
        self.bodies.bodies.map(|body| body.link)
    }

    /// The joints in the frames of the links, by the plain algorithm.
    fn plain_joints(&self) -> carry::Joints<'g> {
        carry::joints(self.bodies, &self.state, Algorithm::PLAIN)
    }

    /// A matrix by rows, from columns with an entry for each velocity.
    pub(crate) fn rows_of(&self, columns: &[&List<VelocityId, Term<'g>>]) -> Vec<Term<'g>> {
        let row = |row: VelocityId| columns.iter().map(move |column| column[row]);
        self.velocities().flat_map(row).collect()
    }

    /// ∂τ/∂q and ∂τ/∂q̇ of a motion with the given q̈, with the external wrenches.
    pub(crate) fn torque_derivatives(
        &self,
        qdd: &List<VelocityId, Term<'g>>,
    ) -> [Square<VelocityId, Term<'g>>; 2] {
        let qdd = velocities::shared(&self.state, self.bodies, qdd);
        let (joints, gravity) = (self.joints(), self.gravity);
        let [constant, rotating] = self.external_wrenches();
        let [mut by_coordinate, by_rate] =
            derivatives::inverse_dynamics(&joints, gravity, &self.state, &qdd, &rotating);
        derivatives::add_constant_wrenches(&mut by_coordinate, &joints, &constant);
        [by_coordinate, by_rate].map(|matrix| self.by_velocities(matrix))
    }

    /// λ, one entry a velocity.
    pub(crate) fn weights(&self) -> List<VelocityId, Term<'g>> {
        self.entries(Variable::Weights)
    }

    /// An argument over velocities.
    pub(crate) fn entries(&self, of: Variable) -> List<VelocityId, Term<'g>> {
        let entry = |k| self.state.of_velocity(of, k);
        self.velocities().map(entry).collect()
    }

    /// The derivatives of λᵀτ by q, q̇ and q̈ at the given q̈ and λ, with the external wrenches.
    pub(crate) fn torque_gradient(
        &self,
        [qdd, weights]: [&List<VelocityId, Term<'g>>; 2],
    ) -> [List<VelocityId, Term<'g>>; 3] {
        let arguments = [qdd, weights].map(|of| velocities::shared(&self.state, self.bodies, of));
        let arguments = arguments.each_ref();
        let (joints, gravity) = (self.joints(), self.gravity);
        let [constant, rotating] = self.external_wrenches();
        let mut found =
            gradient::inverse_dynamics(&joints, gravity, &self.state, arguments, &rotating);
        let [_, weights] = arguments;
        gradient::add_constant_wrenches(&mut found.q, &joints, weights, &constant);
        [found.q, found.qd, found.qdd].map(|part| self.forces(&part))
    }

    /// The second derivatives of λᵀτ at the given q̈ and λ, with the external wrenches.
    pub(crate) fn torque_hessian(
        &self,
        [qdd, weights]: [&List<VelocityId, Term<'g>>; 2],
    ) -> [Square<VelocityId, Term<'g>>; 4] {
        let arguments = [qdd, weights].map(|of| velocities::shared(&self.state, self.bodies, of));
        let arguments = arguments.each_ref();
        let (joints, gravity) = (self.joints(), self.gravity);
        let [constant, rotating] = self.external_wrenches();
        let mut found =
            hessian::inverse_dynamics(&joints, gravity, &self.state, arguments, &rotating);
        let [_, weights] = arguments;
        hessian::add_constant_wrenches(&mut found.q_q, &joints, weights, &constant);
        [found.q_q, found.q_qd, found.qd_qd, found.q_qdd].map(|block| self.by_velocities(block))
    }

    /// The external wrenches that are constant in frame 0, and those that rotate with their bodies.
    fn external_wrenches(&self) -> [Vec<(BodyId, Action<Term<'g>>)>; 2] {
        let external = self.external(self.algorithm.frame);
        if self.bodies.external_in_frame_0 {
            [external, Vec::new()]
        } else {
            [Vec::new(), external]
        }
    }

    /// ∂τ/∂q at rest, by rows.
    pub(crate) fn gravity_derivative(&self) -> Square<VelocityId, Term<'g>> {
        let gravity = self.gravity;
        self.by_velocities(gravity::derivative(&self.joints(), gravity, &self.state))
    }

    /// The Coriolis matrix C, by rows.
    pub(crate) fn coriolis_matrix(&self) -> Square<VelocityId, Term<'g>> {
        self.by_velocities(derivatives::coriolis_matrix(&self.joints(), &self.state))
    }

    /// A matrix with a row and a column for each velocity, from one with those for each body.
    pub(crate) fn by_velocities(
        &self,
        matrix: Square<BodyId, Term<'g>>,
    ) -> Square<VelocityId, Term<'g>> {
        velocities::gathered_by_both(&self.state, self.bodies, matrix)
    }

    /// M, by rows.
    pub(crate) fn mass_matrix(&self) -> Square<VelocityId, Term<'g>> {
        let matrix = composite::mass_matrix(&self.joints(), &self.state);
        velocities::gathered_twice(&self.state, self.bodies, matrix)
    }
}

impl<'g> Scene<'_, 'g> {
    /// q̈ for τ, against gravity and with closed loops, and the multipliers λ of the loops.
    pub(crate) fn constrained(&self) -> [Vec<Term<'g>>; 2] {
        let bias = self.torques(&self.coasting());
        let forces = bias.numbered();
        let forces = forces.map(|(k, &bias)| self.state.of_velocity(Variable::Tau, k) - bias);
        let forces: List<VelocityId, _> = forces.collect();
        let loops = constrained::Loops {
            jacobian: loops::jacobian(self),
            bias: loops::bias(self),
            alike: loops::alike(self.bodies),
            order: self.bodies.elimination.clone(),
            zero_pivot: self.algorithm.scalar.zero_pivot(),
        };
        constrained::accelerations(&self.mass_matrix(), &self.parents(), &forces, &loops)
    }

    /// τ of the actuated joints in a motion that keeps loops closed.
    pub(crate) fn actuated(&self) -> List<VelocityId, Term<'g>> {
        let loops = constrained::Loops {
            jacobian: loops::jacobian(self),
            bias: Vec::new(),
            alike: loops::alike(self.bodies),
            order: self.bodies.elimination.clone(),
            zero_pivot: self.algorithm.scalar.zero_pivot(),
        };
        let needed = self.torques(&self.qdd());
        constrained::actuated(&needed, &self.bodies.actuated, &loops)
    }
}

/// For each velocity the diagonal entry of the mass matrix and its pivot.
#[must_use]
pub fn pivots<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, Algorithm::PLAIN);
    forward_dynamics::pivots(&scene.mass_matrix(), &scene.parents())
}

/// The same by articulated bodies, if each has a velocity of its own. The other entries, of which there are as many as
/// pairs of joints, are not computed.
#[must_use]
pub fn articulated_pivots<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, Algorithm::PLAIN);
    let pivots = articulated::pivots(&scene.link_joints()).into_iter();
    pivots.flatten().collect()
}

/// The equation of accelerations: M, by rows, the torques at q̈ = 0 and, if a residual is computed, those of q̈; of a free
/// base relative to its fall.
pub(crate) fn equation<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    algorithm: Algorithm,
    has_residual: bool,
) -> Vec<Term<'g>> {
    let falling = FreeFall::of(&Scene::new(graph, bodies, FrameId::FIRST, algorithm));
    let scene = falling.scene();
    let mut terms = Vec::from(scene.mass_matrix());
    terms.extend(scene.driving(&scene.coasting()));
    if has_residual {
        terms.extend(scene.driving(&scene.qdd()));
    }
    terms
}

/// The derivatives by q and q̇ of the torques of accelerations relative to the fall of a floating base, by rows.
pub(crate) fn torque_derivatives<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    algorithm: Algorithm,
) -> Vec<Term<'g>> {
    let falling = FreeFall::of(&Scene::new(graph, bodies, FrameId::FIRST, algorithm));
    let qdd = falling.scene().qdd();
    falling.torque_derivatives(&qdd).map(Vec::from).concat()
}

/// The acceleration of the fall of a floating base, and its derivatives by q and q̇, by rows; zeros if the base is
/// fixed.
pub(crate) fn free_fall<'g>(graph: &'g Graph, bodies: &Bodies<'g>) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, Algorithm::PLAIN);
    let falling = FreeFall::of(&scene);
    let derivatives = falling.derivatives().map(Vec::from).concat();
    let acceleration = Vec::from(falling.acceleration());
    acceleration.into_iter().chain(derivatives).collect()
}

/// The equation for the refinement of M⁻¹: M, by rows, and M q̈ for q̈ = 0 and for any.
pub(crate) fn equation_at_rest<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    algorithm: Algorithm,
) -> Vec<Term<'g>> {
    let scene = Scene::new(graph, bodies, FrameId::FIRST, algorithm);
    let mut terms = Vec::from(scene.mass_matrix());
    terms.extend(scene.coasting());
    terms.extend(scene.inertial(&scene.qdd()));
    terms
}

/// The motion in the articulated-body recursion, of a floating base relative to its fall: see [`articulated::motion`].
pub(crate) fn articulated_motion<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    algorithm: Algorithm,
) -> Vec<Term<'g>> {
    let falling = FreeFall::of(&Scene::new(graph, bodies, FrameId::FIRST, algorithm));
    let scene = falling.scene();
    let external = scene.external(Frame::Link);
    articulated::motion(&scene.link_joints(), scene.gravity, &scene.state, &external)
}

/// One step inwards of the articulated-body recursion from each joint: see [`articulated::step`].
pub(crate) fn articulated_steps<'g>(
    graph: &'g Graph,
    bodies: &Bodies<'g>,
    algorithm: Algorithm,
    entries: &[Term<'g>; ARTICULATED_STEP],
) -> Vec<Vec<Term<'g>>> {
    let joints = Scene::new(graph, bodies, FrameId::FIRST, algorithm).link_joints();
    let steps = joints.iter().map(|joint| articulated::step(joint, entries));
    steps.collect()
}
