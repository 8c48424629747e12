//! Joint accelerations by the articulated-body recursion (Featherstone 1983): what a body and all
//! that hangs on it loosely opposes to an acceleration, carried inwards; accelerations outwards.
//!
//! In: the joints and bodies with physical inertias, never regrouped ones. Out: q̈. No mass matrix is
//! formed, so no digit is lost with its conditioning.

use super::State;
use super::carry::Joint;
use super::newton_euler::beyond;
use crate::chain::Motion;
use crate::expression::Term;
use crate::matrix::{Acceleration, Action, Inertia, Pose, Rotation, Symmetric, Vector};

/// q̈ of τ, one entry a joint.
pub fn forward_dynamics<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    let graph = state.graph;
    let count = joints.len();
    let rest = Acceleration::linear(Vector::zero(graph));
    let still = |h: Acceleration<Term<'g>>| Acceleration {
        omega: h.omega,
        ..rest
    };

    // Velocities, the part of each acceleration that they cause, and the actions of that part.
    let mut velocities: Vec<Acceleration<Term<'g>>> = Vec::with_capacity(count);
    let mut drifts = Vec::with_capacity(count);
    let mut articulated = Vec::with_capacity(count);
    let mut actions = Vec::with_capacity(count);
    for (k, joint) in joints.iter().enumerate() {
        let outer = joint.parent.map_or(rest, |parent| velocities[parent]);
        let drift = beyond(outer, joint, state.qd(k), state.zero());
        let velocity = still(drift);
        actions.push(Action::of(velocity, joint.inertia));
        articulated.push(Articulated::of(joint.inertia));
        velocities.push(velocity);
        drifts.push(drift);
    }

    let mut yields = Vec::with_capacity(count);
    for k in (0..count).rev() {
        let (joint, action) = (&joints[k], actions[k]);
        let given = articulated[k].yielding(joint, joint.motion);
        let lacking = state.tau(k) - action.along(joint.screw);
        if let Some(parent) = joint.parent {
            let left = given.left;
            let push = lacking * given.inverse;
            let moved = left.times(drifts[k].omega_dot, drifts[k].a);
            let carried = Action {
                c: action.c + moved.c + given.action.c * push,
                f: action.f + moved.f + given.action.f * push,
            };
            articulated[parent] = articulated[parent]
                + left
                    .turn(joint.turn())
                    .shift(joint.offset())
                    .inboard(joint.placement);
            actions[parent] = actions[parent]
                + carried
                    .change_frame(joint.displacement())
                    .change_frame(joint.placement);
        }
        yields.push((lacking, given));
    }
    yields.reverse();

    // Gravity is an acceleration of the base the other way.
    let base = Acceleration::linear(-gravity);
    let mut accelerations: Vec<Acceleration<Term<'g>>> = Vec::with_capacity(count);
    let mut found = Vec::with_capacity(count);
    for (k, joint) in joints.iter().enumerate() {
        let outer = joint.parent.map_or(base, |parent| Acceleration {
            omega: velocities[parent].omega,
            ..accelerations[parent]
        });
        let carried = beyond(outer, joint, state.qd(k), state.zero());
        let (lacking, given) = &yields[k];
        let opposed = carried.omega_dot.dot(given.action.c) + carried.a.dot(given.action.f);
        let acceleration = (*lacking - opposed) * given.inverse;
        let (u, b) = (joint.screw.u, joint.screw.b);
        accelerations.push(Acceleration {
            omega: carried.omega,
            omega_dot: carried.omega_dot + u * acceleration,
            a: carried.a + b * acceleration,
        });
        found.push(acceleration);
    }
    found
}

/// The linear map from an acceleration (ω̇, a) to the action (c, f) that it takes:
/// c = A ω̇ + B a, f = Bᵗ ω̇ + M a.
#[derive(Clone, Copy)]
struct Articulated<'g> {
    a: Symmetric<Term<'g>>,
    b: Rotation<Term<'g>>,
    m: Symmetric<Term<'g>>,
}

