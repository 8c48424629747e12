//! Tests that the check accepts right programs and rejects all others.

use std::path::Path;

use super::Check;
use crate::chain::Chain;
use crate::description::{Description, inline, read_file, read_text};
use crate::error::Errors;
use crate::expand::{expand, understand};
use crate::expression::Double;
use crate::formulation::{Angles, Formulation, Forward, Frame, Parameters, Products};
use crate::function::{Function, Given, Truth};
use crate::request::{Parameter, Request, Target};
use crate::schedule::{Operand, Operation, Program, run};
use crate::space::FrameId;

pub(super) fn described(name: &str) -> Description {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../robots")
        .join(name);
    let mut errors = Errors::new();
    let description = read_file(&path, None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

fn field(name: &str, target: Target) -> Parameter {
    Parameter {
        field: quote::format_ident!("{name}"),
        target,
        range: None,
    }
}

/// A robot with placements in fields. Its programs compute some zeros, since the orthogonality of a rotation's
/// columns is not used.
fn placed() -> (Description, Request) {
    let parameters = vec![
        field("elbow", Target::PlacementOf("joint4".into())),
        field("wrist", Target::PlacementOf("joint7".into())),
        field("base", Target::BasePlacement),
    ];
    let request = Request {
        parameters,
        ..Request::default()
    };
    (described("panda_class.urdf"), request)
}

/// Robots with every type of joint, with and without fields.
fn robots() -> Vec<(Description, Request)> {
    let robot = |name: &str| (described(name), Request::default());
    let mut loaded = robot("panda_class.urdf");
    loaded.1.parameters = vec![
        field("gravity", Target::Gravity),
        field("mass", Target::MassOf("link5".into())),
        field("center", Target::CenterOfMassOf("link5".into())),
        field("origin", Target::OriginOf("joint3".into())),
        field("payload", Target::PayloadOn("link8".into())),
        field("inertia", Target::InertiaOf("link4".into())),
        field("base", Target::BasePosition),
    ];
    vec![
        loaded,
        robot("scara.urdf"),
        robot("stanford_general.urdf"),
        robot("quadruped.urdf"),
    ]
}

pub(super) fn all_of(
    description: &Description,
    request: &Request,
) -> Vec<(Vec<Function>, FrameId, Program)> {
    let module = expand(description, request).unwrap_or_else(|errors| panic!("{errors}"));
    let functions = module.functions.into_iter();
    functions
        .map(|generated| (generated.functions, FrameId::FIRST, generated.program))
        .collect()
}

fn prepare(description: &Description, request: &Request) -> (Chain, Check) {
    let chain = understand(description, request).unwrap_or_else(|errors| panic!("{errors}"));
    let chain = chain.identified();
    let check = Check::of(&chain).unwrap_or_else(|errors| panic!("{errors}"));
    (chain, check)
}

/// The operation with another sign of one operand.
fn turned(operation: Operation) -> Operation {
    use Operation::{Add, Div, Mul, MulAdd, MulSub, Neg, NegMulAdd, Sign, Sqrt, Sub};
    match operation {
        Add(a, b) => Sub(a, b),
        Sub(a, b) => Add(a, b),
        Mul(a, b) => Div(a, b),
        Div(a, b) => Mul(a, b),
        Sqrt(a) | Sign(a) => Neg(a),
        Neg(a) => Add(a, Operand::Literal(0.0)),
        MulAdd(a, b, c) => MulSub(a, b, c),
        MulSub(a, b, c) => NegMulAdd(a, b, c),
        NegMulAdd(a, b, c) => MulAdd(a, b, c),
    }
}

/// The operation with a relative error in its literal, if it has one.
fn shifted(operation: Operation, by: f64) -> Option<Operation> {
    let off = |operand| match operand {
        Operand::Literal(number) => Operand::Literal(number * (1.0 + by)),
        other => other,
    };
    let [a, b, c] = {
        let mut operands = operation.operands().into_iter();
        [(); 3].map(|()| operands.next().unwrap_or(Operand::Literal(0.0)))
    };
    let changed = match operation {
        Operation::Add(..) => Operation::Add(off(a), b),
        Operation::Sub(..) => Operation::Sub(off(a), b),
        Operation::Mul(..) => Operation::Mul(off(a), b),
        Operation::MulAdd(..) => Operation::MulAdd(off(a), b, off(c)),
        Operation::MulSub(..) => Operation::MulSub(off(a), b, off(c)),
        Operation::NegMulAdd(..) => Operation::NegMulAdd(off(a), b, off(c)),
        other => other,
    };
    (changed != operation).then_some(changed)
}

/// The results of a program at the states of a check.
fn results<'c>(
    check: &'c Check,
    program: &'c Program,
) -> impl Iterator<Item = Vec<Double>> + use<'c> {
    let states = check.states.iter();
    states.map(|judge| run(program, |input| judge.state.get(input)))
}

