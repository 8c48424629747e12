//! Armature, damping and friction of each velocity of a joint, as scalars.
//!
//! In: the joint's data, and the struct fields that replace them. Out: a [`ActuatorTerms`], zero where nothing is modelled. The
//! armature is the reflected inertia: the given one, plus that of each motor's rotor times its squared ratio.

use super::TermReader;
use crate::description::Joint;
use crate::expression::Term;
use crate::joint::ActuatorTerms;
use crate::joint::actuator::ActuatorQuantity;
use crate::request::Target;

impl<'g> TermReader<'g, '_> {
    /// Armature, damping and friction of the velocity with this index among those of a joint.
    pub(super) fn actuator(&mut self, joint: &Joint, place: usize) -> ActuatorTerms<Term<'g>> {
        let number = |quantity: ActuatorQuantity| {
            let numbers = self
                .request
                .actuator(&joint.name.text, &joint.actuator, quantity);
            let number = match numbers {
                [all] => Some(all),
                each => each.get(place),
            };
            number.map(|number| self.number(number))
        };
        let or_zero = |term: Option<Term<'g>>| term.unwrap_or_else(|| self.graph.constant(0.0));
        let ratio = number(ActuatorQuantity::Ratio).unwrap_or_else(|| self.graph.constant(1.0));
        let mut rotor = or_zero(number(ActuatorQuantity::Rotor)) * ratio * ratio;
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
            armature: or_zero(number(ActuatorQuantity::Armature)) + rotor,
            damping: or_zero(number(ActuatorQuantity::Damping)),
            friction: or_zero(number(ActuatorQuantity::Friction)),
        };
        let mut field = |quantity: ActuatorQuantity, described: Term<'g>| {
            let is = |target: &Target| {
                let of = target.actuators();
                of.is_some_and(|(name, of)| of == quantity && name.text == joint.name.text)
            };
            let [term] = self.free(is, [described]);
            term
        };
        ActuatorTerms {
            armature: field(ActuatorQuantity::Armature, described.armature),
            damping: field(ActuatorQuantity::Damping, described.damping),
            friction: field(ActuatorQuantity::Friction, described.friction),
        }
    }
}
