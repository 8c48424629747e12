//! Second derivatives of inverse dynamics, contracted with weights: the Hessian of λᵀτ.
//!
//! In: the joints, a motion, and a weight for each body's torque. Out: the second derivatives of λᵀτ by q, q̇ and q̈, a
//! matrix for each pair of arguments that has any.
//!
//! With Λ = Σ λ L of the joints that carry a body, λᵀτ = Σ Λ ⊗ skew\[H J\]. A displacement along Lₐ changes Λ, W and H
//! of all bodies that joint a carries by Λ × Lₐ, Ψ̇ₐ and X + 2 x̲ W, as in [`derivatives`](super::derivatives), with Λ
//! that of the parent body. All sums over bodies are then bilinear, so that the first derivatives are
//!
//! * by q_b: Ψλ_b ⊗ Φ + Ψ̈_b ⊗ P + Ψ̇_b · G,
//! * by q̇_b: (L̇_b + Ψ̇_b) ⊗ P + L_b · G,
//!
//! with Ψλ_b = Λ L_b − L_b Λ, and of all bodies that joint b carries the wrench Φ, the momentum P = Σ skew\[Λ J\] and the
//! couple G = Σ 2 skew\[Y Λᵗ\]. A second derivative, by the coordinate of a joint a that carries joint b, is the scalar
//! product of Ψλₐ, Ψ̇ₐ and Ψ̈ₐ with columns of joint b. The columns that belong to Ψ̇ₐ are couples: their forces cancel.

use std::collections::BTreeMap;

use super::carry::{Joint, Joints};
use super::derivatives::{Rates, Whole, rates};
use super::newton_euler::{Moving, motion};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::{List, Square};
use crate::matrix::{Action, Flow, Screw, Vector, Velocity};

/// Second derivatives of λᵀτ, a row and a column for each body. Where both arguments are the same, a row has the
/// derivative of a first derivative, by the column's motion.
pub struct Hessian<'g> {
    /// By q and q: each row is the derivative of one entry of the gradient, along each velocity.
    pub by_q_q: Square<BodyId, Term<'g>>,
    /// By q, a row each, and q̇.
    pub by_q_qd: Square<BodyId, Term<'g>>,
    /// By q̇ and q̇; symmetric.
    pub by_qd_qd: Square<BodyId, Term<'g>>,
    /// By q, a row each, and q̈.
    pub by_q_qdd: Square<BodyId, Term<'g>>,
}

/// Second derivatives at the given q̈, with external wrenches on some bodies that rotate with them.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    weights: &List<BodyId, Term<'g>>,
    external: &[(BodyId, Action<Term<'g>>)],
) -> Hessian<'g> {
    let motion = motion(joints, gravity, state, qdd, external);
    let rates = rates(joints, gravity, &motion.motions);
    // Each velocity enters doubled.
    let whole = Whole::of(joints, state, &motion.motions, |v| v + v);
    let weighted = Weighted::of(joints, state, weights, &motion.motions, &whole);
    let zero = || Square::filled(state.zero(), joints.len());
    let mut found = Hessian {
        by_q_q: zero(),
        by_q_qd: zero(),
        by_qd_qd: zero(),
        by_q_qdd: zero(),
    };
    for (k, joint) in joints.numbered() {
        let own = Columns::of(joint, &rates[k], &weighted, &whole, motion.actions[k], k);
        // Velocities of the same joint have the same frame, and observers of their own.
        for other in joints.ids().filter(|&other| {
            joint.carries_screw(other, joints) || joints[other].carries_screw(k, joints)
        }) {
            let faster = motion.motions[k].relative - motion.motions[other].relative;
            let own = own.seen_by(faster + faster);
            let of = Motion::of(&joints[other], &rates[other], weighted.rates[other]);
            found.by_q_q[(k, other)] = own.by_q(&of);
            found.by_q_qd[(other, k)] = own.by_q_of_rate(&of);
            found.by_q_qdd[(other, k)] = of.weights_along(own.inertia);
            if other <= k {
                let turned = weighted.momenta[k].moved_along(joint.screw);
                let entry = of.screw.u.dot(own.rate) - turned.along(of.screw);
                found.by_qd_qd.set_both((k, other), entry);
            }
        }
        let weights = &weighted.carried[k];
        let mut seen = own;
        let mut at = k;
        while let Some(parent) = joints[at].parent {
            seen = seen.inboard(&joints[at], whole.gains[at]);
            at = parent;
            if joint.carries_screw(at, joints) {
                continue;
            }
            let of = Motion::of(&joints[at], &rates[at], weights[&at]);
            found.by_q_q.set_both((k, at), seen.by_q(&of));
            found.by_q_qd[(at, k)] = seen.by_q_of_rate(&of);
            found.by_q_qd[(k, at)] = of.screw.u.dot(seen.turn) + seen.second.along(of.twice);
            found.by_qd_qd.set_both((k, at), of.screw.u.dot(seen.rate));
            found.by_q_qdd[(at, k)] = of.weights_along(seen.inertia);
            found.by_q_qdd[(k, at)] = seen.second.along(of.screw);
        }
    }
    found
}

