//! Descriptions before they are damaged.
//!
//! In: a random source. Out: a robot that ships or one with more elements, in any language, or a long robot.

mod simulators;

use self::simulators::{MJCF, SDF, XACRO};
use super::Language;
use crate::states::Random;

const URDF: [&str; 8] = [
    include_str!("../../../robots/two_link.urdf"),
    include_str!("../../../robots/two_link.urdf"),
    include_str!("../../../robots/scara.urdf"),
    include_str!("../../../robots/stanford.urdf"),
    include_str!("../../../robots/panda_class.urdf"),
    include_str!("../../../robots/quadruped.urdf"),
    include_str!("../../robots/hostile.urdf"),
    REAL,
];

/// In the style of exporters: residues, prefixes, meshes, transmissions, plugins, comments.
const REAL: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<!-- This URDF was automatically created by SolidWorks to URDF Exporter! -->
<robot name="exported" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <material name="grey"><color rgba="0.79 0.82 0.93 1"/></material>
  <link name="base_link">
    <inertial><origin xyz="-2.1E-17 0.013 0" rpy="0 0 0"/><mass value="0.29"/>
      <inertia ixx="1e-4" ixy="-1.8E-20" ixz="0" iyy="2e-4" iyz="0" izz="1e-4"/></inertial>
    <visual><geometry><mesh filename="package://a/b.stl"/></geometry></visual>
  </link>
  <link name="l1">
    <inertial><origin xyz="0.09 -1.6653e-16 0.07" rpy="-1.6653e-16 1.1102e-16 0.5"/><mass value="1"/>
      <inertia ixx="0.002" ixy="1e-9" ixz="-1e-9" iyy="0.003" iyz="0" izz="0.003"/></inertial>
  </link>
  <joint name="j1" type="revolute">
    <origin xyz="0 -9.5e-18 0.054" rpy="1.5708 -5.5e-17 -1.5708"/>
    <parent link="base_link"/><child link="l1"/><axis xyz="0 0 1"/>
    <limit lower="-2.1" upper="2.1" effort="10" velocity="10"/>
    <dynamics damping="0.1" friction="0.2"/><safety_controller k_velocity="1"/>
  </joint>
  <link name="l2">
    <inertial><origin xyz="0 0 -0.05"/><mass value="0.3"/>
      <inertia ixx="1e-4" ixy="0" ixz="0" iyy="1e-4" iyz="0" izz="1e-5"/></inertial>
    <collision><geometry><cylinder length="0.1" radius="0.02"/></geometry></collision>
  </link>
  <joint name="j2" type="continuous">
    <origin xyz="0.1 0 0" rpy="3.14159 0 1.5708"/><parent link="l1"/><child link="l2"/>
    <axis xyz="0.577 0.577 0.577"/>
  </joint>
  <link name="tip"/>
  <joint name="end" type="fixed"><parent link="l2"/><child link="tip"/></joint>
  <transmission name="t"><type>SimpleTransmission</type><joint name="j1"/></transmission>
  <gazebo reference="l1"><plugin name="p" filename="libp.so"/></gazebo>
</robot>
"#;

const TABLES: [&str; 2] = [
    "\
# An arm with a wrist.
convention modified
joint     kind        a    alpha   d     theta  link    lower upper velocity mass cx   cy cz   ixx  ixy ixz iyy  iyz izz
waist     revolute    0    0       0.4   0      trunk   -2.9  2.9   3        3.2  0.1  0  0    0.1  0   0   0.1  0   0.1
shoulder  revolute    0    -pi/2   0     0      upper   -1    pi    3        2    0.2  0  0.01 0.02 0   0   0.1  0   0.1
elbow     continuous  0.43 0       0.15  pi/2   fore    -     -     -        1    0    -0.1 0  0.01 0   0   0.01 0   0.01
quill     prismatic   0    1.5708  0     0      rod     0     0.5   1        0.5  0    0  0    0    0   0   0    0   0
tool      fixed       0    0       0.1   0
",
    "\
convention standard
joint kind a alpha d theta pitch
j1 revolute 0 1.5708 0.089 0
j2 screw -0.425 0 0 0.1 0.01
j3 revolute -0.39 -3*pi/4 0 1e-3 -
",
];

