//! Mechanics that are not modelled: one warning for each kind.

use super::{fine, warnings, warnings_in_joint};
use crate::builder::Builder;
use crate::function::Function;

/// A robot with a joint for each inner text, each in lines of its own from line 2.
fn robot(kind: &str, inner: &[&str]) -> String {
    let joints = inner.iter().enumerate().map(|(k, inner)| {
        let child = k + 1;
        format!(
            "<joint name=\"j{k}\" type=\"{kind}\"><axis xyz=\"0 0 1\"/>{inner}<parent link=\"{k}\"/>\
             <child link=\"{child}\"/></joint><link name=\"{child}\"/>\n"
        )
    });
    let joints: String = joints.collect();
    format!("<robot name=\"r\"><link name=\"0\"/>\n{joints}</robot>")
}

#[test]
fn friction_is_one_warning_for_all_moving_joints() {
    let damping = r#"<dynamics damping="0.1" friction="0.0"/>"#;
    let friction = r#"<dynamics friction = " 0.2 "/>"#;
    let none = r#"<dynamics damping="0" friction="-0.0"/>"#;
    assert_eq!(
        warnings(&robot("revolute", &[none, damping])),
        ["arm.urdf:3:53: not modelled: damping of joint \"j1\""]
    );
    assert_eq!(
        warnings(&robot("prismatic", &[damping, none, friction, damping])),
        ["arm.urdf:2:54: not modelled: damping and friction of joint \"j0\" and 2 others"]
    );
    assert_eq!(
        warnings(&robot(
            "continuous",
            &[r#"<dynamics D="1" K="7000" damping="0"/>"#]
        )),
        [
            "arm.urdf:2:65: not modelled: attribute \"D\" of the <dynamics> of joint \"j0\" and 1 other: other dynamics"
        ]
    );
    assert_eq!(warnings(&robot("fixed", &[damping])), [""; 0]);
    assert_eq!(warnings(&robot("revolute", &["<dynamics/>"])), [""; 0]);
}

#[test]
fn gears_are_one_warning_for_all_transmissions() {
    let transmission = |name: &str, reduction: &str| {
        format!(
            "<transmission name=\"{name}\"><actuator name=\"m\"><mechanicalReduction>{reduction}\
             </mechanicalReduction></actuator></transmission>\n"
        )
    };
    let text = |transmissions: &[&str]| {
        format!(
            "<robot name=\"r\"><link name=\"a\"/>\n{}</robot>",
            transmissions.concat()
        )
    };
    let one = &transmission("t", " 1.0\n");
    let hundred = &transmission("u", "100");
    assert_eq!(warnings(&text(&[one])), [""; 0]);
    assert_eq!(
        warnings(&text(&[hundred])),
        ["arm.urdf:2:43: not modelled: the reduction of transmission \"u\""]
    );
    assert_eq!(
        warnings(&text(&[one, hundred, hundred])),
        ["arm.urdf:4:43: not modelled: the reduction of transmission \"u\" and 1 other"]
    );
}

#[test]
fn limits_of_continuous_joints_are_one_warning() {
    let limits = r#"<limit lower="-3.14" upper="3.14" effort="1" velocity="1"/>"#;
    assert_eq!(
        warnings(&robot("continuous", &[limits, "", limits])),
        ["arm.urdf:2:55: not used: the limits of joint \"j0\" and 1 other, of type continuous"]
    );
    for none in [
        r#"<limit effort="1" velocity="1"/>"#,
        r#"<limit lower="0" upper="0.0"/>"#,
        r#"<limit lower="-inf" upper="inf"/>"#,
    ] {
        assert_eq!(warnings(&robot("continuous", &[none])), [""; 0], "{none}");
    }
}

#[test]
fn soft_limits_narrower_than_limits_are_a_warning() {
    let soft = |limits: &str| {
        let inner = format!(
            "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\"/>\n<safety_controller k_velocity=\"1\" {limits}/>\
             <calibration rising=\"0.1\"/>"
        );
        warnings_in_joint("revolute", &inner)
    };
    let wanted = [
        "arm.urdf:3:1: not used: the soft limits of joint \"j\", which are narrower than the limits",
    ];
    assert_eq!(
        soft("soft_lower_limit=\"-0.9\" soft_upper_limit=\"1\""),
        wanted
    );
    assert_eq!(soft("soft_upper_limit=\"0.5\""), wanted);
    for wide in [
        "",
        "soft_lower_limit=\"0\" soft_upper_limit=\"0\"",
        "soft_lower_limit=\"-1\" soft_upper_limit=\"1\" k_position=\"20\"",
        "soft_lower_limit=\"-2\" soft_upper_limit=\"1.5\"",
    ] {
        assert_eq!(soft(wide), [""; 0], "{wide}");
    }
}

#[test]
fn warnings_are_above_the_generated_code_and_strict_makes_them_errors() {
    let text = robot(
        "revolute",
        &[
            r#"<dynamics damping="0.1"/>"#,
            r#"<limit lower="1" upper="-1"/>"#,
        ],
    )
    .replace("xyz=\"0 0 1\"", "xyz=\"0 0 2\"");
    let builder = || Builder::from_description(fine(&text)).generate([Function::ForwardKinematics]);
    let source = builder().to_source().expect("a robot").to_string();
    let refused = builder().strict().to_source().expect_err("warnings");
    for warning in [
        "arm.urdf:2:45: the axis of joint",
        "arm.urdf:3:53: the lower limit of joint",
        "arm.urdf:2:53: not modelled: damping of joint",
    ] {
        assert!(source.contains(warning), "{warning}\n{source}");
        assert!(
            refused.to_string().contains(warning),
            "{warning}\n{refused}"
        );
    }
}
