//! Derivatives of inverse dynamics: ∂τ/∂q, ∂τ/∂q̇ and the Coriolis matrix.
//!
//! In: the joints and a motion. Out: matrices, by rows, a row for each torque. A change of qₘ or q̇ₘ adds X + 2 x̲ W
//! to H of all bodies that joint m carries, so that the torque of joint i changes by Lᵢ ⊗ skew\[X J + 2 x̲ Y\], with
//! J and Y = W J of the bodies that both carry, and
//!
//! * for qₘ: X = Ψ̈ₘ, x̲ = Ψ̇ₘ, the derivatives of a screw fixed to the parent body of joint m; if joint m does not
//!   move the screw of joint i, Φ of all bodies that joint m carries rotates relative to it, which adds Lₘ Φ + Φ Lₘᵗ;
//! * for q̇ₘ: X = L̇ₘ + Ψ̇ₘ, x̲ = Lₘ.
//!
//! External wrenches in a link's frame rotate with the link, and are part of Φ; those in frame 0 are constant, so that
//! only L moves relative to them. Of the actuator's terms only viscous friction changes with q̇.
//!
//! C has the columns of X = L̇ₘ, x̲ = ½ Lₘ; friction, which dissipates power, is not in it. (Singh, Russo, Wensing,
//! "Efficient analytical derivatives of rigid-body dynamics using spatial vector algebra", 2022, in the matrices of the
//! paper.)
//!
//! Forces do not depend on a constant velocity of the observer: the matrices of each joint are those of an observer who
//! moves with its pole, so that no velocity of an origin is passed on from the base.

use super::carry::{DisplacedJoint, Joints};
use super::newton_euler::{BodyMotion, motion, seen};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::{List, Square};
use crate::matrix::{Acceleration, Action, Flow, Inertia, Pose, Screw, Vector};

/// ∂τ/∂q and ∂τ/∂q̇ at the given q̈, with external wrenches on some bodies that rotate with them.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    external: &[(BodyId, Action<Term<'g>>)],
) -> [Square<BodyId, Term<'g>>; 2] {
    let motion = motion(joints, gravity, state, qdd, external);
    let rates = rates(joints, gravity, &motion.motions);
    let by_coordinate = rates.iter().zip(joints).zip(&motion.actions);
    let by_coordinate = by_coordinate.map(|((rates, joint), action)| Change {
        x: rates.second,
        rotation: rates.carried.u,
        turned: Some(action.moved_along(joint.screw)),
    });
    let by_rate = rates.iter().zip(joints).map(|(rates, joint)| Change {
        x: rates.own + rates.carried,
        rotation: joint.screw.u,
        turned: None,
    });
    // Each velocity enters doubled.
    let whole = Whole::of(joints, state, &motion.motions, |v| v + v);
    let changes = by_coordinate.zip(by_rate).map(|(q, qd)| [q, qd]);
    let [by_coordinate, mut by_rate] = whole.torques(joints, state, &changes.collect());
    for (k, joint) in joints.numbered() {
        let own = &mut by_rate[(k, k)];
        *own = *own + joint.actuator.damping;
    }
    [by_coordinate, by_rate]
}

/// Adds to ∂τ/∂q the part of wrenches that are constant in frame 0: −Σ (Lₘ Lᵢ − Lᵢ Lₘ) ⊗ Φ where joint m moves Lᵢ.
pub fn add_constant_wrenches<'g>(
    matrix: &mut Square<BodyId, Term<'g>>,
    joints: &Joints<'g>,
    external: &[(BodyId, Action<Term<'g>>)],
) {
    let mut carried: List<BodyId, Option<Action<Term<'g>>>> = List::filled(None, joints.len());
    let sum = |sum: &mut Option<Action<Term<'g>>>, action| {
        *sum = Some(sum.map_or(action, |sum| sum + action));
    };
    for &(body, action) in external {
        sum(&mut carried[body], action);
    }
    for (k, joint) in joints.numbered().rev() {
        let Some(action) = carried[k] else {
            continue;
        };
        // (Lₘ Lᵢ − Lᵢ Lₘ) ⊗ Φ = Lₘ ⊗ (Lᵢ Φ + Φ Lᵢᵗ), which changes its sign if both are exchanged.
        let (mut turned, mut at) = (action.moved_along(joint.screw), k);
        while let Some(parent) = joints[at].parent {
            (turned, at) = (joints[at].action_inboard(turned), parent);
            let power = turned.along(joints[at].screw);
            let entry = &mut matrix[(k, at)];
            *entry = *entry - power;
            if joint.carries_screw(at, joints) {
                let entry = &mut matrix[(at, k)];
                *entry = *entry + power;
            }
        }
        if let Some(parent) = joint.parent {
            sum(&mut carried[parent], joint.action_inboard(action));
        }
    }
}

