//! Models as text, and what they become.

mod files;
mod hostile;
mod joints;
mod placement;

use super::read;
use crate::description::Given;
use crate::description::spatial::Pose;
use crate::description::{Description, Joint, Step};
use crate::error::Errors;
use crate::expression::Double;

/// Reads a text without mistakes.
pub(super) fn model(text: &str) -> Description {
    let mut errors = Errors::new();
    let robot = read(text, "arm.sdf", None, &Given::default(), None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    robot.expect("a description")
}

/// The errors of a text.
pub(super) fn errors(text: &str) -> String {
    let mut errors = Errors::new();
    let _ = read(text, "arm.sdf", None, &Given::default(), None, &mut errors);
    errors.to_string()
}

/// A model with these elements, in a file of version 1.9.
pub(super) fn with(elements: &str) -> String {
    format!("<sdf version=\"1.9\"><model name=\"arm\">{elements}</model></sdf>")
}

/// A link with a pose and 1 kg.
pub(super) fn link(name: &str, pose: &str) -> String {
    format!(
        "<link name=\"{name}\">{pose}<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy>\
         <izz>1</izz></inertia></inertial></link>"
    )
}

pub(super) fn joint<'d>(robot: &'d Description, name: &str) -> &'d Joint {
    let mut joints = robot.joints.iter();
    let joint = joints.find(|joint| joint.name.text == name);
    joint.expect("a joint of that name")
}

/// Compares the position of a placement, and the direction of its x axis.
pub(super) fn is_at(steps: &[Step], position: [f64; 3], x: [f64; 3]) {
    let pose = Pose::of(steps);
    let found = pose.position.map(Double::to_f64);
    let first = pose.rotation.map(|row| row[0].to_f64());
    let pairs = found.iter().chain(&first).zip(position.iter().chain(&x));
    for (found, wanted) in pairs {
        assert!(
            (found - wanted).abs() < 1e-15,
            "{found} for {wanted}: {steps:?}"
        );
    }
}

#[test]
fn links_without_numbers_have_those_of_the_format() {
    let robot = model(&with(
        "<link name=\"a\"/><link name=\"b\"><inertial><mass>2</mass></inertial></link>\
        <joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis/></joint>",
    ));
    let [a, b] = [0, 1].map(|k| robot.links[k].inertial.as_ref().expect("an inertia"));
    assert_eq!((a.mass.value, b.mass.value), (1.0, 2.0));
    assert_eq!(
        a.inertia.map(|entry| entry.value),
        [1.0, 0.0, 0.0, 1.0, 0.0, 1.0]
    );
    let warnings: Vec<&str> = robot
        .warnings
        .iter()
        .map(|warning| &*warning.message)
        .collect();
    assert_eq!(
        warnings,
        ["the inertial of link \"a\" is not written: 1 kg and 1 kg m² about each axis"]
    );
    assert_eq!(
        joint(&robot, "j").axis.map(|entry| entry.value),
        [0.0, 0.0, 1.0]
    );
}

#[test]
fn everything_that_is_not_read_is_a_warning() {
    let robot = model(&with(
        "<link name=\"a\"><inertial><mass>1</mass><inertia/></inertial><gravity>false</gravity><visual/><oddity/></link>\
         <link name=\"b\"><inertial><mass>1</mass><inertia/></inertial></link>\
         <joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>\
         <dynamics><spring_stiffness>3</spring_stiffness><damping>0.1</damping></dynamics></axis></joint>",
    ));
    let warnings: Vec<&str> = robot
        .warnings
        .iter()
        .map(|warning| &*warning.message)
        .collect();
    assert_eq!(
        warnings,
        [
            "not modelled: <gravity> in link \"a\": a link without gravity",
            "<oddity> in link \"a\" is ignored",
            "not modelled: <spring_stiffness> in the <dynamics> of the <axis> of joint \"j\": a spring",
        ]
    );
}

#[test]
fn a_file_is_one_robot() {
    let two = "<sdf version=\"1.9\"><model name=\"a\"/><model name=\"b\"/></sdf>";
    assert_eq!(
        errors(two),
        "error: arm.sdf:1:1: the file has 2 movable models, \"a\" and \"b\", and a robot is one\n  \
         hint: write one <model>; several parts are models in a model, with joints between them\n"
    );
    let world = format!(
        "<sdf version=\"1.9\"><world name=\"w\"><gravity>0 0 -1.6</gravity>\n<model name=\"ground\"><static>true</static>\
         <link name=\"plane\"/></model><model name=\"arm\">{}</model></world></sdf>",
        link("a", "")
    );
    let robot = model(&world);
    assert_eq!(robot.name.text, "arm");
    assert_eq!(
        robot
            .gravity
            .map(|gravity| gravity.map(|entry| entry.value)),
        Some([0.0, 0.0, -1.6])
    );
    assert_eq!(
        robot.warnings[0].message,
        "1 static model of the world ignored"
    );
    let version = with(&link("a", "")).replace("1.9", "2.0");
    let warning = &model(&version).warnings[0];
    assert_eq!(
        warning.message,
        "the file has the version \"2.0\", and is read as one of 1.4 to 1.12"
    );
}
