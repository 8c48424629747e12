//! `<link>`: name, mass, centre of mass, inertia tensor.
//!
//! A link without `<inertial>` is valid here; its meaning depends on the rest of the robot.

use roxmltree::Node;

use crate::description::xml::element::Reader;
use crate::description::{Inertial, Link, Name, Number};
use crate::wording::quoted;

/// Reads a link; `None` without a name.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) -> Option<Link> {
    let name = reader.name(node, "name", "a link");
    let subject = subject(name.as_ref());
    let children = Reader::children(node);
    let inertial = reader
        .only(&children, "inertial", &subject)
        .and_then(|node| inertial(reader, node, &subject));
    name.map(|name| Link { name, inertial })
}

fn subject(name: Option<&Name>) -> String {
    match name {
        Some(name) => format!("link {}", quoted(&name.text)),
        None => "the link without a name".to_owned(),
    }
}

fn inertial<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>, link: &str) -> Option<Inertial> {
    let subject = format!("the inertial of {link}");
    let children = Reader::children(node);
    let origin = reader.only(&children, "origin", &subject);
    let origin = reader.origin(origin, &subject);
    let mass = reader
        .required(node, &children, "mass", &subject, "<mass value=\"…\"/>")
        .and_then(|mass| reader.number(mass, "value", &format!("the mass of {link}")));
    if let Some(mass) = mass
        && mass.value < 0.0
    {
        reader.errors.push(
            mass.place,
            format!("the mass of {link} is negative: {}", mass.value),
        );
    }
    let hint = "<inertia ixx=\"…\" ixy=\"…\" ixz=\"…\" iyy=\"…\" iyz=\"…\" izz=\"…\"/>";
    let inertia = reader
        .required(node, &children, "inertia", &subject, hint)
        .and_then(|node| tensor(reader, node, link));
    Some(Inertial {
        origin,
        mass: mass?,
        inertia: inertia?,
        place: reader.place(node),
    })
}

/// The six entries of the tensor; each missing or malformed one is an error.
fn tensor<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>, link: &str) -> Option<[Number; 6]> {
    let entries = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"]
        .map(|entry| reader.number(node, entry, &format!("{entry} of {link}")));
    let mut tensor = [Number::default(); 6];
    for (number, entry) in tensor.iter_mut().zip(entries) {
        *number = entry?;
    }
    Some(tensor)
}