/// C of M q̈ + C q̇ + gravity, with Ṁ = C + Cᵗ.
pub fn coriolis_matrix<'g>(joints: &Joints<'g>, state: &State<'g>) -> Square<BodyId, Term<'g>> {
    let nothing = Vector::zero(state.graph);
    let at_rest = List::filled(state.zero(), joints.len());
    let motion = motion(joints, nothing, state, &at_rest, &[]);
    let rates = rates(joints, nothing, &motion.motions);
    let changes = rates.iter().zip(joints).map(|(rates, joint)| {
        [Change {
            x: rates.own,
            rotation: joint.screw.u,
            turned: None,
        }]
    });
    let whole = Whole::of(joints, state, &motion.motions, |v| v);
    let [matrix] = whole.torques(joints, state, &changes.collect());
    matrix
}

/// Derivatives of a joint's screw, for an observer at rest with its pole.
pub(super) struct Rates<'g> {
    /// L̇ = W L − L W, with W of the body in whose frame L is constant: the last that the joint moves.
    pub(super) own: Screw<Term<'g>>,
    /// Ψ̇, the same with W of the joint's parent body.
    pub(super) carried: Screw<Term<'g>>,
    /// Ψ̈, the derivative of Ψ̇ on that body.
    pub(super) second: Screw<Term<'g>>,
}

pub(super) fn rates<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    motions: &List<BodyId, BodyMotion<'g>>,
) -> List<BodyId, Rates<'g>> {
    let base = Acceleration::linear(-gravity);
    // The parent body of each joint, and the last body that it moves.
    let mut outer: List<BodyId, Acceleration<Term<'g>>> = List::new();
    let mut last: List<BodyId, BodyId> = joints.ids().collect();
    for joint in joints {
        outer.push(match joint.parent {
            Some(parent) if joint.taken => outer[parent],
            parent => {
                let (h, offset) = seen(parent.map_or(base, |k| motions[k].h), joint);
                h.move_pole(offset)
            }
        });
    }
    for (k, joint) in joints.numbered().rev() {
        if let (true, Some(parent)) = (joint.taken, joint.parent) {
            last[parent] = last[k];
        }
    }
    let each = joints.numbered().map(|(k, joint)| {
        let Screw { u, b } = joint.screw;
        let (outer, own, last) = (outer[k], &motions[k], &motions[last[k]]);
        // Velocities of those bodies relative to the pole.
        let (of_outer, of_last) = (-own.relative, last.relative - own.relative);
        let carried = Screw {
            u: outer.omega.cross(u),
            b: outer.omega.cross(b) + of_outer.cross(u),
        };
        let at_rest = Acceleration {
            a: Vector::zero(u.x().graph()),
            ..outer
        };
        Rates {
            own: Screw {
                u: last.h.omega.cross(u),
                b: last.h.omega.cross(b) + of_last.cross(u),
            },
            second: Screw {
                u: at_rest.point(u),
                b: at_rest.point(b) + outer.a.cross(u) + of_outer.cross(carried.u + carried.u),
            },
            carried,
        }
    });
    each.collect()
}

/// The effect of a change of one coordinate or velocity.
struct Change<'g> {
    /// X and x of X + 2 x̲ W, which is added to H of all bodies that its joint carries.
    x: Screw<Term<'g>>,
    rotation: Vector<Term<'g>>,
    /// L Φ + Φ Lᵗ, if it rotates the bodies that its joint carries.
    turned: Option<Action<Term<'g>>>,
}

/// All bodies that each joint carries: J, and a multiple of Y for an observer who moves with the joint's pole.
pub(super) struct Whole<'g> {
    pub(super) inertias: List<BodyId, Inertia<Term<'g>>>,
    pub(super) flows: List<BodyId, Flow<Term<'g>>>,
    /// The velocity of each joint's pole relative to that of its parent, with the same multiple: from its
    /// displacement, and from its placement.
    pub(super) gains: List<BodyId, [Vector<Term<'g>>; 2]>,
}

