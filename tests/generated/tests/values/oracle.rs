//! The two sources of true values agree in 256 bits: dense matrices in frame 0 from the description, and the graph of
//! the generator in link frames.
//!
//! Differences are relative to the largest S of the result, which in forward dynamics includes the condition of the
//! mass matrix. A tolerance of 10⁻⁵⁰ leaves 27 decimal digits for rounding in 256 bits, and is 18 digits below the 106
//! bits of the generator. Derivatives have another tolerance, since one of the sources computes them by differences.

use std::path::Path;

use homogen_codegen::Function;
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{self, Description, Number, inline};
use homogen_codegen::error::Errors;
use homogen_codegen::layout::{Layout, Sliding};
use homogen_codegen::list::Id;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::program_by;
use homogen_codegen::request::Request;
use homogen_codegen::space::{FrameId, Variable};
use homogen_tests::actuators::with_actuators;
use homogen_tests::arguments;
use homogen_tests::big::Big;
use homogen_tests::effort::effort;
use homogen_tests::metrics;
use homogen_tests::oracle::robot::Robot;
use homogen_tests::oracle::state::exact;
use homogen_tests::oracle::{frame_0, link_frames};
use homogen_tests::states::Random;
use homogen_tests::tested::F64;

/// States of each robot.
fn states() -> usize {
    effort(2, 10)
}

/// States of a robot with each set of actuators and external wrenches.
fn few_states() -> usize {
    effort(1, 4)
}

const TOLERANCE: f64 = 1e-50;

/// Factor of the tolerance for derivatives, which one of the sources computes by differences.
const BY_DIFFERENCES: f64 = 1e5;

const DERIVATIVES: [Function; 7] = [
    Function::InverseDynamicsDerivatives,
    Function::InverseDynamicsVjp,
    Function::InverseDynamicsJvp,
    Function::ForwardDynamicsDerivatives,
    Function::ForwardDynamicsVjp,
    Function::ForwardDynamicsJvp,
    Function::GravityDerivative,
];

/// Functions of loops that are not solutions.
const OF_LOOPS: [Function; 3] = [
    Function::Constraint,
    Function::ConstraintJacobian,
    Function::ConstraintBias,
];

/// The layout of the description, and one with all changes of frames and parameters.
const LAYOUTS: [Layout; 2] = [
    Layout::DESCRIBED,
    Layout {
        normals: true,
        sliding: Sliding::AtMassCenter,
        rotate_ends: true,
        regroup: true,
    },
];

fn build(description: &Description, request: &Request) -> Chain {
    chain::build(description, request)
        .unwrap_or_else(|errors| panic!("{errors}"))
        .identified()
}

/// The worst difference of a robot's functions, which must be within the tolerance.
fn agree(description: &Description, request: &Request) -> f64 {
    agree_within(TOLERANCE, states(), description, request)
}

