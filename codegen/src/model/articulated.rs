//! Forward dynamics by the articulated-body algorithm (Featherstone 1983): articulated inertias are passed inwards,
//! accelerations outwards; or the inverse of the mass matrix, from unit forces on their way inwards.
//!
//! In: the joints and bodies with physical inertias, without regrouping. Out: q̈, or M⁻¹. No mass matrix is formed, so
//! that digits are lost only as far as masses differ, and not by its condition number.

use super::algorithm::Congruence;
use super::carry::{DisplacedJoint, Joints};
use super::newton_euler::{BodyMotion, beyond};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::{Block, Component, LabelledBodies, Term};
use crate::joint::Motion;
use crate::list::{Id, List, Square};
use crate::matrix::{Acceleration, Action, Inertia, Pose, Rotation, Symmetric, Vector};

/// q̈ for torques and forces, one entry a joint; `driving` has them for each body.
pub fn forward_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    driving: impl Fn(BodyId) -> Term<'g>,
    external: &[(BodyId, Action<Term<'g>>)],
) -> List<BodyId, Term<'g>> {
    let Drift {
        velocities,
        drifts,
        mut actions,
    } = Drift::of(joints, state);
    for &(body, action) in external {
        actions[body] = actions[body] - action;
    }
    let mut articulated = joints.map(|joint| Articulated::of(joint.inertia));

    let mut eliminated = Vec::with_capacity(joints.len());
    for (k, joint) in joints.numbered().rev() {
        let action = actions[k];
        let own = articulated[k].eliminate(joint);
        let friction = joint.actuator.resistance(state.qd(k));
        let unbalanced = driving(k) - friction - action.along(joint.screw);
        if let Some(parent) = joint.parent {
            let reduced = own.reduced;
            let by_pivot = unbalanced * own.inverse;
            let moved = reduced.times(drifts[k].omega_dot, drifts[k].a);
            let carried = Action {
                c: action.c + moved.c + own.action.c * by_pivot,
                f: action.f + moved.f + own.action.f * by_pivot,
            };
            let (reduced, carried) = passed_on(joint, &reduced, carried);
            articulated[parent] = articulated[parent] + reduced;
            actions[parent] = actions[parent] + carried;
        }
        eliminated.push((unbalanced, own));
    }
    eliminated.reverse();
    let eliminated: List<BodyId, _> = eliminated.into();

    let mut found = List::new();
    outwards(joints, gravity, state, &velocities, |k, carried| {
        let (unbalanced, own) = &eliminated[k];
        let opposed = carried.omega_dot.dot(own.action.c) + carried.a.dot(own.action.f);
        let acceleration = (*unbalanced - opposed) * own.inverse;
        found.push(acceleration);
        acceleration
    });
    found
}

/// For each joint its diagonal entry of the mass matrix, which is the inertia that it moves if all others are at rest,
/// and its pivot, which is the inertia that it moves if all joints outboard of it are free.
pub fn pivots<'g>(joints: &Joints<'g>) -> List<BodyId, [Term<'g>; 2]> {
    let mut composites = joints.map(|joint| joint.inertia);
    let mut articulated = joints.map(|joint| Articulated::of(joint.inertia));
    let mut pivots = Vec::with_capacity(joints.len());
    for (k, joint) in joints.numbered().rev() {
        let whole = Action::of_screw(joint.screw, composites[k]).along(joint.screw);
        let own = articulated[k].eliminate(joint);
        if let Some(parent) = joint.parent {
            composites[parent] = composites[parent] + joint.inertia_inboard(composites[k]);
            articulated[parent] = articulated[parent] + own.reduced.passed_on(joint);
        }
        let share = own.action.along(joint.screw);
        pivots.push([whole, share].map(|inertia| inertia + joint.actuator.armature));
    }
    pivots.reverse();
    pivots.into()
}

