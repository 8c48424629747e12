//! A floating base: the motion relative to free fall.
//!
//! In: bodies, and a state. Out: for a robot whose bodies are all carried by one floating joint, the acceleration
//! f = Rᵗ g − ω × v of the base where no force acts, in the axes of the base, with the rotation R, the velocity v and
//! the angular velocity ω of the base, and the derivatives of f.
//!
//! Torques and forces determine α = q̈ − f, whatever the gravity, the orientation and the velocity v: they are those of
//! an observer who falls with the base. Solved for α, accelerations lose no digits where weights and inertial forces
//! cancel, and no column of derivatives is computed for the base's position, orientation and velocity v but those of f.

use super::{Scene, velocities};
use crate::chain::{BodyId, Position};
use crate::expression::Term;
use crate::joint::Manifold;
use crate::layout::Bodies;
use crate::list::{Id, List, Square};
use crate::matrix::{Pose, Vector};
use crate::space::{CoordinateId, Variable, VelocityId};

/// The coordinates and velocities of a floating base.
#[derive(Clone, Copy)]
struct FreeBase<'g> {
    /// Its first coordinate.
    first: CoordinateId,
    /// M of its frame in frame 0 where its coordinates are zero.
    placement: Pose<Term<'g>>,
    /// The components of v.
    linear: [VelocityId; 3],
    /// The components of ω.
    angular: [VelocityId; 3],
}

impl<'g> FreeBase<'g> {
    /// The floating base of some bodies; `None` if one of them hangs on a base that is fixed, or if a resistance or an
    /// inertia of an actuator acts along v.
    fn of(bodies: &Bodies<'g>) -> Option<Self> {
        let mut roots = bodies.bodies.iter().filter(|body| body.parent.is_none());
        let (root, None) = (roots.next()?, roots.next()) else {
            return None;
        };
        let Position::Manifold(Manifold::Floating, first) = root.position else {
            return None;
        };
        // The base has six bodies, one a velocity, before all others.
        let along = |translates: bool, axis: usize| {
            let mut own = bodies.bodies.iter().take(6);
            let body = own.find(|body| body.motion.translates() == translates && body.axis == axis);
            body.expect("a floating joint has a velocity of each kind along each axis")
        };
        let [linear, angular] =
            [true, false].map(|translates| [0, 1, 2].map(|axis| along(translates, axis)));
        let mut parts = linear.iter().flat_map(|body| body.actuator.entries());
        if parts.any(|part| !part.is_zero()) {
            return None;
        }
        let [linear, angular] = [linear, angular].map(|of| of.map(|body| body.velocity));
        Some(Self {
            first,
            placement: root.placement,
            linear,
            angular,
        })
    }

    /// True if it is a velocity of the base.
    fn has(self, velocity: VelocityId) -> bool {
        self.linear.contains(&velocity) || self.angular.contains(&velocity)
    }
}

/// A function's scene in free fall; the scene itself if the base is not free, with f = 0.
pub(crate) struct FreeFall<'s, 'g> {
    /// The scene of an observer at rest.
    outside: Scene<'s, 'g>,
    scene: Scene<'s, 'g>,
    base: Option<FreeBase<'g>>,
}

impl<'s, 'g> FreeFall<'s, 'g> {
    /// The fall of the base of a scene.
    pub(crate) fn of(scene: &Scene<'s, 'g>) -> Self {
        let base = FreeBase::of(scene.bodies);
        let mut falling = scene.clone();
        if let Some(base) = base {
            falling.gravity = Vector::zero(scene.graph);
            falling.state = scene.state.without(base.linear);
        }
        Self {
            outside: scene.clone(),
            scene: falling,
            base,
        }
    }

    /// The scene of an observer who falls with the base: without gravity, and without v.
    pub(crate) const fn scene(&self) -> &Scene<'s, 'g> {
        &self.scene
    }

    /// True if α does not depend on a coordinate: on those of the base, unless a wrench is constant in frame 0.
    fn ignores_coordinate(&self, velocity: VelocityId) -> bool {
        let bodies = self.scene.bodies;
        let is_oriented = bodies.external_in_frame_0 && !bodies.external.is_empty();
        !is_oriented && self.base.is_some_and(|base| base.has(velocity))
    }

    /// True if α does not depend on a velocity.
    fn ignores_rate(&self, velocity: VelocityId) -> bool {
        (self.base).is_some_and(|base| base.linear.contains(&velocity))
    }

