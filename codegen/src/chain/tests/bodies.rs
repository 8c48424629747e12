//! Links and joints: merged, locked, left out, ordered, reported.

use super::*;
use crate::description::Number;
use crate::expression::{Double, Expr, Input, Node};
use crate::joint::Motion;
use crate::space::FrameId;

/// The numbers of a body: second moments xx, yy, zz, xy, xz, yz, first moments, mass.
fn inertia(chain: &Chain, joint: usize) -> Vec<f64> {
    let entries = chain.joints[BodyId(joint)].inertia.entries();
    entries.iter().map(|&entry| number(chain, entry)).collect()
}

fn number(chain: &Chain, entry: Expr) -> f64 {
    chain.graph.value(entry).map_or(f64::NAN, Double::to_f64)
}

fn close(results: &[f64], expected: &[f64]) {
    assert_eq!(results.len(), expected.len());
    for (x, y) in results.iter().zip(expected) {
        assert!((x - y).abs() < 1e-15, "{results:?} for {expected:?}");
    }
}

fn names(chain: &Chain) -> Vec<&str> {
    let joints = chain.joints.iter();
    joints.map(|joint| joint.name.as_str()).collect()
}

const ROD: &str = "
    link rod { mass: 2.0, com: [0.1, 0, 0], inertia: [0.02, 0.03, 0.04] }
    link tip { mass: 1.0, com: [0.2, 0, 0], inertia: [0.01, 0.02, 0.03] }";

