//! Joints: types, placements, limits, friction and armature.

use std::f64::consts::PI;

use super::{all_near, errors, fine, in_world, joint, near, pose, values, warnings};
use crate::joint::actuator::ActuatorQuantity;

#[test]
fn several_joints_of_a_body_are_in_series() {
    let robot = fine(&in_world(
        "<body name=\"a\" pos=\"1 0 0\"><joint name=\"x\" type=\"slide\" axis=\"1 0 0\"/>\
         <joint name=\"y\" axis=\"0 1 0\" pos=\"0 0 2\"/><joint name=\"z\" pos=\"0 0 2\"/>\
         <joint type=\"slide\"/></body>",
    ));
    let ends: Vec<[&str; 3]> = (robot.joints.iter())
        .map(|joint| [&*joint.name.text, &*joint.parent.text, &*joint.child.text])
        .collect();
    assert_eq!(
        ends,
        [
            ["x", "world", "a.x"],
            ["y", "a.x", "a.y"],
            ["z", "a.y", "a.z"],
            ["a_slide", "a.z", "a.a_slide"],
            ["a", "a.a_slide", "a"],
        ]
    );
    let places = ["x", "y", "z", "a_slide", "a"].map(|name| pose(&joint(&robot, name).origin).1);
    all_near(places[0], [1.0, 0.0, 0.0]);
    all_near(places[1], [0.0, 0.0, 2.0]);
    all_near(places[2], [0.0; 3]);
    all_near(places[3], [0.0; 3]);
    all_near(places[4], [0.0, 0.0, -2.0]);
}

#[test]
fn frames_move_joints() {
    let robot = fine(&in_world(
        "<body name=\"a\"><frame pos=\"1 2 3\" euler=\"0 0 1.5707963267948966\">\
         <joint name=\"j\" pos=\"1 0 0\" axis=\"1 0 0\"/></frame></body>",
    ));
    let found = joint(&robot, "j");
    all_near(values(found.axis), [0.0, 1.0, 0.0]);
    all_near(pose(&found.origin).1, [1.0, 3.0, 3.0]);
}

#[test]
fn a_reference_is_the_coordinate_of_the_described_configuration() {
    let robot = fine(
        "<mujoco><worldbody><body name=\"a\"><joint name=\"h\" axis=\"0 0 -1\" ref=\"90\"/>\
         <body name=\"b\"><joint name=\"s\" type=\"slide\" axis=\"0 3 4\" ref=\"10\"/></body></body></worldbody></mujoco>",
    );
    let (rotation, _) = pose(&joint(&robot, "h").origin);
    all_near(rotation[0], [0.0, -1.0, 0.0]);
    let (_, position) = pose(&joint(&robot, "s").origin);
    all_near(position, [0.0, -6.0, -8.0]);
}

/// Lower and upper limit of a joint.
fn limits(compiler: &str, attributes: &str) -> Option<[f64; 2]> {
    let text = format!(
        "<mujoco><compiler {compiler}/><worldbody><body><joint name=\"j\" {attributes}/></body></worldbody></mujoco>"
    );
    let robot = fine(&text);
    let limits = joint(&robot, "j").limits?;
    limits
        .lower
        .is_finite()
        .then_some([limits.lower, limits.upper])
}

