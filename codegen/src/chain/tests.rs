//! Tests of the chain stage: inline robots, and the errors about those that are inconsistent.
//!
//! Errors within one item belong to the readers and are tested there.

mod actuators;
mod base_parameters;
mod bodies;
mod collision;
mod external;
mod fields;
mod joints;
mod rotations;

use std::path::Path;

use super::{BodyId, Chain, build};
use crate::description::{Description, Name, inline};
use crate::error::Errors;
use crate::request::{Parameter, Request, Target};
use crate::space::FrameId;

/// A description and a request in the grammar of `chain!`.
pub(crate) fn read(text: &str) -> (Description, Request) {
    let mut errors = Errors::new();
    let tokens = text.parse().expect("tokens");
    let item = inline::read(tokens, Path::new("nowhere"), &mut errors);
    assert!(errors.is_empty(), "{errors}");
    let item = item.expect("an item");
    (item.description.expect("a description"), item.request)
}

pub(crate) fn fine(text: &str) -> Chain {
    let (description, request) = read(text);
    build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

/// All errors about a robot, with places and hints.
fn said(text: &str) -> String {
    let (description, request) = read(text);
    let errors = build(&description, &request).expect_err("mistakes");
    errors.to_string()
}

fn lines(lines: &[&str]) -> String {
    lines.join("\n") + "\n"
}

pub(crate) fn named(text: &str) -> Name {
    Name {
        text: text.to_owned(),
        ..Name::default()
    }
}

/// An arm of three links with a tool on a fixed joint, with some settings.
fn arm(settings: &str) -> String {
    format!(
        "struct Arm {{ {settings} }}
        link base;
        joint shoulder: revolute(z) {{ from: base, to: upper }}
        joint elbow: revolute(y) {{ from: upper, to: fore, at: xyz(0.4, 0, 0) }}
        joint mount: fixed {{ from: fore, to: tool, at: xyz(0.3, 0, 0) }}
        link upper; link fore; link tool;"
    )
}

/// The same with a second tool, so that there are two ends.
fn fork(settings: &str) -> String {
    arm(settings) + "joint hand: prismatic(x) { from: fore, to: finger } link finger;"
}

#[test]
fn an_unknown_link() {
    let arm = "struct Arm; link base; link upper;
        joint shoulder: revolute(z) { from: basse, to: upper }
        joint elbow: revolute(z) { from: upper, to: \"quite another\" }";
    assert_eq!(
        said(arm),
        lines(&[
            r#"error: there is no link "basse""#,
            r#"  hint: did you mean "base"? links: "base" and "upper""#,
            r#"error: there is no link "quite another""#,
            r#"  hint: links: "base" and "upper""#
        ])
    );
}

#[test]
fn a_link_on_two_joints() {
    let arm = "struct Arm; link base; link upper;
        joint left: revolute(z) { from: base, to: upper }
        joint right: revolute(z) { from: base, to: upper }";
    assert_eq!(
        said(arm),
        lines(&[
            r#"error: link "upper" has two parent joints, "left" and "right""#,
            "  hint: leave one of the joints out, and describe it as a loop"
        ])
    );
}

#[test]
fn a_cycle_beside_the_base() {
    let arm = "struct Arm; link base; link a; link b; link c;
        joint one: revolute(z) { from: a, to: b }
        joint two: revolute(z) { from: b, to: c }
        joint three: revolute(z) { from: c, to: a }";
    assert_eq!(
        said(arm),
        lines(&[r#"error: joint "one" closes a cycle: link "a" is its own ancestor"#])
    );
}

#[test]
fn a_cycle_of_all_links() {
    let arm = "struct Arm; link a; link b;
        joint one: revolute(z) { from: a, to: b }
        joint two: revolute(z) { from: b, to: a }";
    assert_eq!(
        said(arm),
        lines(&[r#"error: joint "one" closes a cycle: link "a" is its own ancestor"#])
    );
}

#[test]
fn several_roots() {
    let two = "struct Arm; link base; link upper; link table;
        joint one: revolute(z) { from: base, to: upper }";
    assert_eq!(
        said(two),
        lines(&[
            r#"error: links "base", "table" have no parent: a robot has one root"#,
            "  hint: connect them by joints, or name the base to model one part alone"
        ])
    );
    let four = format!("{two} link chair; link lamp;");
    assert_eq!(
        said(&four),
        lines(&[
            r#"error: links "base", "table" and 2 more have no parent: a robot has one root"#,
            "  hint: connect them by joints, or name the base to model one part alone"
        ])
    );
    let named = two.replace("struct Arm;", "struct Arm { base: base }");
    assert_eq!(fine(&named).report.dropped, ["table"]);
}

#[test]
fn what_is_requested_must_exist() {
    assert_eq!(
        said(&arm("base: bass")),
        lines(&[
            r#"error: there is no link "bass""#,
            r#"  hint: did you mean "base"? links: "base", "upper", "fore" and "tool""#
        ])
    );
    let settings = "tip: toll, drop(uper), frames(far), lock(shoulde, elbw = 0.3)";
    assert_eq!(
        said(&arm(settings)),
        lines(&[
            r#"error: there is no link "uper""#,
            r#"  hint: did you mean "upper"? links: "base", "upper", "fore" and "tool""#,
            r#"error: there is no link "toll""#,
            r#"  hint: did you mean "tool"? links: "base", "upper", "fore" and "tool""#,
            r#"error: there is no link "far""#,
            r#"  hint: links: "base", "upper", "fore" and "tool""#,
            r#"error: there is no joint "shoulde""#,
            r#"  hint: did you mean "shoulder"? joints: "shoulder", "elbow" and "mount""#,
            r#"error: there is no joint "elbw""#,
            r#"  hint: did you mean "elbow"? joints: "shoulder", "elbow" and "mount""#
        ])
    );
}

#[test]
fn what_is_requested_must_be_downstream_of_the_base() {
    assert_eq!(
        said(&arm("base: upper, tip: base")),
        lines(&[
            r#"error: the tip "base" is not a descendant of the base "upper""#,
            "  hint: choose a base above it in the tree, and do not drop it"
        ])
    );
    assert_eq!(
        said(&arm("drop(fore), tip: tool, frames(fore)")),
        lines(&[
            r#"error: the tip "tool" is not a descendant of the base "base""#,
            "  hint: choose a base above it in the tree, and do not drop it",
            r#"error: the frame "fore" is not a descendant of the base "base""#,
            "  hint: choose a base above it in the tree, and do not drop it"
        ])
    );
    assert_eq!(
        said(&arm("drop(base)")),
        lines(&[r#"error: the base "base" cannot be dropped"#])
    );
}

#[test]
fn only_joints_that_move_can_be_locked_and_once() {
    assert_eq!(
        said(&arm("lock(mount)")),
        lines(&[r#"error: joint "mount" is fixed and cannot be locked"#])
    );
    assert_eq!(
        said(&arm("lock(elbow, elbow = 0.3)")),
        lines(&[r#"error: joint "elbow" is locked twice"#])
    );
}

/// A joint with two coordinates and one with one, with settings for the struct and for the first joint.
fn plunger(settings: &str, body: &str) -> String {
    format!(
        "struct Arm {{ {settings} }} link base; joint quill: cylindrical(z) {{ {body} }} link spindle;
         joint tilt: revolute(x); link bit {{ mass: 1.0, com: [0, 0, 1], inertia: [1, 1, 1] }}"
    )
}

#[test]
fn a_joint_with_two_coordinates_has_two_entries_and_is_held_as_one() {
    let chain = fine(&plunger("", ""));
    let names: Vec<&str> = chain
        .joints
        .iter()
        .map(|joint| joint.name.as_str())
        .collect();
    assert_eq!(names, ["quill.angle", "quill.shift", "tilt"]);
    assert_eq!(chain.report.joints, ["quill", "tilt"]);
    let held = fine(&plunger("lock(quill)", ""));
    assert_eq!(held.report.joints, ["tilt"]);
    assert_eq!(
        said(&plunger("lock(quill = 0.3)", "")),
        lines(&[
            r#"error: joint "quill" has several coordinates and is locked at one value"#,
            "  hint: lock it without a value, which sets all of them to 0",
        ])
    );
}

#[test]
fn no_joint_is_called_as_a_coordinate_of_another() {
    let clash = plunger("", "").replace("joint tilt", "joint \"quill.shift\"");
    assert_eq!(
        said(&clash),
        lines(&[
            r#"error: joint "quill.shift" has the name of a coordinate of joint "quill""#,
            "  hint: rename one of them",
        ])
    );
}

#[test]
fn limits_of_two_coordinates_are_left_out_with_a_warning() {
    let chain = fine(&plunger("", "limits: [-1.0, 1.0]"));
    let spaces = chain.spaces();
    let mut entries = spaces.coordinates.iter().chain(&spaces.velocities);
    assert!(entries.all(|entry| entry.range.is_none()));
    let warnings: Vec<&str> = (chain.report.warnings.iter())
        .map(|warning| warning.message.as_str())
        .collect();
    let limits = "joint \"quill\" is cylindrical and has limits, which are not modelled: they do \
                  not name a coordinate";
    assert!(warnings.contains(&limits), "{warnings:?}");
    let strict = said(&plunger("strict", "limits: [-1.0, 1.0]"));
    assert!(strict.contains(limits), "{strict}");
}

#[test]
fn some_joint_must_move() {
    assert_eq!(
        said(&arm("lock(shoulder, elbow)")),
        lines(&[r#"error: no joint of "Arm" moves"#])
    );
    assert_eq!(
        said("struct Arm; link base;"),
        lines(&[r#"error: no joint of "Arm" moves"#])
    );
    assert_eq!(
        said(&arm("base: tool")),
        lines(&[r#"error: no joint of "Arm" moves"#])
    );
}

#[test]
fn several_ends_need_a_tip_where_it_matters() {
    assert_eq!(
        said(&fork("path_only")),
        lines(&[
            "error: path_only needs a tip, and the robot has more than one end",
            r#"  hint: name one of: "tool", "finger""#
        ])
    );
    assert_eq!(
        said(&fork("generate(forward_kinematics)")),
        lines(&[
            "error: poses and Jacobians need a tip, and the robot has more than one end",
            r#"  hint: name one as the tip: "tool", "finger""#
        ])
    );
    let chain = fine(&fork("generate(inverse_dynamics)"));
    assert!(!chain.has_tip && chain.frames.is_empty());
    let chain = fine(&fork("generate(forward_kinematics), frames(fore)"));
    assert!(!chain.has_tip && chain.frames[FrameId::FIRST].name == "fore");
}

#[test]
fn a_few_of_many_ends_are_named() {
    let finger = |k| format!("joint j{k}: revolute(z) {{ from: base, to: f{k} }} link f{k};");
    let fingers = (0..11).map(finger).collect::<Vec<_>>().concat();
    let hand = format!("struct Hand {{ path_only }} link base; {fingers}");
    assert_eq!(
        said(&hand),
        lines(&[
            "error: path_only needs a tip, and the robot has more than one end",
            r#"  hint: name one of: "f0", "f1", "f2", "f3", "f4", "f5", "f6", "f7", and 3 more"#
        ])
    );
}

#[test]
fn names_are_unique() {
    // Readers refuse duplicates; a description made in code has not been read.
    let (mut description, request) = read(&arm(""));
    description.links[3].name = description.links[2].name.clone();
    description.joints[2].name = description.joints[1].name.clone();
    let errors = build(&description, &request).expect_err("mistakes");
    assert_eq!(
        errors.to_string(),
        lines(&[
            r#"error: two links are called "fore""#,
            r#"error: two joints are called "elbow""#,
            r#"error: there is no link "tool""#,
            r#"  hint: links: "base", "upper", "fore" and "fore""#
        ])
    );
}

#[test]
fn fields_replace_what_is_modelled() {
    let (description, mut request) = read(&arm("drop(fore)"));
    for target in [
        Target::MassOf(named("tool")),
        Target::CenterOfMassOf(named("tol")),
        Target::OriginOf(named("elbow")),
        Target::OriginOf(named("wrist")),
    ] {
        let field = quote::format_ident!("field_{}", request.parameters.len());
        request.parameters.push(Parameter {
            field,
            target,
            range: None,
        });
    }
    let errors = build(&description, &request).expect_err("mistakes");
    assert_eq!(
        errors.to_string(),
        lines(&[
            r#"error: link "tool" is not modelled"#,
            r#"error: there is no link "tol""#,
            r#"  hint: did you mean "tool"? links: "base", "upper", "fore" and "tool""#,
            r#"error: joint "elbow" is not modelled"#,
            r#"error: there is no joint "wrist""#,
            r#"  hint: joints: "shoulder", "elbow" and "mount""#
        ])
    );
}

#[test]
fn errors_of_several_kinds_are_reported_together() {
    assert_eq!(
        said(&arm("drop(base), tip: toll, lock(mount)")),
        lines(&[
            r#"error: there is no link "toll""#,
            r#"  hint: did you mean "tool"? links: "base", "upper", "fore" and "tool""#,
            r#"error: joint "mount" is fixed and cannot be locked"#,
            r#"error: the base "base" cannot be dropped"#
        ])
    );
}
