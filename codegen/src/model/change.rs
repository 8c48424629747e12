//! Changes of inverse dynamics along a direction: the torques, differentiated on the graph.
//!
//! In: a scene whose arguments have changes. Out: δτ. The recursions are those of τ, so that δτ shares all that τ
//! computes: a rotation of a change is two products, and that of what the rotation turns is in τ already.
//!
//! The displacement M of a joint without axes of its own changes by M Λ, with the change Λ of its velocities: through its
//! quaternion that would take more operations, and bounds would not know that its length stays 1.

use std::collections::BTreeMap;

use super::Scene;
use crate::chain::{BodyId, Position};
use crate::expression::{Expr, Input, Term, along_known, substitute};
use crate::joint::Manifold;
use crate::list::{Id, List};
use crate::matrix::Vector;
use crate::space::{CoordinateId, Variable, VelocityId};

type Torques<'g> = List<VelocityId, Term<'g>>;

/// The change of torques along those of q, q̇ and q̈.
pub(crate) fn of<'g>(scene: &Scene<'_, 'g>, torques: &Torques<'g>) -> Torques<'g> {
    let mut changes = Changes::of_motion(scene);
    changes.add_argument(scene, [Variable::Qdd, Variable::QddChange]);
    changes.along(scene, torques).into()
}

/// The change of torques along those of q and q̇, at constant accelerations.
pub(crate) fn at_constant_accelerations<'g>(
    scene: &Scene<'_, 'g>,
    accelerations: &Torques<'g>,
) -> Torques<'g> {
    // Accelerations depend on q and q̇ themselves, so inputs stand for them until the torques are differentiated.
    let found = Changes::of_motion(scene).along(scene, &scene.driving(&scene.qdd()));
    let found: Vec<Expr> = found.into_iter().map(Term::expr).collect();
    substitute(scene.graph, &found, |input| match input {
        Input::Variable(Variable::Qdd, k) => Some(accelerations[VelocityId::new(k.into())]),
        _ => None,
    })
    .into()
}

/// The known changes of expressions.
struct Changes<'g>(BTreeMap<Expr, Term<'g>>);

impl<'g> Changes<'g> {
    /// Those of q, of displacements, and of q̇.
    fn of_motion(scene: &Scene<'_, 'g>) -> Self {
        let state = &scene.state;
        let mut changes = Self(BTreeMap::new());
        for (k, body) in scene.bodies.bodies.numbered() {
            match body.position {
                Position::Along { coordinate, .. } => {
                    let change = state.of_velocity(Variable::QChange, body.velocity);
                    changes.add(state.coordinate(coordinate), change);
                }
                Position::Manifold(manifold, first) => {
                    changes.add_displacement(scene, k, (manifold, first));
                }
                Position::Taken => {}
            }
        }
        changes.add_argument(scene, [Variable::Qd, Variable::QdChange]);
        changes
    }

    /// Adds that of an expression. Constants have none.
    fn add(&mut self, of: Term<'g>, change: Term<'g>) {
        if of.value().is_none() {
            self.0.insert(of.expr(), change);
        }
    }

    /// Adds those of the displacement of a joint without axes of its own, whose first body has the coordinates.
    fn add_displacement(
        &mut self,
        scene: &Scene<'_, 'g>,
        first: BodyId,
        (manifold, coordinate): (Manifold, CoordinateId),
    ) {
        let state = &scene.state;
        let [mut linear, mut angular] = [(); 2].map(|()| Vector::zero(scene.graph));
        let bodies = scene.bodies.bodies.numbered().skip(first.index());
        let own =
            bodies.take_while(|(k, body)| *k == first || matches!(body.position, Position::Taken));
        for (_, body) in own {
            let change = state.of_velocity(Variable::QChange, body.velocity);
            let half = if body.motion.translates() {
                &mut linear
            } else {
                &mut angular
            };
            half.0[body.axis] = change;
        }
        let displacement = manifold.displacement(|k| state.coordinate(coordinate.plus(k)));
        let rotation = displacement.rotation;
        for (entry, change) in displacement
            .translation
            .0
            .into_iter()
            .zip((rotation * linear).0)
        {
            self.add(entry, change);
        }
        // The rows of R ω̲ are r × ω, of the rows r of R.
        for row in rotation.0 {
            let changes = Vector(row).cross(angular);
            for (entry, change) in row.into_iter().zip(changes.0) {
                self.add(entry, change);
            }
        }
    }

    /// Adds those of an argument over velocities.
    fn add_argument(&mut self, scene: &Scene<'_, 'g>, [argument, change]: [Variable; 2]) {
        for k in scene.velocities() {
            let [entry, change] = [argument, change].map(|of| scene.state.of_velocity(of, k));
            self.add(entry, change);
        }
    }

    /// The changes of torques.
    fn along(&self, scene: &Scene<'_, 'g>, torques: &Torques<'g>) -> Vec<Term<'g>> {
        let torques: Vec<Expr> = torques.iter().map(|torque| torque.expr()).collect();
        along_known(scene.graph, &torques, |expr| self.0.get(&expr).copied())
    }
}