    /// ∂τ/∂q and ∂τ/∂q̇ at the given α.
    pub(crate) fn torque_derivatives(
        &self,
        relative: &List<VelocityId, Term<'g>>,
    ) -> [Square<VelocityId, Term<'g>>; 2] {
        let [mut by_q, mut by_qd] = self.scene.torque_derivatives(relative);
        self.clear(&mut by_q, |_, column| self.ignores_coordinate(column));
        self.clear(&mut by_qd, |_, column| self.ignores_rate(column));
        [by_q, by_qd]
    }

    /// The derivatives of λᵀτ by q and q̇ at the given α and λ.
    pub(crate) fn torque_gradient(
        &self,
        arguments: [&List<VelocityId, Term<'g>>; 2],
    ) -> [List<VelocityId, Term<'g>>; 2] {
        let [mut by_q, mut by_qd, _] = self.scene.torque_gradient(arguments);
        let zero = self.scene.state.zero();
        for k in self.scene.velocities() {
            if self.ignores_coordinate(k) {
                by_q[k] = zero;
            }
            if self.ignores_rate(k) {
                by_qd[k] = zero;
            }
        }
        [by_q, by_qd]
    }

    /// The second derivatives of λᵀτ at the given α and λ: by q and q, q and q̇, q̇ and q̇, q and q̈.
    pub(crate) fn torque_hessian(
        &self,
        arguments: [&List<VelocityId, Term<'g>>; 2],
    ) -> [Square<VelocityId, Term<'g>>; 4] {
        let [mut q_q, mut q_qd, mut qd_qd, mut q_qdd] = self.scene.torque_hessian(arguments);
        self.clear(&mut q_q, |row, column| {
            self.ignores_coordinate(row) || self.ignores_coordinate(column)
        });
        self.clear(&mut q_qd, |row, column| {
            self.ignores_coordinate(row) || self.ignores_rate(column)
        });
        self.clear(&mut qd_qd, |row, column| {
            self.ignores_rate(row) || self.ignores_rate(column)
        });
        self.clear(&mut q_qdd, |row, _| self.ignores_coordinate(row));
        [q_q, q_qd, qd_qd, q_qdd]
    }

    /// Sets the entries to zero that are so whatever the arguments.
    fn clear(
        &self,
        matrix: &mut Square<VelocityId, Term<'g>>,
        is_zero: impl Fn(VelocityId, VelocityId) -> bool,
    ) {
        for place in matrix.places() {
            if is_zero(place.0, place.1) {
                matrix[place] = self.scene.state.zero();
            }
        }
    }

    /// Y of τ = Y π by its columns at the given α.
    pub(crate) fn regressor(
        &self,
        relative: &List<VelocityId, Term<'g>>,
    ) -> Vec<List<VelocityId, Term<'g>>> {
        let second = self.shared(relative);
        let mut columns = self.scene.regressor_of_links(|k| second[k]);
        columns.extend(self.regressor_of_actuators(relative));
        columns
    }

    /// λᵗ Y at the given α, for each of some λ.
    pub(crate) fn regressor_along(
        &self,
        relative: &List<VelocityId, Term<'g>>,
        weights: &[List<VelocityId, Term<'g>>],
    ) -> Vec<Vec<Term<'g>>> {
        let second = self.shared(relative);
        let mut rows = self.scene.regressor_of_links_along(|k| second[k], weights);
        let columns = self.regressor_of_actuators(relative);
        for (row, weights) in rows.iter_mut().zip(weights) {
            row.extend(columns.iter().map(|column| self.dot(column, weights)));
        }
        rows
    }

    /// The columns of actuators, which move with q̈.
    fn regressor_of_actuators(
        &self,
        relative: &List<VelocityId, Term<'g>>,
    ) -> Vec<List<VelocityId, Term<'g>>> {
        let second = self.shared(&self.accelerations(relative));
        self.outside.regressor_of_actuators(|k| second[k])
    }

    /// The values of each body, from those of each velocity.
    fn shared(&self, of: &List<VelocityId, Term<'g>>) -> List<BodyId, Term<'g>> {
        velocities::shared(&self.scene.state, self.scene.bodies, of)
    }

    /// q̈ = α + f.
    pub(crate) fn accelerations(
        &self,
        relative: &List<VelocityId, Term<'g>>,
    ) -> List<VelocityId, Term<'g>> {
        let fall = self.acceleration();
        let sums = relative.iter().zip(&fall);
        sums.map(|(&relative, &fall)| relative + fall).collect()
    }