impl<'g> Whole<'g> {
    pub(super) fn of(
        joints: &Joints<'g>,
        state: &State<'g>,
        motions: &List<BodyId, BodyMotion<'g>>,
        multiple: impl Fn(Vector<Term<'g>>) -> Vector<Term<'g>>,
    ) -> Self {
        let gains = joints.map(|joint| {
            let DisplacedJoint { placement, .. } = joint;
            let at_rest = Vector::zero(state.graph);
            let omega = joint.parent.map_or(at_rest, |k| motions[k].h.omega);
            let linear = joint.turn() * joint.screw.b * state.qd(joint.body);
            let turned = placement.rotation.transposed() * omega;
            [
                multiple(turned.cross(joint.offset()) + linear),
                multiple(omega.cross(placement.translation)),
            ]
        });
        let mut inertias = joints.map(|joint| joint.inertia);
        let flows = joints.iter().zip(motions);
        let mut flows: List<BodyId, _> = flows
            .map(|(joint, own)| Flow::of_rotation(multiple(own.h.omega), joint.inertia))
            .collect();
        for (k, joint) in joints.numbered().rev() {
            let (index, frame) = joint.numbers();
            inertias[k].label(index, frame);
            if let Some(parent) = joint.parent {
                let [by_displacement, by_placement] = gains[k];
                let (inertia, flow) = match joint.displacement {
                    Some(Pose { rotation, .. }) => {
                        (inertias[k].rotate(rotation), flows[k].rotate(rotation))
                    }
                    None => (
                        joint.rotated(inertias[k]),
                        flows[k].rotate_about_z(joint.angle),
                    ),
                };
                let flow = flow
                    .faster(by_displacement, inertia)
                    .translate(joint.offset());
                let inertia = inertia
                    .translate(joint.offset())
                    .rotate(joint.placement.rotation);
                let flow = flow.rotate(joint.placement.rotation);
                let flow = flow.faster(by_placement, inertia);
                flows[parent] = flows[parent] + flow.translate(joint.placement.translation);
                inertias[parent] =
                    inertias[parent] + inertia.translate(joint.placement.translation);
            }
        }
        Self {
            inertias,
            flows,
            gains,
        }
    }

    /// The torques of some changes of each joint, in one matrix a change.
    fn torques<const K: usize>(
        &self,
        joints: &Joints<'g>,
        state: &State<'g>,
        changes: &List<BodyId, [Change<'g>; K]>,
    ) -> [Square<BodyId, Term<'g>>; K] {
        let mut matrices = std::array::from_fn(|_| Square::filled(state.zero(), joints.len()));
        for (k, joint) in joints.numbered() {
            let (inertia, flow) = (self.inertias[k], self.flows[k]);
            // skew[L J] and skew[L Yᵗ] give the torque of a change by a scalar product with it.
            let mut own = Action::of_screw(joint.screw, inertia);
            let mut against = flow.against(joint.screw);
            let mut wrenches = changes[k].each_ref().map(|change| {
                Action::of_screw(change.x, inertia) + flow.rotated_by(change.rotation)
            });
            let mut at = k;
            loop {
                for (matrix, wrench) in matrices.iter_mut().zip(wrenches) {
                    matrix[(at, k)] = wrench.along(joints[at].screw);
                }
                if at != k {
                    for (matrix, change) in matrices.iter_mut().zip(&changes[at]) {
                        matrix[(k, at)] = own.along(change.x) + against.dot(change.rotation);
                    }
                }
                let Some(parent) = joints[at].parent else {
                    break;
                };
                if joint.carries_screw(at, joints) && !joint.carries_screw(parent, joints) {
                    for (wrench, change) in wrenches.iter_mut().zip(&changes[k]) {
                        *wrench = change.turned.map_or(*wrench, |turned| *wrench + turned);
                    }
                }
                let [by_displacement, by_placement] = self.gains[at];
                let steps = [
                    (joints[at].displacement(), by_displacement),
                    (joints[at].placement, by_placement),
                ];
                for (pose, faster) in steps {
                    own = own.change_frame(pose);
                    against = pose.rotation * against + faster.cross(own.f);
                    wrenches = wrenches.map(|wrench| wrench.change_frame(pose));
                }
                at = parent;
            }
        }
        matrices
    }
}
