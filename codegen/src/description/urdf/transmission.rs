//! `<transmission>`: motors and gears.
//!
//! In: one element. Out: the inertia of a rotor and its ratio, for the joint that one motor drives alone; a
//! doubt where it says that a gear stands between motor and joint, or a rotor behind it. The ratio is
//! `<mechanicalReduction>`, or Drake's `<drake:gear_ratio value="…"/>`, which goes with its
//! `<drake:rotor_inertia value="…"/>` (Drake, "Parsing files to populate a MultibodyPlant"); URDF itself
//! has no word for a rotor. It never looks at anything else: torques and coordinates are those of joints.

use roxmltree::Node;

use super::element::Reader;
use crate::description::{Joint, Number, number};
use crate::joint::drive::Part;
use crate::wording::quoted;

/// A motor and the joint that it drives.
pub(super) struct Geared {
    joint: String,
    parts: Vec<(Part, Number)>,
}

/// Reads what stands between a motor and its joint.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Geared> {
    let all = |name: &str| {
        let found = |node: &Node<'_, 't>| called(node, name);
        node.descendants().filter(found).collect::<Vec<_>>()
    };
    let name = node.attribute_node("name");
    let name = name.map(|name| reader.value(&name));
    let subject = format!("transmission {}", quoted(&name.unwrap_or_default()));
    let driven = match (&*all("joint"), &*all("actuator")) {
        ([joint], [_]) => joint.attribute_node("name"),
        _ => None,
    };
    let driven = driven.map(|joint| reader.value(&joint).into_owned());
    let is_one = |text: &str| text.trim().parse() == Ok(1.0);
    let reductions = all("mechanicalReduction");
    let gear = reductions.iter();
    let mut gear = gear.filter(|gear| !is_one(gear.text().unwrap_or_default()));
    if let Some(gear) = gear.next() {
        let place = reader.place(*gear);
        reader.unmodelled.gear(place, &subject, driven.clone());
    }
    let rotors = all("rotor_inertia");
    if let Some(rotor) = rotors.first() {
        let place = reader.place(*rotor);
        reader.unmodelled.rotor(place, &subject);
    }
    let mut parts = Vec::new();
    let mut say = |part: Part, node: Option<&Node<'_, 't>>, text: &str| {
        if let Some(node) = node {
            let place = reader.place(*node);
            let number = number::read(text.trim(), place);
            let number = number.unwrap_or_else(|_| number::computed(f64::NAN, place));
            parts.push((part, number));
        }
    };
    let value = |node: &Node<'_, 't>| node.attribute("value").unwrap_or_default().to_owned();
    // A reduction may stand beside the joint and again beside the motor.
    let reduction = reductions.first();
    let text = reduction.and_then(Node::text).unwrap_or_default();
    say(Part::Ratio, reduction, text);
    let ratios = all("gear_ratio");
    say(
        Part::Ratio,
        ratios.first(),
        &ratios.first().map(value).unwrap_or_default(),
    );
    say(
        Part::Rotor,
        rotors.first(),
        &rotors.first().map(value).unwrap_or_default(),
    );
    Some(Geared {
        joint: driven?,
        parts,
    })
}

/// Whether an element has a name, behind Drake's prefix where that belongs.
fn called(node: &Node<'_, '_>, name: &str) -> bool {
    let tag = node.tag_name().name();
    tag.strip_prefix(PREFIX).unwrap_or(tag) == name
}

/// What `drake:` is read as.
const PREFIX: &str = "drake.";

/// Gives joints what was read for them.
pub(super) fn mount(geared: Vec<Geared>, joints: &mut [Joint]) {
    for Geared { joint, parts } in geared {
        let driven = joints.iter_mut().find(|known| known.name.text == joint);
        if let Some(driven) = driven {
            for (part, number) in parts {
                driven.drive.say(part, vec![number]);
            }
        }
    }
}
