//! All matrices of a robot in a configuration.
//!
//! In: a [`Robot`] and q. Out: poses, screws and inertias in frame 0; for q̇ and q̈ velocities, accelerations, wrenches
//! and the torques of links and actuators.

mod derivatives;
mod hessian;
mod sizes;

pub(super) use hessian::{Direction, Gradient};

use super::{Approximate, BodyId, Closed, Columns, DegreeOfFreedom, Matrix, Moved, Robot};
use crate::expression::{Arithmetic, Double};
use crate::joint;
use crate::list::{self, Id, List, Square};
use crate::space::{CoordinateId, FrameId, ParameterId, SphereId, VelocityId};

/// A robot in a configuration: all matrices of its links, in frame 0.
pub(super) struct Configuration {
    robot: Robot,
    poses: List<BodyId, Matrix<Approximate>>,
    /// For the joint of each link, each L times its factor, with its velocity.
    screws: List<BodyId, Vec<(VelocityId, Matrix<Approximate>)>>,
    /// J of each link.
    inertias: List<BodyId, Matrix<Approximate>>,
}

/// The motion of the joints: q̇ and q̈.
pub(super) struct Rates {
    pub(super) first: List<VelocityId, Approximate>,
    pub(super) second: List<VelocityId, Approximate>,
}

impl Configuration {
    pub(super) fn of(robot: Robot, q: &[Double]) -> Self {
        let q = |k: CoordinateId| Approximate::exact(q[k.index()]);
        let mut poses: List<BodyId, Matrix<Approximate>> = List::new();
        let (mut screws, mut inertias) = (List::new(), List::new());
        for body in &robot.bodies {
            let displacement = match body.moved {
                Moved::By {
                    screw,
                    coordinate,
                    factor,
                    offset,
                } => Matrix::displacement(screw, &(factor * q(coordinate) + offset)),
                Moved::Held(screw, at) => Matrix::displacement(screw, &Approximate::written(at)),
                Moved::Manifold(manifold, first) => placed(manifold, |entry| q(first.plus(entry))),
            };
            let mut pose = body.placement.times(&displacement);
            if let Some(parent) = body.parent {
                pose = poses[parent].times(&pose);
            }
            let degrees_of_freedom = body.degrees_of_freedom.iter().map(|degree_of_freedom| {
                let [u, b] = degree_of_freedom.screw;
                let screw = pose.carries(&Matrix::screw(u, b));
                (
                    degree_of_freedom.velocity,
                    screw.scaled(&degree_of_freedom.factor),
                )
            });
            screws.push(degrees_of_freedom.collect());
            inertias.push(pose.times(&body.inertia).times(&pose.transposed()));
            poses.push(pose);
        }
        Self {
            robot,
            poses,
            screws,
            inertias,
        }
    }

    /// J of each link.
    pub(super) fn inertias(&self) -> &[Matrix<Approximate>] {
        &self.inertias
    }

    /// For each link, true if a joint moves it.
    pub(super) fn moves(&self) -> List<BodyId, bool> {
        let mut moves: List<BodyId, bool> = List::new();
        for body in &self.robot.bodies {
            let carried = body.parent.is_some_and(|parent| moves[parent]);
            moves.push(carried || !body.degrees_of_freedom.is_empty());
        }
        moves
    }

    /// The loops.
    pub(super) fn loops(&self) -> &[Closed] {
        &self.robot.loops
    }

    /// The residuals of all loops in the order in which they are eliminated.
    pub(super) fn elimination(&self) -> &[usize] {
        &self.robot.elimination
    }

    /// Changes the order in which residuals are eliminated.
    pub(super) fn eliminate_in(&mut self, order: Vec<usize>) {
        self.robot.elimination = order;
    }

    /// The velocities with an actuator.
    pub(super) fn actuated(&self) -> &[VelocityId] {
        &self.robot.actuated
    }

    /// The numbers of all velocities.
    fn velocities(&self) -> impl Iterator<Item = VelocityId> + use<> {
        list::ids(self.robot.velocities)
    }

    /// The degrees of freedom of all bodies.
    pub(super) fn degrees_of_freedom(&self) -> impl Iterator<Item = &DegreeOfFreedom> {
        self.robot
            .bodies
            .iter()
            .flat_map(|body| &body.degrees_of_freedom)
    }

    /// Acceleration of gravity in frame 0.
    pub(super) const fn gravity(&self) -> [Approximate; 3] {
        self.robot.gravity
    }

