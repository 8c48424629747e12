//! Struct fields: what they replace, and what they cannot replace.

use super::*;
use crate::expression::{Double, Evaluation, Expr, Input};

/// An arm with fields of these names.
fn with_fields(text: &str, fields: Vec<(&str, Target)>) -> Result<Chain, Errors> {
    let (description, mut request) = read(text);
    let fields = fields.into_iter().map(|(name, target)| Parameter {
        field: quote::format_ident!("{name}"),
        target,
        range: None,
    });
    request.parameters = fields.collect();
    build(&description, &request)
}

fn refused(text: &str, fields: Vec<(&str, Target)>) -> String {
    let refusal = with_fields(text, fields).expect_err("a mistake");
    refusal.to_string()
}

/// Numbers of a chain whose only field has these entries.
fn at(chain: &Chain, exprs: &[Expr], field: &[f64]) -> Vec<f64> {
    let found = Evaluation::<Double>::of(&chain.graph, exprs).at(|input| match input {
        Input::Parameter(0, entry) => Double::from(field[usize::from(entry)]),
        other => panic!("{other:?} is read"),
    });
    found.into_iter().map(Double::to_f64).collect()
}

fn close(results: &[f64], expected: &[f64]) {
    assert_eq!(results.len(), expected.len());
    for (x, y) in results.iter().zip(expected) {
        assert!((x - y).abs() < 1e-15, "{results:?} for {expected:?}");
    }
}

/// The first link moves; the last has no mass, and is rotated about x.
const ARM: &str = "struct Arm { strict } link base;
    link rod { mass: 2.0, com: [0.1, 0, 0], inertia: [0.02, 0.03, 0.04] } link flange;
    joint hinge: revolute(z) { from: base, to: rod }
    joint weld: fixed { from: rod, to: flange, at: xyz(0.5, 0, 0) rx(pi/2) }";

#[test]
fn a_payload_is_added_to_the_described_inertia() {
    let chain = with_fields(ARM, vec![("load", Target::PayloadOn(named("flange")))]);
    let chain = chain.unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(*chain.nominal, [[0.0; 10].to_vec()]);
    let inertia = chain.joints[BodyId(0)].inertia.entries();
    // By hand: the rod's second moments are (0.025, 0.015, 0.005), and 0.02 more at xx.
    let empty = at(&chain, &inertia, &[0.0; 10]);
    close(
        &empty,
        &[0.045, 0.015, 0.005, 0.0, 0.0, 0.0, 0.2, 0.0, 0.0, 2.0],
    );
    // (0.1, 0.2, 0.3) in the flange is (0.6, −0.3, 0.2) in the rod. About that point, ∫rrᵗdm is
    // (0.03, 0.02, 0.01) with 0.004 at xy, −0.003 at xz and 0.002 at yz in the flange's axes; in the
    // rod's y is −z, and z is y.
    let load = [4.0, 0.1, 0.2, 0.3, 0.03, -0.004, 0.003, 0.04, -0.002, 0.05];
    let loaded = at(&chain, &inertia, &load);
    let added: Vec<f64> = loaded.iter().zip(&empty).map(|(x, y)| x - y).collect();
    let square = [1.44, 0.36, 0.16, -0.72, 0.48, -0.24];
    let about = [0.03, 0.01, 0.02, 0.003, 0.004, -0.002];
    let mut expected: Vec<f64> = square.iter().zip(about).map(|(x, y)| x + y).collect();
    expected.extend([2.4, -1.2, 0.8, 4.0]);
    close(&added, &expected);
}

#[test]
fn payloads_on_unknown_or_fixed_links_and_duplicates_are_refused() {
    let load = |link: &str| Target::PayloadOn(named(link));
    let fields = vec![
        ("one", load("flang")),
        ("two", load("base")),
        ("three", load("rod")),
        ("four", load("rod")),
    ];
    assert_eq!(
        refused(ARM, fields),
        lines(&[
            r#"error: field `four` stands for a payload on link "rod", as `three` does"#,
            "  hint: leave out one of them",
            r#"error: there is no link "flang""#,
            r#"  hint: did you mean "flange"? links: "base", "rod" and "flange""#,
            r#"error: link "base" does not move: a payload on it changes nothing"#,
            "  hint: leave the field out, or choose a base above the link in the tree"
        ])
    );
    assert_eq!(
        load("rod").refusal([-1.0, 1.0]).map(|[problem, _]| problem),
        Some("has negative masses")
    );
}

