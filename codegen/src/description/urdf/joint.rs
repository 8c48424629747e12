//! `<joint>`: what moves, about or along which axis, from which link to which.
//!
//! In: one element. Out: a [`Joint`], as far as it could be read, and complaints. Friction is kept
//! and noted, for it is modelled where it is asked for. URDF itself knows no screw joints, which have
//! `<thread pitch="…"/>` in metres per radian, and no universal ones, which have `<axis2 xyz="…"/>`; `<drake:joint>`
//! has types of its own (Drake, "Parsing Models for Multibody Dynamics").

use roxmltree::Node;

use super::limit;
use crate::description::kind;
use crate::description::xml::element::Reader;
use crate::description::{Joint, Mimic, Name, Number, axis, number};
use crate::error::Place;
use crate::joint::JointKind;
use crate::joint::drive::{Part, Parts};
use crate::wording::quoted;

/// Reads a joint; none where it has no name or hangs nowhere.
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

/// Whether it is Drake's element, whose types are `ball`, `planar` and `universal`.
fn is_of_drake(node: Node<'_, '_>) -> bool {
    node.tag_name().name() == "drake.joint"
}

/// Whether its axes are those of the frame, and nothing that is written.
fn has_axes_of_drake(node: Node<'_, '_>, kind: JointKind) -> bool {
    is_of_drake(node) && (matches!(kind, JointKind::Planar) || kind.definition().axes() == 2)
}

/// Planar joints of Drake move across z, universal ones turn about x and then y.
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
            format!("the axis of {subject} is ignored, as Drake ignores that of type {word}"),
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

/// Warns of a second axis or a thread where the type has none.
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
                Some(format!("the type that has one is {of}")),
            );
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

/// Friction and damping; takes note of them, if they are not zero. What
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
            let value = reader.value(&attribute);
            // Of a joint with several velocities one number for each.
            let words = value.split_ascii_whitespace();
            let number = |word| number::read(word, place);
            let number = |word| number(word).unwrap_or_else(|_| number::computed(f64::NAN, place));
            drive.say(part, words.map(number).collect());
        }
        words.extend(part.map(Part::word));
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
        about_pinocchio(reader, place, kind, [1.0, 0.0, 0.0], subject);
        reader.warn(
            place,
            format!("{subject} has no <axis>: it moves about or along x, as URDF has it"),
            Some("write <axis xyz=\"1 0 0\"/>".to_owned()),
        );
        return along_x(place);
    };
    let direction = direction(reader, element, &format!("the axis of {subject}"));
    let entries = direction.map(|entry| entry.value);
    about_pinocchio(reader, reader.place(element), kind, entries, subject);
    direction
}

/// Warns of a planar joint whose axis is not z, for which readers differ.
fn about_pinocchio(
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
        format!("{subject} is planar about another axis than z: Pinocchio and MoveIt move it across z all the same"),
        Some("rotate its <origin> instead of its axis, where other readers must agree".to_owned()),
    );
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

/// Whether a value is nothing but zeros, however they are written.
fn is_zero(value: &str) -> bool {
    let mut numbers = value.split_ascii_whitespace();
    numbers.all(|number| number.parse() == Ok(0.0))
}
