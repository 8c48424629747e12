//! What the drive of a joint adds to each of its velocities, as scalars.
//!
//! In: what is said of it, and the struct fields that stand for it. Out: a [`Drive`], zero where nothing is
//! modelled. The armature is what the joint feels: that which is given, and that of a rotor times the
//! square of its ratio, of each motor.

use super::Reader;
use crate::description::Joint;
use crate::expression::Term;
use crate::joint::Drive;
use crate::joint::drive::Part;
use crate::request::Target;

impl<'g> Reader<'g, '_> {
    /// The drive of the velocity that has this place among those of a joint.
    pub(super) fn drive(&mut self, joint: &Joint, place: usize) -> Drive<Term<'g>> {
        let said = |part: Part| {
            let numbers = self.request.drive(&joint.name.text, &joint.drive, part);
            let number = match numbers {
                [all] => Some(all),
                each => each.get(place),
            };
            number.map(|number| self.number(number))
        };
        let or_zero = |term: Option<Term<'g>>| term.unwrap_or_else(|| self.graph.constant(0.0));
        let ratio = said(Part::Ratio).unwrap_or_else(|| self.graph.constant(1.0));
        let mut rotor = or_zero(said(Part::Rotor)) * ratio * ratio;
        for motor in self.request.further_motors(&joint.name.text, &joint.drive) {
            let [inertia, ratio] = [motor.rotor, motor.ratio];
            let ratio = ratio.map_or_else(|| self.graph.constant(1.0), |ratio| self.number(&ratio));
            let inertia = or_zero(inertia.map(|inertia| self.number(&inertia)));
            rotor = rotor + inertia * ratio * ratio;
        }
        let described = Drive {
            armature: or_zero(said(Part::Armature)) + rotor,
            damping: or_zero(said(Part::Damping)),
            friction: or_zero(said(Part::Friction)),
        };
        let mut field = |part: Part, described: Term<'g>| {
            let is = |target: &Target| {
                let of = target.drives();
                of.is_some_and(|(name, of)| of == part && name.text == joint.name.text)
            };
            let [term] = self.free(is, [described]);
            term
        };
        Drive {
            armature: field(Part::Armature, described.armature),
            damping: field(Part::Damping, described.damping),
            friction: field(Part::Friction, described.friction),
        }
    }
}
