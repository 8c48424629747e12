//! How joint forces and torques answer to a small change of the motion: ∂τ/∂q, ∂τ/∂q̇ and the Coriolis
//! matrix.
//!
//! In: the joints and a motion. Out: matrices, row by row, a row a force. A change of qₘ or q̇ₘ adds
//! X + 2 x̲ W to H of all that joint m carries, so that joint i feels Lᵢ ⊗ skew\[X J + 2 x̲ Y\], with J and
//! Y = W J of what both carry, and
//!
//! * of qₘ: X = Ψ̈ₘ, x̲ = Ψ̇ₘ, the rates of a screw on the body that joint m hangs on; where the screw of
//!   joint i is not carried along, Φ of all that joint m carries is turned against it: Lₘ Φ + Φ Lₘᵗ more;
//! * of q̇ₘ: X = L̇ₘ + Ψ̇ₘ, x̲ = Lₘ.
//!
//! Actions from outside turn with the links that they are given in, and are part of Φ; those in frame 0 stay, so that
//! of each only L moves against it. Of what joints feel of their drives only viscous friction changes with the rates.
//!
//! C has the columns of X = L̇ₘ, x̲ = ½ Lₘ; friction, which takes power, is none of it. (Singh, Russo, Wensing, "Efficient analytical derivatives of
//! rigid-body dynamics using spatial vector algebra", 2022, in the matrices of the paper.)
//!
//! Forces are the same for all who see the robot at a constant velocity: the matrices of each joint
//! are those of one who moves with its pole, so that no velocity of an origin is carried from the base.

use super::carry::{Joint, Joints};
use super::newton_euler::{Moving, motion, seen};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::{List, Square};
use crate::matrix::{Acceleration, Action, Flow, Inertia, Pose, Screw, Vector};

/// ∂τ/∂q and ∂τ/∂q̇ at the given q̈, where actions from outside are on some bodies and turn with them.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    outside: &[(BodyId, Action<Term<'g>>)],
) -> [Square<BodyId, Term<'g>>; 2] {
    let motion = motion(joints, gravity, state, qdd, outside);
    let rates = rates(joints, gravity, &motion.motions);
    let by_coordinate = rates.iter().zip(joints).zip(&motion.actions);
    let by_coordinate = by_coordinate.map(|((rates, joint), action)| Change {
        x: rates.second,
        turn: rates.carried.u,
        turned: Some(action.turned(joint.screw)),
    });
    let by_rate = rates.iter().zip(joints).map(|(rates, joint)| Change {
        x: rates.own + rates.carried,
        turn: joint.screw.u,
        turned: None,
    });
    // Each velocity enters with its double.
    let whole = Whole::of(joints, state, &motion.motions, |v| v + v);
    let changes = by_coordinate.zip(by_rate).map(|(q, qd)| [q, qd]);
    let [by_coordinate, mut by_rate] = whole.felt(joints, state, &changes.collect());
    for (k, joint) in joints.numbered() {
        let own = &mut by_rate[(k, k)];
        *own = *own + joint.drive.damping;
    }
    [by_coordinate, by_rate]
}

/// Adds to ∂τ/∂q what actions on bodies do that stay as they are in frame 0: −Σ (Lₘ Lᵢ − Lᵢ Lₘ) ⊗ Φ where joint
/// m carries Lᵢ.
pub fn add_standing<'g>(
    matrix: &mut Square<BodyId, Term<'g>>,
    joints: &Joints<'g>,
    outside: &[(BodyId, Action<Term<'g>>)],
) {
    let mut carried: List<BodyId, Option<Action<Term<'g>>>> = List::filled(None, joints.len());
    let sum = |sum: &mut Option<Action<Term<'g>>>, action| {
        *sum = Some(sum.map_or(action, |sum| sum + action));
    };
    for &(body, action) in outside {
        sum(&mut carried[body], action);
    }
    for (k, joint) in joints.numbered().rev() {
        let Some(action) = carried[k] else {
            continue;
        };
        let inboard = |action: Action<Term<'g>>, joint: &Joint<'g>| {
            let displaced = action.change_frame(joint.displacement());
            displaced.change_frame(joint.placement)
        };
        // (Lₘ Lᵢ − Lᵢ Lₘ) ⊗ Φ = Lₘ ⊗ (Lᵢ Φ + Φ Lᵢᵗ), which changes its sign where both change places.
        let (mut turned, mut at) = (action.turned(joint.screw), k);
        while let Some(parent) = joints[at].parent {
            (turned, at) = (inboard(turned, &joints[at]), parent);
            let power = turned.along(joints[at].screw);
            let entry = &mut matrix[(k, at)];
            *entry = *entry - power;
            if joint.carries_screw(at, joints) {
                let entry = &mut matrix[(at, k)];
                *entry = *entry + power;
            }
        }
        if let Some(parent) = joint.parent {
            sum(&mut carried[parent], inboard(action, joint));
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
            turn: joint.screw.u,
            turned: None,
        }]
    });
    let whole = Whole::of(joints, state, &motion.motions, |v| v);
    let [matrix] = whole.felt(joints, state, &changes.collect());
    matrix
}

/// How the screw of a joint moves, seen from where its pole stands still.
struct Rates<'g> {
    /// L̇ = W L − L W, with W of the body in whose frame L is constant: the last that the joint moves.
    own: Screw<Term<'g>>,
    /// Ψ̇, the same with W of the body that the joint hangs on, as a whole.
    carried: Screw<Term<'g>>,
    /// Ψ̈, the rate of the change of Ψ̇ on that body.
    second: Screw<Term<'g>>,
}

