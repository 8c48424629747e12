//! Everything that may stand in a URDF file, and what becomes of it.
//!
//! In: nothing. Out: the table of URDF 1.0 and 1.1, and of the extensions of ROS, Gazebo, Drake, MuJoCo, Bullet and
//! Isaac. It never reads a number.

mod actuators;
mod format;
mod simulators;

use crate::description::xml::elements::{Content, Entry, Format, Lost, Others, When};

/// The format.
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

/// Each element that has content, as the guide calls it.
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

/// The table as the guide shows it, in Markdown: of each element what may stand in it, attributes first.
#[must_use]
pub fn page() -> String {
    URDF.page()
}
