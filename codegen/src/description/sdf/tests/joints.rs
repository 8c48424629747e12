//! Types, axes, limits and couplings of joints.

use super::{errors, is_at, joint, link, model, with};
use crate::description::Description;
use crate::joint::JointKind;
use crate::joint::actuator::ActuatorQuantity;

/// Two links, and a joint with these elements.
fn moving(kind: &str, elements: &str) -> String {
    let links = [link("a", ""), link("b", "<pose>0 0 1 0 0 0</pose>")].concat();
    with(&format!(
        "{links}<joint name=\"j\" type=\"{kind}\"><parent>a</parent><child>b</child>{elements}</joint>"
    ))
}

fn axis(robot: &Description) -> [f64; 3] {
    joint(robot, "j").axis.map(|entry| entry.value)
}

#[test]
fn types_are_those_of_urdf() {
    let z = "<axis><xyz>0 0 1</xyz></axis>";
    let limited = "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>2</upper><effort>-1</effort>\
                   <velocity>3</velocity></limit></axis>";
    let two = format!("{z}<axis2><xyz>1 0 0</xyz></axis2>");
    for (kind, elements, word) in [
        ("revolute", z, "continuous"),
        ("revolute", limited, "revolute"),
        ("continuous", limited, "continuous"),
        ("prismatic", z, "prismatic"),
        ("ball", "", "spherical"),
        ("fixed", "", "fixed"),
        ("universal", &two, "universal"),
        ("revolute2", &two, "universal"),
    ] {
        let robot = model(&moving(kind, elements));
        assert_eq!(joint(&robot, "j").kind.word(), word, "{kind}");
    }
    let robot = model(&moving("revolute", limited));
    let limits = joint(&robot, "j").limits.expect("limits");
    assert_eq!(
        (limits.lower, limits.upper, limits.velocity),
        (-1.0, 2.0, 3.0)
    );
    assert!(limits.effort.is_infinite());
    let old = limited.replace("-1<", "-1e16<").replace("2<", "1e16<");
    let robot = model(&moving("revolute", &old));
    assert_eq!(joint(&robot, "j").kind.word(), "continuous");
}

#[test]
fn pitches_of_screws_have_two_units() {
    let z = "<axis><xyz>0 0 1</xyz></axis>";
    let pitch = |element: &str| {
        let robot = model(&moving("screw", &format!("{z}{element}")));
        match joint(&robot, "j").kind {
            JointKind::Screw { pitch } => pitch.value,
            other => panic!("{other:?}"),
        }
    };
    let per_turn = pitch("<screw_thread_pitch>0.01</screw_thread_pitch>");
    assert!((per_turn - 0.01 / std::f64::consts::TAU).abs() < 1e-18);
    // Radians per metre of a left-handed thread.
    assert!((pitch("<thread_pitch>-200</thread_pitch>") - 0.005).abs() < 1e-18);
}

