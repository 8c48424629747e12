//! `<joint>`: what moves, about or along which axis, from which link to which.
//!
//! In: one element. Out: a [`Joint`], as far as it could be read, and complaints. The joints that
//! are not modelled are refused by name, friction is passed over with a doubt, and what tells a
//! controller (soft limits, calibration) without one; a screw joint has `<thread pitch="…"/>` in metres per
//! radian, since URDF itself knows none.

use roxmltree::Node;

use super::element::Reader;
use crate::description::kind;
use crate::description::{Joint, Limits, Name, Number, axis, number};
use crate::joint::JointKind;
use crate::wording::quoted;

/// What a joint may hold, mechanics or not.
const PARTS: [&str; 10] = [
    "origin",
    "parent",
    "child",
    "axis",
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
    let limits = limits(reader, &children, kind, &subject);
    mimic(reader, &children, kind, &subject);
    friction(reader, &children, kind, &subject);
    Some(Joint {
        name: name?,
        kind: kind.unwrap_or(JointKind::Fixed),
        parent: parent?,
        child: child?,
        origin,
        axis,
        limits,
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

/// A joint that moves with another is refused; one that does not move mimics nothing.
fn mimic<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) {
    let Some(mimic) = reader.only(children, "mimic", subject) else {
        return;
    };
    let place = reader.place(mimic);
    if matches!(kind, Some(JointKind::Fixed)) {
        let message = format!("{subject} is fixed, and its <mimic> is ignored");
        reader.warn(place, message, None);
        return;
    }
    let other = mimic.attribute_node("joint");
    let other = other.map(|other| reader.value(&other)).unwrap_or_default();
    reader.errors.push_with_hint(
        place,
        format!(
            "{subject} mimics joint {}, and mimic joints are not modelled",
            quoted(&other)
        ),
        "make it fixed, or remove <mimic> to give it a coordinate of its own",
    );
}

/// Takes note of friction, damping and whatever else `<dynamics>` says, if it is not zero.
fn friction<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) {
    let Some(node) = reader.only(children, "dynamics", subject) else {
        return;
    };
    if matches!(kind, Some(JointKind::Fixed)) {
        return;
    }
    let words: Vec<&str> = node
        .attributes()
        .filter(|attribute| !is_zero(attribute.value()))
        .map(|attribute| match attribute.name() {
            "damping" => "damping",
            "friction" => "friction",
            _ => "other dynamics",
        })
        .collect();
    if !words.is_empty() {
        reader
            .unmodelled
            .friction(reader.place(node), subject, &words);
    }
}

/// The axis with length 1; along x where the text gives none, as URDF has it.
fn axis<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> [Number; 3] {
    let along_x = |place| [1.0, 0.0, 0.0].map(|value| number::computed(value, place));
    let element = reader.only(children, "axis", subject);
    // The axis of a fixed joint means nothing, and is often written as zero.
    if !kind.is_some_and(JointKind::moves) {
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
    let subject = format!("the axis of {subject}");
    let place = reader.place(element);
    let Some(xyz) = element.attribute_node("xyz") else {
        reader.errors.push_with_hint(
            place,
            format!("{subject} has no attribute \"xyz\""),
            "write <axis xyz=\"0 0 1\"/>",
        );
        return along_x(place);
    };
    let Some(numbers) = reader.numbers(&xyz, &subject) else {
        return along_x(place);
    };
    let place = reader.value_place(&xyz);
    match axis::unit(numbers) {
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
    let unlimited = Limits {
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
        velocity,
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
    })
}

/// Whether a value is the number zero, however it is written.
fn is_zero(value: &str) -> bool {
    value.trim().parse() == Ok(0.0)
}
