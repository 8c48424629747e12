//! Joints of a body.

use super::Mjcf;
use crate::convert::actuators;
use crate::convert::elementary::{Elementary, ElementaryMotion};
use crate::convert::markup::Attribute;
use crate::convert::numbers::{plain, text, texts};
use crate::description::spatial::{Pose, to_number};
use crate::description::{JointId, Number};
use crate::error::Place;
use crate::joint::Manifold;
use crate::joint::actuator::ActuatorQuantity;
use crate::number::computed;
use crate::wording::quoted;

impl Mjcf<'_> {
    /// A part of a joint; `frame` is the pose of its frame in the body, `None` for the same frame.
    pub(super) fn joint(&mut self, part: &Elementary<'_>, joint: JointId, frame: Option<&Pose>) {
        let (kind, has_axis) = match part.motion {
            ElementaryMotion::Rotation => ("hinge", true),
            ElementaryMotion::Translation => ("slide", true),
            ElementaryMotion::Manifold(Manifold::Spherical) => ("ball", false),
            ElementaryMotion::Manifold(Manifold::Floating) => ("free", false),
            ElementaryMotion::Fixed => return,
            ElementaryMotion::Manifold(Manifold::Planar) => {
                let message = format!(
                    "joint {} is planar, with velocities in its own frame: MJCF has no such joint",
                    quoted(&part.name)
                );
                let hint = "use two prismatic joints and a revolute one";
                self.errors.push_with_hint(part.of.place, message, hint);
                return;
            }
        };
        let mut attributes: Vec<Attribute> =
            vec![("name", part.name.clone()), ("type", kind.to_owned())];
        let number = |value| to_number(value, Place::Unknown);
        if let Some(frame) = frame.filter(|_| part.motion != ElementaryMotion::Translation) {
            attributes.push(("pos", texts(&frame.position.map(number))));
        }
        if has_axis {
            let axis = frame.map_or(part.axis, |frame| {
                let axis = part.axis.map(|entry| entry.exact());
                frame.direction(axis).map(number)
            });
            attributes.push(("axis", texts(&axis)));
        }
        self.order.push((joint, part.motion));
        self.limits(part, joint, &mut attributes);
        self.actuator(part, &mut attributes);
        self.markup.empty("joint", &attributes);
    }

    fn limits(&mut self, part: &Elementary<'_>, joint: JointId, attributes: &mut Vec<Attribute>) {
        let Some(limits) = part.limits else { return };
        let [lower, upper] = [limits.lower, limits.upper];
        // Zeros are limits that were not written.
        let is_written = part.is_limited() && (lower != 0.0 || upper != 0.0);
        let is_range = lower.is_finite() && upper.is_finite() && lower < upper;
        let is_said = match part.motion {
            ElementaryMotion::Rotation | ElementaryMotion::Translation => is_range,
            ElementaryMotion::Manifold(Manifold::Spherical) => is_range && lower == 0.0,
            ElementaryMotion::Fixed
            | ElementaryMotion::Manifold(Manifold::Planar | Manifold::Floating) => false,
        };
        if is_written && is_said {
            attributes.push(("range", format!("{} {}", plain(lower), plain(upper))));
        } else if is_written {
            let message = format!(
                "the limits {} and {} of joint {} are left out: MJCF has none like them",
                plain(lower),
                plain(upper),
                quoted(&part.name)
            );
            self.warn(part.of.place, message, None);
        }
        let is_scalar = matches!(
            part.motion,
            ElementaryMotion::Rotation | ElementaryMotion::Translation
        );
        if is_scalar && limits.effort.is_finite() && limits.effort > 0.0 {
            let effort = plain(limits.effort);
            attributes.push(("actuatorfrcrange", format!("-{effort} {effort}")));
        }
        if limits.velocity.is_finite() && limits.velocity > 0.0 {
            self.fast.push(joint);
        }
    }

    fn actuator(&mut self, part: &Elementary<'_>, attributes: &mut Vec<Attribute>) {
        let motors = actuators::motors(part).unwrap_or_else(|quantity| {
            self.differ(part, quantity);
            Vec::new()
        });
        let armature = actuators::reflected(&motors);
        let armature = armature.map(|armature| computed(armature, Place::Unknown));
        let [damping, friction] =
            [ActuatorQuantity::Damping, ActuatorQuantity::Friction].map(|quantity| {
                actuators::number(part, quantity).unwrap_or_else(|()| {
                    self.differ(part, quantity);
                    None
                })
            });
        if part.motion == ElementaryMotion::Manifold(Manifold::Floating)
            && (armature.is_some() || friction.is_some())
        {
            let message = format!(
                "joint {} is floating, and MuJoCo has its armature and friction along other axes",
                quoted(&part.name)
            );
            self.errors.push(part.of.place, message);
        }
        let words: [(&str, Option<Number>); 3] = [
            ("armature", armature),
            ("damping", damping),
            ("frictionloss", friction),
        ];
        for (word, number) in words {
            attributes.extend(number.map(|number| (word, text(&number))));
        }
    }

    fn differ(&mut self, part: &Elementary<'_>, quantity: ActuatorQuantity) {
        let message = actuators::differ(part, quantity);
        self.errors.push(part.of.place, message);
    }
}