#[test]
fn a_range_is_a_limit_by_limited_or_autolimits() {
    assert_eq!(limits("", ""), None);
    let [lower, upper] = limits("", "range=\"-90 180\"").unwrap();
    near(lower, -PI / 2.0);
    near(upper, PI);
    assert_eq!(
        limits("angle=\"radian\"", "range=\"-1 2\""),
        Some([-1.0, 2.0])
    );
    assert_eq!(
        limits("", "type=\"slide\" range=\"-1 2\""),
        Some([-1.0, 2.0])
    );
    assert_eq!(limits("", "range=\"-1 2\" limited=\"false\""), None);
    assert_eq!(
        limits(
            "autolimits=\"false\"",
            "type=\"slide\" range=\"-1 2\" limited=\"true\""
        ),
        Some([-1.0, 2.0])
    );
    let refusal = errors(
        "<mujoco><compiler autolimits=\"false\"/><worldbody><body>\n<joint range=\"-1 2\"/></body></worldbody></mujoco>",
    );
    assert!(refusal.contains("arm.xml:2:1: a joint of body \"body_1\" has a range, but autolimits is false and it has no limited"), "{refusal}");
    let refusal = errors(&in_world("<body><joint name=\"j\" range=\"2 1\"/></body>"));
    assert!(
        refusal.contains("the range of joint \"j\" is from 2 to 1"),
        "{refusal}"
    );
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn actuatorfrcrange_is_the_effort_limit() {
    let robot = fine(&in_world(
        "<body><joint name=\"j\" actuatorfrcrange=\"-3 5\"/></body>",
    ));
    assert_eq!(joint(&robot, "j").limits.unwrap().effort, 5.0);
    assert_eq!(joint(&robot, "j").kind.word(), "continuous");
}

#[test]
fn free_joints_stand_alone_in_the_world() {
    let robot = fine(&in_world(
        "<body name=\"a\" pos=\"1 2 3\"><freejoint/></body>",
    ));
    let free = joint(&robot, "a");
    assert_eq!(free.kind.word(), "floating");
    assert!(free.origin.is_empty());
    let refusal = errors(&in_world(
        "<body name=\"a\"><body name=\"b\">\n<freejoint/></body></body>",
    ));
    assert!(
        refusal.contains("arm.xml:3:1: body \"b\" has a free joint inside another body"),
        "{refusal}"
    );
    let refusal = errors(&in_world("<body name=\"a\"><joint/>\n<freejoint/></body>"));
    assert!(
        refusal.contains("body \"a\" has a free joint beside other joints"),
        "{refusal}"
    );
    assert!(errors(&in_world("<joint/>")).contains("the world has a <joint>"));
    assert!(errors(&in_world("<freejoint/>")).contains("the world has a <freejoint>"));
}

#[test]
fn friction_and_armature_are_kept_and_noted() {
    let robot = fine(&in_world(
        "<body><joint name=\"j\" damping=\"0.5\" frictionloss=\"0.25\" armature=\"0.125\"/></body>",
    ));
    let actuator = &joint(&robot, "j").actuator;
    let found = [
        ActuatorQuantity::Damping,
        ActuatorQuantity::Friction,
        ActuatorQuantity::Armature,
    ];
    let found = found.map(|part| {
        actuator
            .of(part)
            .iter()
            .map(|number| number.value)
            .collect::<Vec<_>>()
    });
    assert_eq!(found, [vec![0.5], vec![0.25], vec![0.125]]);
    let none = super::Modelled {
        friction: false,
        armature: false,
        has_rotor: &|_| false,
    };
    let noted: Vec<String> = (robot.unmodelled.warnings(&none).into_iter())
        .map(|warning| warning.message)
        .collect();
    assert_eq!(
        noted,
        [
            "not modelled: damping and friction of joint \"j\"",
            "not modelled: the armature of joint \"j\""
        ]
    );
}

#[test]
fn springs_and_nonlinear_damping_are_warnings() {
    let found = |joint_text: &str| {
        warnings(&in_world(&format!(
            "<body name=\"a\">\n{joint_text}</body>"
        )))
    };
    assert_eq!(
        found("<joint stiffness=\"2\" springref=\"1\"/>"),
        ["arm.xml:3:1: not modelled: a joint of body \"a\": a spring"]
    );
    assert_eq!(
        found("<joint name=\"j\" damping=\"1 0 2\"/>"),
        ["arm.xml:3:30: not modelled: joint \"j\": damping that is not linear in the velocity"]
    );
    let free = found("<joint name=\"j\" type=\"free\" armature=\"1\" frictionloss=\"1\"/>");
    assert_eq!(
        free,
        [
            "arm.xml:3:56: not modelled: joint \"j\" and 1 other: armature or friction of a free joint"
        ]
    );
    assert!(
        found("<freejoint align=\"true\"/>")[0]
            .contains("MuJoCo moves the frame of this free body")
    );
    assert!(found("<freejoint align=\"true\"/><body/>").is_empty());
}

#[test]
fn armatures_of_actuators_are_motors() {
    let robot = fine(
        "<mujoco><worldbody><body><joint name=\"j\"/></body></worldbody><default><motor gear=\"50\"/></default>\
         <actuator><motor joint=\"j\" armature=\"1e-4\"/><position joint=\"j\" gear=\"3\" kp=\"7\"/></actuator></mujoco>",
    );
    let actuator = &joint(&robot, "j").actuator;
    let found =
        [ActuatorQuantity::Rotor, ActuatorQuantity::Ratio].map(|part| actuator.of(part)[0].value);
    assert_eq!(found.map(f64::to_bits), [1e-4_f64, 50.0].map(f64::to_bits));
    assert!(actuator.further().is_empty());
}

#[test]
fn keys_are_configurations() {
    let text = |qpos: &str| {
        format!(
            "<mujoco><worldbody><body name=\"a\"><freejoint name=\"f\"/><geom size=\"1\"/><body name=\"b\"><joint name=\"j\"/><geom size=\"1\"/>\
             <body name=\"c\"/></body></body></worldbody><keyframe><key name=\"home\" qpos=\"{qpos}\"/><key time=\"1\"/></keyframe></mujoco>"
        )
    };
    let robot = fine(&text("1 2 3 2 0 0 0 90"));
    let [home] = &robot.configurations[..] else {
        panic!("{:?}", robot.configurations);
    };
    assert_eq!(home.name.text, "home");
    let found: Vec<(&str, Vec<f64>)> = (home.joints.iter())
        .map(|(joint, own)| (&*joint.text, own.iter().map(|entry| entry.value).collect()))
        .collect();
    // In radians, though angles of the file are in degrees; the quaternion has the order x, y, z, w, and length 1.
    let free = vec![1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0];
    assert_eq!(found, [("f", free), ("j", vec![90.0])]);
    let wrong = text("1 2 3");
    assert!(fine(&wrong).configurations.is_empty());
    let message = "key \"home\" has 3 coordinates, and the joints 8";
    assert!(
        warnings(&wrong)
            .iter()
            .any(|warning| warning.contains(message))
    );
}
