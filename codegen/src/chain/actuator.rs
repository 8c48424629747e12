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
use crate::joint::actuator::ActuatorQuantity;
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
    for (k, (name, quantity, _)) in request.actuators.iter().enumerate() {
        check_joint(name, *quantity, description, tree, joints, errors);
        let mut before = request.actuators[..k].iter();
        if before.any(|(other, of, _)| of == quantity && other.text == name.text) {
            let message = format!("the {} occurs twice", called(*quantity, name));
            errors.push(name.place, message);
        }
    }
    for parameter in &request.parameters {
        if let Some((name, quantity)) = parameter.target.actuators() {
            check_joint(name, quantity, description, tree, joints, errors);
        }
    }
    for branch in tree.branches.iter().filter(|branch| branch.held.is_none()) {
        check_numbers(&description[branch.joint], request, errors);
    }
}

/// Checks that an actuator belongs to a joint that moves.
fn check_joint(
    name: &Name,
    quantity: ActuatorQuantity,
    description: &Description,
    tree: &Tree,
    joints: &Names<'_, JointId>,
    errors: &mut Errors,
) {
    let Some(joint) = joints.find(name, errors) else {
        return;
    };
    let (called, word) = (quoted(&name.text), quantity.word());
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
    for quantity in ActuatorQuantity::ALL {
        let numbers = request.actuator(name, &joint.actuator, quantity);
        let further = request.further_motors(name, &joint.actuator).iter();
        let further = further.filter_map(|motor| match quantity {
            ActuatorQuantity::Rotor => motor.rotor.as_ref(),
            ActuatorQuantity::Ratio => motor.ratio.as_ref(),
            _ => None,
        });
        let what = called(quantity, &joint.name);
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
            } else if *value < 0.0 && quantity != ActuatorQuantity::Ratio {
                errors.push(*place, format!("the {what} is negative: {value}"));
            } else if value.abs() > LARGEST {
                errors.push(*place, format!("the {what} is too large"));
            }
        }
    }
    check_motors(joint, request, errors);
    let first = |quantity| {
        request
            .actuator(&joint.name.text, &joint.actuator, quantity)
            .first()
    };
    // Many files have a gear ratio without a rotor, which has no effect.
    let mut asked = request.actuators.iter();
    let asked = asked.find(|(name, quantity, _)| {
        *quantity == ActuatorQuantity::Ratio && name.text == joint.name.text
    });
    if let (Some((name, ..)), None) = (asked, first(ActuatorQuantity::Rotor)) {
        errors.push_with_hint(
            name.place,
            format!("the {} has no rotor", called(ActuatorQuantity::Ratio, name)),
            "set rotor as well, or only armature, which includes the ratio",
        );
    }
}

/// Checks that the request replaces all motors of a joint with several: rotor and ratio together.
fn check_motors(joint: &Joint, request: &Request, errors: &mut Errors) {
    let asked = |of: ActuatorQuantity| {
        let mut actuators = request.actuators.iter();
        actuators.find(|(name, quantity, _)| *quantity == of && name.text == joint.name.text)
    };
    let several = !joint.actuator.further().is_empty();
    let alone = match (
        asked(ActuatorQuantity::Rotor),
        asked(ActuatorQuantity::Ratio),
    ) {
        (Some((name, quantity, _)), None) | (None, Some((name, quantity, _))) if several => {
            (name, *quantity)
        }
        _ => return,
    };
    let (name, quantity) = alone;
    let count = 1 + joint.actuator.further().len();
    errors.push_with_hint(
        name.place,
        format!(
            "the {} is for one motor, but the file has {count}",
            called(quantity, name)
        ),
        "set rotor and ratio together, which replace all motors; or armature, which is added",
    );
}

fn called(quantity: ActuatorQuantity, joint: &Name) -> String {
    format!("{} of joint {}", quantity.word(), quoted(&joint.text))
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
                .actuator(name, &joint.actuator, ActuatorQuantity::Rotor)
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
    let none = |is: fn(ActuatorQuantity) -> bool| {
        let has_any = |joint: &&Joint| {
            let mut quantities = ActuatorQuantity::ALL
                .into_iter()
                .filter(|quantity| is(*quantity));
            quantities.any(|quantity| {
                !request
                    .actuator(&joint.name.text, &joint.actuator, quantity)
                    .is_empty()
            })
        };
        let mut fields = request.parameters.iter();
        let field = fields.any(|field| {
            field
                .target
                .actuators()
                .is_some_and(|(_, quantity)| is(quantity))
        });
        !field && !moving.iter().any(has_any)
    };
    let asked = [
        (
            request.friction && none(ActuatorQuantity::resists),
            "friction",
        ),
        (
            request.rotors && none(|quantity| !quantity.resists()),
            "armature",
        ),
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