/// The inverse of the mass matrix, by rows: M⁻¹ = Yᵗ D⁻¹ Y, with the pivots D. Yₖⱼ is the unbalanced force at joint
/// k, at rest, for a unit force at joint j; it is zero unless k is inboard of j (the innovations form of Rodriguez,
/// Jain and Kreutz-Delgado, "A spatial operator algebra for manipulator modeling and control", 1991).
pub fn mass_matrix_inverse<'g>(joints: &Joints<'g>, state: &State<'g>) -> Square<BodyId, Term<'g>> {
    let mut articulated = joints.map(|joint| Articulated::of(joint.inertia));
    let mut eliminated = Vec::with_capacity(joints.len());
    for (k, joint) in joints.numbered().rev() {
        let own = articulated[k].eliminate(joint);
        if let Some(parent) = joint.parent {
            articulated[parent] = articulated[parent] + own.reduced.passed_on(joint);
        }
        eliminated.push(own);
    }
    eliminated.reverse();
    let eliminated: List<BodyId, _> = eliminated.into();

    // For each joint, the joints inboard of it and itself, with Y, from itself inwards.
    let one = state.graph.constant(1.0);
    let unbalanced_rows = joints.ids().map(|column| {
        let mut rows = vec![(column, one)];
        let mut action = eliminated[column].passed(one, None, &joints[column]);
        let mut at = column;
        while let Some(parent) = joints[at].parent {
            action = joints[at].action_inboard(action);
            let joint = &joints[parent];
            let unbalanced = -action.along(joint.screw);
            rows.push((parent, unbalanced));
            action = eliminated[parent].passed(unbalanced, Some(action), joint);
            at = parent;
        }
        rows.reverse();
        rows
    });
    let unbalanced_rows: List<BodyId, Vec<(BodyId, Term<'g>)>> = unbalanced_rows.collect();
    let mut entries = Square::filled(state.zero(), joints.len());
    for column in joints.ids() {
        for row in joints.ids().take(column.number()) {
            // The joints inboard of both are the common beginning of their rows, which go from the base outwards.
            let both = unbalanced_rows[row].iter().zip(&unbalanced_rows[column]);
            let both = both.take_while(|((k, _), (l, _))| k == l);
            let products = both
                .map(|((k, of_row), (_, of_column))| *of_column * eliminated[*k].inverse * *of_row);
            let entry = products.reduce(|sum, product| sum + product);
            let entry = entry.unwrap_or_else(|| state.zero());
            entries.set_both((row, column), entry);
        }
    }
    entries
}

/// Number of values of [`motion`] for each joint: c and f of the velocity terms, less external wrenches; ω̇ and a of
/// the velocity terms beyond the joint; ω̇ and a of the body.
pub const MOTION: usize = 18;

/// The terms of the recursion that depend on the motion, for given q̈, without a division.
pub fn motion<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    external: &[(BodyId, Action<Term<'g>>)],
) -> Vec<Term<'g>> {
    let mut drift = Drift::of(joints, state);
    for &(body, action) in external {
        drift.actions[body] = drift.actions[body] - action;
    }
    let own = |k: BodyId, _: Acceleration<Term<'g>>| state.qdd(k);
    let accelerations = outwards(joints, gravity, state, &drift.velocities, own);
    let all = drift.actions.iter().zip(&drift.drifts).zip(accelerations);
    all.flat_map(|((action, drift), acceleration)| {
        [
            action.c,
            action.f,
            drift.omega_dot,
            drift.a,
            acceleration.omega_dot,
            acceleration.a,
        ]
    })
    .flat_map(|vector| vector.0)
    .collect()
}

/// Number of values of an articulated inertia: A and M as xx, yy, zz, xy, xz, yz, with B by rows between them.
pub const INERTIA: usize = 6 + 9 + 6;

/// Number of arguments and results of [`step`]: an articulated inertia, c, f.
pub const STEP: usize = INERTIA + 3 + 3;

/// The articulated inertia and the wrench that a body passes on, after its joint's part has been subtracted, in the
/// frame of the parent body.
pub fn step<'g>(joint: &DisplacedJoint<'g>, entries: &[Term<'g>; STEP]) -> Vec<Term<'g>> {
    let a = std::array::from_fn(|k| entries[k]);
    let b = std::array::from_fn(|row| std::array::from_fn(|column| entries[6 + 3 * row + column]));
    let m = std::array::from_fn(|k| entries[15 + k]);
    let [c, f] =
        [INERTIA, INERTIA + 3].map(|first| Vector(std::array::from_fn(|k| entries[first + k])));
    let mut reduced = Articulated {
        a: Symmetric(a),
        b: Rotation(b),
        m: Symmetric(m),
    };
    if joint.actuator.armature.is_zero() {
        reduced.clear(joint);
    }
    let (reduced, action) = passed_on(joint, &reduced, Action { c, f });
    let inertia = reduced
        .a
        .0
        .into_iter()
        .chain(reduced.b.0.concat())
        .chain(reduced.m.0);
    inertia.chain(action.c.0).chain(action.f.0).collect()
}

/// The velocity terms: velocities of the bodies, the accelerations that each joint adds to them, and their wrenches.
struct Drift<'g> {
    velocities: List<BodyId, BodyMotion<'g>>,
    drifts: List<BodyId, Acceleration<Term<'g>>>,
    actions: List<BodyId, Action<Term<'g>>>,
}

impl<'g> Drift<'g> {
    fn of(joints: &Joints<'g>, state: &State<'g>) -> Self {
        let at_rest = Acceleration::linear(Vector::zero(state.graph));
        let rest = BodyMotion::still(at_rest);
        let mut all = Self {
            velocities: List::new(),
            drifts: List::new(),
            actions: List::new(),
        };
        for (k, joint) in joints.numbered() {
            let outer = joint.parent.map_or(rest, |parent| all.velocities[parent]);
            let drift = beyond(outer, joint, state.qd(k), state.zero());
            let velocity = Acceleration {
                omega: drift.h.omega,
                ..at_rest
            };
            all.actions.push(Action::of(velocity, joint.inertia));
            all.velocities.push(BodyMotion {
                h: velocity,
                ..drift
            });
            all.drifts.push(drift.h);
        }
        all
    }
}

/// The accelerations of the bodies, with −H_g for the base; `of_joint` returns q̈ of a joint from the acceleration of
/// its body at q̈ = 0.
fn outwards<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    velocities: &List<BodyId, BodyMotion<'g>>,
    mut of_joint: impl FnMut(BodyId, Acceleration<Term<'g>>) -> Term<'g>,
) -> List<BodyId, Acceleration<Term<'g>>> {
    let base = BodyMotion::still(Acceleration::linear(-gravity));
    let mut accelerations: List<BodyId, Acceleration<Term<'g>>> = List::new();
    for (k, joint) in joints.numbered() {
        let outer = joint.parent.map_or(base, |parent| BodyMotion {
            h: Acceleration {
                omega: velocities[parent].h.omega,
                ..accelerations[parent]
            },
            ..velocities[parent]
        });
        let carried = beyond(outer, joint, state.qd(k), state.zero()).h;
        let acceleration = of_joint(k, carried);
        let (u, b) = (joint.screw.u, joint.screw.b);
        accelerations.push(Acceleration {
            omega: carried.omega,
            omega_dot: carried.omega_dot + u * acceleration,
            a: carried.a + b * acceleration,
        });
    }
    accelerations
}

