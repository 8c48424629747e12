//! Errors of files that are not URDF, not expanded, or not XML.

use super::{ARM, MASS, TENSOR, errors, errors_in, errors_in_inertial, fine, warnings};

#[test]
fn a_byte_order_mark_is_ignored() {
    let text = format!("\u{feff}{ARM}");
    assert_eq!(fine(&text).links.len(), 3);
    assert_eq!(
        errors("\u{feff}<robot><link name=\"a\"/></robot>"),
        "error: arm.urdf:1:1: the robot has no attribute \"name\"\n"
    );
}

#[test]
fn other_formats_are_named() {
    assert_eq!(
        errors("<sdf version=\"1.6\"/>"),
        "error: arm.urdf:1:1: this is SDF, not URDF: the root element is <sdf>\n  \
         hint: read it as SDF: #[robot(sdf = \"…\")], Builder::from_sdf, or the command line\n"
    );
    assert!(errors("<mujoco model=\"a\"/>").contains("this is MJCF, not URDF"));
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
fn xacro_is_one_error() {
    let message = "this file contains xacro, and does not declare it\n  \
                   hint: write xmlns:xacro=\"http://www.ros.org/wiki/xacro\" in <robot …>, or end the name of the file in \
                   .xacro\n";
    let incomplete = "xacro did not know this macro, and links are missing\n  \
                      hint: read the xacro file that this one was made from, and include the file of the macro\n";
    let namespace = "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";
    assert_eq!(
        errors(&format!(
            "<robot name=\"r\" {namespace}>\n<xacro:arm prefix=\"a\"/><link/></robot>"
        )),
        format!("error: arm.urdf:2:1: {incomplete}")
    );
    assert_eq!(
        errors("<robot name=\"r\">\n<xacro:arm prefix=\"a\"/></robot>"),
        format!("error: arm.urdf:2:1: {incomplete}")
    );
    assert_eq!(
        errors_in("<link name=\"${prefix}arm\"/><link/>"),
        format!("error: arm.urdf:2:13: {message}")
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"${{m / 2}}\"/>{TENSOR}")),
        format!("error: arm.urdf:2:14: {message}")
    );
    // Expanded files keep the declaration of the namespace.
    assert_eq!(
        errors(&format!(
            "<robot name=\"r\" {namespace}><link name=\"a\"/></robot>"
        )),
        ""
    );
}

/// NASA's Valkyrie is distributed with such calls.
#[test]
fn a_macro_unknown_to_xacro_is_a_warning() {
    let call = |links: &str| {
        format!(
            "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n<xacro:imu of=\"a\"/>{links}</robot>"
        )
    };
    assert_eq!(
        warnings(&call("<link name=\"a\"/>")),
        ["arm.urdf:2:1: macro \"imu\" in robot \"r\" was not expanded by xacro and is ignored"]
    );
    // A joint may need a link that the macro would have made.
    let joint = "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>";
    assert_eq!(
        errors(&call(&format!("<link name=\"a\"/>{joint}"))),
        "error: arm.urdf:2:1: xacro did not know this macro, and links are missing\n  \
         hint: read the xacro file that this one was made from, and include the file of the macro\n"
    );
}

#[test]
fn errors_of_xml_point_at_their_place() {
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
        "error: arm.urdf:2:16: </joint> has no matching start tag\n  \
         hint: close the open element by </link>\n"
    );
    assert_eq!(
        errors("<robot name=\"r\"\nname=\"s\"/>"),
        "error: arm.urdf:2:1: attribute \"name\" occurs twice\n"
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
fn constructs_that_other_readers_ignore_are_ignored() {
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
fn a_single_ampersand_is_a_character() {
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