/// True if a program differs from results at the states of a check by more than a part of the largest of them.
fn differs(check: &Check, program: &Program, from: &[Vec<Double>], least: f64) -> bool {
    from.iter()
        .zip(results(check, program))
        .any(|(one, other)| {
            let largest = one
                .iter()
                .fold(0.0_f64, |most, x| most.max(x.to_f64().abs()));
            let pairs = one.iter().zip(&other);
            let mut distances = pairs.map(|(x, y)| (*x - *y).to_f64().abs());
            // NaN differs from everything.
            !distances.all(|distance| distance <= least * largest)
        })
}

/// Largest number of steps of a program that are changed.
const STEPS: usize = 150;

#[test]
fn every_changed_operation_of_a_program_is_refused() {
    let (mut turns, mut shifts) = (0, 0);
    for (description, request) in robots() {
        let (_, check) = prepare(&description, &request);
        for (functions, frame, program) in all_of(&description, &request) {
            // A solution is as good as the equation that it solves, whatever the condition number; derivatives of
            // accelerations contain it twice.
            let (by, least) = match functions[0].truth() {
                Truth::Value(_) | Truth::OfMass(_) | Truth::Directional(_) => (1e-9, 1e-11),
                Truth::Solution(
                    Given::TorqueDerivatives
                    | Given::Regressor
                    | Given::Gradient
                    | Given::Change
                    | Given::Hessian,
                ) => (1e-2, 1e-5),
                Truth::Solution(_) | Truth::Constrained(_) => (1e-3, 1e-8),
            };
            let right: Vec<_> = results(&check, &program).collect();
            // One step in three or fewer, so that it takes seconds.
            let stride = program.steps.len().div_ceil(STEPS).max(3);
            for k in (0..program.steps.len()).step_by(stride) {
                let operation = program.steps[k].operation;
                for (changed, count) in [
                    (Some(turned(operation)), &mut turns),
                    (shifted(operation, by), &mut shifts),
                ] {
                    let Some(changed) = changed else { continue };
                    let mut broken = program.clone();
                    broken.steps[k].operation = changed;
                    if !differs(&check, &broken, &right, least) {
                        continue;
                    }
                    *count += 1;
                    let verdict = check.judge_program(&functions, frame, &broken, request.scalar);
                    assert!(
                        verdict.is_err(),
                        "{}: step {k} of {functions:?}, {operation:?} for {changed:?}",
                        description.name.text
                    );
                }
            }
        }
    }
    assert!(turns > 2000 && shifts > 400, "{turns} and {shifts}");
}

