//! Classes of defaults.

use super::{errors, fine, inertial, joint, near};
use crate::joint::actuator::ActuatorQuantity;

/// The damping of the joint of a body with these defaults and attributes.
fn damping(defaults: &str, body: &str, joint_attributes: &str) -> Option<f64> {
    let text = format!(
        "<mujoco>{defaults}<worldbody><body name=\"a\" {body}><body name=\"b\">\
         <joint name=\"j\" {joint_attributes}/></body></body></worldbody></mujoco>"
    );
    let robot = fine(&text);
    let actuator = &joint(&robot, "j").actuator;
    actuator
        .of(ActuatorQuantity::Damping)
        .first()
        .map(|number| number.value)
}

const NESTED: &str = "<default><joint damping=\"1\"/><default class=\"o\"><joint damping=\"2\"/>\
                      <default class=\"i\"><joint armature=\"5\"/></default></default></default>";

#[test]
fn the_innermost_value_counts() {
    assert_eq!(damping(NESTED, "", ""), Some(1.0));
    assert_eq!(damping(NESTED, "childclass=\"i\"", ""), Some(2.0));
    assert_eq!(
        damping(NESTED, "childclass=\"i\"", "class=\"main\""),
        Some(1.0)
    );
    assert_eq!(damping(NESTED, "", "class=\"o\""), Some(2.0));
    assert_eq!(
        damping(NESTED, "childclass=\"o\"", "damping=\"3\""),
        Some(3.0)
    );
    assert_eq!(damping(NESTED, "", "damping=\"0\""), None);
}

/// A class inherits what its outer class has at that point of the text.
#[test]
fn earlier_classes_do_not_inherit_from_later_sections() {
    let later = format!("{NESTED}<default><joint damping=\"7\"/></default>");
    assert_eq!(damping(&later, "", ""), Some(7.0));
    assert_eq!(damping(&later, "", "class=\"i\""), Some(2.0));
    let before = format!("<default><default class=\"p\"/></default>{NESTED}");
    assert_eq!(damping(&before, "", "class=\"p\""), None);
}

#[test]
fn classes_do_not_apply_to_a_freejoint() {
    let text = |joint: &str| {
        let world = format!("<worldbody><body name=\"a\">{joint}</body></worldbody>");
        fine(&format!("<mujoco>{NESTED}{world}</mujoco>"))
    };
    let damped = |joint_text: &str| {
        let robot = text(joint_text);
        !joint(&robot, "j")
            .actuator
            .of(ActuatorQuantity::Damping)
            .is_empty()
    };
    assert!(damped("<joint name=\"j\" type=\"free\"/>"));
    assert!(!damped("<freejoint name=\"j\"/>"));
}

/// The mass of a geom under these defaults.
fn mass(defaults: &str, attributes: &str) -> f64 {
    let text = format!(
        "<mujoco><default>{defaults}</default><worldbody><body name=\"a\"><geom {attributes}/></body></worldbody></mujoco>"
    );
    inertial(&fine(&text), "a").mass.value
}

#[test]
fn each_entry_of_size_has_its_own_default() {
    let of_a_box = "<geom type=\"box\" size=\"0.1 0.2 0.3\" density=\"100\"/>";
    near(mass(of_a_box, ""), 100.0 * 8.0 * 0.006);
    near(mass(of_a_box, "size=\"0.5\""), 100.0 * 8.0 * 0.03);
    near(
        mass(of_a_box, "size=\"0.5 0.5\" density=\"10\""),
        10.0 * 8.0 * 0.075,
    );
    near(mass(of_a_box, "mass=\"3\""), 3.0);
    near(
        mass(
            "<geom type=\"box\" size=\"1 1 1\" mass=\"2\"/>",
            "density=\"5\"",
        ),
        2.0,
    );
}

#[test]
fn an_orientation_replaces_other_forms_of_a_class() {
    let upright = |attributes: &str| {
        let text = format!(
            "<mujoco><default><geom type=\"box\" size=\"1 1 2\" euler=\"0 90 0\"/></default>\
             <worldbody><body name=\"a\"><geom {attributes}/></body></worldbody></mujoco>"
        );
        let robot = fine(&text);
        let found = inertial(&robot, "a");
        super::pose(&found.origin).0[2][2]
    };
    near(upright(""), 0.0);
    near(upright("quat=\"1 0 0 0\""), 1.0);
    near(upright("euler=\"0 0 0\""), 1.0);
    near(upright("zaxis=\"1 0 0\""), 0.0);
}

#[test]
fn unknown_and_unnamed_classes_are_errors() {
    assert_eq!(
        errors(
            "<mujoco><worldbody><body>\n<joint class=\"arn\"/></body></worldbody><default><default class=\"arm\"/></default></mujoco>"
        ),
        "error: arm.xml:2:15: there is no class of defaults \"arn\"\n  \
         hint: did you mean \"arm\"? known classes: arm and main\n"
    );
    assert_eq!(
        errors(
            "<mujoco><default><default class=\"a\"/>\n<default class=\"a\"/></default></mujoco>"
        ),
        "error: arm.xml:2:17: the class of defaults \"a\" is defined twice\n"
    );
    assert!(
        errors("<mujoco><default><default/></default></mujoco>")
            .contains("a class of defaults has no name")
    );
    assert!(
        errors("<mujoco><default class=\"a\"/></mujoco>")
            .contains("the outermost class of defaults has the name \"a\"")
    );
}
