//! Errors of joints: types, axes, links and limits.

use super::{errors_in, errors_in_joint, fine, warnings_in_joint};
use crate::error::Place;
use crate::joint::ALL;
use crate::wording::list;

#[test]
fn unknown_types_are_errors() {
    let types = list(ALL.map(|kind| kind.word));
    assert_eq!(
        errors_in_joint("revolut", ""),
        format!(
            "error: arm.urdf:1:71: joint \"j\" has the unknown type \"revolut\"\n  \
             hint: did you mean \"revolute\"? known types: {types}\n"
        )
    );
    assert_eq!(
        errors_in_joint("ball", ""),
        "error: arm.urdf:1:71: joint \"j\" has the unknown type \"ball\"\n  \
         hint: write spherical\n"
    );
    assert_eq!(
        errors_in_joint("screw", r#"<axis xyz="0 0 1"/>"#),
        "error: arm.urdf:1:49: joint \"j\" has no <thread>\n  \
         hint: add <thread pitch=\"…\"/>, in metres per radian\n"
    );
    assert_eq!(
        errors_in_joint("universal", r#"<axis xyz="0 0 1"/>"#),
        "error: arm.urdf:1:49: joint \"j\" has no <axis2>\n  \
         hint: add <axis2 xyz=\"0 1 0\"/>, in the frame of its child\n"
    );
}

#[test]
fn mimic_joints_are_read() {
    let axis = r#"<axis xyz="0 0 1"/>"#;
    assert_eq!(
        errors_in_joint("revolute", &format!("{axis}<mimic/>")),
        "error: arm.urdf:2:20: the <mimic> of joint \"j\" has no attribute \"joint\"\n"
    );
    let mimic = r#"<mimic joint="k" multiplier="half" offset="nan"/>"#;
    assert_eq!(
        errors_in_joint("revolute", &format!("{axis}{mimic}")),
        "error: arm.urdf:2:49: the multiplier of the <mimic> of joint \"j\" is not a number: \"half\"\n"
    );
    assert_eq!(errors_in_joint("spherical", r#"<axis xyz="0 0 0"/>"#), "");
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
fn axes_are_directions() {
    assert_eq!(
        errors_in_joint("revolute", r#"<axis xyz="0 0 0"/>"#),
        "error: arm.urdf:2:12: the axis of joint \"j\" is zero\n  \
         hint: give it a direction, such as 0 0 1\n"
    );
    assert_eq!(
        errors_in_joint("revolute", "<axis/>"),
        "error: arm.urdf:2:1: the axis of joint \"j\" has no attribute \"xyz\"\n  \
         hint: write <axis xyz=\"0 0 1\"/>\n"
    );
    assert_eq!(
        errors_in_joint("revolute", r#"<axis xyz="0 0 inf"/>"#),
        "error: arm.urdf:2:16: the axis of joint \"j\" is infinite: \"inf\"\n"
    );
    assert_eq!(errors_in_joint("fixed", r#"<axis xyz="0 0 0"/>"#), "");
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn an_axis_of_another_length_is_kept_with_a_warning() {
    let robot = fine(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n\
         <joint name=\"j\" type=\"prismatic\"><parent link=\"a\"/><child link=\"b\"/>\
         <axis xyz=\"0 3 4\"/></joint></robot>",
    );
    assert_eq!(robot.joints[0].axis.map(|x| x.value), [0.0, 0.75, 1.0]);
    assert_eq!(
        robot.warnings[0].hint.as_deref(),
        Some("the unit vector is 0 0.6 0.8")
    );
    assert_eq!(
        warnings_in_joint("prismatic", r#"<axis xyz="0 3 4"/>"#),
        ["arm.urdf:2:12: the axis of joint \"j\" has length 5, and is normalised"]
    );
    assert!(warnings_in_joint("revolute", r#"<axis xyz="0.577 0.577 0.577"/>"#).is_empty());
}

#[test]
fn a_repeated_element_must_be_equal() {
    let axis = r#"<axis xyz="0 0 1"/>"#;
    assert_eq!(
        warnings_in_joint("revolute", &format!("{axis}{axis}")),
        ["arm.urdf:2:20: joint \"j\" has the same <axis> twice"]
    );
    assert_eq!(
        errors_in_joint("revolute", &format!("{axis}<axis xyz=\"0 1 0\"/>")),
        "error: arm.urdf:2:20: joint \"j\" has more than one <axis>\n"
    );
}

#[test]
fn a_fixed_joint_ignores_mimic() {
    assert_eq!(
        warnings_in_joint("fixed", r#"<mimic joint="k"/>"#),
        ["arm.urdf:2:1: joint \"j\" is fixed, and its <mimic> is ignored"]
    );
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn a_missing_axis_is_x_with_a_warning() {
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
        "joint \"j\" has no <axis>: its axis is x, as URDF defines"
    );
    assert_eq!(warning.hint.as_deref(), Some("write <axis xyz=\"1 0 0\"/>"));
}

#[test]
fn limits_out_of_order_are_ignored_with_a_warning() {
    let robot = fine(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\
         <joint name=\"j\" type=\"prismatic\"><parent link=\"a\"/><child link=\"b\"/>\n\
         <axis xyz=\"1 0 0\"/><limit lower=\"1\" upper=\"-1\" velocity=\"2\"/></joint></robot>",
    );
    let limits = robot.joints[0].limits.unwrap();
    assert!(limits.lower == f64::NEG_INFINITY && limits.upper == f64::INFINITY);
    assert!((limits.velocity - 2.0).abs() < f64::EPSILON);
    assert_eq!(
        robot.source.errors().locate(&robot.warnings[0]),
        "arm.urdf:2:20: the lower limit of joint \"j\", 1, is above the upper one, -1: \
         read as unlimited"
    );
}

#[test]
fn limits_are_numbers() {
    let axis = r#"<axis xyz="0 0 1"/>"#;
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
    assert_eq!(errors_in_joint("revolute", &format!("{axis}<limit/>")), "");
}
