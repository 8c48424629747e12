//! What is said of files that are no URDF, or not yet, or no XML.

use super::{ARM, MASS, TENSOR, errors, errors_in, errors_in_inertial, fine, warnings};

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
fn what_is_no_urdf_is_said() {
    assert_eq!(
        errors("<sdf version=\"1.6\"/>"),
        "error: arm.urdf:1:1: this is SDF, which describes worlds, and not URDF: the root element is <sdf>\n  \
         hint: give the URDF that it was made of; or convert it, as by the tools of ROS for SDF, and look at what \
         `homogen check` says of the result\n"
    );
    assert!(errors("<mujoco model=\"a\"/>").contains("this is MJCF, the format of MuJoCo"));
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
        format!("error: arm.urdf:2:1: {message}")
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

/// NASA's Valkyrie is passed on like that.
#[test]
fn a_macro_that_xacro_did_not_know_is_passed_over_with_a_warning() {
    let call = |links: &str| {
        format!(
            "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n<xacro:imu of=\"a\"/>{links}</robot>"
        )
    };
    assert_eq!(
        warnings(&call("<link name=\"a\"/>")),
        ["arm.urdf:2:1: macro \"imu\" that xacro left in robot \"r\" is ignored"]
    );
    // A joint may want a link that a macro would have made.
    let joint = "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>";
    assert_eq!(
        errors(&call(&format!("<link name=\"a\"/>{joint}"))),
        "error: arm.urdf:2:1: this is a xacro file that has yet to be expanded to URDF\n  \
         hint: run: xacro robot.urdf.xacro > robot.urdf\n"
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
        errors("<robot name=\"r\">\n<link name=a/></robot>"),
        "error: arm.urdf:2:12: this is not well-formed XML: expected a quote not 'a'\n"
    );
    assert_eq!(
        errors("<!DOCTYPE r [\n<robot name=\"r\"/>"),
        "error: arm.urdf:1:1: <!DOCTYPE …> does not end\n  hint: remove it\n"
    );
}

#[test]
fn what_other_readers_pass_over_is_passed_over() {
    let link = "<link name=\"a\"/>";
    for text in [
        format!("\n \n<?xml version=\"1.0\"?>\n<robot name=\"r\">{link}</robot>"),
        format!("<!DOCTYPE robot SYSTEM \"r.dtd\"><robot name=\"r\">{link}</robot>"),
        format!("<robot name=\"r\"><!-- a -- b -->{link}</robot>"),
        format!(
            "<robot name=\"r\">{link}<gazebo><drake:joint name=\"j\" drake:x=\"1\"/></gazebo></robot>"
        ),
        format!("<robot name=\"r\" xmlns:g=\"g\" xsi:schemaLocation=\"g\">{link}</robot>"),
        format!("<robot name=\"r\" xmlns=\"http://www.ros.org\">{link}</robot>"),
        format!("<robot name=\"r\">this & that{link}</robot>"),
        format!("<robot name=\"r\">{link}</robot>\n\0"),
    ] {
        assert_eq!(errors(&text), "", "{text}");
        assert_eq!(warnings(&text), [""; 0], "{text}");
        assert_eq!(fine(&text).links.len(), 1, "{text}");
    }
}

#[test]
fn an_ampersand_is_a_character_where_it_begins_no_reference() {
    let robot = fine("<robot name=\"this & that &amp;\n&#66;\"><link name=\"&l;\"/></robot>");
    assert_eq!(robot.name.text, "this & that & B");
    assert_eq!(robot.links[0].name.text, "&l;");
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"&m;\"/>{TENSOR}")),
        "error: arm.urdf:2:14: the mass of link \"a\" is not a number: \"&m;\"\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("{MASS}{TENSOR}<drake:mass value=\"x\"/>")),
        ""
    );
}
