//! Tests of the grammar and of each of its messages.

mod closure;
mod composite;

use super::*;
use crate::description::tokens::show;
use crate::description::{Axis, Step};
use crate::joint::JointKind;

const SCARA: &str = "
/// A SCARA.
#[derive(Debug)]
pub struct Scara { gravity: [0.0, 0.0, -9.81], tip: tool, generate(inverse_dynamics) }
link base;
joint shoulder: revolute(z) { at: xyz(0.0, 0.0, 0.40), limits: [-2.9, 2.9], velocity: 2.0 }
link upper { mass: 3.2, com: [0.12, 0, 0], inertia: [0.01, 0.02, 0.03] }
joint elbow: continuous(-z) { at: xyz(0.3, 0, 0) rpy(0.1, 0.2, pi/2) rx(-pi) }
link fore { mass: 1.50, inertia: [1, 2, 3, 4, 5, 6], inertia_rpy: [0, 0, 0.1] }
joint \"z-axis\": screw([0.0, 0.6, 0.8], pitch: 0.01);
link tool;
joint camera: fixed { from: upper, to: eye }
link eye
";

fn try_read(text: &str) -> (Option<Item>, String) {
    let mut errors = Errors::new();
    let item = read(text.parse().unwrap(), Path::new("nowhere"), &mut errors);
    (item, show(&errors))
}

fn fine(text: &str) -> Item {
    let (item, messages) = try_read(text);
    assert_eq!(messages, "");
    item.unwrap()
}

/// The errors of items that begin in line 2.
fn errors_in(items: &str) -> String {
    try_read(&format!("struct Arm;\n{items}")).1
}

