//! Drives for robots that are described without any.
//!
//! In: a description and a request. Out: the request with an armature, a rotor behind a gear, damping and
//! friction at every joint that moves, another number for each velocity.

use homogen_codegen::description::{Description, Number};
use homogen_codegen::joint::drive::Part;
use homogen_codegen::request::Request;

/// The request, with drives.
#[must_use]
pub fn driven(description: &Description, mut request: Request) -> Request {
    let held: Vec<&str> = (request.lock.iter())
        .map(|(name, _)| name.text.as_str())
        .collect();
    let is_held = |name: &str| held.contains(&name);
    let moving = description.joints.iter().filter(|joint| {
        // What follows a joint that is held does not move either.
        let follows = joint
            .mimic
            .as_ref()
            .is_some_and(|mimic| is_held(&mimic.leader.text));
        joint.kind.moves() && !is_held(&joint.name.text) && !follows
    });
    let mut said = Vec::new();
    let mut entry = 0.0;
    for joint in moving {
        for (part, size) in [
            (Part::Armature, 0.03),
            (Part::Rotor, 2e-5),
            (Part::Ratio, 40.0),
            (Part::Damping, 0.7),
            (Part::Friction, 0.3),
        ] {
            let numbers = joint.kind.freedoms().iter().map(|_| {
                entry += 1.0;
                // Between half and three halves of the size.
                let share: f64 = entry * 0.618_033_988_749_895;
                number(size * (0.5 + share.fract()))
            });
            said.push((joint.name.clone(), part, numbers.collect()));
        }
    }
    request.drives = said;
    request
}

fn number(value: f64) -> Number {
    Number {
        value,
        ..Number::default()
    }
}
