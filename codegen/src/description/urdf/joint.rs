//! `<joint>`: what moves, about or along which axis, from which link to which.
//!
//! In: one element. Out: a [`Joint`], as far as it could be read, and complaints. Friction is kept
//! and noted, for it is modelled where it is asked for; what tells a controller (soft limits, calibration)
//! is passed over. URDF itself
//! knows no screw joints, which have `<thread pitch="…"/>` in metres per radian, and no universal ones,
//! which have `<axis2 xyz="…"/>`.

use roxmltree::Node;

use super::element::Reader;
use crate::description::kind;
use crate::description::{Joint, Limits, Mimic, Name, Number, axis, number};
use crate::error::Place;
use crate::joint::JointKind;
use crate::joint::drive::{Part, Parts};
use crate::wording::quoted;

/// What a joint may hold, mechanics or not.
const PARTS: [&str; 11] = [
    "origin",
    "parent",
    "child",
    "axis",
    "axis2",
    "limit",
    "thread",
    "mimic",
    "dynamics",
    "calibration",
    "safety_controller",
];

/// Reads a joint; none where it has no name or hangs nowhere.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Joint> {
    let name = reader.name(node, "name", "a joint");
    let subject = match &name {
        Some(name) => format!("joint {}", quoted(&name.text)),
        None => "the joint without a name".to_owned(),
    };
    let children = reader.children(node, &subject, &PARTS);
    let kind = kind(reader, node, &children, &subject);
    let parent = end(reader, node, &children, "parent", &subject);
    let child = end(reader, node, &children, "child", &subject);
    if let (Some(parent), Some(child)) = (&parent, &child)
        && parent.text == child.text
    {
        reader.errors.push(
            child.place,
            format!("{subject} joins link {} to itself", quoted(&child.text)),
        );
    }
    let origin = reader.only(&children, "origin", &subject);
    let origin = reader.origin(origin, &subject);
    let axis = axis(reader, node, &children, kind, &subject);
    let second_axis = second_axis(reader, node, &children, kind, &subject);
    let limits = limits(reader, &children, kind, &subject);
    let mimic = mimic(reader, &children, kind, &subject);
    let drive = dynamics(reader, &children, kind, &subject);
    Some(Joint {
        name: name?,
        kind: kind.unwrap_or(JointKind::Fixed),
        parent: parent?,
        child: child?,
        origin,
        axis,
        second_axis,
        limits,
        mimic,
        drive,
        place: reader.place(node),
    })
}

/// What the joint allows; none where that was refused.
fn kind<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    subject: &str,
) -> Option<JointKind> {
    let name = reader.name(node, "type", subject)?;
    match kind::read(&name.text, subject) {
        Ok(kind) => kind
            .with_pitch(|| {
                let hint = "<thread pitch=\"…\"/>, in metres per radian";
                let thread = reader.required(node, children, "thread", subject, hint);
                thread
                    .and_then(|node| {
                        reader.number(node, "pitch", &format!("the pitch of {subject}"))
                    })
                    .ok_or(())
            })
            .ok(),
        Err((message, hint)) => {
            reader.errors.push_with_hint(name.place, message, hint);
            None
        }
    }
}

/// The link at one end.
fn end<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    end: &str,
    subject: &str,
) -> Option<Name> {
    let hint = format!("<{end} link=\"…\"/>");
    let element = reader.required(node, children, end, subject, &hint)?;
    reader.name(element, "link", &format!("the {end} of {subject}"))
}

/// The joint that moves this one, if one does; a joint that does not move mimics nothing.
fn mimic<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> Option<Mimic> {
    let node = reader.only(children, "mimic", subject)?;
    let place = reader.place(node);
    let kind = kind?;
    if !kind.moves() {
        let message = format!("{subject} is fixed, and its <mimic> is ignored");
        reader.warn(place, message, None);
        return None;
    }
    let leader = reader.name(node, "joint", &format!("the <mimic> of {subject}"))?;
    let mut number = |name: &str, otherwise: f64| match node.attribute(name) {
        Some(_) => reader.number(
            node,
            name,
            &format!("the {name} of the <mimic> of {subject}"),
        ),
        None => Some(number::computed(otherwise, place)),
    };
    Some(Mimic {
        leader,
        multiplier: number("multiplier", 1.0)?,
        offset: number("offset", 0.0)?,
        place,
    })
}

/// Friction and damping; takes note of them and of whatever else `<dynamics>` says, if it is not zero. What
/// is not a number is one that is not finite, to be refused where it is asked for.
fn dynamics<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> Parts {
    let mut drive = Parts::default();
    let Some(node) = reader.only(children, "dynamics", subject) else {
        return drive;
    };
    if matches!(kind, Some(JointKind::Fixed)) {
        return drive;
    }
    let mut words = Vec::new();
    for attribute in node.attributes().filter(|said| !is_zero(said.value())) {
        let part = Part::from_word(attribute.name()).filter(|part| part.resists());
        if let Some(part) = part {
            let place = reader.value_place(&attribute);
            let number = number::read(reader.value(&attribute).trim(), place);
            let number = number.unwrap_or_else(|_| number::computed(f64::NAN, place));
            drive.say(part, vec![number]);
        }
        words.push(part.map_or("other dynamics", Part::word));
    }
    if !words.is_empty() {
        let place = reader.place(node);
        reader.unmodelled.friction(place, subject, words);
    }
    drive
}