/// The sums over all bodies that each joint carries, with Λ.
struct Weighted<'g> {
    /// Ψλ = Λ L − L Λ, with Λ of the joint's parent body.
    rates: List<BodyId, Screw<Term<'g>>>,
    /// Ψλ of each joint that carries a joint, in the frame of the latter.
    carried: List<BodyId, BTreeMap<BodyId, Screw<Term<'g>>>>,
    /// P = Σ skew\[Λ J\].
    momenta: List<BodyId, Action<Term<'g>>>,
    /// 2 Σ Λ J.
    flows: List<BodyId, Flow<Term<'g>>>,
    /// G = 2 Σ skew\[Y Λᵗ\] for the observer of Y.
    couples: List<BodyId, Vector<Term<'g>>>,
}

impl<'g> Weighted<'g> {
    fn of(
        joints: &Joints<'g>,
        state: &State<'g>,
        weights: &List<BodyId, Term<'g>>,
        motions: &List<BodyId, Moving<'g>>,
        whole: &Whole<'g>,
    ) -> Self {
        let rest = Velocity::zero(state.graph);
        let mut outer: List<BodyId, Velocity<Term<'g>>> = List::new();
        let mut lambdas: List<BodyId, Velocity<Term<'g>>> = List::new();
        for (k, joint) in joints.numbered() {
            let parent = joint
                .parent
                .map_or(rest, |parent| joint.motion_outboard(lambdas[parent]));
            outer.push(match joint.parent {
                Some(parent) if joint.taken => outer[parent],
                _ => parent,
            });
            lambdas.push(parent + Velocity::of_screw(joint.screw, weights[k]));
        }
        let screw = |w: Velocity<Term<'g>>| Screw { u: w.omega, b: w.v };
        let each = joints.iter().zip(&lambdas);
        let mut momenta: List<BodyId, _> = each
            .clone()
            .map(|(joint, &lambda)| Action::of_screw(screw(lambda), joint.inertia))
            .collect();
        let mut flows: List<BodyId, _> = each
            .clone()
            .map(|(joint, lambda)| {
                let flow = Flow::of_rotation(lambda.omega + lambda.omega, joint.inertia);
                flow.faster(lambda.v + lambda.v, joint.inertia)
            })
            .collect();
        let mut couples: List<BodyId, _> = each
            .zip(motions)
            .map(|((joint, &lambda), own)| {
                let flow = Flow::of_rotation(own.h.omega + own.h.omega, joint.inertia);
                flow.against(screw(lambda))
            })
            .collect();
        for (k, joint) in joints.numbered().rev() {
            let Some(parent) = joint.parent else { continue };
            let mut flow = match joint.displacement {
                Some(pose) => flows[k].rotate(pose.rotation),
                None => flows[k].rotate_about_z(joint.angle),
            };
            flow = flow.translate(joint.offset());
            flow = flow.rotate(joint.placement.rotation);
            flows[parent] = flows[parent] + flow.translate(joint.placement.translation);
            let (mut momentum, mut couple) = (momenta[k], couples[k]);
            let steps = [
                (joint.displacement(), whole.gains[k][0]),
                (joint.placement, whole.gains[k][1]),
            ];
            for (pose, faster) in steps {
                momentum = momentum.change_frame(pose);
                couple = pose.rotation * couple + faster.cross(momentum.f);
            }
            momenta[parent] = momenta[parent] + momentum;
            couples[parent] = couples[parent] + couple;
        }
        let rates: List<BodyId, _> = joints
            .iter()
            .zip(&outer)
            .map(|(joint, w)| w.rate_of(joint.screw))
            .collect();
        let mut carried: List<BodyId, BTreeMap<BodyId, Screw<Term<'g>>>> = List::new();
        for joint in joints {
            let mut own = BTreeMap::new();
            if let Some(parent) = joint.parent {
                let inboard = carried[parent].iter().chain([(&parent, &rates[parent])]);
                own.extend(inboard.map(|(&of, &rate)| {
                    let rate = Velocity { omega: rate.u, v: rate.b };
                    (of, screw(joint.motion_outboard(rate)))
                }));
            }
            carried.push(own);
        }
        Self {
            rates,
            carried,
            momenta,
            flows,
            couples,
        }
    }
}

