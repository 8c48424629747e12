//! Armature, damping and friction of each velocity of a joint, as scalars.
//!
//! In: the joint's data, and the struct fields that replace them. Out: a [`ActuatorTerms`], zero where nothing is modelled. The
//! armature is the reflected inertia: the given one, plus that of each motor's rotor times its squared ratio.

use super::TermReader;
use crate::description::Joint;
use crate::expression::Term;
use crate::joint::ActuatorTerms;
use crate::joint::actuator::Part;
use crate::request::Target;

impl<'g> TermReader<'g, '_> {
    /// Armature, damping and friction of the velocity with this index among those of a joint.
    pub(super) fn actuator(&mut self, joint: &Joint, place: usize) -> ActuatorTerms<Term<'g>> {
        let number = |part: Part| {
            let numbers = self
                .request
                .actuator(&joint.name.text, &joint.actuator, part);
            let number = match numbers {
                [all] => Some(all),
                each => each.get(place),
            };
            number.map(|number| self.number(number))
        };
        let or_zero = |term: Option<Term<'g>>| term.unwrap_or_else(|| self.graph.constant(0.0));
        let ratio = number(Part::Ratio).unwrap_or_else(|| self.graph.constant(1.0));
        let mut rotor = or_zero(number(Part::Rotor)) * ratio * ratio;
        for motor in self
            .request
            .further_motors(&joint.name.text, &joint.actuator)
        {
            let [inertia, ratio] = [motor.rotor, motor.ratio];
            let ratio = ratio.map_or_else(|| self.graph.constant(1.0), |ratio| self.number(&ratio));
            let inertia = or_zero(inertia.map(|inertia| self.number(&inertia)));
            rotor = rotor + inertia * ratio * ratio;
        }
        let described = ActuatorTerms {
            armature: or_zero(number(Part::Armature)) + rotor,
            damping: or_zero(number(Part::Damping)),
            friction: or_zero(number(Part::Friction)),
        };
        let mut field = |part: Part, described: Term<'g>| {
            let is = |target: &Target| {
                let of = target.actuators();
                of.is_some_and(|(name, of)| of == part && name.text == joint.name.text)
            };
            let [term] = self.free(is, [described]);
            term
        };
        ActuatorTerms {
            armature: field(Part::Armature, described.armature),
            damping: field(Part::Damping, described.damping),
            friction: field(Part::Friction, described.friction),
        }
    }
}
