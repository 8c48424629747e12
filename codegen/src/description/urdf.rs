//! URDF, the Unified Robot Description Format.
//!
//! In: the text of a file. Out: a [`Description`], as far as it could be read, with a complaint
//! for every mistake, each at its line and column. Everything that is not mechanics (meshes,
//! simulators' settings) is passed over; mechanics that are modelled only where they are
//! asked for (friction, gears) are kept beside a doubt. It never takes time or memory out of proportion to the text, and never
//! guesses a number that is not there.

mod closure;
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
use super::{Description, Name, Source, Unmodelled, names};
use crate::error::{Errors, Place};
use crate::wording::quoted;

#[doc(hidden)]
pub use self::elements::page;
/// What to do about a file that has yet to be expanded.
const XACRO: (&str, &str) = (
    "this is a xacro file that has yet to be expanded to URDF",
    "run: xacro robot.urdf.xacro > robot.urdf",
);

/// How a file begins.
const BEGINS: &str = "a URDF file begins with <robot name=\"…\">";

/// Reads the text of a file named `file`; `anchor` is the token that named it, for the compiler.
///
/// Where something was pushed, the description holds what could be read all the same: enough to
/// know how many joints there are, not to be computed with.
pub fn read(
    text: &str,
    file: &str,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, anchor);
    let positions = Positions::new(text.strip_prefix('\u{feff}').unwrap_or(text));
    let plain = plain::plain(positions.text());
    let document = xml::parse(&plain, &positions, BEGINS, errors)?;
    let mut reader = Reader {
        positions: &positions,
        errors: Errors::new(),
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
        is_of_version_1_0: false,
        xacro: None,
        call: None,
    };
    let mut description = robot(&mut reader, document.root_element());
    if description.is_some() {
        survey::survey(&mut reader, document.root_element(), &elements::URDF);
    }
    reader.warnings.sort_by_key(|warning| warning.place.order());
    let is_whole = || reader.errors.is_empty() && description.as_ref().is_some_and(has_its_links);
    let call = reader.call.filter(|_| !is_whole());
    if let Some(place) = reader.xacro.or(call) {
        // Whatever else is wrong is likely to be so because of that.
        errors.push_with_hint(place, XACRO.0, XACRO.1);
        return None;
    }
    errors.append(reader.errors);
    errors.warn(reader.warnings.iter().cloned());
    if let Some(description) = &mut description {
        description.source = Source {
            file: Some(file.to_owned()),
            anchor,
            included: Vec::new(),
            beside: Vec::new(),
            hash: fingerprint(text.as_bytes()),
        };
        description.warnings = reader.warnings;
        description.unmodelled = reader.unmodelled;
        names::check(description, errors);
        names::check_loops(description, errors);
    }
    description
}

/// Whether there is every link that a joint names.
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
                "this is SDF, which describes worlds, and not URDF",
                "give the URDF that it was made of; or convert it, as by the tools of ROS for SDF, and look at what \
                 `homogen check` says of the result",
            ],
            "mujoco" | "mujocoinclude" => [
                "this is MJCF, the format of MuJoCo, and not URDF",
                "read it as MJCF: the reader of its text does, whatever the file's name ends with",
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
    let mut geared = Vec::new();
    for child in Reader::children(root) {
        match child.tag_name().name() {
            "link" => links.extend(link::read(reader, child)),
            "joint" | "drake.joint" => joints.extend(joint::read(reader, child)),
            "loop_joint" => loops.extend(closure::read(reader, child)),
            "transmission" => geared.extend(transmission::read(reader, child)),
            "ros2_control" => {
                let inner = Reader::children(child).into_iter();
                let inner = inner.filter(|inner| inner.tag_name().name() == "transmission");
                geared.extend(inner.filter_map(|inner| transmission::read(reader, inner)));
            }
            _ => {}
        }
    }
    transmission::mount(reader, geared, &mut joints);
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
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    })
}

/// Notes the version; warns of one that is not known.
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
                "{subject} has the version {}, which is not known: read as 1.1",
                quoted(&written)
            ),
            Some("versions of URDF are 1.0 and 1.1".to_owned()),
        );
    }
}

#[cfg(test)]
mod tests;
