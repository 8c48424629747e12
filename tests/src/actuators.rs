//! Actuators for descriptions without any.
//!
//! In: a description and a request. Out: the request with an armature, a rotor behind a gear, damping and friction at
//! every joint that moves, with a different number for each velocity.

use homogen_codegen::description::{Description, Number};
use homogen_codegen::joint::actuator::ActuatorQuantity;
use homogen_codegen::request::Request;

/// The request with actuators.
#[must_use]
pub fn with_actuators(description: &Description, mut request: Request) -> Request {
    let locked: Vec<&str> = (request.lock.iter())
        .map(|(name, _)| name.text.as_str())
        .collect();
    let is_locked = |name: &str| locked.contains(&name);
    let moving = description.joints.iter().filter(|joint| {
        // A mimic joint of a locked joint does not move either.
        let mimics_locked = joint
            .mimic
            .as_ref()
            .is_some_and(|mimic| is_locked(&mimic.mimicked.text));
        joint.kind.moves() && !is_locked(&joint.name.text) && !mimics_locked
    });
    let mut settings = Vec::new();
    let mut entry = 0.0;
    for joint in moving {
        for (quantity, size) in [
            (ActuatorQuantity::Armature, 0.03),
            (ActuatorQuantity::Rotor, 2e-5),
            (ActuatorQuantity::Ratio, 40.0),
            (ActuatorQuantity::Damping, 0.7),
            (ActuatorQuantity::Friction, 0.3),
        ] {
            let numbers = joint.kind.degrees_of_freedom().iter().map(|_| {
                entry += 1.0;
                // Between half and three halves of the size.
                let share: f64 = entry * 0.618_033_988_749_895;
                number(size * (0.5 + share.fract()))
            });
            settings.push((joint.name.clone(), quantity, numbers.collect()));
        }
    }
    request.actuators = settings;
    request
}

fn number(value: f64) -> Number {
    Number {
        value,
        ..Number::default()
    }
}
