//! Warnings of elements and attributes that are not read.

use super::{ARM, fine, in_world, warnings};

#[test]
fn ignored_elements_are_not_warnings() {
    assert_eq!(warnings(ARM), [""; 0]);
    let sections = "<mujoco><size njmax=\"1\"/><visual><map znear=\"1\"/></visual><statistic extent=\"1\"/>\
                    <asset><texture name=\"t\"/><material name=\"m\"/></asset><contact><exclude body1=\"a\" body2=\"b\"/></contact>\
                    <sensor><gyro site=\"s\"/></sensor><keyframe><key qpos=\"0\"/></keyframe>\
                    <tendon><fixed name=\"f\"><joint joint=\"j\" coef=\"1\"/></fixed></tendon></mujoco>";
    assert_eq!(warnings(sections), [""; 0]);
}

#[test]
fn mechanics_that_are_not_modelled_are_warnings_once() {
    for (text, message) in [
        (
            in_world("<body gravcomp=\"1\"/><body gravcomp=\"0.5\"/>"),
            "gravity compensation of a body",
        ),
        (
            in_world("<body mocap=\"true\"/>"),
            "a body whose pose the program sets (mocap)",
        ),
        (
            in_world("<body><plugin plugin=\"p\"/></body>"),
            "forces of a plug-in",
        ),
        (
            "<mujoco><option density=\"1.2\" viscosity=\"1\"/></mujoco>".to_owned(),
            "forces of a fluid",
        ),
        (
            "<mujoco><tendon><spatial stiffness=\"1\"/></tendon></mujoco>".to_owned(),
            "springs, friction or inertia of a tendon",
        ),
        (
            "<mujoco><equality><tendon tendon1=\"a\"/></equality></mujoco>".to_owned(),
            "a constraint of a tendon or a flexible body",
        ),
        (
            "<mujoco><actuator><muscle joint=\"j\"/></actuator></mujoco>".to_owned(),
            "a muscle",
        ),
        (
            "<mujoco><deformable><flex name=\"f\"/></deformable></mujoco>".to_owned(),
            "a flexible body",
        ),
    ] {
        let found = warnings(&text);
        assert!(
            found.len() == 1 && found[0].ends_with(message),
            "{text}: {found:?}"
        );
    }
    assert_eq!(
        warnings(&in_world("<body gravcomp=\"0\" mocap=\"false\"/>")),
        [""; 0]
    );
}

#[test]
fn misspelt_names_are_warnings() {
    let robot = fine(&in_world(
        "<body name=\"a\"><joint name=\"j\" axes=\"1 0 0\"/>\n<inertail/></body>",
    ));
    let found: Vec<_> = robot
        .warnings
        .iter()
        .map(|w| (&*w.message, w.hint.as_deref()))
        .collect();
    assert_eq!(
        found,
        [
            (
                "attribute \"axes\" of joint \"j\" is ignored",
                Some("did you mean axis?")
            ),
            (
                "<inertail> in body \"a\" is ignored",
                Some("did you mean <inertial>?")
            ),
        ]
    );
}
