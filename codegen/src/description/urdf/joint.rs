//! `<joint>`: type, axes, links, limits, friction.
//!
//! Friction is kept and noted, because it is modelled only on request. Extensions of URDF: screw joints with
//! `<thread pitch="…"/>` in metres per radian, universal joints with `<axis2 xyz="…"/>`, and the types of
//! `<drake:joint>` (Drake, "Parsing Models for Multibody Dynamics").

use roxmltree::Node;

use super::limit;
use crate::description::kind;
use crate::description::xml::element::Reader;
use crate::description::{Joint, Mimic, Name, Number, axis, number};
use crate::error::Place;
use crate::joint::JointKind;
use crate::joint::actuator::{Actuator, ActuatorQuantity};
use crate::wording::quoted;

/// Reads a joint; `None` without a name, a type or two links.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Joint> {
    let name = reader.name(node, "name", "a joint");
    let subject = match &name {
        Some(name) => format!("joint {}", quoted(&name.text)),
        None => "the joint without a name".to_owned(),
    };
    let children = Reader::children(node);
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
    let axes = if kind.is_some_and(|kind| has_axes_of_drake(node, kind)) {
        axes_of_drake(reader, node, &children, kind, &subject)
    } else {
        [
            axis(reader, node, &children, kind, &subject),
            second_axis(reader, node, &children, kind, &subject),
        ]
    };
    let [axis, second_axis] = axes;
    out_of_place(reader, &children, kind, &subject);
    let limits = limit::read(reader, &children, kind, &subject);
    limit::soft(reader, &children, limits, kind, &subject);
    let mimic = mimic(reader, &children, kind, &subject);
    let actuator = dynamics(reader, &children, kind, &subject);
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
        actuator,
        place: reader.place(node),
    })
}

/// The type of the joint; `None` if it is unknown.
fn kind<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    subject: &str,
) -> Option<JointKind> {
    let name = reader.name(node, "type", subject)?;
    let word = match name.text.as_str() {
        "ball" if is_of_drake(node) => "spherical",
        word => word,
    };
    match kind::read(word, subject) {
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

/// True for Drake's element, which has the types `ball`, `planar` and `universal`.
fn is_of_drake(node: Node<'_, '_>) -> bool {
    node.tag_name().name() == "drake.joint"
}

/// True if the axes are fixed by Drake's type.
fn has_axes_of_drake(node: Node<'_, '_>, kind: JointKind) -> bool {
    is_of_drake(node) && (matches!(kind, JointKind::Planar) || kind.definition().axes() == 2)
}

/// The axes of Drake's types: planar joints have the normal z, universal joints rotate about x and then y.
fn axes_of_drake<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> [[Number; 3]; 2] {
    let place = reader.place(node);
    let along = |entries: [f64; 3]| entries.map(|value| number::computed(value, place));
    if let Some(axis) = reader.only(children, "axis", subject) {
        let word = kind.map_or("", JointKind::word);
        reader.warn(
            reader.place(axis),
            format!("the axis of {subject} is ignored, as in Drake for type {word}"),
            Some(format!(
                "rotate its <origin>, or write <joint type=\"{word}\">"
            )),
        );
    }
    let first = match kind {
        Some(JointKind::Planar) => [0.0, 0.0, 1.0],
        _ => [1.0, 0.0, 0.0],
    };
    [along(first), along([0.0, 1.0, 0.0])]
}

/// Warns of a second axis or a thread that the type does not have.
fn out_of_place<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) {
    let Some(kind) = kind else { return };
    let wanted = [
        ("axis2", kind.definition().axes() == 2, "universal"),
        ("thread", kind.pitch().is_some(), "screw"),
    ];
    for (name, is_wanted, of) in wanted {
        let mut found = children.iter();
        if let Some(found) = found.find(|child| child.tag_name().name() == name && !is_wanted) {
            reader.warn(
                reader.place(*found),
                format!(
                    "<{name}> in {subject} is ignored: its type is {}",
                    kind.word()
                ),
                Some(format!("only type {of} has one")),
            );
        }
    }
}

/// The parent or child link.
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

/// The mimicked joint with multiplier and offset; a fixed joint ignores it, with a warning.
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
    let mimicked = reader.name(node, "joint", &format!("the <mimic> of {subject}"))?;
    let mut number = |name: &str, otherwise: f64| match node.attribute(name) {
        Some(_) => reader.number(
            node,
            name,
            &format!("the {name} of the <mimic> of {subject}"),
        ),
        None => Some(number::computed(otherwise, place)),
    };
    Some(Mimic {
        mimicked,
        multiplier: number("multiplier", 1.0)?,
        offset: number("offset", 0.0)?,
        place,
    })
}

