//! Origins: translations, angles, quaternions.

use super::{errors_in_joint, fine, warnings_in_joint};
use crate::description::Step;

fn origin(version: &str, attributes: &str) -> String {
    format!(
        "<robot name=\"r\"{version}><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"fixed\">\
         <parent link=\"a\"/><child link=\"b\"/>\n<origin {attributes}/></joint></robot>"
    )
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn a_quaternion_of_version_1_1_is_read() {
    let robot = fine(&origin(
        " version=\"1.1\"",
        "xyz=\"1 2 3\" quat_xyzw=\"0.1 -0.2 0.3 0.927362\"",
    ));
    let [Step::Translate(_), Step::Quaternion(entries)] = &robot.joints[0].origin[..] else {
        panic!("{:?}", robot.joints[0].origin);
    };
    assert_eq!(
        entries.map(|entry| entry.value),
        [0.1, -0.2, 0.3, 0.927_362]
    );
    assert_eq!(entries[3].resolution, 1e-6);
    assert!(robot.warnings.is_empty(), "{:?}", robot.warnings);
}

#[test]
fn a_quaternion_of_another_version_is_read_with_a_warning() {
    for version in ["", " version=\"1.0\""] {
        let robot = fine(&origin(version, "quat_xyzw=\"0 0 0 1\""));
        assert_eq!(robot.joints[0].origin.len(), 1);
        let messages: Vec<_> = robot.warnings.iter().map(|w| w.message.as_str()).collect();
        assert_eq!(
            messages,
            [
                "quat_xyzw of the origin of joint \"j\" needs URDF 1.1, but the robot has no such version"
            ]
        );
    }
    let robot = fine(&origin(" version=\"2.0\"", ""));
    let messages: Vec<_> = robot.warnings.iter().map(|w| w.message.as_str()).collect();
    assert_eq!(
        messages,
        ["robot \"r\" has the unknown version \"2.0\", and is read as 1.1"]
    );
}

#[test]
fn a_quaternion_of_another_length_is_a_warning_unless_its_digits_explain_it() {
    let warnings_of = |quaternion: &str| {
        let robot = fine(&origin(
            " version=\"1.1\"",
            &format!("quat_xyzw=\"{quaternion}\""),
        ));
        let warnings = robot.warnings.iter();
        warnings.map(|w| w.message.clone()).collect::<Vec<_>>()
    };
    assert_eq!(warnings_of("0.707 0 0 0.707"), [""; 0]);
    assert_eq!(warnings_of("0.7071068 0 0 0.7071068"), [""; 0]);
    assert_eq!(
        warnings_of("0 0 0 2"),
        ["quat_xyzw of the origin of joint \"j\" has length 2, and is normalised"]
    );
    assert_eq!(warnings_of("0.7072000 0 0 0.7072000").len(), 1);
}

#[test]
fn wrong_rotations_are_errors() {
    assert_eq!(
        errors_in_joint("fixed", "<origin quat_xyzw=\"0 0 0 0\"/>"),
        "error: arm.urdf:2:20: quat_xyzw of the origin of joint \"j\" is zero\n  \
         hint: give it a rotation, such as 0 0 0 1\n"
    );
    assert_eq!(
        errors_in_joint("fixed", "<origin rpy=\"0 0 1\" quat_xyzw=\"0 0 0 1\"/>"),
        "error: arm.urdf:2:21: the origin of joint \"j\" has both rpy and quat_xyzw\n  \
         hint: leave one of them out\n"
    );
    assert_eq!(
        errors_in_joint("fixed", "<origin quat_xyzw=\"0 0 1\"/>"),
        "error: arm.urdf:2:20: quat_xyzw of the origin of joint \"j\" has 3 numbers instead of 4\n"
    );
}

#[test]
fn an_angle_of_more_than_a_revolution_is_a_warning() {
    let warnings_of = |rpy: &str| warnings_in_joint("fixed", &format!("<origin rpy=\"{rpy}\"/>"));
    assert_eq!(
        warnings_of("90 0 0"),
        [
            "arm.urdf:2:14: rpy of the origin of joint \"j\" has an angle of 90 rad, more than one revolution"
        ]
    );
    assert_eq!(warnings_of("0 -45 180").len(), 1);
    for meant in ["3.14159265 0 -3.1416", "6.28 -6.283185307179587 6.2832"] {
        assert_eq!(warnings_of(meant), [""; 0], "{meant}");
    }
}