/// What a joint that yields leaves of an articulated inertia.
struct Yielding<'g> {
    /// The action that a unit acceleration of the joint takes.
    action: Action<Term<'g>>,
    /// The reciprocal of the joint's share in it.
    inverse: Term<'g>,
    /// What the joint passes on.
    left: Articulated<'g>,
}

impl<'g> Articulated<'g> {
    /// Of a rigid body: A = Tr(∫rrᵗ) − ∫rrᵗ, B = q̲, M = m.
    fn of(inertia: Inertia<Term<'g>>) -> Self {
        let [xx, yy, zz, xy, xz, yz] = inertia.second.0;
        let [x, y, z] = inertia.q.0;
        let (m, zero) = (inertia.mass, x.graph().constant(0.0));
        Self {
            a: Symmetric([yy + zz, xx + zz, xx + yy, -xy, -xz, -yz]),
            b: Rotation([[zero, -z, y], [z, zero, -x], [-y, x, zero]]),
            m: Symmetric([m, m, m, zero, zero, zero]),
        }
    }

    fn times(&self, omega_dot: Vector<Term<'g>>, a: Vector<Term<'g>>) -> Action<Term<'g>> {
        Action {
            c: Rotation(self.a.rows()) * omega_dot + self.b * a,
            f: self.b.transposed() * omega_dot + Rotation(self.m.rows()) * a,
        }
    }

    /// What a joint takes and leaves: the map minus U Uᵗ / D, of which the joint's own row and
    /// column vanish.
    fn yielding(&self, joint: &Joint<'g>, motion: Motion) -> Yielding<'g> {
        let action = self.times(joint.screw.u, joint.screw.b);
        let share = action.along(joint.screw);
        share.label(|| format!("d_{}", joint.index + 1));
        let inverse = share.graph().constant(1.0) / share;
        let (c, f) = (action.c, action.f);
        let (over_c, over_f) = (c * inverse, f * inverse);
        let mut left = Self {
            a: self.a - Symmetric::half_product(c, over_c),
            b: Rotation(std::array::from_fn(|i| {
                std::array::from_fn(|j| self.b.0[i][j] - over_c.0[i] * f.0[j])
            })),
            m: self.m - Symmetric::half_product(f, over_f),
        };
        let zero = inverse.graph().constant(0.0);
        match motion {
            Motion::Revolute => {
                left.a.clear_z(zero);
                left.b.0[2] = [zero; 3];
            }
            Motion::Prismatic => {
                left.m.clear_z(zero);
                for row in &mut left.b.0 {
                    row[2] = zero;
                }
            }
            Motion::Screw(_) => {}
        }
        Yielding {
            action,
            inverse,
            left,
        }
    }

    /// In other axes.
    fn turn(&self, rotation: Rotation<Term<'g>>) -> Self {
        let about_z = (rotation.0[1][0], rotation.0[0][0]);
        Self {
            a: self.a.rotate_about_z(about_z),
            b: rotation * self.b * rotation.transposed(),
            m: self.m.rotate_about_z(about_z),
        }
    }

    /// About a point at −p, from where the body's origin is at p.
    fn shift(&self, p: Vector<Term<'g>>) -> Self {
        let zero = p.x().graph().constant(0.0);
        let [x, y, z] = p.0;
        let skew = Rotation([[zero, -z, y], [z, zero, -x], [-y, x, zero]]);
        let b = self.b + skew * Rotation(self.m.rows());
        let added = skew * b.transposed() + self.b * skew.transposed();
        Self {
            a: self.a + Symmetric::from_rows(added.0),
            b,
            m: self.m,
        }
    }

    /// In the frame that the body's frame is seen from at a constant pose.
    fn inboard(&self, pose: Pose<Term<'g>>) -> Self {
        let rotation = pose.rotation;
        let turned = Self {
            a: self.a.rotate(rotation),
            b: rotation * self.b * rotation.transposed(),
            m: self.m.rotate(rotation),
        };
        turned.shift(pose.translation)
    }
}

impl std::ops::Add for Articulated<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            a: self.a + other.a,
            b: self.b + other.b,
            m: self.m + other.m,
        }
    }
}
