//! Second derivatives of inverse dynamics, contracted with weights: the Hessian of λᵀτ.
//!
//! In: the joints, a motion, and a weight for the torque of each body. Out: the second derivatives of λᵀτ by q, q̇ and
//! q̈.
//!
//! They are derivatives of the [`gradient`](super::gradient), whose sums over bodies are all bilinear. A joint a that
//! carries joint b changes Φ, P, G and the screws of b by the same rule as it changes Λ and H. Hence an entry is a scalar
//! product of Ψλₐ, Ψ̇ₐ, Ψ̈ₐ and Lₐ with columns of joint b. Those for Ψ̇ₐ are couples: their forces cancel. They are
//! carried inwards, and Ψλₐ outwards, which takes the fewest operations. (The scalar form of Singh, Russell and Wensing,
//! "Second-order derivatives of rigid-body dynamics", 2024, is a tensor of three indices.)

use std::collections::BTreeMap;

use super::carry::{DisplacedJoint, Joints};
use super::derivatives::{Rates, Whole};
use super::gradient::{Lambda, Weighted, WeightedMotion};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::{List, Square};
use crate::matrix::{Action, Screw, Vector, Velocity};

/// Second derivatives of λᵀτ. An entry is the derivative, by the row's coordinate or velocity, of the derivative by the
/// column's.
pub struct Hessian<'g> {
    /// By q and q. Two velocities of one joint do not commute: their entries differ.
    pub q_q: Square<BodyId, Term<'g>>,
    /// By q and q̇.
    pub q_qd: Square<BodyId, Term<'g>>,
    /// By q̇ and q̇.
    pub qd_qd: Square<BodyId, Term<'g>>,
    /// By q and q̈.
    pub q_qdd: Square<BodyId, Term<'g>>,
}

/// The Hessian of λᵀτ at the given q̈, with external wrenches on some bodies that rotate with them.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    arguments: [&List<BodyId, Term<'g>>; 2],
    external: &[(BodyId, Action<Term<'g>>)],
) -> Hessian<'g> {
    let of = WeightedMotion::of(joints, gravity, state, arguments, external);
    let WeightedMotion {
        motion,
        rates,
        whole,
        lambda,
    } = &of;
    let turned = carried_rates(joints, lambda);
    let weighted = of.sums(joints);
    let zero = || Square::filled(state.zero(), joints.len());
    let mut found = Hessian {
        q_q: zero(),
        q_qd: zero(),
        qd_qd: zero(),
        q_qdd: zero(),
    };
    for (k, joint) in joints.numbered() {
        let momentum = weighted.momenta[k];
        let own = Columns::of(
            (k, joint),
            &rates[k],
            turned[k][&k],
            motion.actions[k],
            whole,
            &weighted,
        );
        // All velocities of one joint have the same frame, and observers of their own.
        for other in together(joints, k) {
            let of = Along::of(&joints[other], &rates[other], turned[other][&other]);
            let faster = motion.motions[k].relative - motion.motions[other].relative;
            let seen = own.faster(faster + faster);
            found.q_q[(other, k)] = seen.q_q(&of);
            found.q_qd[(other, k)] = own.q_qd(&of);
            found.q_qdd[(other, k)] = own.by_qdd.along(of.weights);
            if other <= k {
                // The screws of one joint do not move each other's, as that of a joint inboard does.
                let turned = momentum.moved_along(joint.screw).along(of.screw);
                found.qd_qd.set_both((other, k), own.qd_qd(&of) - turned);
            }
        }
        let (mut seen, mut at) = (own, k);
        while let Some(parent) = joints[at].parent {
            seen = seen.inboard(&joints[at], whole.gains[at]);
            at = parent;
            if !joint.carries_screw(at, joints) {
                let of = Along::of(&joints[at], &rates[at], turned[k][&at]);
                found.q_q.set_both((at, k), seen.q_q(&of));
                found.q_qd[(at, k)] = seen.q_qd(&of);
                found.q_qd[(k, at)] = of.screw.u.dot(seen.turn) + seen.second.along(of.by_rate);
                found.qd_qd.set_both((at, k), seen.qd_qd(&of));
                found.q_qdd[(at, k)] = seen.by_qdd.along(of.weights);
                found.q_qdd[(k, at)] = seen.second.along(of.screw);
            }
        }
    }
    found
}

