//! Limits, friction, damping and armature of a joint.
//!
//! Damping, friction and armature are kept and noted: they are modelled with the keys `friction` and `rotors`, and are
//! warnings without them. Springs and other mechanics that are not modelled are noted as warnings.

use super::JointType;
use crate::description::Limits;
use crate::description::mjcf::elements::unmodelled::{ALIGNED, CUBIC, OF_WORLD, SPRING};
use crate::description::mjcf::reading::Mjcf;
use crate::description::mjcf::values::Attributes;
use crate::joint::actuator::{Actuator, ActuatorQuantity};

/// A setting that may follow from the presence of a range.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Limited {
    No,
    Yes,
    ByRange,
}

const LIMITED: [(&str, Limited); 3] = [
    ("false", Limited::No),
    ("true", Limited::Yes),
    ("auto", Limited::ByRange),
];

impl<'a> Mjcf<'a> {
    /// The limits of the joint; those of a ball bound its rotation angle.
    pub(super) fn limits(
        &mut self,
        attributes: &Attributes<'a>,
        form: JointType,
        subject: &str,
    ) -> Option<Limits> {
        let range = self.numbers::<2>(attributes.get("range"), subject);
        let limited = self.choice(
            attributes.get("limited"),
            &LIMITED,
            Limited::ByRange,
            subject,
        );
        let effort = self.effort(attributes, form, subject);
        let has_range = range.is_some_and(|range| range.iter().any(|end| end.value != 0.0));
        let is_limited = match limited {
            _ if form == JointType::Free => false,
            Limited::No => false,
            Limited::Yes => true,
            Limited::ByRange => has_range && self.model().compiler.autolimits,
        };
        if limited == Limited::ByRange && has_range && !self.model().compiler.autolimits {
            let message =
                format!("{subject} has a range, but autolimits is false and it has no limited");
            let hint = "write limited=\"true\" or limited=\"false\", or remove autolimits";
            self.refuse(attributes.own, message, hint);
        }
        let unlimited = Limits {
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            velocity: f64::INFINITY,
            effort,
        };
        if !is_limited {
            return Some(unlimited).filter(|limits| limits.effort.is_finite());
        }
        let is_angle = matches!(form, JointType::Hinge | JointType::Ball);
        let ends = range.map(|range| {
            let ends = range.map(|end| if is_angle { self.angle(end) } else { end });
            ends.map(|end| end.value)
        });
        let [lower, upper] = ends.unwrap_or_default();
        if lower >= upper && form != JointType::Ball {
            let message = format!("the range of {subject} is from {lower} to {upper}");
            let hint = "the first number must be the smaller one";
            self.refuse(attributes.own, message, hint);
        }
        Some(Limits {
            lower,
            upper,
            ..unlimited
        })
    }

    /// The maximum torque or force of all actuators together \[N m\] or \[N\]; infinite if it is not written.
    fn effort(&mut self, attributes: &Attributes<'a>, form: JointType, subject: &str) -> f64 {
        let range = self.numbers::<2>(attributes.get("actuatorfrcrange"), subject);
        let limited = attributes.get("actuatorfrclimited");
        let limited = self.choice(limited, &LIMITED, Limited::ByRange, subject);
        let is_limited = match limited {
            Limited::No => false,
            Limited::Yes => true,
            Limited::ByRange => self.model().compiler.autolimits,
        };
        let most = range.map_or(0.0, |[lower, upper]| {
            lower.value.abs().max(upper.value.abs())
        });
        if is_limited && most > 0.0 && matches!(form, JointType::Hinge | JointType::Slide) {
            most
        } else {
            f64::INFINITY
        }
    }

    /// Notes a free body whose frame MuJoCo moves to its inertial frame.
    pub(super) fn aligned(&mut self, attributes: &Attributes<'a>, subject: &str) {
        let words = [
            ("false", false),
            ("true", true),
            ("auto", self.model().compiler.align_free),
        ];
        let by_compiler = self.model().compiler.align_free;
        if self.choice(attributes.get("align"), &words, by_compiler, subject) {
            let place = self.place(attributes.own);
            self.noted.note(&ALIGNED, place, subject.to_owned());
        }
    }

    /// Damping, friction and armature of the joint.
    pub(super) fn friction_and_armature(
        &mut self,
        attributes: &Attributes<'a>,
        form: JointType,
        subject: &str,
    ) -> Actuator {
        let mut actuator = Actuator::default();
        let mut words = Vec::new();
        let resisting = [
            ("damping", ActuatorQuantity::Damping),
            ("frictionloss", ActuatorQuantity::Friction),
        ];
        for (name, quantity) in resisting {
            let [first, second, third] = self.entries::<3>(attributes, name, subject);
            // MuJoCo's friction of a free joint acts along the axes of the world; the velocities here are in body axes.
            let is_of_world = form == JointType::Free && quantity == ActuatorQuantity::Friction;
            match first.filter(|number| number.value != 0.0) {
                Some(number) if is_of_world => {
                    self.noted.note(&OF_WORLD, number.place, subject.to_owned());
                }
                Some(number) => {
                    actuator.say(quantity, vec![number]);
                    words.push(quantity.word());
                }
                None => {}
            }
            let mut more = [second, third].into_iter().flatten();
            if let Some(more) = more.find(|more| more.value != 0.0) {
                self.noted.note(&CUBIC, more.place, subject.to_owned());
            }
        }
        let place = self.place(attributes.own);
        if !words.is_empty() {
            self.reader.unmodelled.friction(place, subject, words);
        }
        let armature = self.number(attributes.get("armature"), subject);
        let armature = armature.filter(|armature| armature.value != 0.0);
        if let Some(armature) = armature.filter(|_| form == JointType::Free) {
            self.noted
                .note(&OF_WORLD, armature.place, subject.to_owned());
        } else if let Some(armature) = armature {
            actuator.say(ActuatorQuantity::Armature, vec![armature]);
            self.reader.unmodelled.armature(place, subject);
        }
        let [first, second, third] = self.entries::<3>(attributes, "stiffness", subject);
        let [frequency, ratio] = self.entries::<2>(attributes, "springdamper", subject);
        let mut springs = [first, second, third, frequency, ratio]
            .into_iter()
            .flatten();
        if springs.any(|spring| spring.value != 0.0) {
            self.noted.note(&SPRING, place, subject.to_owned());
        }
        actuator
    }
}
