//! `<loop_joint>`: a joint that closes a loop between two links of the tree.
//!
//! URDF itself has no loops. The element is that of Drake's former reader and of Isaac Sim's importer:
//! `<loop_joint name="…" type="spherical"><link1 link="…" xyz="…" rpy="…"/><link2 …/></loop_joint>`, with the frame of
//! the joint on each link. Types with axes have `<axis xyz="…"/>` and `<axis2 …/>` in these frames, a rod has
//! `<rod length="…"/>`.

use roxmltree::Node;

use super::joint::{along_x, direction};
use crate::closure::{ALL, Definition};
use crate::description::xml::element::Reader;
use crate::description::{Loop, Step};
use crate::wording::{known, quoted};

/// Reads a loop; `None` without a name, a type or two links.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Loop> {
    let name = reader.name(node, "name", "a loop joint");
    let subject = match &name {
        Some(name) => format!("loop joint {}", quoted(&name.text)),
        None => "the loop joint without a name".to_owned(),
    };
    let children = Reader::children(node);
    let kind = kind(reader, node, &subject);
    let closure = kind.and_then(|kind| {
        let length = || {
            let hint = "<rod length=\"…\"/>, in metres";
            let rod = reader.required(node, &children, "rod", &subject, hint);
            let what = format!("the length of {subject}");
            let length = rod
                .and_then(|rod| reader.number(rod, "length", &what))
                .ok_or(())?;
            if length.value > 0.0 {
                return Ok(length);
            }
            let message = format!("{what} is not positive: {}", length.value);
            reader.errors.push(length.place, message);
            Err(())
        };
        kind.with_length(length).ok()
    });
    let mut axes = [along_x(reader.place(node)); 2];
    for (k, name) in ["axis", "axis2"].into_iter().enumerate() {
        if let Some(axis) = reader.only(&children, name, &subject) {
            let what = format!("the <{name}> of {subject}");
            axes[k..].fill(direction(reader, axis, &what));
        } else if kind.is_some_and(|kind| k < kind.axes) {
            let message = format!("{subject} has no <{name}>: its axis is x");
            let hint = format!("write <{name} xyz=\"1 0 0\"/>");
            reader.warn(reader.place(node), message, Some(hint));
        }
    }
    let [from, to] = ["link1", "link2"].map(|end| {
        let hint = format!("<{end} link=\"…\" xyz=\"0 0 0\" rpy=\"0 0 0\"/>");
        let element = reader.required(node, &children, end, &subject, &hint)?;
        let what = format!("the <{end}> of {subject}");
        let link = reader.name(element, "link", &what)?;
        let place: Vec<Step> = reader.placement(element, &what);
        Some((link, place))
    });
    let ((from, at), (to, to_at)) = (from?, to?);
    Some(Loop {
        name: name?,
        closure: closure?,
        from,
        to,
        at,
        to_at,
        axes,
    })
}

/// The type of the loop; `None` if it is unknown.
fn kind<'t>(
    reader: &mut Reader<'_, 't>,
    node: Node<'_, 't>,
    subject: &str,
) -> Option<&'static Definition> {
    let word = reader.name(node, "type", subject)?;
    let text = match word.text.as_str() {
        "continuous" => "revolute",
        text => text,
    };
    let kind = Definition::named(text);
    if kind.is_none() {
        let message = format!("{subject} has the unknown type {}", quoted(&word.text));
        let hint = known(text, "types", &ALL.map(|kind| kind.word));
        reader.errors.push_with_hint(word.place, message, hint);
    }
    kind
}