    /// The columns of the base regressor, as columns of the regressor.
    pub(super) fn base_columns(&self) -> &[ParameterId] {
        &self.robot.base_columns
    }

    /// M of a frame.
    pub(super) fn pose(&self, frame: FrameId) -> Matrix<Approximate> {
        self.robot.frames[frame].map_or_else(Matrix::identity, |body| self.poses[body].clone())
    }

    /// The frame and the radius of each collision sphere.
    pub(super) const fn spheres(&self) -> &List<SphereId, (FrameId, Approximate)> {
        &self.robot.spheres
    }

    /// The pairs of spheres that have distances.
    pub(super) fn pairs(&self) -> &[[SphereId; 2]] {
        &self.robot.pairs
    }

    /// The requested frames.
    pub(super) fn frames(&self) -> impl Iterator<Item = FrameId> + use<> {
        list::ids(self.robot.requested)
    }

    /// The screws of the joints that move a frame, with their indices in q̇.
    pub(super) fn moving(&self, frame: FrameId) -> Vec<&(VelocityId, Matrix<Approximate>)> {
        let mut moving = Vec::new();
        let mut at = self.robot.frames[frame];
        while let Some(body) = at {
            moving.extend(&self.screws[body]);
            at = self.robot.bodies[body].parent;
        }
        moving
    }

    /// The same, each with L̇ = W L − L W, with W of the link that the joint carries.
    pub(super) fn moving_rates(
        &self,
        frame: FrameId,
        rates: &Rates,
    ) -> Vec<(VelocityId, &Matrix<Approximate>, Matrix<Approximate>)> {
        let motions = self.motions(rates);
        let mut moving = Vec::new();
        let mut at = self.robot.frames[frame];
        while let Some(body) = at {
            let w = &motions[body].0;
            let screws = self.screws[body].iter();
            moving.extend(screws.map(|(k, screw)| (*k, screw, w.commutator(screw))));
            at = self.robot.bodies[body].parent;
        }
        moving
    }

    /// W and H of each link: W + L q̇, and H + L q̈ + (L q̇)² + 2 W L q̇, where L q̇ is the sum over all velocities
    /// of its joint.
    pub(super) fn motions(
        &self,
        rates: &Rates,
    ) -> List<BodyId, (Matrix<Approximate>, Matrix<Approximate>)> {
        let mut motions: List<BodyId, (Matrix<Approximate>, Matrix<Approximate>)> = List::new();
        for (body, screws) in self.robot.bodies.iter().zip(&self.screws) {
            let (w, h) = match body.parent {
                Some(parent) => motions[parent].clone(),
                None => (Matrix::zero(), Matrix::zero()),
            };
            let sum = |of: &List<VelocityId, Approximate>| {
                let terms = screws.iter().map(|(k, screw)| screw.scaled(&of[*k]));
                terms.reduce(|sum, term| sum.plus(&term))
            };
            let (Some(own), Some(second)) = (sum(&rates.first), sum(&rates.second)) else {
                motions.push((w, h));
                continue;
            };
            let twice = w.times(&own).scaled(&Approximate::exact(2.0));
            let second = second.plus(&own.times(&own));
            motions.push((w.plus(&own), h.plus(&second).plus(&twice)));
        }
        motions
    }

    /// W and H of a frame.
    pub(super) fn motion(
        &self,
        frame: FrameId,
        rates: &Rates,
    ) -> (Matrix<Approximate>, Matrix<Approximate>) {
        match self.robot.frames[frame] {
            Some(body) => self.motions(rates)[body].clone(),
            None => (Matrix::zero(), Matrix::zero()),
        }
    }

    /// The torques of all joints for given accelerations of the links: Φ = skew(H J) of all links outboard, along L.
    fn forces(
        &self,
        acceleration: impl Fn(BodyId) -> Option<Matrix<Approximate>>,
    ) -> List<VelocityId, Approximate> {
        let mut forces = self.nothing();
        let inertias = self.inertias.numbered();
        let mut actions: List<BodyId, Option<Matrix<Approximate>>> = inertias
            .map(|(k, inertia)| Some(acceleration(k)?.times(inertia).skew()))
            .collect();
        for (k, body) in self.robot.bodies.numbered().rev() {
            let Some(action) = actions[k].take() else {
                continue;
            };
            for (velocity, screw) in &self.screws[k] {
                forces[*velocity] = forces[*velocity] + along(screw, &action);
            }
            if let Some(parent) = body.parent {
                actions[parent] = Some(match actions[parent].take() {
                    Some(outer) => outer.plus(&action),
                    None => action,
                });
            }
        }
        forces
    }