#[test]
fn the_default_range_of_a_payload_is_physical() {
    let load = Parameter {
        field: quote::format_ident!("load"),
        target: Target::PayloadOn(named("rod")),
        range: Some([0.0, 4.0]),
    };
    let (mass, center) = ([0.0, 4.0], [-0.25, 0.25]);
    let (moment, product) = ([0.0, 0.25], [-0.125, 0.125]);
    assert_eq!(
        load.ranges(&[0.0; 10]),
        [
            mass, center, center, center, moment, product, product, moment, product, moment
        ]
    );
    let names = ["m", "x", "y", "z", "xx", "xy", "xz", "yy", "yz", "zz"];
    assert_eq!(load.entries(), names.map(|name| format!("load_{name}")));
    assert_eq!(
        load.range_words(&[0.0; 10]),
        "`load` from 0 to 4 kg, its centre of mass up to 0.25 m along each axis, its moments of inertia \
         up to 0.25 kg m² and its products up to half of that, as a body has them"
    );
}

#[test]
fn an_inertia_is_about_the_centre_of_mass_in_the_axes_of_the_inertial() {
    let chain = with_fields(ARM, vec![("tensor", Target::InertiaOf(named("rod")))]);
    let chain = chain.unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(*chain.nominal, [[0.02, 0.0, 0.0, 0.03, 0.0, 0.04].to_vec()]);
    let inertia = chain.joints[BodyId(0)].inertia.entries();
    let tensor = [0.05, 0.001, 0.002, 0.06, 0.003, 0.07];
    let found = at(&chain, &inertia, &tensor);
    // ½ Tr(I) − I, and for a mass of 2 at x = 0.1 0.02 more at xx.
    let expected = [0.06, 0.03, 0.02, -0.001, -0.002, -0.003, 0.2, 0.0, 0.0, 2.0];
    close(&found, &expected);

    // An inertial that is rotated about x: its y is z of the link.
    let turned = r#"<robot name="arm"><link name="base"/><link name="rod"><inertial>
        <origin rpy="1.5707963267948966 0 0"/><mass value="1"/>
        <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
        <joint name="hinge" type="continuous"><parent link="base"/><child link="rod"/></joint></robot>"#;
    let mut errors = Errors::new();
    let description = crate::description::read_text(turned, "arm.urdf", None, &mut errors);
    let request = Request {
        parameters: vec![Parameter {
            field: quote::format_ident!("tensor"),
            target: Target::InertiaOf(named("rod")),
            range: None,
        }],
        ..Request::default()
    };
    let chain = build(&description.expect("it can be read"), &request).expect("no mistakes");
    let inertia = chain.joints[BodyId(0)].inertia.entries();
    let found = at(&chain, &inertia, &[4.0, 0.0, 0.0, 5.0, 0.0, 6.0]);
    close(&found[..3], &[3.5, 1.5, 2.5]);
}

#[test]
fn the_inertia_of_a_massless_link_gives_a_warning_and_of_a_fixed_one_is_refused() {
    let of = |link: &str| vec![("tensor", Target::InertiaOf(named(link)))];
    assert_eq!(
        refused(ARM, of("flange")),
        "error: link \"flange\" has no mass but an inertia: field `tensor` (refused: strict)\n"
    );
    assert_eq!(
        refused(ARM, of("base")),
        lines(&[
            r#"error: link "base" does not move: its inertia changes nothing"#,
            "  hint: leave the field out, or choose a base above the link in the tree"
        ])
    );
    let tensor = Target::InertiaOf(named("rod"));
    let problem = tensor.refusal([-1.0, 1.0]).map(|[problem, _]| problem);
    assert_eq!(problem, Some("has negative moments of inertia"));
    let field = Parameter {
        field: quote::format_ident!("tensor"),
        target: tensor,
        range: None,
    };
    let nominal = [0.02, 0.0, 0.0, 0.03, 0.0, 0.04];
    assert_eq!(
        field.range_words(&nominal),
        "moments of `tensor` from 0 to 0.08 kg m² and its products up to half of that"
    );
    assert_eq!(field.ranges(&nominal)[1], [-0.04, 0.04]);
}

