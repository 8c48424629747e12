//! Robots with quaternions, planar joints, mimic joints, or links without inertia between joints.
//!
//! In: a name. Out: a description with such joints in the middle.

use std::fmt::Write;

/// A joint and the link that it carries: parent, type, origin, axis, further elements, mass.
type Row = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    f64,
);

/// Two fingers on coupled prismatic joints at a wrist, and a thumb that mimics one of them.
const GRIPPER: &[Row] = &[
    ("base", "revolute", "0 0.1 0.2", "0 0 1", LIMIT, 0.6),
    ("l1", "revolute", "0 0.05 0.3", "0 1 0", LIMIT, 0.4),
    ("l2", "prismatic", "0 0.03 0.1", "0 1 0", FINGER, 0.05),
    (
        "l2",
        "prismatic",
        "0 -0.03 0.1",
        "0 1 0",
        MIMIC_FINGER,
        0.05,
    ),
    ("l2", "revolute", "0.04 0 0.08", "1 0 0", MIMIC_THUMB, 0.04),
    (
        "l5",
        "revolute",
        "0 0 0.05",
        "0.6 0 0.8",
        MIMIC_OF_THUMB,
        0.02,
    ),
];

const LIMIT: &str = r#"<limit lower="-2" upper="2" velocity="3" effort="9"/>"#;
const FINGER: &str = r#"<limit lower="0" upper="0.04" velocity="0.3" effort="9"/>"#;
const MIMIC_FINGER: &str = r#"<limit lower="-1" upper="1" velocity="3" effort="9"/>
    <mimic joint="j3" multiplier="-1" offset="0.002"/>"#;
const MIMIC_THUMB: &str = r#"<limit lower="-3" upper="3" velocity="9" effort="9"/>
    <mimic joint="j3" multiplier="25" offset="0.1"/>"#;
const MIMIC_OF_THUMB: &str = r#"<limit lower="-3" upper="3" velocity="9" effort="9"/>
    <mimic joint="j5" multiplier="-0.5" offset="0"/>"#;

/// A planar joint, a ball joint with an arm, and a floating joint with a prismatic one.
const EVERY_MANIFOLD: &[Row] = &[
    ("base", "planar", "0.2 0 0.1", "0 0.6 0.8", "", 3.0),
    ("l1", "spherical", "0.1 -0.2 0.3", "0 0 1", "", 2.0),
    ("l2", "revolute", "0 0.05 0.4", "0 1 0", LIMIT, 1.0),
    ("l1", "floating", "0 0 1", "0 0 1", "", 1.2),
    ("l4", "prismatic", "0 0 -0.1", "0 0.6 0.8", LIMIT, 0.3),
];

/// A platform on two prismatic joints with massless links; on it, a shaft on a universal joint that carries a bolt, a
/// stage with three translations, and a head on two revolute joints, the first with a nearly massless link.
const NOTHING_BETWEEN: &[Row] = &[
    ("base", "prismatic", "0.2 0 0.1", "1 0 0", LIMIT, 0.0),
    ("l1", "prismatic", "0 0 0.2", "0 0.8 0.6", LIMIT, 0.0),
    ("l2", "revolute", "0 0.1 0", "0 0 1", LIMIT, 5.0),
    ("l3", "universal", "0.2 0 0.1", "1 0 0", CARDAN, 1.0),
    ("l4", "cylindrical", "0 0.1 0.2", "0 0 1", "", 0.8),
    ("l3", "translation", "-0.2 0 0.1", "0 0 1", "", 0.5),
    ("l6", "revolute", "0 0.1 0", "1 0 0", LIMIT, 1e-9),
    ("l7", "revolute", "0 0 0.1", "0 0.8 0.6", LIMIT, 0.4),
];

const CARDAN: &str = r#"<axis2 xyz="0 0.8 0.6"/>"#;

/// The description of a robot of this name; `None` if it is not one of these.
pub fn text(name: &str) -> Option<String> {
    let rows = match name {
        "gripper" => GRIPPER,
        "every_manifold" => EVERY_MANIFOLD,
        "nothing_between" => NOTHING_BETWEEN,
        _ => return None,
    };
    let mut text = format!(r#"<robot name="{name}"><link name="base"/>"#);
    for (k, (parent, kind, at, axis, more, mass)) in (1..).zip(rows) {
        let (moment, product) = (mass * 0.02, mass * 0.0002);
        write!(
            text,
            r#"<joint name="j{k}" type="{kind}"><origin xyz="{at}" rpy="0.3 -0.2 0.4"/>
            <parent link="{parent}"/><child link="l{k}"/><axis xyz="{axis}"/>{more}</joint>
            <link name="l{k}"><inertial><origin xyz="0.01 -0.02 0.1"/><mass value="{mass}"/>
            <inertia ixx="{moment}" ixy="{product}" ixz="-{product}" iyy="{moment}" iyz="{product}" izz="{moment}"/>
            </inertial></link>"#
        )
        .expect("a string takes everything");
    }
    Some(text + "</robot>")
}
