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
//! C has the columns of X = L̇ₘ, x̲ = ½ Lₘ. (Singh, Russo, Wensing, "Efficient analytical derivatives of
//! rigid-body dynamics using spatial vector algebra", 2022, in the matrices of the paper.)
//!
//! Forces are the same for all who see the robot at a constant velocity: the matrices of each joint
//! are those of one who moves with its pole, so that no velocity of an origin is carried from the base.

use super::carry::Joint;
use super::newton_euler::{Moving, motion, seen};
use super::state::State;
use crate::expression::Term;
use crate::matrix::{Acceleration, Action, Flow, Inertia, Pose, Screw, Vector};

/// ∂τ/∂q and ∂τ/∂q̇ at the given q̈.
pub fn inverse_dynamics<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &[Term<'g>],
) -> [Vec<Term<'g>>; 2] {
    let motion = motion(joints, gravity, state, qdd);
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
    whole.felt(joints, state, &changes.collect::<Vec<_>>())
}

/// C of M q̈ + C q̇ + gravity, with Ṁ = C + Cᵗ.
pub fn coriolis_matrix<'g>(joints: &[Joint<'g>], state: &State<'g>) -> Vec<Term<'g>> {
    let nothing = Vector::zero(state.graph);
    let at_rest = vec![state.zero(); joints.len()];
    let motion = motion(joints, nothing, state, &at_rest);
    let rates = rates(joints, nothing, &motion.motions);
    let changes = rates.iter().zip(joints).map(|(rates, joint)| {
        [Change {
            x: rates.own,
            turn: joint.screw.u,
            turned: None,
        }]
    });
    let whole = Whole::of(joints, state, &motion.motions, |v| v);
    let [matrix] = whole.felt(joints, state, &changes.collect::<Vec<_>>());
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
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    motions: &[Moving<'g>],
) -> Vec<Rates<'g>> {
    let base = Acceleration::linear(-gravity);
    // What each joint hangs on, as a whole, and the last body that it moves.
    let mut outer: Vec<Acceleration<Term<'g>>> = Vec::with_capacity(joints.len());
    let mut last: Vec<usize> = (0..joints.len()).collect();
    for joint in joints {
        outer.push(match joint.parent {
            Some(parent) if joint.taken => outer[parent],
            parent => {
                let (h, offset) = seen(parent.map_or(base, |k| motions[k].h), joint);
                h.move_pole(offset)
            }
        });
    }
    for (k, joint) in joints.iter().enumerate().rev() {
        if let (true, Some(parent)) = (joint.taken, joint.parent) {
            last[parent] = last[k];
        }
    }
    let each = joints.iter().enumerate().map(|(k, joint)| {
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
    inertias: Vec<Inertia<Term<'g>>>,
    flows: Vec<Flow<Term<'g>>>,
    /// How much faster the pole of each joint is than that of the body that it hangs on, by the same
    /// multiple: by its displacement, and by its placement.
    gains: Vec<[Vector<Term<'g>>; 2]>,
}

impl<'g> Whole<'g> {
    fn of(
        joints: &[Joint<'g>],
        state: &State<'g>,
        motions: &[Moving<'g>],
        multiple: impl Fn(Vector<Term<'g>>) -> Vector<Term<'g>>,
    ) -> Self {
        let gains = joints.iter().map(|joint| {
            let Joint { placement, .. } = joint;
            let at_rest = Vector::zero(state.graph);
            let omega = joint.parent.map_or(at_rest, |k| motions[k].h.omega);
            let sliding = joint.turn() * joint.screw.b * state.qd(joint.index);
            let turned = placement.rotation.transposed() * omega;
            [
                multiple(turned.cross(joint.offset()) + sliding),
                multiple(omega.cross(placement.translation)),
            ]
        });
        let gains: Vec<_> = gains.collect();
        let mut inertias: Vec<_> = joints.iter().map(|joint| joint.inertia).collect();
        let flows = joints.iter().zip(motions);
        let mut flows: Vec<_> = flows
            .map(|(joint, own)| Flow::of_turn(multiple(own.h.omega), joint.inertia))
            .collect();
        for (k, joint) in joints.iter().enumerate().rev() {
            let (index, frame) = (k + 1, joint.frame);
            inertias[k].label(|| format!("j_{index}_in_{frame}_"));
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
        joints: &[Joint<'g>],
        state: &State<'g>,
        changes: &[[Change<'g>; K]],
    ) -> [Vec<Term<'g>>; K] {
        let count = joints.len();
        let mut matrices = std::array::from_fn(|_| vec![state.zero(); count * count]);
        for (k, joint) in joints.iter().enumerate() {
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
                    matrix[at * count + k] = felt.along(joints[at].screw);
                }
                if at != k {
                    for (matrix, change) in matrices.iter_mut().zip(&changes[at]) {
                        matrix[k * count + at] = own.along(change.x) + against.dot(change.turn);
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