/// The motion of all bodies that a joint carries, by a change of its coordinate or velocity.
struct Motion<'g> {
    screw: Screw<Term<'g>>,
    /// Ψλ.
    weights: Screw<Term<'g>>,
    /// Rotation of Ψ̇.
    turn: Vector<Term<'g>>,
    /// Ψ̈.
    second: Screw<Term<'g>>,
    /// L̇ + Ψ̇.
    twice: Screw<Term<'g>>,
}

impl<'g> Motion<'g> {
    fn of(joint: &Joint<'g>, rates: &Rates<'g>, weights: Screw<Term<'g>>) -> Self {
        Self {
            screw: joint.screw,
            weights,
            turn: rates.carried.u,
            second: rates.second,
            twice: rates.own + rates.carried,
        }
    }

    fn weights_along(&self, wrench: Action<Term<'g>>) -> Term<'g> {
        wrench.along(self.weights)
    }
}

/// The columns of a joint, in the frame and for the observer of a joint that carries it.
#[derive(Clone, Copy)]
struct Columns<'g> {
    /// Of q, for Ψλ.
    by_q: Action<Term<'g>>,
    /// Of q̇, for Ψλ.
    by_rate: Action<Term<'g>>,
    /// Of q̈, for Ψλ: skew\[L J\].
    inertia: Action<Term<'g>>,
    /// Of q, for Ψ̈.
    second: Action<Term<'g>>,
    /// Of q, for Ψ̇.
    turn: Vector<Term<'g>>,
    /// Of q̇, for Ψ̇.
    rate: Vector<Term<'g>>,
}

impl<'g> Columns<'g> {
    fn of(
        joint: &Joint<'g>,
        rates: &Rates<'g>,
        weighted: &Weighted<'g>,
        whole: &Whole<'g>,
        action: Action<Term<'g>>,
        k: BodyId,
    ) -> Self {
        let (inertia, flow) = (whole.inertias[k], whole.flows[k]);
        let (weights, momentum) = (weighted.rates[k], weighted.momenta[k]);
        let screw = joint.screw;
        let twice = |v: Vector<Term<'g>>| v + v;
        let moved = momentum.moved_along(screw);
        let weighted_flow = |u| weighted.flows[k].rotated_by(u).c;
        Self {
            by_q: Action::of_screw(rates.second, inertia)
                + flow.rotated_by(rates.carried.u)
                + action.moved_along(screw),
            by_rate: Action::of_screw(rates.own + rates.carried, inertia)
                + flow.rotated_by(screw.u),
            inertia: Action::of_screw(screw, inertia),
            second: Action::of_screw(weights, inertia) + moved,
            turn: flow.against(weights)
                + twice(momentum.moved_along(rates.carried).c)
                + screw.u.cross(weighted.couples[k])
                - weighted_flow(rates.carried.u),
            rate: twice(moved.c) - weighted_flow(screw.u),
        }
    }

    /// The same for an observer for whom all bodies are faster by half of a velocity.
    fn seen_by(self, faster: Vector<Term<'g>>) -> Self {
        Self {
            turn: self.turn + faster.cross(self.second.f),
            ..self
        }
    }

    /// The same in the frame and for the observer of the parent body.
    fn inboard(
        self,
        joint: &Joint<'g>,
        [by_displacement, by_placement]: [Vector<Term<'g>>; 2],
    ) -> Self {
        let steps = [
            (joint.displacement(), by_displacement),
            (joint.placement, by_placement),
        ];
        let mut own = self;
        for (pose, faster) in steps {
            own = Self {
                second: own.second.change_frame(pose),
                turn: pose.rotation * own.turn,
                rate: pose.rotation * own.rate,
                ..own
            }
            .seen_by(faster);
        }
        own
    }

    fn by_q(&self, of: &Motion<'g>) -> Term<'g> {
        self.by_q.along(of.weights) + self.turn.dot(of.turn) + self.second.along(of.second)
    }

    fn by_q_of_rate(&self, of: &Motion<'g>) -> Term<'g> {
        self.by_rate.along(of.weights) + self.rate.dot(of.turn)
    }
}
