//! Errors of elements and numbers that do not depend on the element around them.

use super::{TENSOR, errors_in_joint, fine, warnings};

#[test]
fn a_misspelt_element_is_a_warning() {
    let robot = fine(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"fixed\">\
         <parent link=\"a\"/><child link=\"b\"/>\n<orgin xyz=\"1 0 0\"/></joint>\
         <joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/>\n\
         <origin xzy=\"1 0 0\"/><hardware/></joint></robot>",
    );
    let messages: Vec<_> = robot.warnings.iter().map(|w| w.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "<orgin> in joint \"j\" is ignored",
            "attribute \"xzy\" of the <origin> of joint \"k\" is ignored",
            "<hardware> in joint \"k\" is ignored",
        ]
    );
    assert_eq!(
        robot.warnings[0].hint.as_deref(),
        Some("did you mean <origin>?")
    );
}

#[test]
fn errors_of_numbers_point_at_their_digits() {
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
        origin("xyz=\"0,0,1\""),
        "error: arm.urdf:2:14: xyz of the origin of joint \"j\" has 1 number instead of 3\n  \
         hint: write spaces between numbers, and decimal points in them\n"
    );
    assert_eq!(
        origin("xyz=\"0 0\u{a0}1\""),
        "error: arm.urdf:2:17: xyz of the origin of joint \"j\" has a no-break space (U+00A0) in it\n  \
         hint: write a space\n"
    );
    assert_eq!(
        origin("rpy=\"\u{2212}1 0 0\""),
        "error: arm.urdf:2:14: rpy of the origin of joint \"j\" has a minus sign that is not a hyphen (U+2212) \
         in it\n  hint: write -\n"
    );
    assert_eq!(origin("xyz=\"&#49; 0\t0\""), "");
}

/// Hands of Unitree have a line break there, and no inertia in other readers.
#[test]
fn white_space_after_a_number_is_a_warning() {
    let text = |mass: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"><inertial>\n<mass value=\"{mass}\"/>{TENSOR}</inertial></link></robot>"
        )
    };
    let message = "arm.urdf:2:14: the mass of link \"a\" ends in white space, which is ignored";
    assert_eq!(warnings(&text("0.5\r\n")), [message]);
    assert_eq!(warnings(&text("0.5 ")), [message]);
    assert_eq!(warnings(&text(" 0.5")), Vec::<String>::new());
    let mass = |written| {
        fine(&text(written)).links[0]
            .inertial
            .as_ref()
            .map(|of| of.mass.value)
    };
    assert_eq!(mass("0.5\r\n"), mass("0.5"));
}