#[test]
fn links_on_fixed_joints_are_merged_with_the_body_that_carries_them() {
    let chain = fine(&format!(
        "struct Arm; link base; {ROD}
        joint hinge: revolute(z) {{ from: base, to: rod }}
        joint weld: fixed {{ from: rod, to: tip, at: xyz(0.5, 0, 0) rz(pi/2) }}"
    ));
    // By hand: the tip's centre of mass is at (0.5, 0.2, 0), and its x axis along y. Second moments
    // are ½ Tr(I) − I about the centre of mass: (0.025, 0.015, 0.005) for the rod and, rotated,
    // (0.01, 0.02, 0) for the tip; m c cᵗ adds (0.02, 0, 0) and (0.25, 0.04, 0) with 0.1 at xy.
    let expected = [
        0.305, 0.075, 0.005, 0.1, 0.0, 0.0, // second moments
        0.7, 0.2, 0.0, // first moments
        3.0,
    ];
    close(&inertia(&chain, 0), &expected);
    assert_eq!(chain.report.merged, [("tip".into(), "rod".into())]);
    let tip = &chain.frames[FrameId::FIRST];
    assert_eq!((tip.name.as_str(), tip.body), ("tip", Some(BodyId(0))));
    let at = tip.placement.entries();
    let at: Vec<f64> = at.iter().map(|&entry| number(&chain, entry)).collect();
    close(
        &at,
        &[0.0, -1.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    );
}

#[test]
fn links_merged_with_the_base_affect_no_joint() {
    let chain = fine(&format!(
        "struct Arm; link base; link plate {{ mass: 50, com: [1, 1, 1], inertia: [9, 9, 9] }} {ROD}
        joint bolts: fixed {{ from: base, to: plate, at: xyz(0, 0, 0.3) }}
        joint hinge: revolute(z) {{ from: plate, to: rod, at: xyz(0.1, 0, 0) }}
        joint weld: fixed {{ from: plate, to: tip }}"
    ));
    close(&inertia(&chain, 0)[9..], &[2.0]);
    assert_eq!(chain.joints[BodyId(0)].parent, None);
    let at = chain.joints[BodyId(0)].placement.translation.0;
    close(&at.map(|entry| number(&chain, entry)), &[0.1, 0.0, 0.3]);
}

#[test]
fn joints_come_parents_first_and_siblings_as_written() {
    let chain = fine(
        "struct Tree { base: b }
        joint late: revolute(z) { from: left, to: leaf }
        joint right: revolute(x) { from: b, to: rightmost }
        joint left: prismatic(y) { from: b, to: left }
        joint stem: revolute(z) { from: root, to: b }
        link root; link b; link left; link leaf; link rightmost; link other;
        joint beside: revolute(z) { from: root, to: other }",
    );
    assert_eq!(names(&chain), ["right", "left", "late"]);
    let parents: Vec<_> = chain.joints.iter().map(|joint| joint.parent).collect();
    assert_eq!(parents, [None, None, Some(BodyId(1))]);
    assert!(matches!(chain.joints[BodyId(1)].motion, Motion::Prismatic));
    assert_eq!(chain.report.base, "b");
    assert_eq!(chain.report.links, ["b", "left", "leaf", "rightmost"]);
    assert_eq!(chain.report.dropped, ["root", "other"]);
}

#[test]
fn a_branch_is_dropped_with_its_mass_and_locked_without_loss() {
    let whole = |settings| {
        fine(&format!(
            "struct Arm {{ {settings} }} link base; {ROD}
            joint hinge: revolute(z) {{ from: base, to: rod }}
            joint slide: prismatic(x) {{ from: rod, to: tip }}
            link eye; joint gaze: revolute(z) {{ from: rod, to: eye }}"
        ))
    };
    let dropped = whole("drop(tip)");
    assert_eq!(names(&dropped), ["hinge", "gaze"]);
    close(&inertia(&dropped, 0)[9..], &[2.0]);
    let locked = whole("lock(slide = 0.25)");
    assert_eq!(names(&locked), ["hinge", "gaze"]);
    close(&inertia(&locked, 0)[6..], &[0.65, 0.0, 0.0, 3.0]);
    assert_eq!(locked.report.locked, [("slide".into(), 0.25)]);
    // Joints off the path to the tip are locked at zero or at a given value.
    let path = whole("tip: eye, path_only");
    assert_eq!(names(&path), ["hinge", "gaze"]);
    close(&inertia(&path, 0)[6..], &[0.4, 0.0, 0.0, 3.0]);
    let path = whole("tip: eye, path_only, lock(slide = 0.25)");
    close(&inertia(&path, 0)[6..], &[0.65, 0.0, 0.0, 3.0]);
}

#[test]
fn right_angles_are_exact_and_reported_unless_exact_is_set() {
    let arm = |settings| {
        fine(&format!(
            "struct Arm {{ {settings} }} link base; link rod;
            joint hinge: revolute(z) {{ from: base, to: rod, at: rx(-4.7124) rz(10.99557) }}"
        ))
    };
    let snapped = arm("");
    let rotation = snapped.joints[BodyId(0)].placement.rotation.0;
    assert_eq!(number(&snapped, rotation[2][2]), 0.0);
    let reported = snapped.report.snapped.iter();
    let reported: Vec<_> = reported
        .map(|angle| (angle.item.as_str(), angle.written, angle.quarters))
        .collect();
    assert_eq!(reported, [("hinge", -4.7124, -3), ("hinge", 10.99557, 7)]);

    let written = arm("exact");
    let rotation = written.joints[BodyId(0)].placement.rotation.0;
    assert_eq!(number(&written, rotation[2][2]), (-4.7124_f64).cos());
    assert!(written.report.snapped.is_empty());
}

#[test]
fn residues_are_zero_and_reported_unless_exact_is_set() {
    let arm = |settings| {
        fine(&format!(
            "struct Arm {{ {settings} }} link base; link rod;
            joint hinge: revolute([1e-16, 0.0, 1.0]) {{
                from: base, to: rod, at: xyz(0.5, -3e-17, 0.0) rx(-1.6653e-16) rz(0.5)
            }}"
        ))
    };
    let meant = arm("");
    let [hinge] = &*meant.joints else {
        panic!("one joint")
    };
    assert_eq!(number(&meant, hinge.placement.translation.y()), 0.0);
    assert_eq!(number(&meant, hinge.placement.rotation.0[2][2]), 1.0);
    assert_eq!(number(&meant, hinge.placement.rotation.0[2][1]), 0.0);
    assert_eq!(number(&meant, hinge.axis.x()), 0.0);
    assert_eq!(meant.report.right_angles_and_residues(), (0, 3));

    let written = arm("exact");
    let [hinge] = &*written.joints else {
        panic!("one joint")
    };
    assert_eq!(number(&written, hinge.placement.translation.y()), -3e-17);
    assert_eq!(number(&written, hinge.axis.x()), 1e-16);
    assert!(written.report.snapped.is_empty());
}

#[test]
fn impossible_numbers_are_refused() {
    let (mut description, request) = read(
        "struct Arm; link base; link rod { mass: 1.0, inertia: [0, 0, 0] }
        joint hinge: revolute(z) { from: base, to: rod, at: xyz(0.5, 0.0, 0.0) rz(1e17) }",
    );
    description.joints[0].axis = [Number::default(); 3];
    let infinite = Number {
        value: f64::INFINITY,
        ..Number::default()
    };
    description.links[1]
        .inertial
        .as_mut()
        .expect("it has a mass")
        .mass = infinite;
    let refusal = build(&description, &request)
        .expect_err("three mistakes")
        .to_string();
    for mistake in [
        "has an angle so large that its digits do not resolve a revolution",
        "has an axis without a direction",
        "link \"rod\" has a number that is not finite",
    ] {
        assert!(refusal.contains(mistake), "{refusal}");
    }
}

#[test]
fn numbers_whose_products_would_overflow_are_refused_each() {
    let arm = |mass: &str, com: &str, moment: &str| {
        format!(
            "struct Arm; link base; link rod {{ mass: {mass}, com: [{com}, 0.0, 0.0], \
             inertia: [{moment}, 0, 0] }}
            joint hinge: revolute(z) {{ from: base, to: rod }}"
        )
    };
    let mistake = r#"error: link "rod" has a number that is too large"#;
    assert_eq!(said(&arm("1e300", "1e50", "-1.1e30")), lines(&[mistake; 3]));
    fine(&arm("1e30", "-1e30", "1e30"));
}

#[test]
fn a_chain_of_thousands_of_joints_with_one_that_moves_is_accepted() {
    let joint = |k: usize| {
        format!(
            "joint j{k}: revolute(y) {{ at: xyz(0.1, 0, 0) rpy(0.1, 0.2, 0.3) }}
            link l{k} {{ mass: 1, inertia: [1, 1, 1] }}\n"
        )
    };
    let joints: String = (1..3000).map(joint).collect();
    let chain = fine(&format!(
        "struct Snake {{ tip: l1, path_only }} link l0; {joints}"
    ));
    assert_eq!(names(&chain), ["j1"]);
    assert_eq!(number(&chain, chain.joints[BodyId(0)].axis.y()), 1.0);
}

/// The chain of an arm with a field for a target.
fn with_field(text: &str, target: Target) -> Chain {
    let (description, mut request) = read(text);
    let field = quote::format_ident!("field");
    request.parameters.push(Parameter {
        field,
        target,
        range: None,
    });
    build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn fields_become_inputs() {
    let arm = format!(
        "struct Arm; link base; {ROD}
        joint hinge: revolute(z) {{ from: base, to: rod, at: xyz(1, 2, 3) rx(0.3) }}
        joint weld: fixed {{ from: rod, to: tip }}"
    );
    let input = |chain: &Chain, entry: Expr| chain.graph.node(entry);
    let expected = |k| Node::Input(Input::Parameter(0, k));
    let chain = with_field(&arm, Target::Gravity);
    assert_eq!(input(&chain, chain.gravity.0[2]), expected(2));

    let chain = with_field(&arm, Target::OriginOf(named("hinge")));
    let placement = chain.joints[BodyId(0)].placement;
    assert_eq!(input(&chain, placement.translation.0[1]), expected(1));
    assert_eq!(number(&chain, placement.rotation.0[2][1]), 0.3_f64.sin());

    let chain = with_field(&arm, Target::MassOf(named("rod")));
    assert!(
        chain
            .graph
            .value(chain.joints[BodyId(0)].inertia.mass)
            .is_none()
    );
    let chain = with_field(&arm, Target::CenterOfMassOf(named("rod")));
    close(
        &[number(&chain, chain.joints[BodyId(0)].inertia.mass)],
        &[3.0],
    );
    assert!(
        chain
            .graph
            .value(chain.joints[BodyId(0)].inertia.q.0[0])
            .is_none()
    );
}

#[test]
fn a_payload_on_a_massless_link_is_a_point_mass() {
    let arm = "struct Arm { strict } link base; link flange;
        joint hinge: revolute(z) { from: base, to: rod }
        joint mount: fixed { from: rod, to: flange, at: xyz(0.5, 0, 0) } link rod;";
    let (description, request) = read(arm);
    let errors = build(&description, &request).expect_err("a body without mass");
    assert_eq!(
        errors.to_string(),
        "error: link \"rod\" moves and has no inertia: taken as massless (refused: strict)\n"
    );

    let chain = with_field(arm, Target::MassOf(named("flange")));
    let inertia = chain.joints[BodyId(0)].inertia;
    assert_eq!(
        chain.graph.node(inertia.mass),
        Node::Input(Input::Parameter(0, 0))
    );
    let Node::Mul(half, mass) = chain.graph.node(inertia.q.0[0]) else {
        panic!("half a metre times the mass");
    };
    assert_eq!((number(&chain, half), mass), (0.5, inertia.mass));
}

#[test]
fn links_without_inertia_give_one_warning() {
    let chain = fine(
        "struct Arm; link base; joint one: revolute(z); link upper; joint two: revolute(y);
        link fore; joint three: revolute(y); link hand;",
    );
    let reported = chain.report.warnings.iter();
    let reported: Vec<_> = reported.map(|warning| warning.message.as_str()).collect();
    let expected =
        "links \"upper\", \"fore\" and \"hand\" move and have no inertia: taken as massless";
    assert_eq!(reported, [expected]);

    // Kinematics needs no inertia.
    let of_frames = "struct Arm { strict, generate(forward_kinematics, velocity) } link base;
        joint one: revolute(z); link upper;";
    assert_eq!(fine(of_frames).report.warnings.len(), 0);
    let of_forces = of_frames.replace("velocity", "gravity");
    assert!(said(&of_forces).contains("has no inertia"));
}

#[test]
fn non_physical_inertias_are_reported_with_the_amount() {
    let arm = |settings| {
        format!(
            "struct Arm {{ {settings} }} link base;
            link rod {{ mass: 1, com: [0, 0, 0], inertia: [0.1, 0.2, 0.5] }}
            link tip {{ mass: 0, com: [0, 0, 0], inertia: [0.1, 0.1, 0.1] }}
            joint hinge: revolute(z) {{ from: base, to: rod }}
            joint weld: fixed {{ from: rod, to: tip }}"
        )
    };
    let chain = fine(&arm(""));
    let reported = chain.report.warnings.iter();
    let reported: Vec<_> = reported.map(|warning| warning.message.as_str()).collect();
    let expected = [
        "the inertia of link \"rod\" is not physical: a second moment about its centre of mass is \
         -1.000e-1 kg m² (-33.3 % of the largest)",
        "link \"tip\" has no mass but an inertia",
    ];
    assert_eq!(reported, expected);
    close(&inertia(&chain, 0)[..3], &[0.35, 0.25, -0.05]);
    let refused = expected.map(|warning| format!("error: {warning} (refused: strict)\n"));
    assert_eq!(said(&arm("strict")), refused.concat());
}

#[test]
fn places_in_a_file_reach_the_messages_of_the_chain() {
    let text = "<robot name=\"arm\">\n <link name=\"base\"/>\n <link name=\"rod\"/>\n\
        <joint name=\"hinge\" type=\"revolute\">\n  <parent link=\"bas\"/>\n  \
        <child link=\"rod\"/>\n <limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>\
        </joint>\n</robot>";
    let mut errors = Errors::new();
    let description = crate::description::read_text(text, "arm.urdf", None, &mut errors);
    let description = description.expect("it can be read");
    let errors = build(&description, &Request::default()).expect_err("no such link");
    // Earlier warnings are listed beside the error.
    let expected = "error: arm.urdf:5:17: there is no link \"bas\"\n  hint: did you mean \"base\"? links: \"base\" and \"rod\"\n\
        warning: arm.urdf:4:1: joint \"hinge\" has no <axis>: its axis is x, as URDF defines\n  \
        hint: write <axis xyz=\"1 0 0\"/>\n";
    assert_eq!(errors.to_string(), expected);
}