    /// f, one entry a velocity.
    pub(crate) fn acceleration(&self) -> List<VelocityId, Term<'g>> {
        let mut entries = self.scene.coasting();
        if let Some(base) = self.base {
            let [velocity, omega] = self.motion(base);
            let f = self.gravity(base) - omega.cross(velocity);
            for (k, entry) in base.linear.into_iter().zip(f.0) {
                entries[k] = entry;
            }
        }
        entries
    }

    /// ∂f/∂q and ∂f/∂q̇, a row for each entry of f.
    pub(crate) fn derivatives(&self) -> [Square<VelocityId, Term<'g>>; 2] {
        let zero = Square::filled(self.scene.state.zero(), self.scene.velocities().len());
        let [mut by_q, mut by_qd] = [zero.clone(), zero];
        let Some(base) = self.base else {
            return [by_q, by_qd];
        };
        let (gravity, [velocity, omega]) = (self.gravity(base), self.motion(base));
        let set = |matrix: &mut Square<_, _>, column, entries: Vector<Term<'g>>| {
            for (row, entry) in base.linear.into_iter().zip(entries.0) {
                matrix[(row, column)] = entry;
            }
        };
        for (axis, (linear, angular)) in self.axes(base) {
            set(&mut by_q, angular, gravity.cross(axis));
            set(&mut by_qd, angular, velocity.cross(axis));
            set(&mut by_qd, linear, axis.cross(omega));
        }
        [by_q, by_qd]
    }

    /// The change of f, one entry a velocity.
    pub(crate) fn change(&self) -> List<VelocityId, Term<'g>> {
        let changes = [Variable::QChange, Variable::QdChange].map(|of| self.scene.entries(of));
        let by_each = self.derivatives();
        let rows = self.scene.velocities().map(|row| {
            let parts = by_each.iter().zip(&changes);
            let terms = parts.flat_map(|(matrix, changes)| {
                let terms = matrix.row(row).zip(changes);
                terms.map(|(entry, &change)| entry * change)
            });
            terms.fold(self.scene.state.zero(), |sum, term| sum + term)
        });
        rows.collect()
    }

    /// The derivatives of λᵀf by q and q̇.
    pub(crate) fn gradient(
        &self,
        weights: &List<VelocityId, Term<'g>>,
    ) -> [List<VelocityId, Term<'g>>; 2] {
        self.derivatives().map(|matrix| {
            let columns = matrix.ids().map(|column| matrix.column(column));
            columns.map(|column| self.dot(&column, weights)).collect()
        })
    }

    /// The second derivatives of λᵀf by q and q, where an entry is the derivative by the row's coordinate of the
    /// derivative by the column's, and by q̇ and q̇. Those by q and q̇ are zero.
    pub(crate) fn hessian(
        &self,
        weights: &List<VelocityId, Term<'g>>,
    ) -> [Square<VelocityId, Term<'g>>; 2] {
        let zero = Square::filled(self.scene.state.zero(), weights.len());
        let [mut by_q, mut by_qd] = [zero.clone(), zero];
        let Some(base) = self.base else {
            return [by_q, by_qd];
        };
        let (weights, gravity) = (Vector(base.linear.map(|k| weights[k])), self.gravity(base));
        for (outer, (_, row)) in self.axes(base) {
            for (inner, (linear, column)) in self.axes(base) {
                by_q[(row, column)] = weights.dot(gravity.cross(outer).cross(inner));
                by_qd.set_both((row, linear), weights.dot(inner.cross(outer)));
            }
        }
        [by_q, by_qd]
    }

    /// The sum of products, which may be empty.
    fn dot(
        &self,
        one: &List<VelocityId, Term<'g>>,
        other: &List<VelocityId, Term<'g>>,
    ) -> Term<'g> {
        let terms = one.iter().zip(other).map(|(&one, &other)| one * other);
        terms.fold(self.scene.state.zero(), |sum, term| sum + term)
    }

    /// The axes of the base, each with the velocities along and about it.
    fn axes(
        &self,
        base: FreeBase<'g>,
    ) -> impl Iterator<Item = (Vector<Term<'g>>, (VelocityId, VelocityId))> + use<'g> {
        let graph = self.scene.graph;
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let axes = axes.map(|axis| Vector::constant(graph, axis));
        axes.into_iter()
            .zip(base.linear.into_iter().zip(base.angular))
    }

    /// Rᵗ g.
    fn gravity(&self, base: FreeBase<'g>) -> Vector<Term<'g>> {
        let entry = |entry| self.scene.state.coordinate(base.first.plus(entry));
        let displacement = Manifold::Floating.displacement(entry);
        let placed = base.placement.rotation.transposed() * self.outside.gravity;
        displacement.rotation.transposed() * placed
    }

    /// v and ω of the base.
    fn motion(&self, base: FreeBase<'g>) -> [Vector<Term<'g>>; 2] {
        let rate = |k| self.scene.state.of_velocity(Variable::Qd, k);
        [base.linear, base.angular].map(|of| Vector(of.map(rate)))
    }
}