fn rates<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    motions: &List<BodyId, Moving<'g>>,
) -> List<BodyId, Rates<'g>> {
    let base = Acceleration::linear(-gravity);
    // What each joint hangs on, as a whole, and the last body that it moves.
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
        // How much faster than the pole the bodies are there.
        let (of_outer, of_last) = (-own.relative, last.relative - own.relative);
        let carried = Screw {
            u: outer.omega.cross(u),
            b: outer.omega.cross(b) + of_outer.cross(u),
        };
        let standing = Acceleration {
            a: Vector::zero(u.x().graph()),
            ..outer
        };
        Rates {
            own: Screw {
                u: last.h.omega.cross(u),
                b: last.h.omega.cross(b) + of_last.cross(u),
            },
            second: Screw {
                u: standing.point(u),
                b: standing.point(b) + outer.a.cross(u) + of_outer.cross(carried.u + carried.u),
            },
            carried,
        }
    });
    each.collect()
}

/// What a change of one coordinate or rate does.
struct Change<'g> {
    /// X and x of X + 2 x̲ W, which it adds to H of all that its joint carries.
    x: Screw<Term<'g>>,
    turn: Vector<Term<'g>>,
    /// L Φ + Φ Lᵗ, where it turns what its joint carries.
    turned: Option<Action<Term<'g>>>,
}

/// All that each joint carries: J, and some multiple of Y seen by one who moves with the joint's pole.
struct Whole<'g> {
    inertias: List<BodyId, Inertia<Term<'g>>>,
    flows: List<BodyId, Flow<Term<'g>>>,
    /// How much faster the pole of each joint is than that of the body that it hangs on, by the same
    /// multiple: by its displacement, and by its placement.
    gains: List<BodyId, [Vector<Term<'g>>; 2]>,
}

impl<'g> Whole<'g> {
    fn of(
        joints: &Joints<'g>,
        state: &State<'g>,
        motions: &List<BodyId, Moving<'g>>,
        multiple: impl Fn(Vector<Term<'g>>) -> Vector<Term<'g>>,
    ) -> Self {
        let gains = joints.map(|joint| {
            let Joint { placement, .. } = joint;
            let at_rest = Vector::zero(state.graph);
            let omega = joint.parent.map_or(at_rest, |k| motions[k].h.omega);
            let sliding = joint.turn() * joint.screw.b * state.qd(joint.body);
            let turned = placement.rotation.transposed() * omega;
            [
                multiple(turned.cross(joint.offset()) + sliding),
                multiple(omega.cross(placement.translation)),
            ]
        });
        let mut inertias = joints.map(|joint| joint.inertia);
        let flows = joints.iter().zip(motions);
        let mut flows: List<BodyId, _> = flows
            .map(|(joint, own)| Flow::of_turn(multiple(own.h.omega), joint.inertia))
            .collect();
        for (k, joint) in joints.numbered().rev() {
            let (index, frame) = joint.numbers();
            inertias[k].label(index, frame);
            if let Some(parent) = joint.parent {
                let [displacing, placing] = gains[k];
                let (inertia, flow) = match joint.posture {
                    Some(Pose { rotation, .. }) => {
                        (inertias[k].rotate(rotation), flows[k].rotate(rotation))
                    }
                    None => (
                        joint.turned(inertias[k]),
                        flows[k].rotate_about_z(joint.angle),
                    ),
                };
                let flow = flow.faster(displacing, inertia).translate(joint.offset());
                let inertia = inertia
                    .translate(joint.offset())
                    .rotate(joint.placement.rotation);
                let flow = flow.rotate(joint.placement.rotation);
                let flow = flow.faster(placing, inertia);
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

    /// What the joints feel of some changes of each joint, in as many matrices.
    fn felt<const K: usize>(
        &self,
        joints: &Joints<'g>,
        state: &State<'g>,
        changes: &List<BodyId, [Change<'g>; K]>,
    ) -> [Square<BodyId, Term<'g>>; K] {
        let mut matrices = std::array::from_fn(|_| Square::filled(state.zero(), joints.len()));
        for (k, joint) in joints.numbered() {
            let (inertia, flow) = (self.inertias[k], self.flows[k]);
            // skew[L J] and skew[L Yᵗ] turn what a joint feels of a change into a scalar product with it.
            let mut own = Action::of_screw(joint.screw, inertia);
            let mut against = flow.against(joint.screw);
            let mut felt = changes[k]
                .each_ref()
                .map(|change| Action::of_screw(change.x, inertia) + flow.turned_by(change.turn));
            let mut at = k;
            loop {
                for (matrix, felt) in matrices.iter_mut().zip(felt) {
                    matrix[(at, k)] = felt.along(joints[at].screw);
                }
                if at != k {
                    for (matrix, change) in matrices.iter_mut().zip(&changes[at]) {
                        matrix[(k, at)] = own.along(change.x) + against.dot(change.turn);
                    }
                }
                let Some(parent) = joints[at].parent else {
                    break;
                };
                if joint.carries_screw(at, joints) && !joint.carries_screw(parent, joints) {
                    for (felt, change) in felt.iter_mut().zip(&changes[k]) {
                        *felt = change.turned.map_or(*felt, |turned| *felt + turned);
                    }
                }
                let [displacing, placing] = self.gains[at];
                let steps = [
                    (joints[at].displacement(), displacing),
                    (joints[at].placement, placing),
                ];
                for (pose, faster) in steps {
                    own = own.change_frame(pose);
                    against = pose.rotation * against + faster.cross(own.f);
                    felt = felt.map(|felt| felt.change_frame(pose));
                }
                at = parent;
            }
        }
        matrices
    }
}
