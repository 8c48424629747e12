//! The centre of mass and its velocity: first moments of all bodies that joints move, summed inwards and divided by
//! their mass.
//!
//! In: the joints and bodies, and the inertia that regrouping has moved to the base, which counts like that of bodies.
//! Out: the centre of mass in frame 0, its velocity, and the derivative by each velocity.

use super::algorithm::Carried;
use super::carry::{self, Joints};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::{Block, LabelledBodies, Term};
use crate::list::List;
use crate::matrix::{Inertia, Vector};

/// The masses and first moments of bodies with all that they carry.
pub struct MassCenter<'s, 'g> {
    joints: &'s Joints<'g>,
    /// For each joint the bodies that it carries, in the frame of the joint's matrices: the share of the mass, and
    /// the first moment in units of it.
    carried: List<BodyId, (Term<'g>, Vector<Term<'g>>)>,
    /// The first moment of all bodies in frame 0, in the same unit.
    moment: Vector<Term<'g>>,
    /// The divisor of the moments: the mass, if it is an input; a constant mass has been divided by already.
    undivided: Option<Term<'g>>,
}

impl<'s, 'g> MassCenter<'s, 'g> {
    pub fn of(joints: &'s Joints<'g>, base: &Inertia<Term<'g>>) -> Self {
        let masses = joints.iter().map(|joint| joint.inertia.mass);
        let total = masses.fold(base.mass, |sum, mass| sum + mass);
        let known = total.value().is_some();
        let share = |part: Term<'g>| if known { part / total } else { part };
        let own = |inertia: &Inertia<Term<'g>>| (share(inertia.mass), inertia.q.map(share));
        let mut carried = joints.map(|joint| own(&joint.inertia));
        let (_, mut moment) = own(base);
        for (k, joint) in joints.numbered().rev() {
            let (mass, q) = carried[k];
            let (index, frame) = joint.numbers();
            q.label(
                Block::MassCenter
                    .of(LabelledBodies::Body(index))
                    .seen_in(frame),
            );
            let inboard = joint.first_moment_inboard(q, mass);
            if let Some(parent) = joint.parent {
                let (outer_mass, outer) = carried[parent];
                carried[parent] = (outer_mass + mass, outer + inboard);
            } else {
                moment = moment + inboard;
            }
        }
        Self {
            joints,
            carried,
            moment,
            undivided: (!known).then_some(total),
        }
    }

    /// The centre of mass.
    pub fn point(&self) -> Vector<Term<'g>> {
        self.divided(self.moment)
    }

    /// Its velocity: the derivatives of the moments in each body's frame, summed inwards with the joint's own.
    pub fn velocity(&self, state: &State<'g>) -> Vector<Term<'g>> {
        let still = Vector::zero(state.graph);
        let mut rates = List::filled(still, self.joints.len());
        let mut rate = still;
        for (k, joint) in self.joints.numbered().rev() {
            let own = self.moved_by(k) * state.qd(joint.body);
            let inboard = joint.vector_inboard(rates[k] + own);
            match joint.parent {
                Some(parent) => rates[parent] = rates[parent] + inboard,
                None => rate = rate + inboard,
            }
        }
        self.divided(rate)
    }

    /// The velocity at a unit velocity of each body, one after the other.
    pub fn columns(&self, carried: Carried) -> List<BodyId, Vector<Term<'g>>> {
        let columns: List<BodyId, _> = match carried {
            Carried::Outwards => {
                let placed = carry::placed(self.joints).into_iter();
                let rotated = placed.map(|(joint, pose)| pose.rotation * self.moved_by(joint.body));
                rotated.collect()
            }
            Carried::Inwards { .. } => {
                let inwards = |k: BodyId| {
                    let up = std::iter::successors(Some(k), |&k| self.joints[k].parent);
                    up.fold(self.moved_by(k), |column, at| {
                        self.joints[at].vector_inboard(column)
                    })
                };
                self.joints.ids().map(inwards).collect()
            }
        };
        columns.map(|&column| self.divided(column))
    }

    /// The derivative, at a unit velocity of a joint, of the first moment that it carries: u × q + b m.
    fn moved_by(&self, k: BodyId) -> Vector<Term<'g>> {
        let (screw, (mass, q)) = (self.joints[k].screw, self.carried[k]);
        screw.u.cross(q) + screw.b * mass
    }

    fn divided(&self, moment: Vector<Term<'g>>) -> Vector<Term<'g>> {
        match self.undivided {
            Some(mass) => moment.map(|entry| entry / mass),
            None => moment,
        }
    }
}
