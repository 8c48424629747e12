//! Tests of the reader and of each of its messages, with a file for each part. This file reads a whole robot.

mod attach;
mod defaults;
mod equality;
mod files;
mod hostile;
mod inertia;
mod joints;
mod placement;
mod survey;

use super::*;
use crate::description::spatial::Pose;
use crate::description::{Inertial, Joint, Link, Modelled, Step};
use crate::expression::Double as Exact;

/// A robot with an element of each important kind.
const ARM: &str = r#"<mujoco model="arm">
  <compiler angle="radian"/>
  <default>
    <joint damping="0.5"/>
    <default class="small">
      <joint range="-1 1" armature="0.01"/>
      <geom type="capsule" size="0.02"/>
    </default>
  </default>
  <worldbody>
    <geom type="plane" size="1 1 1"/>
    <body name="upper" pos="0 0 0.4" quat="2 0 0 0" childclass="small">
      <joint name="shoulder" axis="0 1 0" ref="0.25"/>
      <geom fromto="0 0 0 0.3 0 0" mass="1.5"/>
      <frame pos="0.3 0 0">
        <body name="fore" euler="0 0 0.5">
          <joint type="slide" axis="1 0 0"/>
          <inertial pos="0.1 0 0" mass="1" diaginertia="0.1 0.2 0.25"/>
          <site name="tip" pos="0.2 0 0"/>
        </body>
      </frame>
    </body>
  </worldbody>
</mujoco>
"#;

/// The errors of a text, as the command line prints them.
fn errors(text: &str) -> String {
    let mut errors = Errors::new();
    let _ = read(text, "arm.xml", None, None, &mut errors);
    errors.to_string()
}

fn fine(text: &str) -> Description {
    let mut errors = Errors::new();
    let description = read(text, "arm.xml", None, None, &mut errors);
    assert!(errors.is_empty(), "{errors}\n{text}");
    description.unwrap()
}

/// A file with these bodies, in radians.
fn in_world(bodies: &str) -> String {
    format!("<mujoco><compiler angle=\"radian\"/><worldbody>\n{bodies}</worldbody></mujoco>")
}

/// The warnings of a text, as the command line prints them.
fn warnings(text: &str) -> Vec<String> {
    let robot = fine(text);
    let modelled = Modelled {
        friction: true,
        armature: true,
        has_rotor: &|_| true,
    };
    let warnings = [robot.warnings, robot.unmodelled.warnings(&modelled)].concat();
    let source = robot.source;
    let warnings = warnings.iter();
    warnings
        .map(|warning| source.errors().locate(warning))
        .collect()
}

fn link<'d>(robot: &'d Description, name: &str) -> &'d Link {
    let mut links = robot.links.iter();
    let found = links.find(|link| link.name.text == name);
    found.unwrap_or_else(|| panic!("no link {name}"))
}

fn joint<'d>(robot: &'d Description, name: &str) -> &'d Joint {
    let mut joints = robot.joints.iter();
    let found = joints.find(|joint| joint.name.text == name);
    found.unwrap_or_else(|| panic!("no joint {name}"))
}

fn inertial<'d>(robot: &'d Description, name: &str) -> &'d Inertial {
    link(robot, name).inertial.as_ref().expect("an inertia")
}

/// A pose as numbers.
fn pose(steps: &[Step]) -> ([[f64; 3]; 3], [f64; 3]) {
    let pose = Pose::of(steps);
    let rotation = pose.rotation.map(|row| row.map(Exact::to_f64));
    (rotation, pose.position.map(Exact::to_f64))
}

fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-14, "{found} is not {wanted}");
}

fn all_near<const N: usize>(found: [f64; N], wanted: [f64; N]) {
    for (found_one, wanted_one) in found.into_iter().zip(wanted) {
        assert!(
            (found_one - wanted_one).abs() < 1e-14,
            "{found:?} is not {wanted:?}"
        );
    }
}

fn values<const N: usize>(numbers: [Number; N]) -> [f64; N] {
    numbers.map(|number| number.value)
}

#[test]
fn an_arm_is_read() {
    let arm = fine(ARM);
    assert_eq!(arm.name.text, "arm");
    let links: Vec<&str> = arm.links.iter().map(|link| &*link.name.text).collect();
    assert_eq!(links, ["world", "upper", "fore", "tip"]);
    let kinds: Vec<(&str, &str, &str, &str)> = (arm.joints.iter())
        .map(|joint| {
            (
                &*joint.name.text,
                joint.kind.word(),
                &*joint.parent.text,
                &*joint.child.text,
            )
        })
        .collect();
    assert_eq!(
        kinds,
        [
            ("shoulder", "revolute", "world", "upper"),
            ("fore", "prismatic", "upper", "fore"),
            ("tip", "fixed", "fore", "tip"),
        ]
    );
    let shoulder = joint(&arm, "shoulder");
    assert_eq!(values(shoulder.axis), [0.0, 1.0, 0.0]);
    let limits = shoulder.limits.unwrap();
    assert_eq!(
        [limits.lower, limits.upper].map(f64::to_bits),
        [-1.0_f64, 1.0].map(f64::to_bits)
    );
    // Its placement is given at q = 0.25.
    let (rotation, position) = pose(&shoulder.origin);
    all_near(position, [0.0, 0.0, 0.4]);
    all_near(rotation[0], [0.25_f64.cos(), 0.0, (-0.25_f64).sin()]);
    let (rotation, position) = pose(&joint(&arm, "fore").origin);
    all_near(position, [0.3, 0.0, 0.0]);
    near(rotation[1][0], 0.5_f64.sin());
    near(inertial(&arm, "upper").mass.value, 1.5);
}

#[test]
fn the_name_of_a_robot_is_that_of_its_model_or_file() {
    assert_eq!(fine("<mujoco><worldbody/></mujoco>").name.text, "arm");
    assert_eq!(fine("<mujoco model=\"a b\"/>").name.text, "a b");
}

#[test]
fn gravity_is_that_of_the_option() {
    let gravity = |option: &str| {
        let robot = fine(&format!("<mujoco>{option}</mujoco>"));
        robot.gravity.map(values)
    };
    assert_eq!(gravity(""), None);
    assert_eq!(gravity("<option timestep=\"0.1\"/>"), None);
    assert_eq!(
        gravity("<option gravity=\"0 1 -2\"/><option/>"),
        Some([0.0, 1.0, -2.0])
    );
    let off = "<option gravity=\"0 1 -2\"><flag gravity=\"disable\"/></option>";
    assert_eq!(gravity(off), Some([0.0; 3]));
}