/// Damping and friction; noted for a warning if they are not zero. A malformed number becomes NaN, which is an error
/// only if friction is modelled.
fn dynamics<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> Actuator {
    let mut actuator = Actuator::default();
    let Some(node) = reader.only(children, "dynamics", subject) else {
        return actuator;
    };
    if matches!(kind, Some(JointKind::Fixed)) {
        return actuator;
    }
    let mut words = Vec::new();
    for attribute in node
        .attributes()
        .filter(|attribute| !is_zero(attribute.value()))
    {
        let quantity =
            ActuatorQuantity::from_word(attribute.name()).filter(|quantity| quantity.resists());
        if let Some(quantity) = quantity {
            let place = reader.value_place(&attribute);
            let value = reader.value(&attribute);
            // A joint with several velocities has one number for each.
            let words = value.split_ascii_whitespace();
            let number = |word| number::read(word, place);
            let number = |word| number(word).unwrap_or_else(|_| number::computed(f64::NAN, place));
            actuator.say(quantity, words.map(number).collect());
        }
        words.extend(quantity.map(ActuatorQuantity::word));
    }
    if !words.is_empty() {
        let place = reader.place(node);
        reader.unmodelled.friction(place, subject, words);
    }
    actuator
}

/// The axis; x if the file has none, as URDF defines.
fn axis<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> [Number; 3] {
    let element = reader.only(children, "axis", subject);
    // Joints without an axis often have one of zeros in files.
    if kind.is_none_or(|kind| kind.definition().axes() == 0) {
        return along_x(reader.place(node));
    }
    let Some(element) = element else {
        let place = reader.place(node);
        warn_of_normal(reader, place, kind, [1.0, 0.0, 0.0], subject);
        reader.warn(
            place,
            format!("{subject} has no <axis>: its axis is x, as URDF defines"),
            Some("write <axis xyz=\"1 0 0\"/>".to_owned()),
        );
        return along_x(place);
    };
    let direction = direction(reader, element, &format!("the axis of {subject}"));
    let entries = direction.map(|entry| entry.value);
    warn_of_normal(reader, reader.place(element), kind, entries, subject);
    direction
}

/// Warns of a planar joint whose normal is not z, because other readers ignore the axis.
fn warn_of_normal(
    reader: &mut Reader<'_, '_>,
    place: Place,
    kind: Option<JointKind>,
    [x, y, z]: [f64; 3],
    subject: &str,
) {
    let is_z = x.abs().max(y.abs()) < 4.0 * f64::EPSILON && z > 0.0;
    if !matches!(kind, Some(JointKind::Planar)) || is_z {
        return;
    }
    reader.warn(
        place,
        format!("{subject} is planar with a normal other than z: Pinocchio and MoveIt use z"),
        Some("rotate its <origin> instead of its axis, to agree with other readers".to_owned()),
    );
}

/// The second axis, of a joint that has two.
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

/// The direction in an element; x if it has none, which is an error.
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
        Ok((axis, warning)) => {
            if let Some(warning) = warning {
                reader.warn(
                    place,
                    format!("{subject} {}", warning.what),
                    Some(warning.hint),
                );
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

/// True if a value consists of zeros in any notation.
fn is_zero(value: &str) -> bool {
    let mut numbers = value.split_ascii_whitespace();
    numbers.all(|number| number.parse() == Ok(0.0))
}