/// The axis with length 1; along x where the text gives none, as URDF has it.
fn axis<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> [Number; 3] {
    let element = reader.only(children, "axis", subject);
    // The axis of a joint that needs none means nothing, and is often written as zero.
    if kind.is_none_or(|kind| kind.definition().axes() == 0) {
        return along_x(reader.place(node));
    }
    let Some(element) = element else {
        let place = reader.place(node);
        reader.warn(
            place,
            format!("{subject} has no <axis>: it moves about or along x, as URDF has it"),
            Some("write <axis xyz=\"1 0 0\"/>".to_owned()),
        );
        return along_x(place);
    };
    direction(reader, element, &format!("the axis of {subject}"))
}

/// The second axis with length 1, of a joint that has two.
fn second_axis<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> [Number; 3] {
    if kind.is_none_or(|kind| kind.definition().axes() < 2) {
        return along_x(reader.place(node));
    }
    let hint = "<axis2 xyz=\"0 1 0\"/>, in the frame of its child";
    match reader.required(node, children, "axis2", subject, hint) {
        Some(element) => direction(reader, element, &format!("the second axis of {subject}")),
        None => along_x(reader.place(node)),
    }
}

pub(super) fn along_x(place: Place) -> [Number; 3] {
    [1.0, 0.0, 0.0].map(|value| number::computed(value, place))
}

/// What an element says of a direction; along x where that is nothing.
pub(super) fn direction<'t>(
    reader: &mut Reader<'_, 't>,
    element: Node<'_, 't>,
    subject: &str,
) -> [Number; 3] {
    let place = reader.place(element);
    let Some(xyz) = element.attribute_node("xyz") else {
        reader.errors.push_with_hint(
            place,
            format!("{subject} has no attribute \"xyz\""),
            "write <axis xyz=\"0 0 1\"/>",
        );
        return along_x(place);
    };
    let Some(numbers) = reader.numbers(&xyz, subject) else {
        return along_x(place);
    };
    let place = reader.value_place(&xyz);
    match axis::direction(numbers) {
        Ok((axis, doubt)) => {
            if let Some(doubt) = doubt {
                reader.warn(place, format!("{subject} {}", doubt.what), Some(doubt.hint));
            }
            axis
        }
        Err(refusal) => {
            let message = format!("{subject} {}", refusal.what);
            reader.errors.push_with_hint(place, message, refusal.hint);
            along_x(place)
        }
    }
}

/// The limits, where there are any. Those of the angle mean nothing for a continuous joint, and
/// nothing for any other where the lower one is above the upper one, by which simulators say that
/// there are none.
fn limits<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> Option<Limits> {
    let node = reader.only(children, "limit", subject)?;
    let mut bound = |name: &str, otherwise: f64| {
        let Some(attribute) = node.attribute_node(name) else {
            return otherwise;
        };
        number::read_bound(reader.value(&attribute).trim()).unwrap_or_else(|refusal| {
            let place = reader.value_place(&attribute);
            reader.refuse(place, &format!("the {name} limit of {subject}"), &refusal);
            otherwise
        })
    };
    let velocity = bound("velocity", f64::INFINITY);
    // Nothing is computed of it: what is no number, or zero, says nothing.
    let effort = node.attribute("effort").map(|text| text.trim().parse());
    let effort = effort.and_then(Result::ok).filter(|most| *most > 0.0);
    let effort = effort.unwrap_or(f64::INFINITY);
    let unlimited = Limits {
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
        velocity,
        effort,
    };
    match kind {
        None | Some(JointKind::Fixed) => return Some(unlimited),
        Some(JointKind::Continuous) => {
            let says = |bound: &f64| bound.is_finite() && *bound != 0.0;
            let ends = [bound("lower", 0.0), bound("upper", 0.0)];
            if ends.iter().any(says) {
                reader.unmodelled.limits(reader.place(node), subject);
            }
            return Some(unlimited);
        }
        Some(_) => {}
    }
    // A limit that is not written is zero, says URDF.
    let (lower, upper) = (bound("lower", 0.0), bound("upper", 0.0));
    if lower > upper {
        reader.warn(
            reader.place(node),
            format!(
                "the lower limit of {subject}, {lower}, is above the upper one, {upper}: taken as \
                 without limits"
            ),
            Some("swap them, if they are meant".to_owned()),
        );
        return Some(unlimited);
    }
    Some(Limits {
        lower,
        upper,
        velocity,
        effort,
    })
}

/// Whether a value is the number zero, however it is written.
fn is_zero(value: &str) -> bool {
    value.trim().parse() == Ok(0.0)
}