#[test]
fn the_base_has_the_position_of_a_field() {
    let text = "struct Arm; link base; link eye;
        joint hinge: revolute(z) { from: base, to: rod, at: xyz(1, 2, 3) rx(0.3) } link rod
            { mass: 1.0, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01] }
        joint mount: fixed { from: base, to: eye, at: xyz(0, 0, 0.5) }";
    let place = || Target::BasePosition;
    let chain = with_fields(
        &text.replace("Arm", "Arm { tip: rod, frames(eye, base) }"),
        vec![("at", place())],
    );
    let chain = chain.unwrap_or_else(|errors| panic!("{errors}"));
    let joint = chain.joints[BodyId(0)].placement.translation.0;
    close(
        &at(&chain, &joint, &[10.0, 20.0, 30.0]),
        &[11.0, 22.0, 33.0],
    );
    let [_, eye, base] = &*chain.frames else {
        panic!("three frames");
    };
    for (frame, z) in [(eye, 30.5), (base, 30.0)] {
        assert_eq!(frame.body, None);
        let found = at(&chain, &frame.placement.translation.0, &[10.0, 20.0, 30.0]);
        close(&found, &[10.0, 20.0, z]);
    }
    assert_eq!(*chain.nominal, [[0.0; 3].to_vec()]);
    assert_eq!(
        refused(text, vec![("one", place()), ("two", place())]),
        "error: field `two` stands for the position of the base, as `one` does\n  hint: leave out one of them\n"
    );
}

#[test]
fn joint_and_base_have_the_placements_of_fields() {
    let text = "struct Arm { tip: rod } link base;
        joint hinge: revolute(z) { from: base, to: rod, at: xyz(1, 2, 3) rz(0.5) rx(pi/2) } link rod
            { mass: 1.0, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01] }";
    let place = [4.0, 5.0, 6.0, 0.3, -0.2, 0.7];
    // Rz(0.7) Ry(-0.2) Rx(0.3), entry by entry.
    let [(sr, cr), (sp, cp), (sy, cy)] = [0.3, -0.2, 0.7].map(f64::sin_cos);
    let turn = [
        cy * cp,
        cy * sp * sr - sy * cr,
        cy * sp * cr + sy * sr,
        sy * cp,
        sy * sp * sr + cy * cr,
        sy * sp * cr - cy * sr,
        -sp,
        cp * sr,
        cp * cr,
    ];
    let chain = with_fields(text, vec![("at", Target::PlacementOf(named("hinge")))]);
    let chain = chain.unwrap_or_else(|errors| panic!("{errors}"));
    let placement = chain.joints[BodyId(0)].placement;
    close(&at(&chain, &placement.rotation.0.concat(), &place), &turn);
    close(
        &at(&chain, &placement.translation.0, &place),
        &[4.0, 5.0, 6.0],
    );
    // As described: about z, then about the new x.
    close(
        &chain.nominal[0_u16.into()],
        &[1.0, 2.0, 3.0, std::f64::consts::FRAC_PI_2, 0.0, 0.5],
    );

    let chain = with_fields(text, vec![("at", Target::BasePlacement)]);
    let chain = chain.unwrap_or_else(|errors| panic!("{errors}"));
    let origin = chain.joints[BodyId(0)].placement.translation.0;
    let expected: [f64; 3] = std::array::from_fn(|row| {
        let turned = (0..3)
            .zip([1.0, 2.0, 3.0])
            .map(|(k, entry)| turn[3 * row + k] * entry);
        place[row] + turned.sum::<f64>()
    });
    let found = at(&chain, &origin, &place);
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() < 4e-15, "{found:?} for {expected:?}");
    }
    assert_eq!(*chain.nominal, [[0.0; 6].to_vec()]);
}

#[test]
fn a_placement_is_one_field_of_an_existing_joint() {
    let text = "struct Arm { drop(tool) } link base; link tool;
        joint hinge: revolute(z) { from: base, to: rod } link rod
            { mass: 1.0, com: [0.1, 0, 0], inertia: [0.01, 0.01, 0.01] }
        joint mount: fixed { from: rod, to: tool }";
    let fields = vec![
        ("one", Target::OriginOf(named("hinge"))),
        ("two", Target::PlacementOf(named("hinge"))),
        ("three", Target::BasePosition),
        ("four", Target::BasePlacement),
        ("five", Target::PlacementOf(named("mount"))),
    ];
    assert_eq!(
        refused(text, fields),
        lines(&[
            r#"error: field `two` stands for the placement of joint "hinge", as `one` does"#,
            "  hint: leave out one of them",
            "error: field `four` stands for the placement of the base, as `three` does",
            "  hint: leave out one of them",
            r#"error: joint "mount" is not modelled"#
        ])
    );
    let field = Parameter {
        field: quote::format_ident!("at"),
        target: Target::PlacementOf(named("hinge")),
        range: None,
    };
    let nominal = [0.0, 0.5, 0.25, 1.0, 0.0, 3.0];
    assert_eq!(
        field.range_words(&nominal),
        "lengths of `at` ≤ 1 m, its angles ≤ π rad"
    );
    let names = ["x", "y", "z", "roll", "pitch", "yaw"].map(|name| format!("at_{name}"));
    assert_eq!(field.entries(), names);
}
