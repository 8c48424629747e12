//! Checks of actuators: rotors, ratios, armatures, damping and friction.
//!
//! In: the description, the request, the tree. Out: an error for each joint that cannot have such data and for each
//! number that is not possible; warnings about data that are described and not modelled. Their sums are made in
//! [`merge`](super::merge).

use super::names::Names;
use super::numbers::LARGEST;
use super::tree::Tree;
use crate::description::{Description, Joint, JointId, Modelled, Name, Number};
use crate::error::{Diagnostic, Errors};
use crate::joint::actuator::Part;
use crate::request::Request;
use crate::wording::quoted;

/// Checks all data of actuators.
pub fn check(
    description: &Description,
    request: &Request,
    tree: &Tree,
    joints: &Names<'_, JointId>,
    errors: &mut Errors,
) {
    for (k, (name, part, _)) in request.actuators.iter().enumerate() {
        check_joint(name, *part, description, tree, joints, errors);
        let mut before = request.actuators[..k].iter();
        if before.any(|(other, of, _)| of == part && other.text == name.text) {
            let message = format!("the {} occurs twice", called(*part, name));
            errors.push(name.place, message);
        }
    }
    for parameter in &request.parameters {
        if let Some((name, part)) = parameter.target.actuators() {
            check_joint(name, part, description, tree, joints, errors);
        }
    }
    for branch in tree.branches.iter().filter(|branch| branch.held.is_none()) {
        check_numbers(&description[branch.joint], request, errors);
    }
}

/// Checks that an actuator belongs to a joint that moves.
fn check_joint(
    name: &Name,
    part: Part,
    description: &Description,
    tree: &Tree,
    joints: &Names<'_, JointId>,
    errors: &mut Errors,
) {
    let Some(joint) = joints.find(name, errors) else {
        return;
    };
    let (called, word) = (quoted(&name.text), part.word());
    let branch = tree.branches.iter().find(|branch| branch.joint == joint);
    if !description[joint].kind.moves() {
        let message = format!("joint {called} is fixed and has no {word}");
        errors.push(name.place, message);
    } else if branch.is_none() {
        errors.push(name.place, format!("joint {called} is not modelled"));
    } else if branch.is_some_and(|branch| branch.held.is_some()) {
        let message = format!("joint {called} does not move: its {word} changes nothing");
        let hint = "leave it out, or do not lock the joint";
        errors.push_with_hint(name.place, message, hint);
    }
}

/// Checks that there is one number for all velocities, or one for each, and that none is negative.
fn check_numbers(joint: &Joint, request: &Request, errors: &mut Errors) {
    let count = joint.kind.degrees_of_freedom().len();
    let name = &joint.name.text;
    for part in Part::ALL {
        let numbers = request.actuator(name, &joint.actuator, part);
        let further = request.further_motors(name, &joint.actuator).iter();
        let further = further.filter_map(|motor| match part {
            Part::Rotor => motor.rotor.as_ref(),
            Part::Ratio => motor.ratio.as_ref(),
            _ => None,
        });
        let what = called(part, &joint.name);
        let place = numbers.first().map_or(joint.place, |number| number.place);
        if numbers.len() > 1 && numbers.len() != count {
            let given = numbers.len();
            errors.push_with_hint(
                place,
                format!("the {what} has {given} numbers for {count} of its velocities"),
                "give one number for all of them, or one for each",
            );
        }
        for Number { value, place, .. } in numbers.iter().chain(further) {
            if !value.is_finite() {
                errors.push(*place, format!("the {what} is not a number"));
            } else if *value < 0.0 && part != Part::Ratio {
                errors.push(*place, format!("the {what} is negative: {value}"));
            } else if value.abs() > LARGEST {
                errors.push(*place, format!("the {what} is too large"));
            }
        }
    }
    check_motors(joint, request, errors);
    let first = |part| {
        request
            .actuator(&joint.name.text, &joint.actuator, part)
            .first()
    };
    // Many files have a gear ratio without a rotor, which has no effect.
    let mut asked = request.actuators.iter();
    let asked = asked.find(|(name, part, _)| *part == Part::Ratio && name.text == joint.name.text);
    if let (Some((name, ..)), None) = (asked, first(Part::Rotor)) {
        errors.push_with_hint(
            name.place,
            format!("the {} has no rotor", called(Part::Ratio, name)),
            "set rotor as well, or only armature, which includes the ratio",
        );
    }
}

/// Checks that the request replaces all motors of a joint with several: rotor and ratio together.
fn check_motors(joint: &Joint, request: &Request, errors: &mut Errors) {
    let asked = |of: Part| {
        let mut actuators = request.actuators.iter();
        actuators.find(|(name, part, _)| *part == of && name.text == joint.name.text)
    };
    let several = !joint.actuator.further().is_empty();
    let alone = match (asked(Part::Rotor), asked(Part::Ratio)) {
        (Some((name, part, _)), None) | (None, Some((name, part, _))) if several => (name, *part),
        _ => return,
    };
    let (name, part) = alone;
    let count = 1 + joint.actuator.further().len();
    errors.push_with_hint(
        name.place,
        format!(
            "the {} is for one motor, but the file has {count}",
            called(part, name)
        ),
        "set rotor and ratio together, which replace all motors; or armature, which is added",
    );
}

fn called(part: Part, joint: &Name) -> String {
    format!("{} of joint {}", part.word(), quoted(&joint.text))
}

/// Warnings about data that are described and not modelled, or requested and not described.
pub fn warnings(description: &Description, request: &Request, tree: &Tree) -> Vec<Diagnostic> {
    let joint = |name: &str| {
        let mut joints = description.joints.iter();
        joints.find(|joint| joint.name.text == name)
    };
    let has_rotor = |name: &str| {
        joint(name).is_some_and(|joint| {
            !request
                .actuator(name, &joint.actuator, Part::Rotor)
                .is_empty()
        })
    };
    let modelled = Modelled {
        friction: request.models_friction(),
        armature: request.models_armature(),
        has_rotor: &has_rotor,
    };
    let mut warnings = description.unmodelled.warnings(&modelled);
    let moving = tree.branches.iter().filter(|branch| branch.held.is_none());
    let moving: Vec<&Joint> = moving.map(|branch| &description[branch.joint]).collect();
    let none = |is: fn(Part) -> bool| {
        let has_any = |joint: &&Joint| {
            let mut parts = Part::ALL.into_iter().filter(|part| is(*part));
            parts.any(|part| {
                !request
                    .actuator(&joint.name.text, &joint.actuator, part)
                    .is_empty()
            })
        };
        let mut fields = request.parameters.iter();
        let field = fields.any(|field| field.target.actuators().is_some_and(|(_, part)| is(part)));
        !field && !moving.iter().any(has_any)
    };
    let asked = [
        (request.friction && none(Part::resists), "friction"),
        (request.rotors && none(|part| !part.resists()), "armature"),
    ];
    for (_, what) in asked.into_iter().filter(|(missing, _)| *missing) {
        warnings.push(Diagnostic {
            place: description.name.place,
            message: format!("{what} is requested, but no moving joint has it in the description"),
            hint: Some("set its value for each joint".to_owned()),
        });
    }
    warnings
}
