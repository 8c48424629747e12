//! First derivatives of inverse dynamics, contracted with weights: the gradient of λᵀτ.
//!
//! In: the joints, a motion, and a weight for the torque of each body. Out: the derivatives of λᵀτ by q, q̇ and q̈,
//! without the matrices of derivatives that they are rows of.
//!
//! With Λ = Σ λ L over the joints that carry a body, λᵀτ = Σ Λ ⊗ skew\[H J\]. A displacement along L changes Λ and H of
//! all bodies that its joint carries, as they see them, by Ψλ = Λ L − L Λ, with Λ of the joint's parent body, and by
//! Ψ̈ + 2 Ψ̲̇ W ([`derivatives`](super::derivatives)). With Φ, the momentum P = Σ skew\[Λ J\] and the couple
//! G = Σ 2 skew\[Y Λᵗ\] of all bodies that the joint carries, the gradient is
//!
//! * by q: Ψλ ⊗ Φ + Ψ̈ ⊗ P + Ψ̇ · G,
//! * by q̇: (L̇ + Ψ̇) ⊗ P + L · G,
//! * by q̈: L ⊗ P, which is M λ.
//!
//! Each is computed as often as there are bodies: the gradient costs little more than τ itself.

use super::carry::{DisplacedJoint, Joints};
use super::derivatives::{Rates, Whole, rates};
use super::newton_euler::{BodyMotion, Dynamics, motion};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Action, Flow, Screw, Vector, Velocity};

/// The derivatives of λᵀτ by each coordinate, velocity and acceleration.
pub struct Gradient<'g> {
    pub q: List<BodyId, Term<'g>>,
    pub qd: List<BodyId, Term<'g>>,
    pub qdd: List<BodyId, Term<'g>>,
}

/// The gradient of λᵀτ at the given q̈, with external wrenches on some bodies that rotate with them.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    [qdd, weights]: [&List<BodyId, Term<'g>>; 2],
    external: &[(BodyId, Action<Term<'g>>)],
) -> Gradient<'g> {
    let of = WeightedMotion::of(joints, gravity, state, [qdd, weights], external);
    let weighted = of.sums(joints);
    let mut found = Gradient {
        q: List::new(),
        qd: List::new(),
        qdd: List::new(),
    };
    for (k, joint) in joints.numbered() {
        let (rates, weight) = (&of.rates[k], weights[k]);
        let (momentum, couple) = (weighted.momenta[k], weighted.couples[k]);
        let by_q = of.motion.actions[k].along(of.lambda.rate(k, joint))
            + momentum.along(rates.second)
            + couple.dot(rates.carried.u);
        let by_qd = momentum.along(rates.own + rates.carried)
            + couple.dot(joint.screw.u)
            + joint.actuator.damping * weight;
        found.q.push(by_q);
        found.qd.push(by_qd);
        found
            .qdd
            .push(momentum.along(joint.screw) + joint.actuator.armature * weight);
    }
    found
}

/// Adds to the gradient by q the part of wrenches that are constant in frame 0, relative to which only L moves: for
/// joint m, −Σ λᵢ (Lₘ Lᵢ − Lᵢ Lₘ) ⊗ Φ over the joints i outboard of it.
pub fn add_constant_wrenches<'g>(
    by_q: &mut List<BodyId, Term<'g>>,
    joints: &Joints<'g>,
    weights: &List<BodyId, Term<'g>>,
    external: &[(BodyId, Action<Term<'g>>)],
) {
    for &(body, action) in external {
        let (mut action, mut at) = (action, Some(body));
        // Σ λᵢ (Lᵢ Φ + Φ Lᵢᵗ) of the joints outboard.
        let mut turned: Option<Action<Term<'g>>> = None;
        while let Some(k) = at {
            let joint = &joints[k];
            if let Some(turned) = turned {
                by_q[k] = by_q[k] - turned.along(joint.screw);
            }
            let own = action.moved_along(joint.screw);
            let weighted = Velocity::of_screw(joint.screw, weights[k]).screw();
            let mut inner = joint.parent;
            // Velocities of one joint move each other's screws.
            while let Some(at) = inner.filter(|&at| joint.carries_screw(at, joints)) {
                by_q[k] = by_q[k] + own.along(joints[at].screw) * weights[at];
                inner = joints[at].parent;
            }
            let more = action.moved_along(weighted);
            let sum = turned.map_or(more, |turned| turned + more);
            turned = Some(joint.action_inboard(sum));
            action = joint.action_inboard(action);
            at = joint.parent;
        }
    }
}

/// A motion with weights, of which the derivatives of λᵀτ are made.
pub(super) struct WeightedMotion<'g> {
    pub(super) motion: Dynamics<'g>,
    pub(super) rates: List<BodyId, Rates<'g>>,
    pub(super) whole: Whole<'g>,
    pub(super) lambda: Lambda<'g>,
}