/// The errors of a joint from a to b.
fn errors_in_joint(joint: &str) -> String {
    errors_in(&format!("{joint}\nlink a; link b;"))
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn an_inline_description_of_a_whole_robot() {
    let item = fine(SCARA);
    assert_eq!(item.ident, "Scara");
    assert_eq!(item.attributes.len(), 2);
    assert!(matches!(item.visibility, Visibility::Public(_)));
    assert_eq!(item.request.tip.unwrap().text, "tool");
    assert_eq!(item.request.gravity.unwrap()[2].value, -9.81);
    assert_eq!(item.request.functions.len(), 1);

    let scara = item.description.unwrap();
    assert_eq!(scara.name.text, "Scara");
    assert_eq!(scara.source.hash, 0);
    let ends: Vec<_> = scara
        .joints
        .iter()
        .map(|joint| (joint.parent.text.as_str(), joint.child.text.as_str()))
        .collect();
    assert_eq!(
        ends,
        [
            ("base", "upper"),
            ("upper", "fore"),
            ("fore", "tool"),
            ("upper", "eye")
        ]
    );
    let limits = scara.joints[0].limits.unwrap();
    assert_eq!(
        (limits.lower, limits.upper, limits.velocity),
        (-2.9, 2.9, 2.0)
    );
    let Step::Translate(at) = scara.joints[0].origin[0] else {
        panic!("{:?}", scara.joints[0].origin);
    };
    assert_eq!((at[2].value, at[2].resolution), (0.4, 0.01));
    assert_eq!(scara.joints[1].axis.map(|x| x.value), [0.0, 0.0, -1.0]);
    assert!(matches!(
        scara.joints[1].origin[..],
        [
            Step::Translate(_),
            Step::Rotate(Axis::Z, yaw),
            Step::Rotate(Axis::Y, _),
            Step::Rotate(Axis::X, _),
            Step::Rotate(Axis::X, turn),
        ] if yaw.value == std::f64::consts::FRAC_PI_2 && turn.value == -std::f64::consts::PI
    ));
    let JointKind::Screw { pitch } = scara.joints[2].kind else {
        panic!("{:?}", scara.joints[2].kind);
    };
    assert_eq!(pitch.value, 0.01);
    assert_eq!(scara.joints[2].name.text, "z-axis");
    assert_eq!(scara.joints[2].axis.map(|x| x.value), [0.0, 0.6, 0.8]);

    assert!(scara.links[0].inertial.is_none());
    let upper = scara.links[1].inertial.as_ref().unwrap();
    assert_eq!(
        upper.inertia.map(|x| x.value),
        [0.01, 0.0, 0.0, 0.02, 0.0, 0.03]
    );
    let fore = scara.links[2].inertial.as_ref().unwrap();
    assert_eq!((fore.mass.value, fore.mass.resolution), (1.5, 0.01));
    assert_eq!(
        fore.inertia.map(|x| x.value),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    );
    assert!(matches!(fore.origin[..], [Step::Rotate(Axis::Z, _), _, _]));
}

#[test]
fn an_inline_table_equals_a_table_in_a_file() {
    let item = fine(
        "struct Arm;
        denavit_hartenberg(modified) {
            one: revolute { a: 0.1, alpha: pi/2, d: 0.4, limits: [-1, 1] }
            two: prismatic { link: slider, mass: 2, com: [0, 0, 0.1], inertia: [1, 1, 1] },
            three: screw { pitch: 0.01 };
            tool: fixed { d: 0.2 }
        }",
    );
    let arm = item.description.unwrap();
    let links: Vec<_> = arm
        .links
        .iter()
        .map(|link| link.name.text.as_str())
        .collect();
    assert_eq!(
        links,
        ["base", "one_link", "slider", "three_link", "tool_link"]
    );
    assert!(arm.links[2].inertial.is_some());
    assert_eq!(arm.joints[1].child.text, "slider");
    assert!(matches!(
        arm.joints[0].origin[..],
        [
            Step::Rotate(Axis::X, _),
            Step::Translate(_),
            Step::Rotate(Axis::Z, _),
            Step::Translate(_)
        ]
    ));
    assert!(arm.joints[0].limits.is_some());
}

#[test]
fn all_mistakes_are_reported_at_once() {
    let (item, messages) = try_read(
        "pub struct Arm { tipp: a, exact }\n\
         link base { mass: -1, com: [0, 0], inertia: [1, 1], colour: red }\n\
         joint one: revolut(z) { at: xyz(0, 0) }\n\
         joint two: revolute([0, 0, 0]) { form: base, limits: [1, -1] }\n\
         joint three: planar;\n\
         jiont four: fixed;\n\
         link tool { mass: 1 }\n\
         link tool;",
    );
    assert_eq!(
        messages,
        "1:18: unknown key \"tipp\"\n  hint: did you mean \"tip\"? known keys: urdf, mjcf, sdf, dh, arguments, packages, base, floating, tip, \
         path_only, lock, drop, actuated, gravity, external, friction, damping, rotors, armature, rotor, ratio, exact, strict, quiet, processor, formulation, generate, frames, collision, scalar, reproducible, prepare, batch, section, crate, link, joint, loop and denavit_hartenberg\n\
         2:19: the mass of link \"base\" is negative: -1\n\
         2:28: the centre of mass of link \"base\" has 2 numbers instead of 3\n\
         2:45: the inertia of link \"base\" has 2 numbers \
         instead of 3 (xx, yy, zz) or 6 (xx, xy, xz, yy, yz, zz)\n\
         2:53: link \"base\" has the unknown key \"colour\"\n  \
         hint: known keys: mass, com, inertia and inertia_rpy\n\
         3:12: joint \"one\" has the unknown type \"revolut\"\n  \
         hint: did you mean \"revolute\"? known types: \
         revolute, continuous, prismatic, screw, cylindrical, universal, translation, planar, spherical, floating and fixed\n\
         3:32: xyz of joint \"one\" has 2 numbers instead of 3\n\
         4:21: the axis of joint \"two\" is zero\n  \
         hint: give it a direction, such as 0 0 1\n\
         4:34: joint \"two\" has the unknown key \"form\"\n  \
         hint: did you mean \"from\"? known keys: from, to, at, limits, velocity, mimic, multiplier, offset, armature, rotor, ratio, damping and friction\n\
         4:54: the lower limit of joint \"two\", 1, is above the upper one, -1\n\
         5:14: joint \"three\" has no axis\n  \
         hint: write planar(z)\n\
         6:1: unknown key \"jiont\"\n  hint: did you mean \"joint\"? known keys: urdf, mjcf, sdf, dh, arguments, packages, base, floating, tip, \
         path_only, lock, drop, actuated, gravity, external, friction, damping, rotors, armature, rotor, ratio, exact, strict, quiet, processor, formulation, generate, frames, collision, scalar, reproducible, prepare, batch, section, crate, link, joint, loop and denavit_hartenberg\n\
         7:6: link \"tool\" has a mass but no inertia\n  \
         hint: add inertia: [0.01, 0.01, 0.01], with zeros for a point mass\n\
         8:6: there is another link \"tool\"\n"
    );
    let item = item.unwrap();
    assert!(item.request.exact);
    assert_eq!(item.description.unwrap().joints.len(), 3);
}

#[test]
fn the_option_of_the_command_line_is_a_hint_for_the_key() {
    let (_, message) = try_read("pub struct Arm { functions: gravity }\nlink base;");
    let meant = "1:18: unknown key \"functions\"\n  hint: did you mean \"generate\"? ";
    assert!(message.starts_with(meant), "{message}");
}

#[test]
fn errors_of_joints_show_the_syntax() {
    assert_eq!(
        errors_in_joint("joint j: revolute { from: a, to: b }"),
        "2:10: joint \"j\" has no axis\n  hint: write revolute(z)\n"
    );
    assert_eq!(
        errors_in_joint("joint j: revolute(w) { from: a, to: b }"),
        "2:19: the axis of joint \"j\" must be x, y, z or a vector\n  \
         hint: write revolute(z), revolute(-z) or revolute([0.0, 0.6, 0.8])\n"
    );
    assert_eq!(
        errors_in_joint("joint j: prismatic([0, 0, 0]) { from: a, to: b }"),
        "2:20: the axis of joint \"j\" is zero\n  hint: give it a direction, such as 0 0 1\n"
    );
    assert_eq!(
        errors_in_joint("joint j: screw(z) { from: a, to: b }"),
        "2:17: joint \"j\" has no pitch\n  \
         hint: write screw(z, pitch: 0.01), in metres per radian\n"
    );
    assert_eq!(
        errors_in_joint("joint j: fixed(z) { from: a, to: b }"),
        "2:16: joint \"j\" is fixed and has no axis\n"
    );
    assert_eq!(
        errors_in_joint("joint j: revolute(z, 3) { from: a, to: b }"),
        "2:20: expected `)` after the axis of joint \"j\"\n"
    );
    assert_eq!(
        errors_in_joint("joint j revolute(z);"),
        "2:9: expected `:` after joint \"j\"\n  hint: write joint elbow: revolute(z)\n"
    );
    assert_eq!(
        errors_in_joint("joint j: revolute(z) at(0);"),
        "2:22: expected `{` or `;` after joint \"j\"\n"
    );
    assert_eq!(
        errors_in_joint("joint j: fixed { from: a, to: b, at: xyx(0, 0, 0) }"),
        "2:38: joint \"j\" has the unknown step \"xyx\" in its placement\n  \
         hint: did you mean \"xyz\"? known steps: xyz, rpy, rx, ry and rz\n"
    );
    assert_eq!(
        errors_in_joint("joint j: fixed { from: a, to: b, at: xyz(0, nan, 0) }"),
        "2:45: xyz of joint \"j\" is not a number\n  \
         hint: write digits, or pi: 0.5, -1e-3, pi/2\n"
    );
    assert_eq!(
        errors_in_joint("joint j: fixed { from: a, from: b, to: b }"),
        "2:27: joint \"j\" has the key \"from\" twice\n"
    );
    assert_eq!(
        errors_in_joint("joint j: fixed { from: a to: b }"),
        "2:26: expected `,` between two fields\n"
    );
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn an_axis_of_another_length_is_kept_with_a_warning() {
    let item = fine(
        "struct Arm;\nlink base;\njoint j: revolute([0.0, 3.0, 4.0]);\nlink arm;\n\
         joint k: revolute([0.577, 0.577, 0.577]);\nlink tool;",
    );
    let arm = item.description.unwrap();
    assert_eq!(arm.joints[0].axis.map(|x| x.value), [0.0, 0.75, 1.0]);
    let [warning] = &arm.warnings[..] else {
        panic!("{:?}", arm.warnings);
    };
    assert_eq!(
        warning.message,
        "the axis of joint \"j\" has length 5, and is normalised"
    );
    assert_eq!(
        warning.hint.as_deref(),
        Some("the unit vector is 0 0.6 0.8")
    );
    assert!(matches!(warning.place, Place::Token(_)));
}

#[test]
fn a_joint_needs_two_links() {
    assert_eq!(
        errors_in("joint j: fixed;"),
        "2:7: joint \"j\" has no parent link\n  \
         hint: name it, from: base, or write the link before the joint\n\
         2:7: joint \"j\" has no child link\n  \
         hint: name it, to: upper, or write the link after the joint\n"
    );
    assert_eq!(
        errors_in("link a; joint j: fixed { to: a }"),
        "2:15: joint \"j\" joins link \"a\" to itself\n"
    );
}

#[test]
fn mass_and_inertia_need_each_other() {
    assert_eq!(
        errors_in("link a { com: [0, 0, 1] }"),
        "2:6: link \"a\" has an inertia but no mass\n  hint: add mass: 1.0\n"
    );
    // A malformed mass is not reported as missing, too.
    assert_eq!(
        errors_in("link a { mass: heavy, inertia: [0, 0, 0] }"),
        "2:16: the mass of link \"a\" is not a number\n  \
         hint: write digits, or pi: 0.5, -1e-3, pi/2\n"
    );
    assert_eq!(
        errors_in("link a { mass: 1, inertia: 0 }"),
        "2:28: the inertia of link \"a\" is not a list of numbers\n  \
         hint: write [0.0, 0.0, 1.0]\n"
    );
    assert_eq!(
        errors_in("link a { mass }"),
        "2:10: expected `=` or `:` after `mass`\n"
    );
}

#[test]
fn errors_of_tables_show_the_syntax() {
    let hint = "hint: write denavit_hartenberg(modified) { … }, or (standard)";
    assert_eq!(
        errors_in("denavit_hartenberg { a: fixed }"),
        format!("2:1: the table names no convention\n  {hint}\n")
    );
    assert_eq!(
        errors_in("denavit_hartenberg(craig) { a: fixed { } }"),
        "2:20: unknown convention \"craig\"\n  hint: known conventions: standard and modified\n"
    );
    assert_eq!(
        errors_in(
            "denavit_hartenberg(standard) {\n\
             one: ball { a: 1 }\n\
             two: revolute { alfa: pi }\n\
             three { a: 1 }\n\
             four: screw;\n\
             five: fixed { mass: -1 }\n\
             }"
        ),
        "3:6: joint \"one\" has the unknown type \"ball\"\n  \
         hint: write spherical\n\
         4:17: joint \"two\" has the unknown key \"alfa\"\n  \
         hint: did you mean \"alpha\"? known keys: mass, com, inertia, inertia_rpy, a, alpha, d, \
         theta, pitch, link, limits and velocity\n\
         5:7: expected `:` after joint \"three\"\n  hint: write elbow: revolute { a: 0.3 }\n\
         6:7: joint \"four\" has no pitch\n  hint: add pitch: 0.01, in metres per radian\n\
         7:21: the mass of the link of joint \"five\" is negative: -1\n\
         7:1: the link of joint \"five\" has a mass but no inertia\n  \
         hint: add inertia: [0.01, 0.01, 0.01], with zeros for a point mass\n"
    );
}

#[test]
fn a_chain_begins_with_its_struct() {
    assert_eq!(
        try_read("link base;").1,
        "1:1: expected `struct`\n  hint: a chain begins with the struct it makes: struct Arm;\n"
    );
    assert_eq!(
        try_read("struct Arm<T>; link base;").1,
        "1:11: expected `{` or `;` after `Arm`\n"
    );
    assert_eq!(
        try_read("struct Arm;").1,
        "1:8: Arm has no description\n  \
         hint: name a file, urdf = \"arm.urdf\", or describe links and joints\n"
    );
    assert!(try_read("").0.is_none());
}

#[test]
fn a_file_and_an_inline_description_exclude_each_other() {
    assert_eq!(
        try_read("struct Arm { urdf: \"arm.urdf\", dh: \"arm.dh\" }").1,
        "1:36: Arm is described twice\n  \
         hint: name one file, or describe links and joints in place\n\
         1:20: cannot read nowhere/arm.urdf: there is no such file\n  \
         hint: paths are relative to the folder of Cargo.toml\n"
    );
}

#[test]
fn no_missing_token_panics() {
    let tokens: Vec<proc_macro2::TokenTree> = flatten(SCARA.parse().unwrap());
    assert!(tokens.len() > 30);
    for skipped in 0..tokens.len() {
        let rest: TokenStream = tokens
            .iter()
            .enumerate()
            .filter(|(n, _)| *n != skipped)
            .map(|(_, token)| token.clone())
            .collect();
        let mut errors = Errors::new();
        let _ = read(rest, Path::new("nowhere"), &mut errors);
    }
    for text in [
        SCARA,
        "struct A; denavit_hartenberg(standard) { a: revolute { a: 1, d: pi } }",
    ] {
        let words: Vec<&str> = text
            .split_inclusive([' ', ',', '(', '{', '[', ':'])
            .collect();
        for skipped in 0..words.len() {
            let mut words = words.clone();
            words.remove(skipped);
            if let Ok(tokens) = words.concat().parse() {
                let _ = read(tokens, Path::new("nowhere"), &mut Errors::new());
            }
        }
    }
}

fn flatten(tokens: TokenStream) -> Vec<proc_macro2::TokenTree> {
    tokens.into_iter().collect()
}

#[test]
fn deeply_nested_brackets_are_errors() {
    for (open, close) in [("(", ")"), ("[", "]"), ("{", "}")] {
        let nested = |depth: usize| {
            let (open, close) = (open.repeat(depth), close.repeat(depth));
            try_read(&format!("struct Arm; link base {open}{close}")).1
        };
        assert!(!nested(100).contains("are nested"), "{}", nested(100));
        assert_eq!(
            nested(100_000),
            "1:151: brackets are nested more than 128 deep\n"
        );
    }
}
