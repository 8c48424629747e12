//! Everything that may stand in an MJCF file, and what becomes of it.
//!
//! In: nothing. Out: the table of MuJoCo 4, and what of its mechanics is lost. It never reads a number.

mod actors;
mod bodies;
pub(super) mod lost;
mod settings;

use super::element::Element;
use crate::description::xml::elements::{Content, Entry, Format, Others};

/// The format.
pub(super) static MJCF: Format = Format {
    root: &MUJOCO,
    places: &PLACES,
    called: &[
        ("mujoco", "model"),
        ("body", "body"),
        ("joint", "joint"),
        ("geom", "geom"),
        ("site", "site"),
        ("mesh", "mesh"),
    ],
    counted: &["body", "joint", "inertial", "geom"],
    elsewhere: &["include"],
};

/// What is refused of coordinates that older versions had.
pub(super) const GLOBAL: &str = "coordinates are global, which MuJoCo itself no longer reads";

/// The root element.
static MUJOCO: Content = Content {
    attributes: &[Entry::read("model", "the robot's name")],
    elements: &[
        Entry::read(
            "compiler",
            "settings; a later one replaces an earlier one, attribute by attribute",
        )
        .with(&settings::COMPILER),
        Entry::read("option", "gravity").with(&settings::OPTION),
        Entry::read("default", "classes of attributes").with(&settings::DEFAULT),
        Entry::read("worldbody", "the fixed base, and what stands in it").with(&bodies::BODY),
        Entry::read("asset", "meshes, whose volume is needed").with(&settings::ASSET),
        Entry::read("equality", "mimic joints and closed loops").with(&actors::EQUALITY),
        Entry::read(
            "actuator",
            "armatures of actuators, where `rotors` asks for them",
        )
        .with(&actors::ACTUATORS),
        Entry::nothing(
            "tendon",
            "a transmission; its springs, friction and inertia are warned of",
        )
        .with(&actors::TENDONS),
        Entry::nothing("deformable", "the mechanics in it are warned of").with(&actors::DEFORMABLE),
        Entry::nothing("size", "memory"),
        Entry::nothing("statistic", "what is seen"),
        Entry::nothing("visual", "what is seen"),
        Entry::nothing("contact", "how it touches"),
        Entry::nothing("sensor", "sensors"),
        Entry::nothing("keyframe", "configurations by name"),
        Entry::nothing("custom", "numbers of one's own"),
        Entry::nothing("extension", "programs; where they act is warned of"),
    ],
    others: Others::Warned,
};

/// Each element that has content, as the guide calls it.
static PLACES: [(&str, &Content); 22] = [
    ("`<mujoco>`", &MUJOCO),
    ("`<compiler>`", &settings::COMPILER),
    ("`<option>`", &settings::OPTION),
    ("`<flag>`", &settings::FLAG),
    ("`<default>`", &settings::DEFAULT),
    ("`<worldbody>` and `<body>`", &bodies::BODY),
    ("`<frame>`", &bodies::FRAME),
    ("`<replicate>`", &bodies::REPLICATE),
    ("`<inertial>`", &bodies::INERTIAL),
    ("`<joint>`", &bodies::JOINT),
    ("`<freejoint>`", &bodies::FREEJOINT),
    ("`<geom>`", &bodies::GEOM),
    ("`<site>`", &bodies::SITE),
    ("`<asset>`", &settings::ASSET),
    ("`<mesh>`", &settings::MESH),
    ("`<equality>`", &actors::EQUALITY),
    (
        "`<joint>`, `<connect>` and `<weld>` of `<equality>`",
        &actors::CONSTRAINT,
    ),
    ("`<actuator>`", &actors::ACTUATORS),
    ("an actuator", &actors::ACTUATOR),
    ("`<tendon>`", &actors::TENDONS),
    ("a tendon", &actors::TENDON),
    ("`<deformable>`", &actors::DEFORMABLE),
];

/// The root element of each file that is included, with what may stand in the place of it.
pub(super) fn included(root: Element<'_>) -> Vec<(Element<'_>, &'static Content)> {
    let mut found = Vec::new();
    let mut waiting: Vec<(Element<'_>, &'static Content)> = vec![(root, &MUJOCO)];
    while let Some((element, content)) = waiting.pop() {
        for child in element.own_children() {
            if let Some(included) = child.included() {
                found.push((included, content));
                waiting.push((included, content));
            } else if let Some(inner) = content.element(child.tag()).and_then(|entry| entry.content)
            {
                waiting.push((child, inner));
            }
        }
    }
    found
}

/// The table as the guide shows it, in Markdown: of each element what may stand in it, attributes first.
#[must_use]
pub fn page() -> String {
    MJCF.page()
}
