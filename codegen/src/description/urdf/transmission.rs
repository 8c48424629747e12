//! `<transmission>`: motors and gears.
//!
//! In: one element. Out: a doubt where it says that a gear stands between motor and joint. It never
//! looks at anything else: torques and coordinates are those of joints.

use roxmltree::Node;

use super::element::Reader;
use crate::wording::quoted;

/// Looks for a reduction that is not 1.
pub(super) fn read<'t>(reader: &mut Reader<'_, 't>, node: Node<'_, 't>) {
    let reduction = node.descendants().find(|node| {
        let is_one = |text: &str| text.trim().parse() == Ok(1.0);
        node.tag_name().name() == "mechanicalReduction" && !is_one(node.text().unwrap_or_default())
    });
    if let Some(reduction) = reduction {
        let name = node.attribute_node("name");
        let name = name.map(|name| reader.value(&name));
        let subject = format!("transmission {}", quoted(&name.unwrap_or_default()));
        reader.unmodelled.gear(reader.place(reduction), &subject);
    }
}