const INLINE: [&str; 3] = [
    r#"
/// A SCARA.
#[derive(Debug)]
pub struct Scara { gravity: [0.0, 0.0, -9.81], tip: tool, generate(inverse_dynamics) }
link base;
joint shoulder: revolute(z) { at: xyz(0.0, 0.0, 0.40), limits: [-2.9, 2.9], velocity: 2.0 }
link upper { mass: 3.2, com: [0.12, 0, 0], inertia: [0.01, 0.02, 0.02] }
joint elbow: continuous(-z) { at: xyz(0.3, 0, 0) rpy(0.1, 0.2, pi/2) rx(-pi) }
link fore { mass: 1.50, inertia: [0.02, 0.03, 0.03, 0.001, 0, 0], inertia_rpy: [0, 0, 0.1] }
joint "z-axis": screw([0.0, 0.6, 0.8], pitch: 0.01);
link tool { mass: 0.8, com: [0.0, 0.0, 0.05], inertia: [0.001, 0.001, 0.0005] }
joint camera: fixed { from: upper, to: eye }
link eye
"#,
    r"
struct Tree { exact, strict, scalar = f32, lock(second = 0.3), drop(off), frames(left, right),
    generate(gravity, all_of(mass_matrix, bias), forward_kinematics), formulation(raw, refined = 1) }
link root;
joint first: revolute(x);
link left { mass: 1, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01] }
joint second: prismatic(y) { from: root, to: right }
link right { mass: 1, com: [0, 0.1, 0], inertia: [0.01, 0.01, 0.01] }
joint third: revolute(-x) { from: right, to: off, at: ry(1/3) }
link off { mass: 2*1.5, inertia: [0.01, 0.01, 0.01] }
",
    r"
struct Table { tip = tool; }
denavit_hartenberg(standard) {
    shoulder: revolute { a: 0, alpha: pi/2, d: 0.4, theta: 0, mass: 1, com: [0, 0, 0.1], inertia: [0.1, 0.1, 0.1] }
    elbow: revolute { a: 0.3, alpha: 0, d: 0, theta: 0.1 }
}
",
];

/// A random description; rarely a long one.
pub(super) fn choose(random: &mut Random) -> (Language, String) {
    match random.below(100) {
        0 => (Language::Urdf, snake(1 + random.below(6000))),
        1..28 => (Language::Urdf, (*random.choose(&URDF)).to_owned()),
        28..42 => (Language::Table, (*random.choose(&TABLES)).to_owned()),
        42..58 => (Language::Inline, (*random.choose(&INLINE)).to_owned()),
        58..72 => (Language::Xacro, (*random.choose(&XACRO)).to_owned()),
        72..86 => (Language::Mjcf, (*random.choose(&MJCF)).to_owned()),
        _ => (Language::Sdf, (*random.choose(&SDF)).to_owned()),
    }
}

/// A serial robot with so many joints.
fn snake(joints: usize) -> String {
    let joint = |k: usize| {
        let parent = k - 1;
        format!(
            "<link name=\"l{k}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" \
             iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link><joint name=\"j{k}\" type=\"continuous\">\
             <origin xyz=\"0.1 0 0\" rpy=\"0.1 0.2 0.3\"/><parent link=\"l{parent}\"/>\
             <child link=\"l{k}\"/><axis xyz=\"0 1 0\"/></joint>\n"
        )
    };
    let joints: String = (1..=joints).map(joint).collect();
    format!("<robot name=\"snake\"><link name=\"l0\"/>{joints}</robot>")
}
