//! Tests of the chosen form, of warnings and of errors.

use proc_macro2::{Ident, Span};

use super::super::choice::cheapest;
use super::super::measured::{ENOUGH, Measure};
use super::super::program::program_by;
use super::super::solvable::{at_the_end, solvable};
use super::hopeless;
use crate::chain::{self, Chain};
use crate::description::{Description, Name, read_text};
use crate::error::Errors;
use crate::expand::understand;
use crate::expression::{Double, Input};
use crate::formulation::{Formulation, Forward, Frame};
use crate::function::Function::{self, ForwardDynamics, MassMatrixInverse};
use crate::layout::Layout;
use crate::model::Algorithm;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::{Parameter, Request, Target};
use crate::schedule::run;
use crate::space::{FrameId, Variable};

const SOLVED: [Function; 2] = [ForwardDynamics, MassMatrixInverse];

/// An inertia at the end of a link of 1 m: mass, and moment about the joints' axes.
type End = (f64, f64);

/// Links in a plane, one after the other.
fn described(links: &[End]) -> Description {
    let names = ["base", "upper", "lower", "hand", "finger"];
    let joints = ["shoulder", "elbow", "wrist", "knuckle"];
    let links = links.iter().enumerate().map(|(k, (mass, moment))| {
        format!(
            r#"<link name="{child}"><inertial><origin xyz="1 0 0"/><mass value="{mass}"/>
            <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="{moment}"/></inertial></link>
            <joint name="{joint}" type="continuous"><parent link="{parent}"/><child link="{child}"/>
            <origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>"#,
            child = names[k + 1],
            joint = joints[k],
            parent = names[k],
        )
    });
    let links: String = links.collect();
    let text = format!(r#"<robot name="arm"><link name="base"/>{links}</robot>"#);
    let mut errors = Errors::new();
    let description = read_text(&text, "arm.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

fn arm(links: &[End]) -> Chain {
    chain::build(&described(links), &Request::default()).expect("a tree")
}

/// An arm with masses at the ends of two links.
fn ends(first: f64, second: f64) -> Chain {
    arm(&[(first, 0.0), (second, 0.0)])
}

/// Four rods, the last with a mass of its own.
fn heavy_tip(mass: f64) -> [End; 4] {
    [1.0, 1.0, 1.0, mass].map(|mass| (mass, mass / 3.0))
}

/// The form chosen for a function in a scalar type.
fn choose(chain: &Chain, function: Function, scalar: Real) -> Result<Forward, Errors> {
    let (processor, formulation) = (Processor::Portable, Formulation::default());
    let found = cheapest(
        processor,
        formulation,
        chain,
        &[function],
        FrameId::FIRST,
        scalar,
    )?;
    Ok(found.algorithm.forward)
}

fn refusal(chain: &Chain, function: Function, scalar: Real) -> String {
    choose(chain, function, scalar)
        .expect_err("refused")
        .to_string()
}

#[test]
fn an_ordinary_arm_needs_no_refinement() {
    for scalar in [Real::F32, Real::F64, Real::Generic] {
        for function in SOLVED {
            let form = choose(&ends(1.0, 1.0), function, scalar);
            assert_eq!(form.expect("regular"), Forward::UNREFINED);
        }
    }
}

#[test]
fn a_heavy_tip_is_refined_where_that_restores_the_digits() {
    let refined = |form| matches!(form, Forward::MassMatrix { refinements: 1.. });
    for (mass, scalar) in [(1e3, Real::F32), (1e3, Real::F64), (1e6, Real::F64)] {
        for function in SOLVED {
            let form = choose(&arm(&heavy_tip(mass)), function, scalar).expect("regular");
            assert!(
                refined(form),
                "{function:?}, {mass:e} kg, {scalar:?}: {form:?}"
            );
        }
    }
}

/// A massless prismatic joint carries a ball joint, whose arm carries a block on another prismatic joint. Nothing
/// resists the first where it points along the arm's z, as in half of the rotations that permute the axes; elsewhere
/// the mass matrix is regular.
#[test]
fn ball_joints_are_measured_with_rotated_axes() {
    let text = r#"<robot name="hammer"><link name="base"/><link name="carriage"/>
        <joint name="slide" type="prismatic"><parent link="base"/><child link="carriage"/><axis xyz="1 0 0"/>
        <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
        <joint name="ball" type="spherical"><parent link="carriage"/><child link="arm"/></joint>
        <link name="arm"><inertial><origin xyz="0.2 0 0"/><mass value="10"/>
        <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
        <joint name="plane" type="planar"><parent link="arm"/><child link="block"/><axis xyz="0 1 0"/></joint>
        <link name="block"><inertial><mass value="13"/>
        <inertia ixx="2" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>"#;
    let description = read_text(text, "hammer.urdf", None, &mut Errors::new());
    let description = description.expect("no mistakes, so a description");
    let chain = chain::build(&description, &Request::default()).expect("a tree");
    for scalar in [Real::F32, Real::F64, Real::Generic] {
        choose(&chain, ForwardDynamics, scalar).expect("regular in most configurations");
    }
}

/// Balls of a centimetre at joints about z, x and y, of which two in three intersect. Frames at common normals
/// are cheaper, but so far from the balls that the balls' inertias are lost in the rounding of that distance.
#[test]
fn a_form_is_given_up_only_if_it_loses_digits_in_every_layout() {
    let at = ["0 0.3 0", "0 0 0", "0.3 0 0"];
    let axes = ["0 0 1", "1 0 0", "0 1 0"];
    let balls = (1..=8).map(|k: usize| {
        let (at, axis, parent) = (at[(k - 1) % 3], axes[(k - 1) % 3], k - 1);
        format!(
            r#"<link name="{k}"><inertial><mass value="0.1"/>
            <inertia ixx="1e-6" ixy="0" ixz="0" iyy="1e-6" iyz="0" izz="1e-6"/></inertial></link>
            <joint name="turns {k}" type="continuous"><parent link="{parent}"/><child link="{k}"/>
            <origin xyz="{at}"/><axis xyz="{axis}"/></joint>"#
        )
    });
    let balls: String = balls.collect();
    let text = format!(r#"<robot name="balls"><link name="0"/>{balls}</robot>"#);
    let description = read_text(&text, "balls.urdf", None, &mut Errors::new());
    let description = description.expect("no mistakes, so a description");
    let chain = chain::build(&description, &Request::default()).expect("a tree");
    let mut measure = Measure::of(&chain, &[ForwardDynamics], 1.0, Real::F64);
    let mut worst = |forward| {
        let formulation = Formulation::default().with_forward(forward);
        let (processor, functions) = (Processor::Portable, &[ForwardDynamics]);
        let found = cheapest(
            processor,
            formulation,
            &chain,
            functions,
            FrameId::FIRST,
            Real::F64,
        );
        let found = found.expect("regular");
        (found.algorithm.forward, measure.error(&found.program).worst)
    };
    let (lightest, chosen) = (worst(Some(Forward::Articulated)), worst(None));
    assert!(lightest.1 > ENOUGH, "{lightest:?}");
    assert_eq!(chosen.0, Forward::Articulated);
    assert!(chosen.1 <= ENOUGH, "{chosen:?}");
}

/// A torso on a waist of three joints in light links, whose first and last axes are in line at a right angle of the
/// second, beyond its limits. A rotation with four products loses the inertia of the light links there.
#[test]
fn a_form_that_loses_digits_beyond_the_limits_is_given_up() {
    let text = "struct Waist {} link pelvis;
        joint yaw: revolute(z) { at: xyz(0, 0, 0.1), limits: [-2.6, 2.6] }
        link ring { mass: 0.3, com: [0.01, -0.005, 0.02], inertia: [9e-5, 12e-5, 6e-5] }
        joint roll: revolute(x) { limits: [-0.5, 0.5] }
        link cross { mass: 0.3, com: [0.01, -0.005, 0.02], inertia: [9e-5, 12e-5, 6e-5] }
        joint pitch: revolute(y) { limits: [-0.5, 0.5] }
        link torso { mass: 8, com: [0.01, 0, 0.18], inertia: [0.1, 0.08, 0.03] }";
    let chain = chain::tests::fine(text);
    let algorithm = Algorithm {
        forward: Forward::Articulated,
        ..Algorithm::PLAIN
    };
    let functions = [ForwardDynamics];
    let program = program_by(
        &chain,
        &functions,
        FrameId::FIRST,
        Layout::DESCRIBED,
        algorithm,
    );
    let mut measure = Measure::of(&chain, &functions, 1.0, Real::F64);
    let within = measure.error_within_limits(&program).worst;
    let sparing = measure.error(&program);
    assert!(
        within <= ENOUGH && sparing.worst > ENOUGH,
        "{within}, {sparing:?}"
    );
}

#[test]
fn a_robot_is_refused_if_no_form_leaves_half_of_the_digits() {
    for function in SOLVED {
        let refusal = refusal(&arm(&heavy_tip(1e7)), function, Real::F32);
        let message = format!("{} would lose ", function.name());
        assert!(refusal.contains(&message), "{refusal}");
        assert!(
            refusal.contains("\" the mass matrix loses a factor of "),
            "{refusal}"
        );
        assert!(refusal.contains("generate it for f64"), "{refusal}");
    }
}

/// A point mass is carried by two axes through one other point. In their plane, which the configuration of the
/// description nearly is, the accelerations of the two joints are undetermined, and near it almost so.
#[test]
fn a_robot_that_passes_through_a_singular_configuration_is_not_refused() {
    let text = "struct Arm { exact } link base; joint roll: continuous(-x); link fork;
        joint pitch: continuous([-0.5252502256283673, 0.7901016640150934, -0.31599297618448663]) {
            at: ry(-1.5707963) rx(1.57080) }
        link bob { mass: 0.5, com: [0, -0.09, 0], inertia: [0, 0, 0] }";
    let chain = chain::tests::fine(text);
    for function in SOLVED {
        let form = choose(&chain, function, Real::F64);
        form.unwrap_or_else(|errors| panic!("{errors}"));
    }
}

/// A point mass and three axes through nearly one other point; only the pitch of a screw joint resists rotation about
/// the line of the two points. M is almost singular: its refined inverse has the digits of large entries, and mirrored
/// errors spoil the product M M⁻¹.
#[test]
fn near_a_singular_configuration_an_inverse_still_inverts() {
    let text = "struct Bob { floating } link bob { mass: 0.5877580642700195, com: [0, 0.265, 0], inertia: [0, 0, 0] }
        joint wrist: universal(z, [0, 0.805824145531257, 0.5921549176345827]) {
            at: xyz(-0.004, 0, -0.943733) rx(0.128) }
        link fork; joint thread: screw(z, pitch: 0.0364) { at: xyz(0, -0.063, 0) }
        link nut { mass: 2, inertia: [0.0815431058, 0.08, 0.09] }";
    let chain = chain::tests::fine(text);
    let form = choose(&chain, MassMatrixInverse, Real::F64);
    assert_eq!(form.expect("regular"), Forward::UNREFINED);
}

/// The warnings about an arm for a request with a formulation.
fn warnings(links: &[End], words: Formulation, strict: bool) -> Result<Vec<String>, String> {
    let request = Request {
        functions: SOLVED.map(|function| vec![function]).to_vec(),
        formulation: words,
        scalar: Real::F64,
        strict,
        ..Request::default()
    };
    let chain = understand(&described(links), &request).map_err(|errors| errors.to_string())?;
    let warnings = chain.report.warnings.into_iter();
    Ok(warnings.map(|warning| warning.message).collect())
}

#[test]
fn the_faster_form_is_a_key_away_and_its_warning_states_the_loss() {
    let heavy = [(1.0, 0.0), (1e6, 0.0)];
    assert_eq!(
        warnings(&heavy, Formulation::default(), true),
        Ok(Vec::new())
    );
    let faster = Formulation::default().with_forward(Forward::UNREFINED);
    let reported = warnings(&heavy, faster, false).expect("doubted only");
    let [of_dynamics, of_inverse] = &reported[..] else {
        panic!("{reported:?}");
    };
    for (warning, function) in [
        (of_dynamics, "forward_dynamics"),
        (of_inverse, "mass_matrix_inverse"),
    ] {
        let start = format!("{function} with refined = 0 loses ");
        assert!(warning.starts_with(&start), "{warning}");
        assert!(
            warning.contains(" of its largest result: at joint \"shoulder\""),
            "{warning}"
        );
    }
    let refused = warnings(&heavy, faster, true).expect_err("strict");
    assert!(refused.contains("with refined = 0 loses"), "{refused}");
    assert_eq!(warnings(&[(1.0, 0.0); 2], faster, true), Ok(Vec::new()));
}

/// The larger relative error of both accelerations in f64, against 106 bits, nearly stretched.
fn error(chain: &Chain, refinements: usize) -> f64 {
    let forward = Forward::MassMatrix { refinements };
    let algorithm = Algorithm {
        forward,
        ..Algorithm::PLAIN
    };
    let program = program_by(
        chain,
        &[ForwardDynamics],
        FrameId::FIRST,
        Layout::DESCRIBED,
        algorithm,
    );
    let state = |input| match input {
        Input::Variable(Variable::Q, _) => 1e-4,
        Input::Variable(Variable::Qd, _) => 0.3,
        _ => 1.1,
    };
    let found = run::<f64>(&program, state);
    let exact = run::<Double>(&program, |input| Double::from(state(input)));
    let pairs = found.iter().zip(&exact);
    pairs.fold(0.0, |worst, (found, exact)| {
        worst.max((found / exact.to_f64() - 1.0).abs())
    })
}

#[test]
fn a_refinement_restores_the_digits_that_the_mass_matrix_lost() {
    let arm = ends(1.0, 1e8);
    let [plain, refined] = [0, 1].map(|refinements| error(&arm, refinements));
    assert!(
        plain > 1e-10 && refined < 1e-14,
        "{plain:e} and {refined:e}"
    );
}

/// All three forms, for an arm with skew axes; the inverse is compared with the mass matrix.
#[test]
fn every_form_of_the_inverse_inverts_the_mass_matrix() {
    let arm = arm(&[(1.3, 0.2), (0.7, 0.1)]);
    let at = |function, forward| {
        let algorithm = Algorithm {
            forward,
            ..Algorithm::PLAIN
        };
        let program = program_by(
            &arm,
            &[function],
            FrameId::FIRST,
            Layout::DESCRIBED,
            algorithm,
        );
        run::<Double>(&program, |_| Double::from(0.7))
    };
    let mass = at(Function::MassMatrix, Forward::UNREFINED);
    for forward in [
        Forward::UNREFINED,
        Forward::MassMatrix { refinements: 1 },
        Forward::MassMatrix { refinements: 2 },
        Forward::Articulated,
    ] {
        let inverse = at(MassMatrixInverse, forward);
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let product = mass[2 * row] * inverse[column] + mass[2 * row + 1] * inverse[2 + column];
            let unit = f64::from(u8::from(row == column));
            let missed = (product - Double::from(unit)).to_f64();
            assert!(missed.abs() < 1e-15, "{forward:?}: {missed:e}");
        }
    }
}

/// A motor that turns so much faster than its joint that single precision loses the inertia of the joint beside it.
#[test]
fn a_multiplier_that_loses_the_digits_is_named_instead_of_a_mass() {
    let text = r#"<robot name="geared"><link name="base"/>
        <link name="arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <link name="motor"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <link name="tool"><inertial><origin xyz="0.3 0 0"/><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="lift" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/></joint>
        <joint name="spin" type="continuous"><parent link="arm"/><child link="motor"/><axis xyz="0 1 0"/>
        <mimic joint="lift" multiplier="20000"/></joint>
        <joint name="reach" type="continuous"><parent link="arm"/><child link="tool"/><origin xyz="0.5 0 0"/><axis xyz="0 1 0"/></joint>
        </robot>"#;
    let mut errors = Errors::new();
    let geared = read_text(text, "geared.urdf", None, &mut errors).expect("a robot");
    let chain = chain::build(&geared, &Request::default()).expect("a chain");
    let of = (Real::F32, Frame::Link);
    let worst = solvable(&chain).expect("a mass matrix that can be inverted");
    let found = hopeless(&chain, worst, 1e6, &[ForwardDynamics], of).to_string();
    assert!(
        found.contains("joint \"spin\" mimics joint \"lift\" with a multiplier of 20000"),
        "{found}"
    );
}

#[test]
fn a_massless_end_is_refused_by_the_name_of_its_joint() {
    for function in SOLVED {
        let refusal = refusal(&ends(1.0, 0.0), function, Real::F64);
        assert!(
            refusal.starts_with(
                "error: arm.urdf:6:26: joint \"elbow\" can accelerate without any force"
            ),
            "{refusal}"
        );
        assert!(refusal.contains("give what it carries a mass"), "{refusal}");
    }
}

/// The pivot cancels but for the rounding of literals: at some angles the result is infinite, and so is the exact
/// value.
#[test]
fn two_joints_on_one_axis_with_nothing_between_are_refused_despite_rounded_literals() {
    let text = r#"<robot name="arm"><link name="base"/>
        <joint name="inner" type="continuous"><parent link="base"/><child link="ring"/>
        <axis xyz="0 -1 0"/></joint><link name="ring"/>
        <joint name="outer" type="continuous"><parent link="ring"/><child link="rod"/>
        <axis xyz="0 -1 0"/></joint>
        <link name="rod"><inertial><origin xyz="0 0 0.00726413727"/><mass value="2.416"/>
        <inertia ixx="0" ixy="0" ixz="0" iyy="0.147165418" iyz="0" izz="0"/></inertial></link>
        </robot>"#;
    let mut errors = Errors::new();
    let description = read_text(text, "arm.urdf", None, &mut errors).expect("a robot");
    let chain = chain::build(&description, &Request::default()).expect("a tree");
    for function in SOLVED {
        let refusal = refusal(&chain, function, Real::F64);
        assert!(
            refusal.contains("joint \"inner\" can accelerate without any force"),
            "{refusal}"
        );
    }
}

/// A negative moment about the shoulder's axis, and one about the elbow's.
#[test]
fn a_non_physical_inertia_is_not_called_singular() {
    for (links, carrier, joint) in [
        ([(1.0, -100.0), (1.0, 0.1)], "shoulder", "shoulder"),
        ([(1.0, 0.1), (1.0, -9.0)], "elbow", "elbow"),
    ] {
        for function in SOLVED {
            let refusal = refusal(&arm(&links), function, Real::F64);
            let message = format!(
                "the mass matrix is not positive definite: joint \"{carrier}\" carries a \
                 non-physical inertia, and joint \"{joint}\" accelerates against its force"
            );
            assert!(refusal.contains(&message), "{refusal}");
            assert!(refusal.contains("correct the inertias"), "{refusal}");
        }
    }
}

/// The arm with a field for the mass of a link.
fn with_field(links: &[End], link: &str) -> Result<Chain, Errors> {
    with_fields(links, &[("payload", link)])
}

/// The arm with fields for the masses of links.
fn with_fields(links: &[End], fields: &[(&str, &str)]) -> Result<Chain, Errors> {
    let parameter = |(field, link): &(&str, &str)| Parameter {
        field: Ident::new(field, Span::call_site()),
        target: Target::MassOf(Name::from(*link)),
        range: None,
    };
    let request = Request {
        functions: vec![vec![ForwardDynamics]],
        scalar: Real::F64,
        parameters: fields.iter().map(parameter).collect(),
        ..Request::default()
    };
    understand(&described(links), &request)
}

#[test]
fn a_field_that_costs_the_digits_at_the_end_of_its_range_is_named() {
    let chain = with_field(&[(0.0, 0.0), (0.0, 0.0), (0.0, 1e-18)], "hand").expect("a tree");
    let refusal = refusal(&chain, ForwardDynamics, Real::F64);
    assert!(refusal.contains(" would lose every digit"), "{refusal}");
    let hint = "field \"payload\" is described as zero and taken at the end of its range: \
                declare the range";
    assert!(refusal.contains(hint), "{refusal}");
}

#[test]
fn a_field_that_does_not_help_is_named() {
    let chain = with_field(&[(0.0, 0.0); 2], "upper").expect("a tree");
    let refusal = refusal(&chain, ForwardDynamics, Real::F64);
    let hint = "(field \"payload\", which is described as zero, does not help)";
    assert!(refusal.contains(hint), "{refusal}");
}

#[test]
fn several_fields_that_do_not_help_are_named_in_the_plural() {
    let fields = [("p", "upper"), ("a", "lower")];
    let chain = with_fields(&[(0.0, 0.0); 3], &fields).expect("a tree");
    let refusal = refusal(&chain, ForwardDynamics, Real::F64);
    let hint = "(fields \"p\" and \"a\", which are described as zero, do not help)";
    assert!(refusal.contains(hint), "{refusal}");
}

#[test]
fn several_fields_at_the_ends_of_their_ranges_are_named_in_the_plural() {
    let fields = [("p", "upper"), ("a", "lower")];
    let chain = with_fields(&[(0.0, 0.0), (0.0, 0.0), (1.0, 0.1)], &fields).expect("a tree");
    let hint = "; fields \"p\" and \"a\" are described as zero and taken at the ends of their ranges: \
                declare the ranges";
    assert_eq!(at_the_end(&chain), hint);
}

#[test]
fn a_field_may_make_an_arm_regular() {
    let chain = with_field(&[(1.0, 0.0), (0.0, 0.0)], "lower").expect("a tree");
    let form = choose(&chain, ForwardDynamics, Real::F64).expect("regular with a payload");
    assert_eq!(form, Forward::UNREFINED);
    let warnings: Vec<&str> = (chain.report.warnings.iter())
        .map(|warning| warning.message.as_str())
        .collect();
    let expected = "joint \"elbow\" can accelerate without any force where field \"payload\" is as \
                    described, zero: accelerations are infinite there";
    assert_eq!(warnings, [expected]);
    let described = with_field(&[(1.0, 0.0), (2.0, 0.0)], "lower").expect("a tree");
    assert!(described.report.warnings.is_empty());
}