/// Residues, a prismatic and a screw joint, a branch, a lock, oblique and parallel axes, mass that no joint moves, a
/// base that is not the root, and loops, one of them with both links on joints.
const ODD: &str = "
    struct Odd {
        base: frame, frames(slide, hand), lock(spare = 0.4), drop(cover), gravity: [0.3, -0.2, -9.7],
        actuated(pan, tap)
    }
    link floor; link frame { mass: 3.0, com: [0.1, 0.0, 0.2], inertia: [0.1, 0.2, 0.15] }
    joint feet: fixed { from: floor, to: frame, at: xyz(0.0, 0.0, 1.0) }
    link cover { mass: 1.0, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    joint hood: fixed { from: frame, to: cover }
    link turret { mass: 2.0, com: [0.0, 1e-12, 0.3], inertia: [0.05, 0.06, 0.02, 1e-9, 0.0, 1e-3] }
    joint pan: revolute(z) { from: frame, to: turret, at: xyz(0.1, 0.2, 0.3) rz(0.3) rx(1.1102e-16) }
    link slide { mass: 1.5, com: [0.1, -0.05, 0.2], inertia: [0.02, 0.01, 0.03, 1e-3, 2e-3, -1e-3] }
    joint lift: prismatic([0.0, 0.6, 0.8]) { from: turret, to: slide, at: xyz(0.0, 0.1, 0.0) ry(0.7) }
    link bolt { mass: 0.7, com: [0.02, 0.03, 0.1], inertia: [0.004, 0.005, 0.003, 1e-4, 2e-4, 3e-4] }
    joint drive: screw(-x, pitch: 0.01) { from: slide, to: bolt, at: xyz(0.3, 0.0, 0.1) }
    link wrist { mass: 0.4, com: [0.0, 0.0, 0.05], inertia: [1e-3, 1e-3, 5e-4] }
    joint spare: revolute(y) { from: slide, to: wrist, at: xyz(0.0, 0.2, 0.0) rz(0.5) }
    link hand { mass: 0.9, com: [0.05, 0.02, 0.1], inertia: [2e-3, 3e-3, 4e-3, 1e-4, 0.0, 2e-4] }
    joint roll: revolute(z) { from: wrist, to: hand, at: xyz(0.0, 0.0, 0.2) rx(pi/2) }
    link thumb { mass: 0.2, com: [0.03, 0.01, 0.0], inertia: [1e-4, 2e-4, 3e-4] }
    joint pinch: revolute(z) { from: hand, to: thumb, at: xyz(0.1, 0.0, 0.02) }
    link nail { mass: 0.1, com: [0.02, 0.0, 0.01], inertia: [1e-5, 2e-5, 3e-5, 1e-6, 0.0, 0.0] }
    joint tap: revolute([0.36, 0.48, 0.8]) { from: thumb, to: nail, at: xyz(0.1, 0.0, 0.02) }
    loop pin: universal([0.6, 0.0, 0.8], y) { from: bolt, to: thumb, at: xyz(0.1, 1e-12, 0.2) rx(0.3) }
    loop stay: rod(0.4) { from: frame, to: slide, to_at: xyz(0.2, 0.0, 0.1) }
";

/// Robots with every feature.
fn many() -> Vec<(Description, Request)> {
    let mut errors = Errors::new();
    let tokens = ODD.parse().expect("tokens of Rust");
    let odd = inline::read(tokens, Path::new(""), &mut errors).expect("a robot");
    assert!(errors.is_empty(), "{errors}");
    let odd = (odd.description.expect("a robot"), odd.request);
    robots().into_iter().chain([odd, placed()]).collect()
}

fn pass(formulation: Formulation) {
    for (description, request) in many() {
        let request = Request {
            formulation,
            ..request
        };
        assert!(all_of(&description, &request).len() >= 6);
    }
}

#[test]
fn every_function_of_many_robots_agrees_with_the_description() {
    pass(Formulation::default());
}

#[test]
fn they_agree_in_every_formulation() {
    let forms = [
        Formulation::default()
            .with_angles(Angles::Merged)
            .with_products(Products::Unfused)
            .with_forward(Forward::MassMatrix { refinements: 1 }),
        Formulation::default()
            .with_parameters(Parameters::Raw)
            .with_forward(Forward::MassMatrix { refinements: 2 }),
        Formulation::default().with_frame(Frame::Base),
        Formulation::default().with_forward(Forward::Articulated),
    ];
    for formulation in forms {
        pass(formulation);
    }
}

#[test]
fn a_wrong_result_is_refused_with_function_entry_and_both_numbers() {
    let (description, request) = (described("two_link.urdf"), Request::default());
    let (_, check) = prepare(&description, &request);
    let (functions, frame, mut program) = all_of(&description, &request)
        .into_iter()
        .find(|(functions, ..)| functions == &[Function::Gravity])
        .expect("gravity is among all functions");
    program.results.swap(0, 1);
    let refusal = check.judge_program(&functions, frame, &program, request.scalar);
    let refusal = refusal.expect_err("the torques are exchanged").to_string();
    assert!(
        refusal.contains("entry 0 (joint \"shoulder\") of gravity would be "),
        "{refusal}"
    );
    assert!(refusal.contains(" by the description"), "{refusal}");
    assert!(refusal.contains("this is a fault of homogen"), "{refusal}");
}

#[test]
fn a_number_that_f32_has_no_room_for_is_refused() {
    let text = r#"<robot name="arm"><link name="base"/><link name="rod"><inertial>
        <mass value="1e30"/><origin xyz="1e5 0 0"/>
        <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
        <joint name="hinge" type="continuous"><parent link="base"/><child link="rod"/>
        <axis xyz="0 0 1"/></joint></robot>"#;
    let mut errors = Errors::new();
    let description = read_text(text, "arm.urdf", None, &mut errors).expect("a robot");
    // The literal is in the code of one function, and beside the code of the other.
    let functions = [Function::MassMatrix, Function::BaseRegressor];
    let types = [(crate::Real::F32, true), (crate::Real::F64, false)];
    for (function, (scalar, refused)) in functions.iter().flat_map(|f| types.map(|t| (*f, t))) {
        let request = Request {
            functions: vec![vec![function]],
            scalar,
            ..Request::default()
        };
        let refusal = expand(&description, &request).err();
        assert_eq!(refusal.is_some(), refused);
        let text = refusal.map(|errors| errors.to_string()).unwrap_or_default();
        assert_eq!(
            text.contains("1e40, is too large for f32"),
            refused,
            "{text}"
        );
    }
}

/// Two bodies of 1 kg and more, with inertias of millimetres and a metre apart: M loses eight digits, and the terms of
/// M⁻¹ times the derivatives of torques are 1e7 times their sum.
#[test]
fn derivatives_whose_terms_cancel_are_restored_term_by_term() {
    let text = r#"<robot name="pair"><link name="one"><inertial><mass value="1.72"/>
        <inertia ixx="1.2e-7" ixy="-1e-11" ixz="1e-15" iyy="1.1e-7" iyz="0" izz="9e-8"/></inertial></link>
        <link name="other"><inertial><origin xyz="1e-4 0 1e-4"/><mass value="3"/>
        <inertia ixx="1.4e-7" ixy="0" ixz="-8e-8" iyy="1.7e-7" iyz="0" izz="1.1e-7"/></inertial></link>
        <joint name="apart" type="floating"><parent link="one"/><child link="other"/>
        <origin xyz="0 0 -4e-5"/></joint></robot>"#;
    let mut errors = Errors::new();
    let description = read_text(text, "pair.urdf", None, &mut errors).expect("a robot");
    let request = Request {
        functions: vec![vec![Function::ForwardDynamicsDerivatives]],
        floating: true,
        ..Request::default()
    };
    if let Err(errors) = expand(&description, &request) {
        panic!("{errors}");
    }
}

/// A load on a prismatic joint along the axis of a revolute one: its derivatives are zero, and a program, whose
/// literals are rounded, computes nearly zero.
#[test]
fn derivatives_that_are_zero_may_be_rounding_errors() {
    let text = r#"<robot name="column"><link name="base"/><link name="column"/><link name="slide"><inertial>
        <mass value="0.9"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
        <link name="load"><inertial><mass value="2"/>
        <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
        <joint name="turn" type="continuous"><parent link="base"/><child link="column"/><axis xyz="0 0 -1"/></joint>
        <joint name="lift" type="prismatic"><parent link="column"/><child link="slide"/>
        <axis xyz="-0.03373079732639429 -0.9799569155749697 -0.1963330765014325"/></joint>
        <joint name="stage" type="translation"><parent link="slide"/><child link="load"/></joint></robot>"#;
    let mut errors = Errors::new();
    let description = read_text(text, "column.urdf", None, &mut errors).expect("a robot");
    let request = Request {
        functions: vec![vec![Function::ForwardDynamicsDerivatives]],
        ..Request::default()
    };
    if let Err(errors) = expand(&description, &request) {
        panic!("{errors}");
    }
}

pub(super) fn table(text: &str) -> Description {
    let mut errors = Errors::new();
    let description = read_text(text, "arm.dh", None, &mut errors);
    description.unwrap_or_else(|| panic!("{errors}"))
}

#[test]
fn a_negligible_mass_has_no_centre() {
    let text = |mass: &str| {
        format!(
            "convention standard
joint     kind      a    alpha  d    theta  mass    cx  cy  cz   ixx  ixy  ixz  iyy  iyz  izz
shoulder  revolute  0    pi/2   0.4  0      {mass}  0   0   0.1  0.1  0    0    0.1  0    0.1
elbow     revolute  0.3  0      0    0.1    0       0   0   0    0    0    0    0    0    0
"
        )
    };
    let request = Request {
        functions: vec![vec![Function::CenterOfMass]],
        ..Request::default()
    };
    all_of(&table(&text("1e-150")), &request);
    let refusal = expand(&table(&text("2.2e-308")), &request).expect_err("it underflows");
    assert!(refusal.to_string().contains("no joint moves a mass"));
}