/// Adds the part of wrenches that are constant in frame 0 to the Hessian by q and q: −(Lₐ × (L_b × Λ)) ⊗ Φ, with Λ of the
/// joints from b to the wrench.
pub fn add_constant_wrenches<'g>(
    by_q: &mut Square<BodyId, Term<'g>>,
    joints: &Joints<'g>,
    weights: &List<BodyId, Term<'g>>,
    external: &[(BodyId, Action<Term<'g>>)],
) {
    for &(body, action) in external {
        let (mut action, mut lambda) = (action, Velocity::zero(weights[body].graph()));
        let mut at = Some(body);
        while let Some(k) = at {
            let group: Vec<BodyId> = together(joints, k).filter(|&other| other <= k).collect();
            for &k in &group {
                lambda = lambda + Velocity::of_screw(joints[k].screw, weights[k]);
            }
            for &k in &group {
                let mut turned = action.moved_along(lambda.rate_of(joints[k].screw));
                for &other in &group {
                    let entry = &mut by_q[(other, k)];
                    *entry = *entry + turned.along(joints[other].screw);
                }
                let mut inner = k;
                while let Some(parent) = joints[inner].parent {
                    turned = joints[inner].action_inboard(turned);
                    inner = parent;
                    if !group.contains(&inner) {
                        let entry = by_q[(inner, k)] + turned.along(joints[inner].screw);
                        by_q.set_both((inner, k), entry);
                    }
                }
            }
            let first = &joints[group[0]];
            action = first.action_inboard(action);
            lambda = first.motion_inboard(lambda);
            at = first.parent;
        }
    }
}

/// All velocities of the joint of body `k`, from the first on.
fn together<'a>(joints: &'a Joints<'_>, k: BodyId) -> impl Iterator<Item = BodyId> + 'a {
    let same = move |other: BodyId| {
        joints[k].carries_screw(other, joints) || joints[other].carries_screw(k, joints)
    };
    joints.ids().filter(move |&other| same(other))
}

/// For each joint, Ψλ of itself and of the joints that carry it, in its frame.
fn carried_rates<'g>(
    joints: &Joints<'g>,
    lambda: &Lambda<'g>,
) -> List<BodyId, BTreeMap<BodyId, Screw<Term<'g>>>> {
    let mut rates: List<BodyId, BTreeMap<BodyId, Screw<Term<'g>>>> = List::new();
    for (k, joint) in joints.numbered() {
        let mut own = BTreeMap::from([(k, lambda.rate(k, joint))]);
        if let Some(parent) = joint.parent {
            own.extend(rates[parent].iter().map(|(&of, &Screw { u, b })| {
                let rate = joint.motion_outboard(Velocity { omega: u, v: b });
                (of, rate.screw())
            }));
        }
        rates.push(own);
    }
    rates
}

/// Changes that a joint's coordinate and velocity make in all bodies that the joint carries.
struct Along<'g> {
    screw: Screw<Term<'g>>,
    /// Ψλ, in the frame of the columns that it is multiplied by.
    weights: Screw<Term<'g>>,
    /// The rotation of Ψ̇.
    turn: Vector<Term<'g>>,
    /// Ψ̈.
    second: Screw<Term<'g>>,
    /// L̇ + Ψ̇.
    by_rate: Screw<Term<'g>>,
}