fn agree_within(
    tolerance: f64,
    states: usize,
    description: &Description,
    request: &Request,
) -> f64 {
    let robot = Robot::of(description, request);
    let chain = build(description, request);
    let spaces = chain.spaces();
    assert_eq!(robot.velocities(), spaces.velocities.len());
    assert!(robot.quaternions().eq(spaces.quaternions().map(Id::index)));
    assert_eq!(robot.frames.len(), chain.frames.len());
    let functions: Vec<Function> = frame_0::functions()
        .filter(|function| !function.needs_a_frame() || !chain.frames.is_empty())
        .chain(OF_LOOPS.into_iter().filter(|_| !chain.loops.is_empty()))
        .collect();
    let frame = chain.frames.ids().last().unwrap_or(FrameId::FIRST);
    let algorithm = Algorithm::PLAIN;
    let sources = LAYOUTS
        .map(|layout| link_frames::expressions(&chain, &functions, frame, layout, algorithm));
    let sizes = program_by(&chain, &functions, frame, LAYOUTS[0], algorithm);
    let mut random = Random::new(50);
    let mut worst: f64 = 0.0;
    for _ in 0..states {
        let (coordinates, velocities) = (spaces.coordinates.len(), spaces.velocities.len());
        let mut arguments = arguments::of_lists(coordinates, velocities, &mut random);
        let actions = 0..chain.spaces().actions.len();
        arguments[Variable::Actions] = actions.map(|_| 4.0 * random.unit()).collect();
        let state = exact(&arguments, spaces.quaternions().map(Id::index));
        let sizes = metrics::sizes::<F64>(&sizes, &arguments);
        let found = sources
            .each_ref()
            .map(|source| link_frames::evaluate_in(source, &state));
        let mut at = 0;
        for &function in &functions {
            let expected = frame_0::evaluate(&robot, function, frame.index(), &arguments);
            let these = at..at + expected.len();
            at = these.end;
            let size = metrics::largest(sizes[these.clone()].iter().copied());
            for found in &found {
                let difference = difference(&found[these.clone()], &expected) / size;
                let name = &description.name.text;
                let tolerance = if DERIVATIVES.contains(&function) {
                    tolerance * BY_DIFFERENCES
                } else {
                    worst = worst.max(difference);
                    tolerance
                };
                assert!(
                    difference <= tolerance,
                    "{name}, {function:?}: {difference:e}\n{}",
                    arguments::line(&arguments)
                );
            }
        }
        assert!(found.iter().all(|found| found.len() == at));
    }
    worst
}

fn difference(found: &[Big], expected: &[Big]) -> f64 {
    let pairs = found.iter().zip(expected);
    metrics::largest(pairs.map(|(x, y)| (x - y).abs().to_f64()))
}

