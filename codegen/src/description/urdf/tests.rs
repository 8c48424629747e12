//! Tests of the reader and of each of its messages, with a file for each part. This file reads whole robots, one
//! without errors and one with many.

mod closure;
mod collision;
mod element;
mod hostile;
mod joint;
mod link;
mod placement;
mod survey;
mod unmodelled;
mod xml;

use super::*;
use crate::description::{Axis, Modelled, Number, Step};
use crate::joint::JointKind;

/// An arm with two moving joints and a number of each kind.
const ARM: &str = r#"<?xml version="1.0"?>
<robot name="arm">
  <material name="grey"/>
  <link name="base"/>
  <link name="upper">
    <visual><geometry><sphere radius="1"/></geometry></visual>
    <inertial>
      <origin xyz="0.1 -.25 +1e-3" rpy="0 0 1.2345"/>
      <mass value="2.50"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/>
    </inertial>
  </link>
  <link name="tool"/>
  <joint name="shoulder" type="revolute">
    <origin xyz="0 0 0.4" rpy="0.1 0.2 0.3"/>
    <parent link="base"/>
    <child link="upper"/>
    <axis xyz="0 0.7071 0.7071"/>
    <limit lower="-2.9" upper="2.9" effort="inf" velocity="2"/>
    <dynamics damping="0.0"/>
  </joint>
  <joint name="lift" type="screw">
    <parent link="upper"/>
    <child link="tool"/>
    <axis xyz="0 0 1"/>
    <thread pitch="0.01"/>
  </joint>
</robot>
"#;

/// The errors of a text, as the command line prints them.
fn errors(text: &str) -> String {
    let mut errors = Errors::new();
    let _ = read(text, "arm.urdf", None, &mut errors);
    errors.to_string()
}

fn fine(text: &str) -> Description {
    let mut errors = Errors::new();
    let description = read(text, "arm.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.unwrap()
}

/// The errors of a link or joint in line 2 of a robot.
fn errors_in(item: &str) -> String {
    errors(&format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n{item}</robot>"
    ))
}

/// The errors of a joint from a to b, with its inner text in line 2 from column 1.
fn errors_in_joint(kind: &str, inner: &str) -> String {
    errors(&format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\
         <joint name=\"j\" type=\"{kind}\"><parent link=\"a\"/><child link=\"b\"/>\n\
         {inner}</joint></robot>"
    ))
}

/// The warnings of a robot, as the command line prints them.
fn warnings(text: &str) -> Vec<String> {
    let robot = fine(text);
    let modelled = Modelled {
        friction: false,
        armature: false,
        has_rotor: &|_| false,
    };
    let source = robot.source;
    let warnings = [robot.warnings, robot.unmodelled.warnings(&modelled)].concat();
    let warnings = warnings.iter();
    warnings
        .map(|warning| source.errors().locate(warning))
        .collect()
}

/// The warnings of a joint from a to b, with its inner text in line 2 from column 1.
fn warnings_in_joint(kind: &str, inner: &str) -> Vec<String> {
    warnings(&format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\
         <joint name=\"j\" type=\"{kind}\"><parent link=\"a\"/><child link=\"b\"/>\n\
         {inner}</joint></robot>"
    ))
}

/// The errors of the inertial of a link, with its inner text in line 2 from column 1.
fn errors_in_inertial(inner: &str) -> String {
    errors(&format!(
        "<robot name=\"r\"><link name=\"a\"><inertial>\n{inner}</inertial></link></robot>"
    ))
}

const MASS: &str = "<mass value=\"1\"/>";
const TENSOR: &str = "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>";

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn an_arm_is_read_with_digits_and_places() {
    let arm = fine(ARM);
    assert_eq!(arm.name.text, "arm");
    assert_eq!(arm.links.len(), 3);
    assert!(arm.links[0].inertial.is_none());
    let inertial = arm.links[1].inertial.as_ref().unwrap();
    assert_eq!(inertial.mass.value, 2.5);
    assert_eq!(inertial.mass.resolution, 0.01);
    assert!(matches!(
        inertial.mass.place,
        Place::File {
            line: 9,
            column: 20
        }
    ));
    assert_eq!(
        inertial.inertia.map(|x| x.value),
        [0.1, 0.0, 0.0, 0.2, 0.0, 0.3]
    );
    let [Step::Translate(center), Step::Rotate(Axis::Z, yaw), ..] = inertial.origin[..] else {
        panic!("{:?}", inertial.origin);
    };
    assert_eq!(center.map(|x| x.value), [0.1, -0.25, 0.001]);
    assert!(matches!(
        center[2].place,
        Place::File {
            line: 8,
            column: 29
        }
    ));
    assert_eq!((yaw.value, yaw.resolution), (1.2345, 1e-4));

    let shoulder = &arm.joints[0];
    assert!(matches!(shoulder.kind, JointKind::Revolute));
    assert!(matches!(
        shoulder.origin[..],
        [
            Step::Translate(_),
            Step::Rotate(Axis::Z, Number { value: 0.3, .. }),
            Step::Rotate(Axis::Y, Number { value: 0.2, .. }),
            Step::Rotate(Axis::X, Number { value: 0.1, .. }),
        ]
    ));
    let axis = shoulder.axis.map(|entry| entry.value.to_string());
    assert_eq!(axis, ["0", "0.7071", "0.7071"]);
    let limits = shoulder.limits.unwrap();
    assert_eq!(
        (limits.lower, limits.upper, limits.velocity),
        (-2.9, 2.9, 2.0)
    );
    let JointKind::Screw { pitch } = arm.joints[1].kind else {
        panic!("{:?}", arm.joints[1].kind);
    };
    assert_eq!(pitch.value, 0.01);
    assert!(arm.joints[1].origin.is_empty());
    assert!(arm.warnings.is_empty());
    assert_eq!(arm.source.file.as_deref(), Some("arm.urdf"));
}

#[test]
fn all_mistakes_are_reported_at_once() {
    let text = r#"<robot name="arm">
  <link name="base"/>
  <link name="base"/>
  <link/>
  <link name="upper">
    <inertial>
      <origin xyz="0 0"/>
      <mass value="-1"/>
      <inertia ixx="nan" ixy="0" iyy="1" iyz="0" izz="1e999"/>
    </inertial>
  </link>
  <joint name="elbow" type="hinge">
    <child link="upper"/>
  </joint>
  <joint name="wrist" type="ball">
    <parent link="base"/>
    <child link="upper"/>
  </joint>
</robot>"#;
    assert_eq!(
        errors(text),
        r#"error: arm.urdf:4:3: a link has no attribute "name"
error: arm.urdf:7:20: xyz of the origin of the inertial of link "upper" has 2 numbers instead of 3
error: arm.urdf:8:20: the mass of link "upper" is negative: -1
error: arm.urdf:9:21: ixx of link "upper" is not finite: "nan"
error: arm.urdf:9:7: ixz of link "upper" is missing
error: arm.urdf:9:55: izz of link "upper" is too large for 64 bits: "1e999"
error: arm.urdf:12:29: joint "elbow" has the unknown type "hinge"
  hint: write revolute
error: arm.urdf:12:3: joint "elbow" has no <parent>
  hint: add <parent link="…"/>
error: arm.urdf:15:29: joint "wrist" has the unknown type "ball"
  hint: write spherical
error: arm.urdf:3:15: there is another link "base"
  hint: the other one is in line 2
"#
    );
}
