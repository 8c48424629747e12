//! The table of all elements and attributes of SDF 1.4 to 1.12: read, ignored, or reported as a warning.

mod links;
mod models;
mod pose;

use crate::description::xml::elements::{Content, Format, NotModelled};

/// The format SDF.
pub(super) static SDF: Format = Format {
    root: &models::SDF,
    places: &PLACES,
    called: &[
        ("model", "model"),
        ("link", "link"),
        ("joint", "joint"),
        ("frame", "frame"),
    ],
    counted: &["model", "link", "joint", "inertial"],
    elsewhere: &[],
};

/// Each element with content, under its heading in the guide.
static PLACES: [(&str, &Content); 15] = [
    ("`<sdf>`", &models::SDF),
    ("`<world>`", &models::WORLD),
    ("`<model>`", &models::MODEL),
    ("`<include>`", &models::INCLUDE),
    ("`<frame>`", &models::FRAME),
    ("`<pose>`", &pose::POSE),
    ("`<link>`", &links::LINK),
    ("`<inertial>`", &links::INERTIAL),
    ("`<inertia>`", &links::INERTIA),
    ("`<joint>`", &links::JOINT),
    ("`<axis>` and `<axis2>`", &links::AXIS),
    ("`<xyz>`", &links::XYZ),
    ("`<limit>`", &links::LIMIT),
    ("`<dynamics>`", &links::DYNAMICS),
    ("`<mimic>`", &links::MIMIC),
];

/// A spring.
const SPRING: NotModelled = NotModelled {
    what: "a spring",
    hint: "add its torque to tau",
};

/// The mass of the fluid around a link.
const ADDED_MASS: NotModelled = NotModelled {
    what: "mass that a fluid adds",
    hint: "it is missing from masses and torques",
};

/// A link without gravity.
const GRAVITY: NotModelled = NotModelled {
    what: "a link without gravity",
    hint: "gravity acts on all links here",
};

/// A link that forces do not move.
const KINEMATIC: NotModelled = NotModelled {
    what: "a kinematic link, which forces do not move",
    hint: "lock its joint if it stands still",
};

/// Damping of the motion of a link.
const VELOCITY_DECAY: NotModelled = NotModelled {
    what: "damping of the motion of a link in space",
    hint: "add its wrench with `external`",
};

/// A joint or a force of Drake.
const OF_DRAKE: NotModelled = NotModelled {
    what: "a joint, a constraint or a force of Drake",
    hint: "write a joint of SDF, or add its torque to tau",
};

/// The table of elements and attributes as a page of the guide, in Markdown.
#[must_use]
pub fn page() -> String {
    SDF.page()
}
