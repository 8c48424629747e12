//! `<transmission>`: rotors and gear ratios.
//!
//! Reads the rotor inertia and the ratio of each motor in a transmission with a single joint. Other rotors, and ratios
//! without a rotor, are noted for a warning. The ratio is `<mechanicalReduction>`, an element or an attribute, or
//! Drake's `<drake:gear_ratio value="…"/>` beside its `<drake:rotor_inertia value="…"/>` (Drake, "Parsing Models for
//! Multibody Dynamics"); URDF itself has no element for a rotor. Torques and coordinates are those of joints, so
//! nothing else is read.

use std::collections::HashMap;

use roxmltree::Node;

use crate::description::xml::element::Reader;
use crate::description::{Joint, Number, number};
use crate::joint::actuator::Motor;
use crate::wording::quoted;

/// The motors of a transmission, and their joint.
pub(super) struct Transmission {
    joint: String,
    motors: Vec<Motor>,
}

/// The names of a reduction, as an element and as an attribute.
const REDUCTIONS: [&str; 2] = ["mechanicalReduction", "mechanical_reduction"];

/// The names of ratios of linkages, which are attributes.
const OF_LINKAGES: [&str; 2] = ["gear_ratio", "screw_reduction"];

/// Reads the motors between actuators and their joint.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Transmission> {
    let name = node.attribute_node("name");
    let name = name.map(|name| reader.value(&name));
    let subject = format!("transmission {}", quoted(&name.unwrap_or_default()));
    let joints = all(node, "joint");
    let actuators = all(node, "actuator");
    let joint_name = match &*joints {
        [joint] => joint.attribute_node("name"),
        _ => None,
    };
    let joint_name = joint_name.map(|joint| reader.value(&joint).into_owned());
    let reductions = reductions(reader, node);
    let is_one = |text: &str| text.trim().parse() == Ok(1.0);
    let gear = reductions.iter().find(|gear| !is_one(&gear.text));
    if let Some(gear) = gear.map(|gear| gear.at).or_else(|| linkage(node)) {
        let place = reader.positions.place(gear);
        reader.unmodelled.gear(place, &subject, joint_name.clone());
    }
    let rotors = all(node, "rotor_inertia");
    // A rotor without a single joint cannot be modelled.
    let motors: Vec<Node<'_, 't>> = match &*actuators {
        [_] => vec![node],
        several => several.to_vec(),
    };
    let mounted = joint_name.is_some() && !motors.is_empty();
    for rotor in rotors.iter().take(1) {
        let joint = joint_name.clone().filter(|_| mounted);
        reader
            .unmodelled
            .rotor(reader.place(*rotor), &subject, joint);
    }
    let motor = |motor: &Node<'_, 't>| {
        let mut own = reductions.iter().filter(|gear| within(*motor, gear.at));
        // A reduction may stand in the joint, or again in the motor.
        let reduction = own.next().or_else(|| {
            let mut beside = reductions.iter();
            beside.find(|gear| !actuators.iter().any(|motor| within(*motor, gear.at)))
        });
        let reduction = reduction.map(|gear| read_number(reader, &gear.text, gear.at));
        let value = |name: &str| {
            let found = all(*motor, name).into_iter().next()?;
            let value = found.attribute("value").unwrap_or_default();
            Some(read_number(reader, value, found.range().start))
        };
        Motor {
            rotor: value("rotor_inertia"),
            ratio: value("gear_ratio").or(reduction),
        }
    };
    Some(Transmission {
        joint: joint_name?,
        motors: motors.iter().map(motor).collect(),
    })
}

/// A number; NaN if it is malformed, which is an error only if the rotor is modelled.
fn read_number(reader: &Reader<'_, '_>, text: &str, at: usize) -> Number {
    let place = reader.positions.place(at);
    let number = number::read(text.trim(), place);
    number.unwrap_or_else(|_| number::computed(f64::NAN, place))
}

/// A reduction in the text, with its offset.
struct Reduction {
    at: usize,
    text: String,
}

/// All reductions, in the order of the text.
fn reductions<'t>(reader: &Reader<'_, 't>, node: Node<'_, 't>) -> Vec<Reduction> {
    let mut found = Vec::new();
    for inner in node.descendants().filter(Node::is_element) {
        for attribute in inner.attributes() {
            if REDUCTIONS.contains(&attribute.name()) {
                found.push(Reduction {
                    at: attribute.range().start,
                    text: reader.value(&attribute).into_owned(),
                });
            }
        }
        if REDUCTIONS.iter().any(|name| called(&inner, name)) {
            found.push(Reduction {
                at: inner.range().start,
                text: inner.text().unwrap_or_default().to_owned(),
            });
        }
    }
    found
}

/// The offset of a linkage's ratio.
fn linkage(node: Node<'_, '_>) -> Option<usize> {
    let mut attributes = node.descendants().flat_map(|inner| inner.attributes());
    let found = attributes.find(|attribute| OF_LINKAGES.contains(&attribute.name()));
    found.map(|attribute| attribute.range().start)
}

/// True if an offset lies in an element.
fn within(node: Node<'_, '_>, at: usize) -> bool {
    node.range().contains(&at)
}

fn all<'a, 't>(node: Node<'a, 't>, name: &str) -> Vec<Node<'a, 't>> {
    let found = node.descendants().skip(1).filter(|node| called(node, name));
    found.collect()
}

/// True if an element has a name, with or without Drake's prefix.
fn called(node: &Node<'_, '_>, name: &str) -> bool {
    let tag = node.tag_name().name();
    tag.strip_prefix(PREFIX).unwrap_or(tag) == name
}

/// Drake's prefix after [`plain`](super::super::xml::plain) has replaced the colon.
const PREFIX: &str = "drake.";

/// Adds the motors of transmissions to their joints.
pub(super) fn mount(
    reader: &mut Reader<'_, '_>,
    transmissions: Vec<Transmission>,
    joints: &mut [Joint],
) {
    let places: HashMap<String, usize> = (joints.iter().enumerate().rev())
        .map(|(place, joint)| (joint.name.text.clone(), place))
        .collect();
    for Transmission { joint, motors } in transmissions {
        match places.get(&joint) {
            Some(&place) => {
                for motor in motors {
                    joints[place].actuator.mount(motor);
                }
            }
            None => reader.unmodelled.dismount(&joint),
        }
    }
}