impl<'g> Along<'g> {
    fn of(joint: &DisplacedJoint<'g>, rates: &Rates<'g>, weights: Screw<Term<'g>>) -> Self {
        Self {
            screw: joint.screw,
            weights,
            turn: rates.carried.u,
            second: rates.second,
            by_rate: rates.own + rates.carried,
        }
    }
}

/// The columns of a joint: three for Ψλ, in its own frame, and three that are carried inwards.
#[derive(Clone, Copy)]
struct Columns<'g> {
    /// Coefficient of Ψλ in the derivatives by q.
    by_q: Action<Term<'g>>,
    /// Coefficient of Ψλ in those by q̇.
    by_qd: Action<Term<'g>>,
    /// Coefficient of Ψλ in those by q̈: skew\[L J\].
    by_qdd: Action<Term<'g>>,
    /// Coefficient of Ψ̈ in the derivatives by q.
    second: Action<Term<'g>>,
    /// Coefficient of the rotation of Ψ̇ in the derivatives by q: a couple.
    turn: Vector<Term<'g>>,
    /// Coefficient of the rotation of Ψ̇ in those by q̇.
    turn_by_qd: Vector<Term<'g>>,
}

impl<'g> Columns<'g> {
    /// Those of joint `k`, with its Ψλ and with Φ of all bodies that it carries.
    fn of(
        (k, joint): (BodyId, &DisplacedJoint<'g>),
        rates: &Rates<'g>,
        weights: Screw<Term<'g>>,
        action: Action<Term<'g>>,
        whole: &Whole<'g>,
        weighted: &Weighted<'g>,
    ) -> Self {
        let (inertia, flow) = (whole.inertias[k], whole.flows[k]);
        let (momentum, weighted_flow) = (weighted.momenta[k], weighted.flows[k]);
        let twice = |couple: Vector<Term<'g>>| couple + couple;
        let Screw { u, .. } = joint.screw;
        let moved = momentum.moved_along(joint.screw);
        let turned = flow.against(weights) + u.cross(weighted.couples[k]);
        let carried = rates.carried;
        Self {
            by_q: Action::of_screw(rates.second, inertia)
                + flow.rotated_by(carried.u)
                + action.moved_along(joint.screw),
            by_qd: Action::of_screw(rates.own + carried, inertia) + flow.rotated_by(u),
            by_qdd: Action::of_screw(joint.screw, inertia),
            second: Action::of_screw(weights, inertia) + moved,
            turn: turned + twice(momentum.moved_along(carried).c)
                - weighted_flow.rotated_by(carried.u).c,
            turn_by_qd: twice(moved.c) - weighted_flow.rotated_by(u).c,
        }
    }

    /// The same for an observer for whom twice the velocity of all bodies grows by a vector.
    fn faster(self, twice: Vector<Term<'g>>) -> Self {
        Self {
            turn: self.turn + twice.cross(self.second.f),
            ..self
        }
    }

    /// The same for the parent body: what is carried inwards is in its frame.
    fn inboard(self, joint: &DisplacedJoint<'g>, gains: [Vector<Term<'g>>; 2]) -> Self {
        let poses = [joint.displacement(), joint.placement].into_iter();
        poses.zip(gains).fold(self, |own, (pose, gain)| {
            let turned = Self {
                second: own.second.change_frame(pose),
                turn: pose.rotation * own.turn,
                turn_by_qd: pose.rotation * own.turn_by_qd,
                ..own
            };
            turned.faster(gain)
        })
    }

    fn q_q(&self, of: &Along<'g>) -> Term<'g> {
        self.by_q.along(of.weights) + self.turn.dot(of.turn) + self.second.along(of.second)
    }

    fn q_qd(&self, of: &Along<'g>) -> Term<'g> {
        self.by_qd.along(of.weights) + self.turn_by_qd.dot(of.turn)
    }

    fn qd_qd(&self, of: &Along<'g>) -> Term<'g> {
        of.screw.u.dot(self.turn_by_qd)
    }
}
