//! Armature, rotors, damping and friction of the parts of a joint.

use super::elementary::Elementary;
use crate::description::Number;
use crate::expression::Double;
use crate::joint::actuator::{ActuatorQuantity, Motor};
use crate::wording::quoted;

/// The numbers of a quantity: those of one velocity, or all of a part with several.
pub(super) fn numbers<'d>(part: &Elementary<'d>, quantity: ActuatorQuantity) -> &'d [Number] {
    if part.is_advance() {
        return &[];
    }
    let all = part.of.actuator.of(quantity);
    match part.index {
        Some(k) if all.len() > 1 => all.get(k..=k).unwrap_or_default(),
        _ => all,
    }
}

/// The only number of a quantity; `None` without one.
///
/// # Errors
/// Several numbers that differ.
pub(super) fn number(
    part: &Elementary<'_>,
    quantity: ActuatorQuantity,
) -> Result<Option<Number>, ()> {
    let all = numbers(part, quantity);
    let Some((first, others)) = all.split_first() else {
        return Ok(None);
    };
    let is_same = |other: &Number| (other.value, other.rest) == (first.value, first.rest);
    if others.iter().all(is_same) {
        Ok(Some(*first))
    } else {
        Err(())
    }
}

/// The motors of a part: those of the description, and its armature as the rotor of one without a gear.
///
/// # Errors
/// A quantity whose numbers differ between the velocities of the part.
pub(super) fn motors(part: &Elementary<'_>) -> Result<Vec<Motor>, ActuatorQuantity> {
    let of = |quantity| number(part, quantity).map_err(|()| quantity);
    let first = Motor {
        rotor: of(ActuatorQuantity::Rotor)?,
        ratio: of(ActuatorQuantity::Ratio)?,
    };
    let armature = of(ActuatorQuantity::Armature)?.map(|armature| Motor {
        rotor: Some(armature),
        ratio: None,
    });
    let further: &[Motor] = if part.is_advance() {
        &[]
    } else {
        part.of.actuator.further()
    };
    let is_there = |motor: &Motor| motor.rotor.is_some() || motor.ratio.is_some();
    let all = std::iter::once(first).chain(further.iter().copied());
    Ok(all.chain(armature).filter(is_there).collect())
}

/// The inertia of all motors, reflected at the joint.
pub(super) fn reflected(motors: &[Motor]) -> Option<Double> {
    let inertias = motors.iter().filter_map(|motor| {
        let ratio = motor.ratio.map_or(Double::from(1.0), |ratio| ratio.exact());
        Some(motor.rotor?.exact() * ratio * ratio)
    });
    inertias.reduce(|sum, inertia| sum + inertia)
}

/// The message of numbers that differ between the velocities of a part.
pub(super) fn differ(part: &Elementary<'_>, quantity: ActuatorQuantity) -> String {
    let (name, word) = (quoted(&part.name), quantity.word());
    format!("joint {name} has another {word} for each velocity, and the format has one for all")
}
