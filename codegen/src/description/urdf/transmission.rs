//! `<transmission>`: motors and gears.
//!
//! In: one element. Out: of each motor that drives a joint with no other in its transmission, the inertia of its
//! rotor and its ratio; a doubt where a gear stands between motor and joint, or a rotor behind it. The ratio is
//! `<mechanicalReduction>`, an element or an attribute, or Drake's `<drake:gear_ratio value="…"/>`, which goes with
//! its `<drake:rotor_inertia value="…"/>` (Drake, "Parsing Models for Multibody Dynamics"); URDF itself has no word
//! for a rotor. It never looks at anything else: torques and coordinates are those of joints.

use std::collections::HashMap;

use roxmltree::Node;

use crate::description::xml::element::Reader;
use crate::description::{Joint, Number, number};
use crate::joint::drive::Motor;
use crate::wording::quoted;

/// The motors of a transmission and the joint that they drive.
pub(super) struct Geared {
    joint: String,
    motors: Vec<Motor>,
}

/// What a reduction is called, as an element and as an attribute.
const REDUCTIONS: [&str; 2] = ["mechanicalReduction", "mechanical_reduction"];

/// What those of a linkage are called, attributes all.
const OF_LINKAGES: [&str; 2] = ["gear_ratio", "screw_reduction"];

/// Reads what stands between motors and their joint.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Geared> {
    let name = node.attribute_node("name");
    let name = name.map(|name| reader.value(&name));
    let subject = format!("transmission {}", quoted(&name.unwrap_or_default()));
    let joints = all(node, "joint");
    let actuators = all(node, "actuator");
    let driven = match &*joints {
        [joint] => joint.attribute_node("name"),
        _ => None,
    };
    let driven = driven.map(|joint| reader.value(&joint).into_owned());
    let reductions = reductions(reader, node);
    let is_one = |text: &str| text.trim().parse() == Ok(1.0);
    let gear = reductions.iter().find(|gear| !is_one(&gear.text));
    if let Some(gear) = gear.map(|gear| gear.at).or_else(|| linkage(node)) {
        let place = reader.positions.place(gear);
        reader.unmodelled.gear(place, &subject, driven.clone());
    }
    let rotors = all(node, "rotor_inertia");
    // What no joint gets is not modelled, whatever is asked for.
    let motors: Vec<Node<'_, 't>> = match &*actuators {
        [_] => vec![node],
        several => several.to_vec(),
    };
    let mounted = driven.is_some() && !motors.is_empty();
    for rotor in rotors.iter().take(1) {
        let joint = driven.clone().filter(|_| mounted);
        reader
            .unmodelled
            .rotor(reader.place(*rotor), &subject, joint);
    }
    let motor = |motor: &Node<'_, 't>| {
        let mut own = reductions.iter().filter(|gear| within(*motor, gear.at));
        // A reduction may stand beside the joint, and again beside the motor.
        let reduction = own.next().or_else(|| {
            let mut outside = reductions.iter();
            outside.find(|gear| !actuators.iter().any(|motor| within(*motor, gear.at)))
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
    Some(Geared {
        joint: driven?,
        motors: motors.iter().map(motor).collect(),
    })
}

/// A number; what is none is one that is not finite, to be refused where it is asked for.
fn read_number(reader: &Reader<'_, '_>, text: &str, at: usize) -> Number {
    let place = reader.positions.place(at);
    let number = number::read(text.trim(), place);
    number.unwrap_or_else(|_| number::computed(f64::NAN, place))
}

/// A reduction as it is written.
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

/// Where the ratio of a linkage is told.
fn linkage(node: Node<'_, '_>) -> Option<usize> {
    let mut attributes = node.descendants().flat_map(|inner| inner.attributes());
    let found = attributes.find(|attribute| OF_LINKAGES.contains(&attribute.name()));
    found.map(|attribute| attribute.range().start)
}

/// Whether something that begins there stands in an element.
fn within(node: Node<'_, '_>, at: usize) -> bool {
    node.range().contains(&at)
}

fn all<'a, 't>(node: Node<'a, 't>, name: &str) -> Vec<Node<'a, 't>> {
    let found = node.descendants().skip(1).filter(|node| called(node, name));
    found.collect()
}

/// Whether an element has a name, behind Drake's prefix where that belongs.
fn called(node: &Node<'_, '_>, name: &str) -> bool {
    let tag = node.tag_name().name();
    tag.strip_prefix(PREFIX).unwrap_or(tag) == name
}

/// What `drake:` is read as.
const PREFIX: &str = "drake.";

/// Gives joints the motors that were read for them.
pub(super) fn mount(reader: &mut Reader<'_, '_>, geared: Vec<Geared>, joints: &mut [Joint]) {
    let places: HashMap<String, usize> = (joints.iter().enumerate().rev())
        .map(|(place, joint)| (joint.name.text.clone(), place))
        .collect();
    for Geared { joint, motors } in geared {
        match places.get(&joint) {
            Some(&place) => {
                for motor in motors {
                    joints[place].drive.mount(motor);
                }
            }
            None => reader.unmodelled.dismount(&joint),
        }
    }
}
