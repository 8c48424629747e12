//! Joints with several coordinates, mimic joints, and floating bases: their entries, and the errors about impossible
//! ones.

use super::{BodyId, fine, lines, read, said};
use crate::builder::Builder;
use crate::chain::{Chain, MimicJoint, Position, build};
use crate::description::read_text;
use crate::error::Errors;
use crate::expand::expand;
use crate::function::Function;
use crate::list::Id;
use crate::request::Request;
use crate::space::Space;

fn entries(chain: &Chain, space: Space) -> Vec<&str> {
    chain.spaces().names(space).collect()
}

fn warnings(chain: &Chain) -> Vec<&str> {
    let warnings = chain.report.warnings.iter();
    warnings.map(|warning| warning.message.as_str()).collect()
}

/// A body on a joint of a type, with more settings, and another body beyond it.
fn joint_of(kind: &str, more: &str) -> String {
    let body = "{ mass: 2.0, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.01, 0.02, 0.4, 0.03, 0.5] }";
    format!(
        "struct Arm;
         link base; joint turn: revolute([0.0, 0.6, 0.8]); link carrier {body}
         joint j: {kind} {{ {more} at: xyz(0.1, 0.2, 0.3) rpy(0.1, 0.2, 0.3) }} link one {body}
         joint next: revolute(x) {{ at: xyz(0.3, 0.1, 0.2) }} link two {body}"
    )
}

