use super::{OutputFormat, convert};
use crate::description::read_text;
use crate::error::Errors;

fn written(text: &str, format: OutputFormat) -> (String, Vec<String>) {
    let mut errors = Errors::new();
    let description = read_text(text, "robot.xml", None, &mut errors);
    let description = description.expect("a description");
    assert!(errors.is_empty(), "{errors}");
    let converted = convert(&description, format).expect("it is a tree");
    let warnings = converted.warnings.into_iter();
    let warnings = warnings.map(|warning| warning.message);
    (converted.text, warnings.collect())
}

const ARM: &str = r#"<robot name="a &amp; b">
  <link name="base"/>
  <link name="link">
    <inertial><origin xyz="0.1 0 0"/><mass value="1.50"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/></inertial>
  </link>
  <joint name="hinge" type="revolute">
    <parent link="base"/><child link="link"/><origin xyz="0 0 0.25" rpy="1.5708 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="2" velocity="3" effort="4"/><dynamics damping="0.1"/>
  </joint>
</robot>"#;

#[test]
fn urdf_keeps_the_digits_of_the_file() {
    let (text, warnings) = written(ARM, OutputFormat::Urdf);
    assert!(warnings.is_empty(), "{warnings:?}");
    let wanted = r#"<?xml version="1.0"?>
<robot name="a &amp; b">
  <link name="base"/>
  <link name="link">
    <inertial>
      <origin xyz="0.1 0 0"/>
      <mass value="1.50"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/>
    </inertial>
  </link>
  <joint name="hinge" type="revolute">
    <origin xyz="0 0 0.25" rpy="1.5708 0 0"/>
    <parent link="base"/>
    <child link="link"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="2" effort="4" velocity="3"/>
    <dynamics damping="0.1"/>
  </joint>
</robot>
"#;
    assert_eq!(text, wanted);
}

#[test]
fn urdf_keeps_collision_spheres() {
    let sphere = "<collision><origin xyz=\"0 0 0.10\"/><geometry><sphere radius=\"0.05\"/></geometry></collision>";
    let link = format!(
        "<link name=\"base\">{sphere}<collision><geometry><box/></geometry></collision></link>"
    );
    let arm = ARM.replace("<link name=\"base\"/>", &link);
    let (text, _) = written(&arm, OutputFormat::Urdf);
    let wanted = r#"  <link name="base">
    <collision>
      <origin xyz="0 0 0.10"/>
      <geometry>
        <sphere radius="0.05"/>
      </geometry>
    </collision>
  </link>
  <link name="link">
"#;
    assert!(text.contains(wanted), "{text}");
}

#[test]
fn mjcf_has_the_same_numbers() {
    let (text, warnings) = written(ARM, OutputFormat::Mjcf);
    assert_eq!(
        warnings,
        ["MJCF has no limits of velocities: those of \"hinge\" are left out"]
    );
    let wanted = r#"<mujoco model="a &amp; b">
  <compiler angle="radian" eulerseq="XYZ"/>
  <worldbody>
    <body name="base">
      <body name="link" pos="0 0 0.25" euler="1.5708 0 0">
        <inertial pos="0.1 0 0" mass="1.50" diaginertia="0.1 0.2 0.3"/>
        <joint name="hinge" type="hinge" axis="0 0 1" range="-1 2" actuatorfrcrange="-4 4" damping="0.1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"#;
    assert_eq!(text, wanted);
}

#[test]
fn configurations_become_keyframes() {
    let robot = "<mujoco><worldbody><body name=\"a\"><freejoint name=\"f\"/><geom size=\"1\"/><body name=\"b\">\
                 <joint name=\"j\" ref=\"90\"/><geom size=\"1\"/><body name=\"c\"><joint name=\"k\" type=\"ball\"/><geom size=\"1\"/>\
                 </body></body></body></worldbody><equality><joint joint1=\"j\"/></equality>\
                 <keyframe><key name=\"&lt;home&gt;\" qpos=\"1 2 3 0 0 0 1 0.50 1 0 0 0\"/></keyframe></mujoco>";
    let (text, _) = written(robot, OutputFormat::Mjcf);
    let wanted = "<keyframe>\n    <key name=\"&lt;home&gt;\" qpos=\"1 2 3 0 0 0 1 0.50 1 0 0 0\"/>\n  </keyframe>\n";
    assert!(text.contains(wanted), "{text}");
    let (again, _) = written(&text, OutputFormat::Mjcf);
    assert!(again.contains(wanted), "{again}");
}

#[test]
fn links_without_mass_between_joints_are_merged() {
    let chain = r#"<robot name="r"><link name="world"/><link name="between"/><link name="body"><inertial><mass value="1"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="end"/>
      <joint name="first" type="continuous"><parent link="world"/><child link="between"/><axis xyz="0 0 1"/></joint>
      <joint name="second" type="continuous"><parent link="between"/><child link="body"/>
        <origin xyz="0 0 1" rpy="1.5707963267948966 0 0"/><axis xyz="0 0 1"/></joint>
      <joint name="third" type="continuous"><parent link="body"/><child link="end"/><axis xyz="0 0 1"/></joint></robot>"#;
    let (text, warnings) = written(chain, OutputFormat::Mjcf);
    assert!(
        text.contains(r#"<joint name="first" type="hinge" pos="0 -1 0" axis="0 1 0"/>"#),
        "{text}"
    );
    assert_eq!(
        warnings,
        [
            "no mass and no frame: \"between\", merged into the bodies that they carry",
            "no mass: \"end\", whose motion MuJoCo refuses",
        ]
    );
}

#[test]
fn a_description_that_is_no_tree_is_an_error() {
    let mut errors = Errors::new();
    let two = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/></robot>";
    let description = read_text(two, "r.urdf", None, &mut errors).expect("two links");
    for format in [OutputFormat::Urdf, OutputFormat::Mjcf] {
        let errors = convert(&description, format).expect_err("two roots");
        assert!(errors.to_string().contains("have no parent"), "{errors}");
    }
}
