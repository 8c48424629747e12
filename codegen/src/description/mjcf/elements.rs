//! The table of all elements and attributes of MuJoCo 4: read, ignored, or reported as a warning.

mod actors;
mod bodies;
mod settings;
pub(super) mod unmodelled;

use super::element::Element;
use crate::description::xml::elements::{Content, Entry, Format, Others};

/// The format MJCF.
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

/// Message for the global coordinates of older versions.
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
        Entry::read("worldbody", "the fixed base, with its bodies and sites").with(&bodies::BODY),
        Entry::read(
            "asset",
            "meshes, for inertias, and models that are attached",
        )
        .with(&settings::ASSET),
        Entry::read("equality", "mimic joints and closed loops").with(&actors::EQUALITY),
        Entry::read("actuator", "armatures of actuators, with the key `rotors`")
            .with(&actors::ACTUATORS),
        Entry::ignored(
            "tendon",
            "a transmission; a warning of springs, friction and inertia",
        )
        .with(&actors::TENDONS),
        Entry::ignored("deformable", "a warning of its mechanics").with(&actors::DEFORMABLE),
        Entry::ignored("size", "memory"),
        Entry::ignored("statistic", "visual"),
        Entry::ignored("visual", "visual"),
        Entry::ignored("contact", "contacts"),
        Entry::ignored("sensor", "sensors"),
        Entry::read("keyframe", "configurations with names").with(&settings::KEYFRAME),
        Entry::ignored("custom", "user data"),
        Entry::ignored("extension", "plug-ins; a warning where they exert forces"),
    ],
    others: Others::Warned,
};

/// Each element with attributes or children, under its heading in the guide.
static PLACES: [(&str, &Content); 27] = [
    ("`<mujoco>`", &MUJOCO),
    ("`<compiler>`", &settings::COMPILER),
    ("`<option>`", &settings::OPTION),
    ("`<flag>`", &settings::FLAG),
    ("`<default>`", &settings::DEFAULT),
    ("`<worldbody>` and `<body>`", &bodies::BODY),
    ("`<frame>`", &bodies::FRAME),
    ("`<replicate>`", &bodies::REPLICATE),
    ("`<attach>`", &bodies::ATTACH),
    ("`<inertial>`", &bodies::INERTIAL),
    ("`<joint>`", &bodies::JOINT),
    ("`<freejoint>`", &bodies::FREEJOINT),
    ("`<geom>`", &bodies::GEOM),
    ("`<site>`", &bodies::SITE),
    ("`<asset>`", &settings::ASSET),
    ("`<model>` of `<asset>`", &settings::MODEL),
    ("`<mesh>`", &settings::MESH),
    ("`<hfield>`", &settings::HEIGHT_FIELD),
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
    ("`<keyframe>`", &settings::KEYFRAME),
    ("`<key>`", &settings::KEY),
];

/// The root element of each included file, with the table of the elements allowed in its place.
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

/// The table of elements and attributes as a page of the guide, in Markdown.
#[must_use]
pub fn page() -> String {
    MJCF.page()
}
