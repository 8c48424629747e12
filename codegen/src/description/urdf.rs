//! Reads URDF, the Unified Robot Description Format, into a [`Description`].
//!
//! Each mistake is an error with line and column. Elements without mechanics (visuals, settings of simulators) are
//! ignored. Mechanics that are modelled only on request (friction, rotors) are kept, and noted for a warning. Time and
//! memory are proportional to the text, and no missing number is guessed.

mod closure;
mod collision;
mod elements;
mod joint;
mod limit;
mod link;
mod placement;
mod transmission;

use std::collections::HashSet;

use proc_macro2::Span;
use roxmltree::Node;

use super::fingerprint::fingerprint;
use super::position::Positions;
use super::xml::element::Reader;
use super::xml::{self, plain, survey};
use super::{Description, FileFormat, LinkId, Name, Source, Unmodelled, names};
use crate::error::{Diagnostic, Errors, Place};
use crate::list::Id;
use crate::wording::quoted;

#[doc(hidden)]
pub use self::elements::page;
/// Error and hint for xacro in a file that does not declare it.
const UNDECLARED: [&str; 2] = [
    "this file contains xacro, and does not declare it",
    "write xmlns:xacro=\"http://www.ros.org/wiki/xacro\" in <robot …>, or end the name of the file in .xacro",
];

/// Error and hint for a dollar sign that an expansion left where a value is read.
const LEFT: [&str; 2] = [
    "the expansion of this value contains $",
    "$$ stands for the character $: write one",
];

/// Error and hint for an incomplete expansion.
const INCOMPLETE: [&str; 2] = [
    "xacro did not know this macro, and links are missing",
    "read the xacro file that this one was made from, and include the file of the macro",
];

/// Hint for a text without the root element.
const BEGINS: &str = "a URDF file begins with <robot name=\"…\">";

/// Reads the text of the file `file`; `anchor` is the token that named it, for the compiler.
///
/// A description returned together with errors is partial: good for counting joints, not for computing.
pub fn read(
    text: &str,
    file: &str,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, anchor);
    let positions = Positions::new(text.strip_prefix('\u{feff}').unwrap_or(text));
    let source = Source {
        file: Some(file.to_owned()),
        format: Some(FileFormat::Urdf),
        anchor,
        hash: fingerprint(text.as_bytes()),
        ..Source::default()
    };
    read_at(&positions, source, Vec::new(), errors)
}

/// Reads a text with its places: those of the file, or of the files that it was expanded from. `warnings` are those of
/// the expansion.
pub(super) fn read_at(
    positions: &Positions<'_>,
    source: Source,
    warnings: Vec<Diagnostic>,
    errors: &mut Errors,
) -> Option<Description> {
    let plain = plain::plain(positions.text());
    let document = xml::parse(&plain, positions, BEGINS, errors)?;
    let mut reader = Reader::new(positions);
    reader.warnings = warnings;
    let mut description = robot(&mut reader, document.root_element());
    if description.is_some() {
        survey::survey(&mut reader, document.root_element(), &elements::URDF);
    }
    reader.warnings.sort_by_key(|warning| warning.place.order());
    let is_whole = || reader.errors.is_empty() && description.as_ref().is_some_and(has_its_links);
    let call = reader.call.filter(|_| !is_whole());
    let undeclared = if positions.is_expanded() {
        LEFT
    } else {
        UNDECLARED
    };
    let found =
        (reader.xacro.map(|place| (place, undeclared))).or(call.map(|place| (place, INCOMPLETE)));
    if let Some((place, [message, hint])) = found {
        // Other errors are probably consequences of this one.
        errors.push_with_hint(place, message, hint);
        return None;
    }
    errors.append(reader.errors);
    errors.warn(reader.warnings.iter().cloned());
    if let Some(description) = &mut description {
        description.source = source;
        description.warnings = reader.warnings;
        description.unmodelled = reader.unmodelled;
        names::check(description, errors);
        names::check_loops(description, errors);
    }
    description
}

/// True if all links exist that joints name.
fn has_its_links(description: &Description) -> bool {
    let links = description.links.iter().map(|link| &*link.name.text);
    let links: HashSet<_> = links.collect();
    let mut ends = description
        .joints
        .iter()
        .flat_map(|joint| [&joint.parent, &joint.child]);
    ends.all(|end| links.contains(&*end.text))
}

fn robot<'t>(reader: &mut Reader<'_, 't>, root: Node<'_, 't>) -> Option<Description> {
    let tag = root.tag_name().name();
    if tag != "robot" {
        let [what, hint] = match tag {
            "sdf" | "world" => [
                "this is SDF, not URDF",
                "read it as SDF: #[robot(sdf = \"…\")], Builder::from_sdf, or the command line",
            ],
            "mujoco" | "mujocoinclude" => [
                "this is MJCF, not URDF",
                "read it as MJCF: #[robot(mjcf = \"…\")], Builder::from_mjcf, or the command line",
            ],
            _ => ["this is not a URDF", BEGINS],
        };
        reader.errors.push_with_hint(
            reader.place(root),
            format!("{what}: the root element is <{tag}>"),
            hint,
        );
        return None;
    }
    let name = reader.name(root, "name", "the robot").unwrap_or(Name {
        text: "robot".to_owned(),
        place: Place::Unknown,
    });
    let subject = format!("robot {}", quoted(&name.text));
    version(reader, root, &subject);
    let mut links = Vec::new();
    let mut joints = Vec::new();
    let mut loops = Vec::new();
    let mut transmissions = Vec::new();
    let mut collisions = Vec::new();
    for child in Reader::children(root) {
        match child.tag_name().name() {
            "link" => {
                let link = link::read(reader, child);
                if let Some(link) = &link {
                    let of = (LinkId::new(links.len()), &link.name);
                    collisions.extend(collision::read(reader, child, of));
                }
                links.extend(link);
            }
            "joint" | "drake.joint" => joints.extend(joint::read(reader, child)),
            "loop_joint" => loops.extend(closure::read(reader, child)),
            "transmission" => transmissions.extend(transmission::read(reader, child)),
            "ros2_control" => {
                let inner = Reader::children(child).into_iter();
                let inner = inner.filter(|inner| inner.tag_name().name() == "transmission");
                transmissions.extend(inner.filter_map(|inner| transmission::read(reader, inner)));
            }
            _ => {}
        }
    }
    transmission::mount(reader, transmissions, &mut joints);
    if links.is_empty() && reader.errors.is_empty() {
        reader
            .errors
            .push(reader.place(root), format!("{subject} has no links"));
    }
    Some(Description {
        name,
        source: Source::default(),
        links,
        joints,
        loops,
        configurations: Vec::new(),
        collisions,
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    })
}

/// Reads the version; warns of an unknown one.
fn version<'t>(reader: &mut Reader<'_, 't>, root: Node<'_, 't>, subject: &str) {
    const KNOWN: [&str; 4] = ["1", "1.0", "1.1", "1.2"];
    let version = root.attribute_node("version");
    let written = version.map(|version| reader.value(&version).trim().to_owned());
    reader.is_of_version_1_0 = written
        .as_deref()
        .is_none_or(|text| text == "1" || text == "1.0");
    if let (Some(version), Some(written)) = (version, written)
        && !KNOWN.contains(&written.as_str())
    {
        reader.warn(
            reader.value_place(&version),
            format!(
                "{subject} has the unknown version {}, and is read as 1.1",
                quoted(&written)
            ),
            Some("versions of URDF are 1.0 and 1.1".to_owned()),
        );
    }
}

#[cfg(test)]
mod tests;
