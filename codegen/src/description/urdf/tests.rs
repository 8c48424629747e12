//! Every message of the reader, and texts that no reader should stumble over.

use super::*;
use crate::description::{Axis, JointKind, Number, Step};

/// An arm that moves in two ways, with a number of every kind.
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
    <dynamics damping="0.1"/>
  </joint>
  <joint name="lift" type="screw">
    <parent link="upper"/>
    <child link="tool"/>
    <axis xyz="0 0 1"/>
    <thread pitch="0.01"/>
  </joint>
</robot>
"#;

/// Reads, and gives back all that was complained of as the command line shows it.
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

/// What is said of one link or joint that stands in line 2 of a robot.
fn errors_in(item: &str) -> String {
    errors(&format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n{item}</robot>"
    ))
}

/// What is said of a joint from a to b, whose inner text stands in line 2 from column 1.
fn errors_in_joint(kind: &str, inner: &str) -> String {
    errors(&format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\
         <joint name=\"j\" type=\"{kind}\"><parent link=\"a\"/><child link=\"b\"/>\n\
         {inner}</joint></robot>"
    ))
}

/// What is said of the inertial of a link, whose inner text stands in line 2 from column 1.
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
    assert!((shoulder.axis[1].value - 0.5_f64.sqrt()).abs() < 1e-15);
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
fn a_byte_order_mark_is_no_character() {
    let text = format!("\u{feff}{ARM}");
    assert_eq!(fine(&text).links.len(), 3);
    assert_eq!(
        errors("\u{feff}<robot><link name=\"a\"/></robot>"),
        "error: arm.urdf:1:1: the robot has no attribute \"name\"\n"
    );
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
  <joint name="wrist" type="floating">
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
  hint: known types: revolute, continuous, prismatic, screw and fixed
error: arm.urdf:12:3: joint "elbow" has no <parent>
  hint: add <parent link="…"/>
error: arm.urdf:15:29: joint "wrist" is floating, and such joints are not modelled
  hint: known types: revolute, continuous, prismatic, screw and fixed
error: arm.urdf:3:15: there is another link "base"
  hint: the other one is in line 2
"#
    );
}