fn read(file: &str) -> Description {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../robots")
        .join(file);
    let mut errors = Errors::new();
    let description = description::read_file(&path, None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes")
}

fn robot(file: &str, request: &Request) {
    let worst = agree(&read(file), request);
    println!("{file}: {worst:.1e}");
}

macro_rules! of_the_shipped {
    ($($name:ident, $tip:literal;)*) => {$(
        #[test]
        fn $name() {
            let tip = Some($tip.into());
            let request = Request { tip, ..Request::default() };
            robot(concat!(stringify!($name), ".urdf"), &request);
        }
    )*};
}

of_the_shipped! {
    two_link, "tip";
    scara, "tool";
    stanford, "tool";
    stanford_general, "tool";
    puma560, "tool";
    puma560_general, "tool";
    ur5_class, "tool0";
    panda_class, "link8";
    quadruped, "hr_foot";
}

/// Locked joints, a dropped branch, another base, oblique gravity.
#[test]
fn requests_change_both_sources_alike() {
    let number = |value| Number {
        value,
        ..Number::default()
    };
    robot(
        "quadruped.urdf",
        &Request {
            tip: Some("fl_foot".into()),
            frames: vec!["fl_lower_leg".into()],
            path_only: true,
            gravity: Some([1.1, -2.3, 8.7].map(number)),
            ..Request::default()
        },
    );
    robot(
        "puma560_general.urdf",
        &Request {
            tip: Some("tool".into()),
            base: Some("link_1".into()),
            lock: vec![("joint_4".into(), Some(number(0.3)))],
            ..Request::default()
        },
    );
    robot(
        "quadruped.urdf",
        &Request {
            drop: vec!["fl_upper_leg".into()],
            ..Request::default()
        },
    );
}

/// The sine of 1.5707963267948966 rad is 1 − 1.9·10⁻³³, which the generator's 106 bits cannot distinguish from 1: with
/// `exact`, right angles agree to 10⁻³² only.
#[test]
fn rounded_right_angles_agree_to_106_bits() {
    let request = Request {
        tip: Some("tool".into()),
        exact: true,
        ..Request::default()
    };
    let worst = agree_within(1e-31, states(), &read("puma560_general.urdf"), &request);
    assert!(worst > TOLERANCE, "{worst:e}: the sine is 1");
}

/// The tree of oblique axes of the engine's tests, with more joints of every type, locked and movable, at right angles
/// with few digits.
#[test]
fn a_tree_of_oblique_axes_agrees() {
    let tree = include_str!("../../../../codegen/src/layout/oblique.txt");
    let held = "tip: tool, lock(seven = 0.7, eight = -0.4, ten)";
    let text = tree.replace("tip: tool", held)
        + "
        joint seven: screw([0.0, 0.6, 0.8], pitch: -0.1) { from: f, to: g, at: xyz(0.1, 0, 0) rz(-3.14159) }
        joint eight: prismatic([0.8, 0.6, 0.0]) { from: g, to: h, at: rx(pi/2) }
        joint nine: cylindrical([0.36, -0.48, 0.8]) { from: b, to: i, at: xyz(0.1, -0.1, 0.2) rpy(0.5, 0.1, -0.2) }
        joint ten: cylindrical(x) { from: i, to: j, at: xyz(0.2, 0.1, 0.05) rz(0.4) }
        joint eleven: revolute(y) { from: h, to: k, at: xyz(0.1, 0.1, 0.1) rx(0.7) rz(1.5708) }
        joint twelve: prismatic(x) { from: k, to: l, at: xyz(0.1, 0.2, 0.1) rz(-3.14159) }
        link g { mass: 0.5, com: [0.02, 0.01, 0.01], inertia: [0.003, 0, 0, 0.004, 0, 0.005] }
        link h { mass: 0.3, com: [0.01, -0.02, 0.01], inertia: [0.002, 0, 0, 0.003, 0, 0.004] }
        link i { mass: 0.6, com: [0.03, 0.02, -0.04], inertia: [0.004, 0.001, 0, 0.006, 0.001, 0.005] }
        link j { mass: 0.2, com: [0.02, -0.01, 0.03], inertia: [0.001, 0, 0, 0.001, 0, 0.0015] }
        link k { mass: 0.4, com: [0.03, 0.01, 0.02], inertia: [0.002, 0, 0, 0.002, 0, 0.003] }
        link l { mass: 0.2, com: [0.01, 0.02, 0.01], inertia: [0.001, 0, 0, 0.001, 0, 0.001] }";
    let worst = of_tokens(&text);
    println!("tree: {worst:.1e}");
}

/// Joints with several velocities, in the middle of a chain, at its end and on a branch; mimic joints of joints
/// outboard, of mimic joints and of locked ones; on a fixed and on a floating base.
#[test]
fn every_joint_agrees_on_a_fixed_and_on_a_floating_base() {
    let joints = "
        joint puck: planar([0.0, 0.6, 0.8]) { from: a, to: b, at: xyz(0.2, 0, 0.1) rpy(0.1, 0.2, 0.3) }
        joint ball: spherical { from: b, to: c, at: xyz(0.1, -0.2, 0.3) rx(1.5708) }
        joint early: revolute([0.36, -0.48, 0.8]) {
            from: c, to: d, at: xyz(0.1, 0.05, 0.2), mimic: slide, multiplier: -2.5, offset: 0.375
        }
        joint cross: universal(x, [0.0, 0.8, 0.6]) { from: d, to: e, at: xyz(0, 0, 0.3) }
        joint slide: prismatic(-y) { from: e, to: f, at: xyz(0.1, 0, 0.1) rz(0.4) }
        joint stage: translation { from: b, to: g, at: xyz(0.3, 0, 0) rz(1.0) }
        joint geared: screw(z, pitch: 0.05) {
            from: g, to: h, at: xyz(0, 0.1, 0.1), mimic: early, multiplier: 0.5
        }
        joint tether: floating { from: g, to: i, at: xyz(0, 0.2, 0.4) ry(0.3) }
        joint last: cylindrical(x) { from: i, to: j, at: xyz(0.1, 0, 0) }
        joint held: revolute(y) { from: j, to: k, at: xyz(0, 0.1, 0) }
        joint stopped: revolute(x) { from: k, to: l, at: xyz(0.1, 0, 0), mimic: held, multiplier: 2.0, offset: 0.125 }";
    let first = "link a { mass: 2, com: [0.1, 0, 0.02], inertia: [0.03, 0, 0.001, 0.04, 0, 0.05] }";
    let body =
        "mass: 0.5, com: [0.02, 0.01, 0.03], inertia: [0.003, 0.0005, 0, 0.004, 0.0002, 0.005]";
    let links = ["b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"];
    let links = links.map(|link| format!("link {link} {{ {body} }}"));
    let text = [first, joints, &links.join(" ")].concat();
    for base in ["", "floating, "] {
        let head = format!("struct All {{ {base}tip: f, frames(l), lock(held = 0.5) }} ");
        let worst = of_tokens(&(head + &text));
        println!("{base}: {worst:.1e}");
    }
}

/// A loop of each type between two arms, or to their base.
#[test]
fn loops_of_every_type_agree() {
    let text = "struct Arms { frames(c, e) }
        joint trunk: revolute([0.6, 0.0, 0.8]) { from: base, to: a, at: xyz(0.1, 0.2, 0.3) rpy(0.1, -0.2, 0.3) }
        joint left_1: universal(x, [0.0, 0.8, 0.6]) { from: a, to: b, at: xyz(0.2, 0.1, 0.0) rpy(0.0, 0.5, 0.0) }
        joint left_2: spherical { from: b, to: c, at: xyz(0.0, 0.2, 0.1) rpy(0.2, 0.1, 0.0) }
        joint right_1: planar([0.0, 0.6, 0.8]) { from: a, to: d, at: xyz(-0.2, 0.1, 0.1) }
        joint right_2: screw(y, pitch: 0.05) {
            from: d, to: e, at: xyz(0.1, 0.1, 0.0) rpy(0.3, 0.0, 0.1), mimic: trunk, multiplier: -0.5
        }
        loop weld: fixed { from: c, to: e, at: xyz(0.1, 0.0, 0.1) rpy(0.1, 0.2, 0.3) }
        loop pin: revolute([0.0, 0.6, 0.8]) { from: c, to: e, to_at: xyz(0.0, 0.1, 0.0) rx(1.5708) }
        loop slot: prismatic(-y) { from: base, to: b, at: xyz(0.1, 0.0, 0.1) }
        loop axle: cylindrical(x) { from: e, to: b, to_at: xyz(0.1, 0.2, 0.0) }
        loop cross: universal([0.6, 0.8, 0.0], z) { from: base, to: d, at: xyz(0.1, 0.2, 0.0) }
        loop face: planar(y) { from: b, to: d, at: xyz(0.1, 0.2, 0.0) rpy(0.4, 0.2, 0.1) }
        loop table: translation { from: c, to: base, to_at: rpy(0.2, 0.3, 0.1) }
        loop ball: spherical { from: a, to: e, at: xyz(0.1, 0.2, 0.0) rpy(0.4, 0.2, 0.1) }
        loop stay: rod(0.4) { from: c, to: d, to_at: xyz(0.0, 0.1, 0.0) }";
    let body =
        "mass: 0.5, com: [0.02, 0.01, 0.03], inertia: [0.003, 0.0005, 0, 0.004, 0.0002, 0.005]";
    let links = ["a", "b", "c", "d", "e"].map(|link| format!("link {link} {{ {body} }} "));
    let worst = of_tokens(&format!("{text} link base; {}", links.concat()));
    println!("{worst:.1e}");
}

/// The worst difference of an inline robot: as it is, with actuators at all joints, and with external wrenches too.
fn of_tokens(text: &str) -> f64 {
    let mut errors = Errors::new();
    let tokens = text.parse().expect("tokens");
    let item = inline::read(tokens, Path::new("nowhere"), &mut errors);
    assert!(errors.is_empty(), "{errors}");
    let item = item.expect("an item");
    let (description, request) = (item.description.expect("a description"), item.request);
    let few = |request: &Request| agree_within(TOLERANCE, few_states(), &description, request);
    let plain = few(&request);
    let actuated = with_actuators(&description, request);
    let mut worst = plain.max(few(&actuated));
    for external_in_frame_0 in [false, true] {
        let with_wrenches = Request {
            external: actuated
                .tip
                .iter()
                .chain(&actuated.frames)
                .take(1)
                .cloned()
                .collect(),
            external_in_frame_0,
            ..actuated.clone()
        };
        worst = worst.max(few(&with_wrenches));
    }
    worst
}