#[test]
fn axes_are_in_the_frame_of_the_joint_or_another() {
    let quarter = "1.5707963267948966";
    let robot = model(&moving("revolute", "<axis><xyz>0 0 1</xyz></axis>"));
    assert_eq!(axis(&robot), [0.0, 0.0, 1.0]);
    assert_eq!(robot.links.len(), 2);
    // A joint away from its child moves an auxiliary link.
    let robot = model(&moving(
        "revolute",
        &format!("<pose>0 0 -1 0 {quarter} 0</pose><axis><xyz>0 0 1</xyz></axis>"),
    ));
    assert_eq!(joint(&robot, "j").child.text, "b.j");
    assert_eq!(axis(&robot), [0.0, 0.0, 1.0]);
    is_at(&joint(&robot, "j").origin, [0.0; 3], [0.0, 0.0, -1.0]);
    is_at(
        &joint(&robot, "b.j").origin,
        [-1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
    );
    // In the axes of the model, at the origin of the joint.
    let child = link("b", &format!("<pose>0 0 1 0 {quarter} 0</pose>"));
    for axis in [
        "<axis><xyz expressed_in=\"__model__\">0 0 1</xyz></axis>",
        "<axis><xyz expressed_in=\"a\">0 0 1</xyz></axis>",
        "<axis><xyz>0 0 1</xyz><use_parent_model_frame>1</use_parent_model_frame></axis>",
    ] {
        let text = with(&format!(
            "{}{child}<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child>{axis}</joint>",
            link("a", "")
        ));
        let robot = model(&text);
        is_at(&joint(&robot, "j").origin, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
        is_at(&joint(&robot, "b.j").origin, [0.0; 3], [0.0, 0.0, -1.0]);
    }
    // As version 1.4 has all axes.
    let text = with(&format!(
        "{}{child}<joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>",
        link("a", "")
    ));
    let robot = model(&text.replace("1.9", "1.4"));
    is_at(&joint(&robot, "j").origin, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
}

#[test]
fn joints_connect_frames_and_the_world() {
    let text = with(&format!(
        "<frame name=\"flange\" attached_to=\"b\"><pose relative_to=\"b\">0 0 0.5 0 0 0</pose></frame>{}{}\
         <joint name=\"base\" type=\"prismatic\"><parent>world</parent><child>a</child><axis><xyz>1 0 0</xyz></axis></joint>\
         <joint name=\"j\" type=\"revolute\"><parent>a</parent><child>flange</child><axis><xyz>0 0 1</xyz></axis></joint>",
        link("a", "<pose>0 0 2 0 0 0</pose>"),
        link("b", "<pose>0 0 3 0 0 0</pose>"),
    ));
    let robot = model(&text);
    assert_eq!(joint(&robot, "base").parent.text, "world");
    is_at(
        &joint(&robot, "base").origin,
        [0.0, 0.0, 2.0],
        [1.0, 0.0, 0.0],
    );
    // The joint is at the frame that its child names.
    is_at(&joint(&robot, "j").origin, [0.0, 0.0, 1.5], [1.0, 0.0, 0.0]);
    let swapped = text.replace(
        "<parent>world</parent><child>a</child>",
        "<parent>a</parent><child>world</child>",
    );
    assert!(
        errors(&swapped)
            .contains("the child of joint \"base\" is \"world\"\n  hint: swap parent and child")
    );
}

#[test]
fn friction_and_rotors_are_kept() {
    let robot = model(&moving(
        "revolute",
        "<axis><xyz>0 0 1</xyz><dynamics><damping>0.5</damping><friction>0.25</friction></dynamics></axis>\
         <drake:rotor_inertia>1e-4</drake:rotor_inertia><drake:gear_ratio>50</drake:gear_ratio>",
    ));
    let actuator = &joint(&robot, "j").actuator;
    for (quantity, value) in [
        (ActuatorQuantity::Damping, 0.5),
        (ActuatorQuantity::Friction, 0.25),
        (ActuatorQuantity::Rotor, 1e-4),
        (ActuatorQuantity::Ratio, 50.0),
    ] {
        assert_eq!(actuator.of(quantity)[0].value, value, "{quantity:?}");
    }
}

#[test]
fn joints_follow_others() {
    let hinges = |mimic: &str, gearbox: &str| {
        with(&format!(
            "{}{}{}<joint name=\"first\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>\
             <joint name=\"second\" type=\"revolute\"><parent>a</parent><child>c</child><axis><xyz>0 0 -1</xyz>{mimic}</axis></joint>\
             {gearbox}",
            link("a", ""),
            link("b", ""),
            link("c", "")
        ))
    };
    let of = |robot: &Description| {
        let mimic = joint(robot, "second").mimic.clone().expect("a mimic joint");
        assert_eq!(mimic.mimicked.text, "first");
        (mimic.multiplier.value, mimic.offset.value)
    };
    let mimic = "<mimic joint=\"first\"><multiplier>2</multiplier><offset>0.5</offset><reference>1</reference></mimic>";
    assert_eq!(of(&model(&hinges(mimic, ""))), (2.0, -1.5));
    // θ₂ = −ratio θ₁ about one direction; the second hinge turns about the opposite one.
    let gearbox = "<joint name=\"gear\" type=\"gearbox\"><parent>b</parent><child>c</child>\
        <gearbox_ratio>3</gearbox_ratio><gearbox_reference_body>a</gearbox_reference_body>\
        <axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 1</xyz></axis2></joint>";
    assert_eq!(of(&model(&hinges("", gearbox))), (3.0, 0.0));
    let other = gearbox.replace("<axis2><xyz>0 0 1", "<axis2><xyz>0 0 -1");
    assert_eq!(of(&model(&hinges("", &other))), (-3.0, 0.0));
    let loose = gearbox.replace("<gearbox_reference_body>a", "<gearbox_reference_body>b");
    let robot = model(&hinges("", &loose));
    assert!(
        robot.warnings[0]
            .message
            .starts_with("not modelled: gearbox \"gear\"")
    );
}

#[test]
fn mistakes_of_joints_have_their_places() {
    for (text, message) in [
        (moving("\nhinge", ""), "error: arm.sdf:1:"),
        (moving("revolute", ""), "joint \"j\" has no <axis>"),
        (
            moving("revolute", "<axis><xyz>0 0 0</xyz></axis>"),
            "the axis of joint \"j\" is zero",
        ),
        (
            moving("screw", "<axis/>"),
            "joint \"j\" has no <screw_thread_pitch>",
        ),
        (
            moving("fixed", "").replace("<child>b", "<child>c"),
            "there is no link, joint or frame \"c\"",
        ),
        (
            moving("fixed", "").replace("<child>b", "<child>a"),
            "joint \"j\" joins link \"a\" to itself",
        ),
        (
            moving("fixed", "").replace("<parent>a</parent>", ""),
            "joint \"j\" has no <parent>",
        ),
    ] {
        let errors = errors(&text);
        assert!(errors.contains(message), "{errors}");
    }
}