#[test]
fn each_type_has_its_coordinates_and_velocities() {
    let kinds: [(&str, &[&str], &[&str]); 6] = [
        (
            "universal(x, y)",
            &["j.first", "j.second"],
            &["j.first", "j.second"],
        ),
        (
            "translation",
            &["j.x", "j.y", "j.z"],
            &["j.x", "j.y", "j.z"],
        ),
        (
            "planar(z)",
            &["j.x", "j.y", "j.angle"],
            &["j.vx", "j.vy", "j.wz"],
        ),
        (
            "planar([0.6, 0.0, 0.8])",
            &["j.x", "j.y", "j.angle"],
            &["j.vx", "j.vy", "j.wz"],
        ),
        (
            "spherical",
            &["j.qx", "j.qy", "j.qz", "j.qw"],
            &["j.wx", "j.wy", "j.wz"],
        ),
        (
            "floating",
            &["j.x", "j.y", "j.z", "j.qx", "j.qy", "j.qz", "j.qw"],
            &["j.vx", "j.vy", "j.vz", "j.wx", "j.wy", "j.wz"],
        ),
    ];
    for (kind, coordinates, velocities) in kinds {
        let chain = fine(&joint_of(kind, ""));
        let between = |own: &[&'static str]| [&["turn"], own, &["next"]].concat();
        assert_eq!(
            entries(&chain, Space::Coordinates),
            between(coordinates),
            "{kind}"
        );
        assert_eq!(
            entries(&chain, Space::Velocities),
            between(velocities),
            "{kind}"
        );
        assert_eq!(chain.report.joints, ["turn", "j", "next"]);
    }
}

/// The check of every expansion compares each function with products of matrices that are independent of the chain.
#[test]
fn every_type_has_every_function() {
    for kind in [
        "universal(x, [0.0, 0.6, 0.8])",
        "translation",
        "planar(-x)",
        "planar([0.6, 0.0, 0.8])",
        "spherical",
        "floating",
        "cylindrical(y)",
        "screw(z, pitch: 0.02)",
        "prismatic(y)",
    ] {
        let mimics = "mimic: turn, multiplier: -2.0, offset: 0.3,";
        let alone = kind.starts_with("screw") || kind.starts_with("prismatic");
        let (description, request) = read(&joint_of(kind, if alone { mimics } else { "" }));
        let module = expand(&description, &request);
        let module = module.unwrap_or_else(|errors| panic!("{kind}: {errors}"));
        assert!(
            module.about.left_out.is_empty(),
            "{kind}: {:?}",
            module.about.left_out
        );
    }
}

/// A joint of one branch mimics one of another, which couples their velocities in the elimination.
#[test]
fn branches_connected_only_by_a_mimic_joint_are_coupled() {
    let body = "{ mass: 2.0, com: [0.1, 0.2, 0.3], inertia: [0.3, 0.4, 0.5] }";
    let text = format!(
        "struct Arms {{ tip = d, formulation(refined = 0) }}
         link base; link a {body} link b {body} link c {body} link d {body}
         joint y: revolute(x) {{ from: base, to: b }}
         joint x: revolute(z) {{ from: base, to: a }}
         joint leads: revolute(y) {{ from: a, to: c, at: xyz(0.3, 0.1, 0.0) }}
         joint follows: revolute(y) {{ from: b, to: d, at: xyz(0.1, 0.3, 0.2), mimic: leads, multiplier: -0.5 }}"
    );
    let (description, request) = read(&text);
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(
        module.about.left_out.is_empty(),
        "{:?}",
        module.about.left_out
    );
}

/// A hand with two fingers, one of which mimics the other.
fn hand(settings: &str, finger: &str) -> String {
    format!(
        "struct Hand {{ {settings} }} link base; link palm {{ mass: 1.0, inertia: [1, 1, 1] }}
         link left {{ mass: 0.1, inertia: [1, 1, 1] }} link right {{ mass: 0.1, inertia: [1, 1, 1] }}
         joint wrist: revolute(z) {{ from: base, to: palm }}
         joint one: prismatic(y) {{ from: palm, to: left }}
         joint other: prismatic(y) {{ from: palm, to: right, {finger} }}"
    )
}

#[test]
fn a_mimic_joint_has_no_entries_and_is_reported_with_its_mimicked_joint() {
    let chain = fine(&hand("", "mimic: one, multiplier: -2.0, offset: 0.1"));
    assert_eq!(entries(&chain, Space::Coordinates), ["wrist", "one"]);
    assert_eq!(entries(&chain, Space::Velocities), ["wrist", "one"]);
    let mimicked = MimicJoint {
        joint: "other".to_owned(),
        mimicked: "one".to_owned(),
        multiplier: -2.0,
        offset: 0.1,
    };
    assert_eq!(chain.report.mimicked, [mimicked]);
    let Position::Along { coordinate, factor } = chain.joints[BodyId(2)].position else {
        panic!("{:?}", chain.joints[BodyId(2)]);
    };
    let velocity = chain.joints[BodyId(2)].velocity;
    assert_eq!((coordinate.index(), velocity.index()), (1, 1));
    assert_eq!(
        chain.graph.value(factor).unwrap().to_f64().to_bits(),
        (-2.0_f64).to_bits()
    );
}

#[test]
fn a_mimic_joint_is_locked_with_its_mimicked_joint() {
    let follower = "mimic: one, multiplier: 2.0, offset: 0.1";
    let locked = fine(&hand("lock(one = 0.2)", follower));
    assert_eq!(entries(&locked, Space::Coordinates), ["wrist"]);
    assert_eq!(
        locked.report.locked,
        [("one".to_owned(), 0.2), ("other".to_owned(), 0.5)]
    );
    let dropped = fine(&hand("drop(left)", follower));
    assert_eq!(dropped.report.locked, [("other".to_owned(), 0.1)]);
    let said = "joint \"other\" mimics joint \"one\", which has no coordinate here: held at its \
                position for coordinate 0";
    assert!(
        warnings(&dropped).contains(&said),
        "{:?}",
        warnings(&dropped)
    );
    // What moves the tip by way of another joint is not locked.
    let path = fine(&hand("tip = right, path_only", follower));
    assert_eq!(entries(&path, Space::Coordinates), ["wrist", "one"]);
    let beside = fine(&hand("tip = palm, path_only", follower));
    assert_eq!(entries(&beside, Space::Coordinates), ["wrist"]);
    // A joint that is left out passes on what it mimics.
    let through = hand("drop(left)", "mimic: one").replace(
        "one: prismatic(y) { from: palm, to: left }",
        "one: prismatic(y) { from: palm, to: left, mimic: wrist, multiplier: 0.5 }",
    );
    let through = fine(&through);
    assert_eq!(entries(&through, Space::Coordinates), ["wrist"]);
    assert_eq!(through.report.mimicked[0].mimicked, "wrist");
    // Locked by itself, it mimics nothing, and an unknown name is allowed.
    let alone = fine(&hand("lock(other)", "mimic: nobody"));
    assert_eq!(entries(&alone, Space::Coordinates), ["wrist", "one"]);
}

/// −8e-13 and −2 have no exact sum in 53 bits: its sine is printed, rounded once, as every expansion checks.
#[test]
fn offsets_of_chained_mimic_joints_are_not_rounded_before_use() {
    let (description, request) = read(
        "struct Hand { tip = finger } link base; link palm; link left; link right; link finger;
         joint turn: revolute(y) { from: base, to: palm }
         joint one: revolute(x) { from: palm, to: left, mimic: turn, multiplier: -1, offset: -8e-13 }
         joint other: revolute(x) { from: palm, to: right, mimic: one, offset: -2 }
         joint spare: revolute(y) { from: right, to: finger }",
    );
    let builder = Builder::from_description(description).request(request);
    let made = |builder: Builder| {
        let module = builder.generate([Function::ForwardKinematics]).module();
        module.unwrap_or_else(|errors| panic!("{errors}"));
    };
    made(builder.clone());
    for at in [-1.8, 2.01, -1.4325] {
        made(builder.clone().lock_at("turn", at));
    }
}

#[test]
fn a_mimic_joint_must_have_one_coordinate_and_no_cycle() {
    assert_eq!(
        said(&hand("", "mimic: on")),
        lines(&[
            r#"error: there is no joint "on""#,
            r#"  hint: did you mean "one"? joints: "wrist", "one" and "other""#
        ])
    );
    assert_eq!(
        said(&hand("", "mimic: other")),
        lines(&[
            r#"error: joint "other" mimics itself"#,
            "  hint: one of them must have its own coordinate",
        ])
    );
    let ball = hand("", "mimic: one").replace("one: prismatic(y)", "one: spherical");
    assert_eq!(
        said(&ball),
        lines(&[
            r#"error: joint "other" mimics joint "one", and "one" has several coordinates"#,
            "  hint: mimic joints and mimicked joints must have one coordinate",
        ])
    );
}

#[test]
fn in_a_file_a_joint_that_mimics_an_unknown_one_moves_independently_with_a_warning() {
    let text = r#"<robot name="r"><link name="a"/><link name="b"/>
        <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
        <mimic joint="k"/></joint></robot>"#;
    let mut errors = Errors::new();
    let description = read_text(text, "r.urdf", None, &mut errors).expect("a robot");
    let chain = build(&description, &Request::default()).expect("a chain");
    assert_eq!(entries(&chain, Space::Coordinates), ["j"]);
    let said =
        "joint \"j\" mimics joint \"k\", which does not exist: it gets a coordinate of its own";
    assert!(warnings(&chain).contains(&said), "{:?}", warnings(&chain));
}

#[test]
fn a_floating_base_is_carried_by_a_new_link() {
    let free = fine(&hand("floating", "mimic: one"));
    assert_eq!(free.report.base, "world");
    assert_eq!(free.report.joints, ["root", "wrist", "one"]);
    assert_eq!(
        entries(&free, Space::Velocities)[..2],
        ["root.vx", "root.vy"]
    );
    // The joint that carried the base is left out.
    let palm = fine(&hand("floating, base = palm", "mimic: one"));
    assert_eq!(palm.report.joints, ["root", "one"]);
    assert_eq!(palm.report.dropped, ["base"]);
    // So is a joint that it moves by mimicry.
    let led = fine(&hand("floating, base = palm", "mimic: wrist, offset: 0.1"));
    assert_eq!(led.report.joints, ["root", "one"]);
    assert_eq!(led.report.locked, [("other".to_owned(), 0.1)]);
    // A lock sets the coordinate of the joint that is left out.
    for floating in ["", "floating, "] {
        let asked = format!("{floating}base = palm, lock(wrist = 0.3)");
        let locked = fine(&hand(&asked, "mimic: wrist, offset: 0.1"));
        assert_eq!(locked.report.locked, [("other".to_owned(), 0.4)]);
        assert!(warnings(&locked).is_empty(), "{:?}", warnings(&locked));
    }
    // Names that are taken are skipped.
    let taken = hand("floating", "")
        .replace("base", "world")
        .replace("wrist", "root");
    let taken = fine(&taken);
    assert_eq!(taken.report.base, "ground");
    assert_eq!(taken.report.joints, ["root_joint", "root", "one", "other"]);
}

#[test]
fn a_robot_without_joints_moves_on_a_floating_base() {
    let chain = fine("struct Drone { floating } link frame { mass: 1.0, inertia: [1, 1, 1] }");
    assert_eq!(chain.spaces().velocities.len(), 6);
}
