//! The table of all elements and attributes of URDF 1.0 and 1.1 and of the extensions of ROS, Gazebo, Drake, MuJoCo,
//! Bullet and Isaac: read, ignored, or reported as a warning.

mod actuators;
mod format;
mod simulators;

use crate::description::xml::elements::{Content, Entry, Format, NotModelled, Others, When};

/// The format URDF.
pub(super) const URDF: Format = Format {
    root: &format::ROBOT,
    places: &PLACES,
    called: &[
        ("loop_joint", "loop joint"),
        ("drake:joint", "joint"),
        ("robot", "robot"),
        ("link", "link"),
        ("joint", "joint"),
        ("transmission", "transmission"),
    ],
    counted: &["link", "joint", "inertial"],
    elsewhere: &[],
};

/// An element with one value.
const VALUE: Content = Content {
    attributes: &[Entry::read("value", "the value")],
    elements: &[],
    others: Others::WarnedLikeText,
};

/// Each element with content, under its heading in the guide.
const PLACES: [(&str, &Content); 18] = [
    ("`<robot>`", &format::ROBOT),
    ("`<link>`", &format::LINK),
    ("`<inertial>`", &format::INERTIAL),
    ("`<origin>`", &format::ORIGIN),
    ("`<joint>` and `<drake:joint>`", &format::JOINT),
    ("`<axis>` and `<axis2>`", &format::AXIS),
    ("`<limit>`", &format::LIMIT),
    ("`<dynamics>`", &format::DYNAMICS),
    ("`<mimic>`", &format::MIMIC),
    ("`<safety_controller>`", &format::SAFETY_CONTROLLER),
    ("`<loop_joint>`", &format::LOOP_JOINT),
    ("`<transmission>`", &actuators::TRANSMISSION),
    (
        "`<actuator>` and `<joint>` of a transmission",
        &actuators::END,
    ),
    ("`<gazebo>`, at any depth", &simulators::GAZEBO),
    ("`<mujoco>`", &simulators::MUJOCO),
    ("`<compiler>` of MuJoCo", &simulators::COMPILER),
    ("`<option>` of MuJoCo", &simulators::OPTION),
    (
        "`<contact>` of Bullet, in a link",
        &simulators::BULLET_CONTACT,
    ),
];

/// The table of elements and attributes as a page of the guide, in Markdown.
#[must_use]
pub fn page() -> String {
    URDF.page()
}