impl<'g> WeightedMotion<'g> {
    pub(super) fn of(
        joints: &Joints<'g>,
        gravity: Vector<Term<'g>>,
        state: &State<'g>,
        [qdd, weights]: [&List<BodyId, Term<'g>>; 2],
        external: &[(BodyId, Action<Term<'g>>)],
    ) -> Self {
        let motion = motion(joints, gravity, state, qdd, external);
        let rates = rates(joints, gravity, &motion.motions);
        // Each velocity enters doubled.
        let whole = Whole::of(joints, state, &motion.motions, |v| v + v);
        Self {
            motion,
            rates,
            whole,
            lambda: Lambda::of(joints, state, weights),
        }
    }

    /// The sums with Λ over all bodies that each joint carries.
    pub(super) fn sums(&self, joints: &Joints<'g>) -> Weighted<'g> {
        Weighted::of(joints, &self.lambda, &self.motion.motions, &self.whole)
    }
}

/// Λ = Σ λ L of the joints that carry a body.
pub(super) struct Lambda<'g> {
    /// Λ of each body.
    pub(super) bodies: List<BodyId, Velocity<Term<'g>>>,
    /// Λ of the parent body of each joint.
    outer: List<BodyId, Velocity<Term<'g>>>,
}

impl<'g> Lambda<'g> {
    pub(super) fn of(
        joints: &Joints<'g>,
        state: &State<'g>,
        weights: &List<BodyId, Term<'g>>,
    ) -> Self {
        let rest = Velocity::zero(state.graph);
        let mut outer: List<BodyId, Velocity<Term<'g>>> = List::new();
        let mut bodies: List<BodyId, Velocity<Term<'g>>> = List::new();
        for (k, joint) in joints.numbered() {
            let carried = |parent: BodyId| joint.motion_outboard(bodies[parent]);
            let before = joint.parent.map_or(rest, carried);
            outer.push(match joint.parent {
                Some(parent) if joint.taken => outer[parent],
                _ => before,
            });
            bodies.push(before + Velocity::of_screw(joint.screw, weights[k]));
        }
        Self { bodies, outer }
    }

    /// Ψλ of a joint, in its frame.
    pub(super) fn rate(&self, k: BodyId, joint: &DisplacedJoint<'g>) -> Screw<Term<'g>> {
        self.outer[k].rate_of(joint.screw)
    }
}

/// Sums with Λ over all bodies that each joint carries.
pub(super) struct Weighted<'g> {
    /// P = Σ skew\[Λ J\].
    pub(super) momenta: List<BodyId, Action<Term<'g>>>,
    /// 2 Σ Λ J.
    pub(super) flows: List<BodyId, Flow<Term<'g>>>,
    /// G = 2 Σ skew\[Y Λᵗ\], for the observer of Y.
    pub(super) couples: List<BodyId, Vector<Term<'g>>>,
}

impl<'g> Weighted<'g> {
    fn of(
        joints: &Joints<'g>,
        lambda: &Lambda<'g>,
        motions: &List<BodyId, BodyMotion<'g>>,
        whole: &Whole<'g>,
    ) -> Self {
        let each = joints.iter().zip(&lambda.bodies);
        let momenta = each.clone();
        let mut momenta: List<BodyId, _> = momenta
            .map(|(joint, &lambda)| Action::of_screw(lambda.screw(), joint.inertia))
            .collect();
        let flows = each.clone();
        let mut flows: List<BodyId, _> = flows
            .map(|(joint, &Velocity { omega, v })| {
                Flow::of_rotation(omega + omega, joint.inertia).faster(v + v, joint.inertia)
            })
            .collect();
        let couples = each.zip(motions);
        let mut couples: List<BodyId, _> = couples
            .map(|((joint, &lambda), own)| {
                let omega = own.h.omega;
                Flow::of_rotation(omega + omega, joint.inertia).against(lambda.screw())
            })
            .collect();
        for (k, joint) in joints.numbered().rev() {
            let Some(parent) = joint.parent else { continue };
            let flow = match joint.displacement {
                Some(displacement) => flows[k].rotate(displacement.rotation),
                None => flows[k].rotate_about_z(joint.angle),
            };
            let flow = flow.translate(joint.offset());
            let flow = flow.rotate(joint.placement.rotation);
            flows[parent] = flows[parent] + flow.translate(joint.placement.translation);
            let (mut momentum, mut couple) = (momenta[k], couples[k]);
            let poses = [joint.displacement(), joint.placement];
            for (pose, faster) in poses.into_iter().zip(whole.gains[k]) {
                momentum = momentum.change_frame(pose);
                couple = pose.rotation * couple + faster.cross(momentum.f);
            }
            momenta[parent] = momenta[parent] + momentum;
            couples[parent] = couples[parent] + couple;
        }
        Self {
            momenta,
            flows,
            couples,
        }
    }
}