/// An articulated inertia and a wrench of a body, in the frame of the parent body.
fn passed_on<'g>(
    joint: &DisplacedJoint<'g>,
    reduced: &Articulated<'g>,
    action: Action<Term<'g>>,
) -> (Articulated<'g>, Action<Term<'g>>) {
    (reduced.passed_on(joint), joint.action_inboard(action))
}

/// An articulated inertia Iᴬ: the linear map from an acceleration (ω̇, a) to a wrench (c, f),
/// c = A ω̇ + B a, f = Bᵗ ω̇ + M a.
#[derive(Clone, Copy)]
struct Articulated<'g> {
    a: Symmetric<Term<'g>>,
    b: Rotation<Term<'g>>,
    m: Symmetric<Term<'g>>,
}

/// The articulated inertia of a body with its joint: U = Iᴬ S, 1/D and Iᴬ − U Uᵗ/D.
struct Eliminated<'g> {
    /// U, the wrench of a unit acceleration of the joint.
    action: Action<Term<'g>>,
    /// 1/D.
    inverse: Term<'g>,
    /// Iᴬ − U Uᵗ/D, which is passed on to the parent.
    reduced: Articulated<'g>,
}

impl<'g> Eliminated<'g> {
    /// The wrench p + U u/D that the joint passes on, for its unbalanced force u and a wrench p, if there is one. Its
    /// component along the joint is zero, since u = −Sᵀ p, or u if there is no p. That is exact without an armature;
    /// with one, part of the force remains.
    fn passed(
        &self,
        unbalanced: Term<'g>,
        action: Option<Action<Term<'g>>>,
        joint: &DisplacedJoint<'g>,
    ) -> Action<Term<'g>> {
        let by_pivot = unbalanced * self.inverse;
        let (mut c, mut f) = (self.action.c * by_pivot, self.action.f * by_pivot);
        let mut along = unbalanced;
        if let Some(action) = action {
            (c, f) = (c + action.c, f + action.f);
            along = along.graph().constant(0.0);
        }
        match joint.motion {
            _ if !joint.actuator.armature.is_zero() => {}
            Motion::Revolute => c.0[joint.axis] = along,
            Motion::Prismatic => f.0[joint.axis] = along,
            Motion::Screw(_) => {}
        }
        Action { c, f }
    }
}