    /// Zero for each velocity.
    fn nothing(&self) -> List<VelocityId, Approximate> {
        List::filled(Approximate::exact(0.0), self.robot.velocities)
    }

    /// −H_g.
    fn minus_gravity(&self) -> Matrix<Approximate> {
        let mut minus_gravity = Matrix::zero();
        minus_gravity.set_column(self.robot.gravity.map(|entry| -entry));
        minus_gravity
    }

    /// τ of a motion, against gravity.
    pub(super) fn torques(&self, rates: &Rates) -> List<VelocityId, Approximate> {
        let minus_gravity = self.minus_gravity();
        let motions = self.motions(rates);
        let mut forces = self.forces(|k| Some(motions[k].1.plus(&minus_gravity)));
        for DegreeOfFreedom {
            velocity,
            factor,
            actuator: [armature, damping, friction],
            ..
        } in self.degrees_of_freedom()
        {
            let [rate, second] = [&rates.first, &rates.second].map(|of| *factor * of[*velocity]);
            let actuator = *armature * second + *damping * rate + *friction * rate.sign();
            forces[*velocity] = forces[*velocity] + *factor * actuator;
        }
        forces
    }

    /// Y of τ = Y π by its columns. Each column is τ of a link that alone has mass, with one parameter 1; or of a
    /// joint that alone has an armature, damping or friction of 1. Links without a wanted column have empty ones.
    pub(super) fn regressor(
        &self,
        rates: &Rates,
        is_wanted: impl Fn(ParameterId) -> bool,
    ) -> Columns<Approximate> {
        let mut minus_gravity = Matrix::zero();
        minus_gravity.set_column(self.robot.gravity.map(|entry| -entry));
        let motions = self.motions(rates);
        let mut columns: Columns<Approximate> = List::new();
        for &link in &self.robot.links {
            if !(0..MOMENTS).any(|moment| is_wanted(columns.next().plus(moment))) {
                columns.extend((0..MOMENTS).map(|_| List::new()));
                continue;
            }
            let (h, pose) = (motions[link].1.plus(&minus_gravity), &self.poses[link]);
            for inertia in unit_inertias(pose) {
                let action = h.times(&inertia).skew();
                let mut column = self.nothing();
                let mut at = Some(link);
                while let Some(body) = at {
                    for (velocity, screw) in &self.screws[body] {
                        column[*velocity] = column[*velocity] + along(screw, &action);
                    }
                    at = self.robot.bodies[body].parent;
                }
                columns.push(column);
            }
        }
        columns.extend(self.regressor_of_actuators(rates));
        columns
    }

    /// A number for each inertial parameter of the links: a function of a link and of the J that the parameter is at 1.
    pub(super) fn of_each_parameter(
        &self,
        of: impl Fn(BodyId, &Matrix<Approximate>) -> Approximate,
    ) -> Vec<Approximate> {
        let links = self.robot.links.iter();
        let numbers = links.flat_map(|&link| {
            let inertias = unit_inertias(&self.poses[link]);
            inertias
                .map(|inertia| of(link, &inertia))
                .collect::<Vec<_>>()
        });
        numbers.collect()
    }

    /// The degrees of freedom whose armature, damping and friction are parameters.
    pub(super) fn identified(&self) -> impl Iterator<Item = &DegreeOfFreedom> {
        let identified = self.robot.identified.iter().flatten();
        identified.flat_map(|&body| &self.robot.bodies[body].degrees_of_freedom)
    }

    /// The columns of armature, damping and friction.
    fn regressor_of_actuators(&self, rates: &Rates) -> Vec<List<VelocityId, Approximate>> {
        let mut columns = Vec::new();
        for degree_of_freedom in self.identified() {
            let DegreeOfFreedom {
                velocity, factor, ..
            } = degree_of_freedom;
            let [rate, second] = [&rates.first, &rates.second].map(|of| *factor * of[*velocity]);
            for term in [second, rate, rate.sign()] {
                let mut column = self.nothing();
                column[*velocity] = *factor * term;
                columns.push(column);
            }
        }
        columns
    }

    /// The torques of external wrenches: for each wrench Φ, L ⊗ Φ of all joints inboard of it.
    pub(super) fn external_torques(&self, actions: &[Double]) -> List<VelocityId, Approximate> {
        let mut forces = self.nothing();
        for (link, action) in self.external_wrenches(actions) {
            for body in self.inwards(link) {
                for (velocity, screw) in &self.screws[body] {
                    forces[*velocity] = forces[*velocity] + along(screw, &action);
                }
            }
        }
        forces
    }

