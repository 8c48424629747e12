//! `<collision>`: shapes for collision checks, of which spheres are read.
//!
//! Few requests use them, and other readers of URDF never look at them. So a mistake in one is kept with it, and is an
//! error only if spheres are requested.

use roxmltree::Node;

use crate::description::xml::element::Reader;
use crate::description::{Collision, LinkId, Name, Number, Sphere};
use crate::wording::quoted;

/// Reads the shapes of a link.
pub(super) fn read<'t>(
    reader: &Reader<'_, 't>,
    node: Node<'_, 't>,
    (link, name): (LinkId, &Name),
) -> Vec<Collision> {
    let children = Reader::children(node).into_iter();
    let shapes = children.filter(|child| child.tag_name().name() == "collision");
    shapes
        .map(|node| {
            let mut own = Reader::new(reader.positions);
            let sphere = sphere(&mut own, node, name);
            Collision {
                link,
                sphere,
                errors: own.errors,
                place: reader.place(node),
            }
        })
        .collect()
}

fn sphere<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>, link: &Name) -> Option<Sphere> {
    let subject = format!("a collision of link {}", quoted(&link.text));
    let children = Reader::children(node);
    let geometry = reader.only(&children, "geometry", &subject)?;
    let shapes = Reader::children(geometry);
    let sphere = reader.only(&shapes, "sphere", &subject)?;
    let origin = reader.only(&children, "origin", &subject);
    let origin = reader.origin(origin, &subject);
    let radius: Number = reader.number(sphere, "radius", &format!("the radius of {subject}"))?;
    if radius.value <= 0.0 {
        let message = format!("the radius of {subject} is not positive: {}", radius.value);
        reader.errors.push(radius.place, message);
    }
    Some(Sphere { origin, radius })
}