#[test]
fn joints_that_are_not_modelled_are_refused_by_name() {
    for kind in ["floating", "planar", "spherical"] {
        assert_eq!(
            errors_in_joint(kind, ""),
            format!(
                "error: arm.urdf:1:71: joint \"j\" is {kind}, and such joints are not modelled\n  \
                 hint: known types: revolute, continuous, prismatic, screw and fixed\n"
            )
        );
    }
    assert_eq!(
        errors_in_joint("revolute", r#"<axis xyz="0 0 1"/><mimic joint="k"/>"#),
        "error: arm.urdf:2:20: joint \"j\" mimics joint \"k\", and mimic joints are not modelled\n  \
         hint: make it fixed, or remove <mimic> to give it a coordinate of its own\n"
    );
    assert_eq!(
        errors_in_joint("revolut", ""),
        "error: arm.urdf:1:71: joint \"j\" has the unknown type \"revolut\"\n  \
         hint: did you mean \"revolute\"? known types: \
         revolute, continuous, prismatic, screw and fixed\n"
    );
    assert_eq!(
        errors_in_joint("screw", r#"<axis xyz="0 0 1"/>"#),
        "error: arm.urdf:1:49: joint \"j\" has no <thread>\n  \
         hint: add <thread pitch=\"…\"/>, in metres per radian\n"
    );
}

#[test]
fn axes_are_directions_of_length_one() {
    assert_eq!(
        errors_in_joint("revolute", r#"<axis xyz="0 0 0"/>"#),
        "error: arm.urdf:2:12: the axis of joint \"j\" is zero\n  \
         hint: give it a direction, such as 0 0 1\n"
    );
    assert_eq!(
        errors_in_joint("prismatic", r#"<axis xyz="0 3 4"/>"#),
        "error: arm.urdf:2:12: the axis of joint \"j\" has length 5 instead of 1\n  \
         hint: of length 1 it is 0 0.6 0.8\n"
    );
    assert_eq!(
        errors_in_joint("revolute", "<axis/>"),
        "error: arm.urdf:2:1: the axis of joint \"j\" has no attribute \"xyz\"\n  \
         hint: write <axis xyz=\"0 0 1\"/>\n"
    );
    assert_eq!(errors_in_joint("fixed", r#"<axis xyz="0 0 0"/>"#), "");
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn an_axis_that_is_not_written_is_x_with_a_warning() {
    let robot = fine(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n\
         <joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/></joint>\
         <joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>",
    );
    assert_eq!(robot.joints[0].axis.map(|x| x.value), [1.0, 0.0, 0.0]);
    assert_eq!(robot.warnings.len(), 1);
    let warning = &robot.warnings[0];
    assert!(matches!(warning.place, Place::File { line: 2, column: 1 }));
    assert_eq!(
        warning.message,
        "joint \"j\" has no <axis>: it moves about or along x, as URDF has it"
    );
    assert_eq!(warning.hint.as_deref(), Some("write <axis xyz=\"1 0 0\"/>"));
}

#[test]
fn a_misspelt_element_is_not_passed_over_silently() {
    let robot = fine(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"fixed\">\
         <parent link=\"a\"/><child link=\"b\"/>\n<orgin xyz=\"1 0 0\"/></joint>\
         <joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/>\n\
         <origin xzy=\"1 0 0\"/><hardware/></joint></robot>",
    );
    let said: Vec<_> = robot.warnings.iter().map(|w| w.message.as_str()).collect();
    assert_eq!(
        said,
        [
            "<orgin> in joint \"j\" is ignored",
            "attribute \"xzy\" of the origin of joint \"k\" is ignored",
        ]
    );
    assert_eq!(
        robot.warnings[0].hint.as_deref(),
        Some("did you mean <origin>?")
    );
}

#[test]
fn joints_need_a_name_a_type_and_two_links() {
    assert_eq!(
        errors_in("<joint/>"),
        "error: arm.urdf:2:1: a joint has no attribute \"name\"\n\
         error: arm.urdf:2:1: the joint without a name has no attribute \"type\"\n\
         error: arm.urdf:2:1: the joint without a name has no <parent>\n  \
         hint: add <parent link=\"…\"/>\n\
         error: arm.urdf:2:1: the joint without a name has no <child>\n  \
         hint: add <child link=\"…\"/>\n"
    );
    assert_eq!(
        errors_in(r#"<joint name="j" type="fixed"><parent link="a"/><child link=""/></joint>"#),
        "error: arm.urdf:2:61: the child of joint \"j\" has an empty attribute \"link\"\n"
    );
    assert_eq!(
        errors_in(r#"<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>"#),
        "error: arm.urdf:2:61: joint \"j\" joins link \"a\" to itself\n"
    );
    assert_eq!(
        errors_in_joint("fixed", r#"<parent link="b"/>"#),
        "error: arm.urdf:2:1: joint \"j\" has more than one <parent>\n"
    );
    let joint = r#"<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>"#;
    assert_eq!(
        errors_in(&format!("{joint}\n{joint}")),
        "error: arm.urdf:3:14: there is another joint \"j\"\n  hint: the other one is in line 2\n"
    );
}

#[test]
fn limits_are_in_order() {
    let axis = r#"<axis xyz="0 0 1"/>"#;
    assert_eq!(
        errors_in_joint(
            "revolute",
            &format!("{axis}<limit lower=\"1\" upper=\"-1\"/>")
        ),
        "error: arm.urdf:2:20: the lower limit of joint \"j\", 1, is above the upper one, -1\n"
    );
    assert_eq!(
        errors_in_joint(
            "revolute",
            &format!("{axis}<limit lower=\"nan\" velocity=\"x\"/>")
        ),
        "error: arm.urdf:2:49: the velocity limit of joint \"j\" is not a number: \"x\"\n\
         error: arm.urdf:2:34: the lower limit of joint \"j\" is not finite: \"nan\"\n"
    );
    assert_eq!(
        errors_in_joint(
            "prismatic",
            &format!("{axis}<limit lower=\"-inf\" upper=\"inf\"/>")
        ),
        ""
    );
    assert_eq!(
        errors_in_joint(
            "continuous",
            &format!("{axis}<limit lower=\"1\" upper=\"-1\"/>")
        ),
        ""
    );
    assert_eq!(errors_in_joint("revolute", &format!("{axis}<limit/>")), "");
}

#[test]
fn an_inertial_has_mass_and_inertia() {
    assert_eq!(
        errors_in_inertial(""),
        "error: arm.urdf:1:32: the inertial of link \"a\" has no <mass>\n  \
         hint: add <mass value=\"…\"/>\n\
         error: arm.urdf:1:32: the inertial of link \"a\" has no <inertia>\n  \
         hint: add <inertia ixx=\"…\" ixy=\"…\" ixz=\"…\" iyy=\"…\" iyz=\"…\" izz=\"…\"/>\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass/>{TENSOR}")),
        "error: arm.urdf:2:1: the mass of link \"a\" is missing\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"-0.5\"/>{TENSOR}")),
        "error: arm.urdf:2:14: the mass of link \"a\" is negative: -0.5\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("{MASS}{MASS}{TENSOR}")),
        "error: arm.urdf:2:18: the inertial of link \"a\" has more than one <mass>\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"0\"/>{TENSOR}")),
        ""
    );
}

#[test]
fn numbers_are_said_under_their_own_digits() {
    let origin = |text: &str| errors_in_joint("fixed", &format!("<origin {text}/>"));
    assert_eq!(
        origin("xyz=\"0 inf 0,5\""),
        "error: arm.urdf:2:16: xyz of the origin of joint \"j\" is infinite: \"inf\"\n\
         error: arm.urdf:2:20: xyz of the origin of joint \"j\" is not a number: \"0,5\"\n  \
         hint: write a decimal point, and spaces between numbers\n"
    );
    assert_eq!(
        origin("xyz = '0\n x 0'"),
        "error: arm.urdf:3:2: xyz of the origin of joint \"j\" is not a number: \"x\"\n"
    );
    assert_eq!(
        origin("rpy=\"0\""),
        "error: arm.urdf:2:14: rpy of the origin of joint \"j\" has 1 number instead of 3\n"
    );
    assert_eq!(
        origin("rpy=\"\""),
        "error: arm.urdf:2:14: rpy of the origin of joint \"j\" has 0 numbers instead of 3\n"
    );
    assert_eq!(
        origin("quat_xyzw=\"0 0 0 1\""),
        "error: arm.urdf:2:20: the origin of joint \"j\" has a quaternion, which is not read\n  \
         hint: write rpy=\"roll pitch yaw\"\n"
    );
    assert_eq!(origin("xyz=\"&#49; 0\t0\""), "");
}

#[test]
fn xacro_is_said_once() {
    let message = "this is a xacro file that has yet to be expanded to URDF\n  \
                   hint: run: xacro robot.urdf.xacro > robot.urdf\n";
    let namespace = "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";
    assert_eq!(
        errors(&format!(
            "<robot name=\"r\" {namespace}>\n<xacro:arm prefix=\"a\"/><link/></robot>"
        )),
        format!("error: arm.urdf:2:1: {message}")
    );
    assert_eq!(
        errors("<robot name=\"r\">\n<xacro:arm prefix=\"a\"/></robot>"),
        format!("error: arm.urdf:2:2: {message}")
    );
    assert_eq!(
        errors_in("<link name=\"${prefix}arm\"/><link/>"),
        format!("error: arm.urdf:2:13: {message}")
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"${{m / 2}}\"/>{TENSOR}")),
        format!("error: arm.urdf:2:14: {message}")
    );
    // The namespace alone stays behind in expanded files.
    assert_eq!(
        errors(&format!(
            "<robot name=\"r\" {namespace}><link name=\"a\"/></robot>"
        )),
        ""
    );
}

#[test]
fn what_is_no_urdf_is_said() {
    assert_eq!(
        errors("<sdf version=\"1.6\"/>"),
        "error: arm.urdf:1:1: this is not a URDF: the root element is <sdf>\n  \
         hint: convert it to URDF first\n"
    );
    assert_eq!(
        errors("<!-- x -->\n<html/>"),
        "error: arm.urdf:2:1: this is not a URDF: the root element is <html>\n  \
         hint: a URDF file begins with <robot name=\"…\">\n"
    );
    assert_eq!(errors(" \n"), "error: the file is empty\n");
    assert_eq!(
        errors("links: 7"),
        "error: arm.urdf:1:1: this is not XML\n  \
         hint: a URDF file begins with <robot name=\"…\">\n"
    );
    assert_eq!(
        errors("<robot name=\"r\"/>"),
        "error: arm.urdf:1:1: robot \"r\" has no links\n"
    );
}

#[test]
fn broken_xml_is_said_where_it_breaks() {
    assert_eq!(
        errors("<robot name=\"r\">\n<link name=\"a\"/>\n"),
        "error: arm.urdf:2:17: the file ends in the middle of an element\n  \
         hint: is the file complete?\n"
    );
    assert_eq!(
        errors("<robot name=\"r\">\n<link name=\"a"),
        "error: arm.urdf:2:14: the file ends in the middle of an element\n  \
         hint: is the file complete?\n"
    );
    assert_eq!(
        errors("<robot name=\"r\">\n<link name=\"a\"></joint></robot>"),
        "error: arm.urdf:2:16: </joint> closes nothing\n  \
         hint: the element that is open here ends with </link>\n"
    );
    assert_eq!(
        errors("<robot name=\"r\"\nname=\"s\"/>"),
        "error: arm.urdf:2:1: attribute \"name\" is given twice\n"
    );
    assert_eq!(
        errors("<robot name=\"r\">\n<gazebo:x/></robot>"),
        "error: arm.urdf:2:2: the prefix \"gazebo\" is not declared\n  \
         hint: declare it in the root element: xmlns:gazebo=\"…\"\n"
    );
    assert_eq!(
        errors("<robot name=\"r\">\n<link name=a/></robot>"),
        "error: arm.urdf:2:12: this is not well-formed XML: expected a quote not 'a'\n"
    );
    assert_eq!(
        errors("<robot name=\"&r;\"/>"),
        "error: arm.urdf:1:14: this is not well-formed XML: unknown entity reference 'r'\n"
    );
}

#[test]
fn hostile_files_are_refused_quickly() {
    let nested = |depth: usize| {
        let open = "<a>".repeat(depth);
        let close = "</a>".repeat(depth);
        format!("<robot name=\"r\"><link name=\"a\"/>{open}{close}</robot>")
    };
    assert_eq!(errors(&nested(100_000)), "");
    assert!(errors(&nested(100_000)[..200_000]).contains("the file ends in the middle"));
    assert_eq!(
        errors(&"<a>".repeat(1_000_001)),
        "error: arm.urdf:1:3000001: the file has more than 1000000 elements and attributes\n"
    );
    let attributes = (0..33)
        .map(|i| format!(" a{i}=\"\""))
        .collect::<Vec<_>>()
        .concat();
    assert_eq!(
        errors(&format!("<robot\n{attributes}/>")),
        "error: arm.urdf:1:1: an element has more than 32 attributes\n"
    );
    let namespaces = (0..65)
        .map(|i| format!("<a xmlns:n{i}=\"u\">\n"))
        .collect::<Vec<_>>()
        .concat();
    assert_eq!(
        errors(&namespaces),
        "error: arm.urdf:65:1: the file declares more than 64 namespaces\n"
    );
    assert_eq!(
        errors("<!DOCTYPE r [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]>\n<robot name=\"&c;\"/>"),
        "error: arm.urdf:1:1: the file has a <!DOCTYPE …>, which is not read\n  \
         hint: remove it, and write out the entities it defines\n"
    );
    // A comment is no element, whatever stands in it.
    let comment = format!("<!-- {} -->", "<a = = =".repeat(500_000));
    assert_eq!(
        errors(&format!(
            "{comment}<robot name=\"r\"><link name=\"a\"/></robot>"
        )),
        ""
    );
}

#[test]
fn thousands_of_mistakes_are_counted() {
    let said = errors(&format!(
        "<robot name=\"r\">{}</robot>",
        "<link/>".repeat(5000)
    ));
    assert_eq!(said.lines().count(), 1001);
    assert!(said.ends_with("and 4000 more\n"));
}

#[test]
fn every_truncation_is_survived() {
    for end in (0..ARM.len()).filter(|end| ARM.is_char_boundary(*end)) {
        let said = errors(&ARM[..end]);
        assert_eq!(
            said.is_empty(),
            end >= ARM.trim_end().len(),
            "{end}: {said}"
        );
    }
}

#[test]
fn random_changes_are_survived() {
    // A linear congruential generator is random enough to break XML, and the same everywhere.
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
        usize::try_from(state >> 33).unwrap_or(0) % below
    };
    let bytes = b"<>/\"'=&;!-[]?x0.- \n\t\xc3\xa4\x00:eE+$#{";
    for _ in 0..4000 {
        let mut text = ARM.as_bytes().to_vec();
        for _ in 0..=random(6) {
            let at = random(text.len());
            match random(3) {
                0 => text[at] = bytes[random(bytes.len())],
                1 => text.insert(at, bytes[random(bytes.len())]),
                _ => {
                    text.drain(at..(at + random(12)).min(text.len()));
                }
            }
        }
        let _ = errors(&String::from_utf8_lossy(&text));
    }
}