    /// The external wrenches in frame 0, each with its body.
    fn external_wrenches(
        &self,
        actions: &[Double],
    ) -> impl Iterator<Item = (BodyId, Matrix<Approximate>)> {
        let (bodies, in_frame_0) = &self.robot.external;
        bodies
            .iter()
            .zip(actions.chunks(6))
            .map(|(&body, entries)| {
                let entry = |k: usize| Approximate::exact(entries[k]);
                let [c, f] = [0, 3].map(|first| [entry(first), entry(first + 1), entry(first + 2)]);
                let action = Matrix::action(c, f);
                let pose = &self.poses[body];
                let action = if *in_frame_0 {
                    action
                } else {
                    pose.times(&action).times(&pose.transposed())
                };
                (body, action)
            })
    }

    /// A body and its ancestors, from it inwards.
    fn inwards(&self, body: BodyId) -> impl Iterator<Item = BodyId> {
        let outer = |&body: &BodyId| self.robot.bodies[body].parent;
        std::iter::successors(Some(body), outer)
    }

    /// M: column k is the torques if H of a link is the sum of the L that belong to velocity k, of all joints inboard
    /// of it.
    pub(super) fn mass_matrix(&self) -> Square<VelocityId, Approximate> {
        let column = |velocity: VelocityId| {
            let mut accelerations: List<BodyId, Option<Matrix<Approximate>>> = List::new();
            for (body, screws) in self.robot.bodies.iter().zip(&self.screws) {
                let outer = body.parent.and_then(|parent| accelerations[parent].clone());
                let own = screws.iter().filter(|(of, _)| *of == velocity);
                let own = own.map(|(_, screw)| screw.clone());
                accelerations.push(outer.into_iter().chain(own).reduce(|a, b| a.plus(&b)));
            }
            let mut forces = self.forces(|link| accelerations[link].clone());
            for degree_of_freedom in self
                .degrees_of_freedom()
                .filter(|degree_of_freedom| degree_of_freedom.velocity == velocity)
            {
                let [armature, ..] = degree_of_freedom.actuator;
                forces[velocity] = forces[velocity]
                    + degree_of_freedom.factor * degree_of_freedom.factor * armature;
            }
            forces
        };
        Square::of_columns(&self.velocities().map(column).collect())
    }
}

/// Number of inertial parameters of a link.
const MOMENTS: usize = 10;

/// L ⊗ Φ.
fn along(screw: &Matrix<Approximate>, action: &Matrix<Approximate>) -> Approximate {
    let terms = screw.vectors().into_iter().zip(action.vectors());
    let along = terms.map(|(screw, action)| screw * action);
    along.fold(Approximate::exact(0.0), |sum, term| sum + term)
}

/// J in frame 0 of a link with this pose, M J Mᵗ, with one of m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz equal
/// to 1.
fn unit_inertias(pose: &Matrix<Approximate>) -> impl Iterator<Item = Matrix<Approximate>> {
    let first = [(3, 3), (0, 3), (1, 3), (2, 3)];
    let second = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    first.into_iter().chain(second).map(move |(row, column)| {
        let mut unit = Matrix::zero();
        unit.0[row][column] = Approximate::exact(1.0);
        unit.0[column][row] = Approximate::exact(1.0);
        pose.times(&unit).times(&pose.transposed())
    })
}

/// Q of several coordinates: a translation, and a rotation about z or 1 + 2 w v̲ + 2 v̲² of a quaternion v, w.
fn placed(manifold: joint::Manifold, q: impl Fn(usize) -> Approximate) -> Matrix<Approximate> {
    let zero = Approximate::exact(0.0);
    let rotated = |first: usize| {
        let axis = Matrix::screw([q(first), q(first + 1), q(first + 2)], [zero; 3]);
        let twice = axis.scaled(&Approximate::exact(2.0));
        Matrix::identity()
            .plus(&twice.scaled(&q(first + 3)))
            .plus(&twice.times(&axis))
    };
    match manifold {
        joint::Manifold::Planar => {
            Matrix::translation([q(0), q(1), zero]).times(&Matrix::rotation(2, q(2).sin_cos()))
        }
        joint::Manifold::Spherical => rotated(0),
        joint::Manifold::Floating => Matrix::translation([q(0), q(1), q(2)]).times(&rotated(3)),
    }
}