impl<'g> Articulated<'g> {
    /// Iᴬ of a rigid body: A = Tr(∫rrᵗ) − ∫rrᵗ, B = q̲, M = m.
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

    /// U, 1/D and Iᴬ − U Uᵗ/D of a joint. The joint's own row and column of the last are zero without an armature,
    /// which is part of D.
    fn eliminate(&self, joint: &DisplacedJoint<'g>) -> Eliminated<'g> {
        let action = self.times(joint.screw.u, joint.screw.b);
        let share = action.along(joint.screw) + joint.actuator.armature;
        share.label(
            Block::Pivot
                .of(LabelledBodies::Body(joint.body.into()))
                .entry(Component::Scalar),
        );
        let inverse = share.graph().constant(1.0) / share;
        let (c, f) = (action.c, action.f);
        let (over_c, over_f) = (c * inverse, f * inverse);
        let mut reduced = Self {
            a: self.a - Symmetric::half_product(c, over_c),
            b: Rotation(std::array::from_fn(|i| {
                std::array::from_fn(|j| self.b.0[i][j] - over_c.0[i] * f.0[j])
            })),
            m: self.m - Symmetric::half_product(f, over_f),
        };
        if joint.actuator.armature.is_zero() {
            reduced.clear(joint);
        }
        Eliminated {
            action,
            inverse,
            reduced,
        }
    }

    /// Sets the joint's own row and column to zero.
    fn clear(&mut self, joint: &DisplacedJoint<'g>) {
        let zero = self.b.0[0][0].graph().constant(0.0);
        match joint.motion {
            Motion::Revolute => {
                self.a.clear(joint.axis, zero);
                self.b.0[joint.axis] = [zero; 3];
            }
            Motion::Prismatic => {
                self.m.clear(joint.axis, zero);
                for row in &mut self.b.0 {
                    row[joint.axis] = zero;
                }
            }
            Motion::Screw(_) => {}
        }
    }

    /// In the frame of the parent body.
    fn passed_on(&self, joint: &DisplacedJoint<'g>) -> Self {
        let moved = match joint.displacement {
            Some(displacement) => self.inboard(displacement),
            None => self.turn(joint).shift(joint.offset()),
        };
        moved.inboard(joint.placement)
    }

    /// In the axes before the rotation of the joint.
    fn turn(&self, joint: &DisplacedJoint<'g>) -> Self {
        let rotation = joint.turn();
        let about_z = (rotation.0[1][0], rotation.0[0][0]);
        let rotated = |block: Symmetric<Term<'g>>| match joint.congruence {
            Congruence::Sparing => block.rotate_about_z(about_z),
            Congruence::Full => block.rotate_in_full_about_z(about_z),
        };
        Self {
            a: rotated(self.a),
            b: rotation * self.b * rotation.transposed(),
            m: rotated(self.m),
        }
    }

    /// About another point: the body's origin is at p from it.
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

    /// In the frame in which the body's frame has a constant pose.
    fn inboard(&self, pose: Pose<Term<'g>>) -> Self {
        let rotation = pose.rotation;
        let rotated = Self {
            a: self.a.rotate(rotation),
            b: rotation * self.b * rotation.transposed(),
            m: self.m.rotate(rotation),
        };
        rotated.shift(pose.translation)
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
