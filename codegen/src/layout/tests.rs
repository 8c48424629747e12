//! Tests that every layout and every formulation gives the same results, to the last digits of 106 bits, and that a
//! locked joint is one at rest.

use std::path::Path;

use super::{Layout, Sliding, arrange};
use crate::chain::tests::{fine, named, read};
use crate::chain::{Chain, build};
use crate::error::Errors;
use crate::expression::{Double, Expr, Input, evaluate};
use crate::formulation::{Angles, Forward};
use crate::function::Function;
use crate::joint::Motion;
use crate::model::Algorithm;
use crate::request::{Parameter, Request, Target};
use crate::space::{FrameId, Variable};

/// Some hundred units of rounding at 2⁻¹⁰⁶, for sums of a few hundred products.
const TOLERANCE: f64 = 1e-27;

/// An arbitrary state: all entries differ, and none is special.
fn state(input: Input) -> Double {
    let entry = |k: u16, step: f64| Double::from((f64::from(k) + 1.0) * step) / Double::from(3.0);
    match input {
        Input::Variable(Variable::Q, k) => entry(k, 1.1),
        Input::Variable(Variable::Qd, k) => entry(k, -0.7),
        Input::Variable(Variable::Qdd, k) => entry(k, 1.9),
        Input::Variable(Variable::Tau, k) => entry(k, 2.3),
        Input::Variable(Variable::Actions, k) => entry(k, 0.9),
        Input::Variable(_, k) => entry(k, 0.7),
        Input::Parameter(field, k) => entry(3 * field + k, 0.31),
    }
}

fn results(chain: &Chain, function: Function, layout: Layout, algorithm: Algorithm) -> Vec<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, layout);
    let terms = function.build(&graph, &bodies, FrameId::FIRST, algorithm);
    let results: Vec<Expr> = terms
        .into_iter()
        .map(crate::expression::Term::expr)
        .collect();
    evaluate(&graph, &results, state)
}

/// The largest difference, relative to the largest result.
fn difference(results: &[Double], expected: &[Double]) -> f64 {
    assert_eq!(results.len(), expected.len());
    let largest = |numbers: &mut dyn Iterator<Item = Double>| {
        numbers.fold(0.0_f64, |most, x| most.max(x.to_f64().abs()))
    };
    let mut differences = results.iter().zip(expected).map(|(x, y)| *x - *y);
    let size = largest(&mut expected.iter().copied());
    // Results that are all zero must be zero in every layout.
    largest(&mut differences) / if size == 0.0 { 1.0 } else { size }
}

/// Every layout, including those that no plan compares.
fn layouts() -> Vec<Layout> {
    let mut layouts = Vec::new();
    for normals in [false, true] {
        for sliding in [
            Sliding::AsDescribed,
            Sliding::AtParent,
            Sliding::AtChild,
            Sliding::AtMassCenter,
        ] {
            for rotate_ends in [false, true] {
                for regroup in [false, true] {
                    layouts.push(Layout {
                        normals,
                        sliding,
                        rotate_ends,
                        regroup,
                    });
                }
            }
        }
    }
    layouts
}

/// Every algorithm of a function, including those that only the operation count chooses.
fn algorithms(function: Function) -> Vec<Algorithm> {
    let forms = [
        Forward::UNREFINED,
        Forward::MassMatrix { refinements: 1 },
        Forward::Articulated,
    ];
    match function {
        Function::ForwardDynamics => forms
            .map(|forward| Algorithm {
                forward,
                ..Algorithm::PLAIN
            })
            .to_vec(),
        _ => function.algorithms(),
    }
}

/// The algorithms that only a formulation selects.
fn formulations(function: Function) -> Vec<Algorithm> {
    let apart = [vec![Algorithm::IN_FRAME_0], algorithms(function)].concat();
    let merged = apart.iter().map(|&algorithm| Algorithm {
        angles: Angles::Merged,
        ..algorithm
    });
    [vec![Algorithm::IN_FRAME_0], merged.collect()].concat()
}

/// The two layouts that differ most.
fn extremes() -> [Layout; 2] {
    let most = Layout {
        normals: true,
        sliding: Sliding::AtMassCenter,
        rotate_ends: true,
        regroup: true,
    };
    [Layout::DESCRIBED, most]
}

fn agree(name: &str, chain: &Chain) {
    compare(name, chain, &layouts(), algorithms);
    compare(name, chain, &extremes(), formulations);
}

fn compare(
    name: &str,
    chain: &Chain,
    layouts: &[Layout],
    algorithms: fn(Function) -> Vec<Algorithm>,
) {
    for function in Function::ALL {
        if function.needs_a_frame() && chain.frames.is_empty() {
            continue;
        }
        let expected = results(chain, function, Layout::DESCRIBED, Algorithm::PLAIN);
        for &layout in layouts {
            for algorithm in algorithms(function) {
                let results = results(chain, function, layout, algorithm);
                let difference = difference(&results, &expected);
                assert!(
                    difference < TOLERANCE,
                    "{name}: {function:?} by {layout:?} and {algorithm:?}: {difference:.1e}"
                );
            }
        }
    }
}

/// A tree with every type of joint about oblique axes, whose numbers have many digits.
const OBLIQUE: &str = include_str!("oblique.txt");

fn robot(file: &str, tip: &str) -> Chain {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots");
    let mut errors = Errors::new();
    let description =
        crate::description::read_file(&folder.join(file), None, &mut errors).expect("a robot");
    let request = Request {
        tip: Some(named(tip)),
        ..Request::default()
    };
    build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn robots_that_ship_have_the_same_torques_in_every_layout() {
    for (file, tip) in [
        ("two_link.urdf", "tip"),
        ("scara.urdf", "tool"),
        ("stanford_general.urdf", "tool"),
        ("panda_class.urdf", "link8"),
        ("quadruped.urdf", "hr_foot"),
    ] {
        agree(file, &robot(file, tip));
    }
}

#[test]
fn the_other_robots_that_ship_have_the_same_torques_in_every_formulation() {
    for (file, tip) in [
        ("stanford.urdf", "tool"),
        ("puma560.urdf", "tool"),
        ("puma560_general.urdf", "tool"),
        ("ur5_class.urdf", "tool0"),
    ] {
        compare(file, &robot(file, tip), &extremes(), formulations);
    }
}

#[test]
fn a_tree_of_oblique_axes_has_the_same_torques_in_every_layout() {
    agree("tree", &fine(OBLIQUE));
}

/// A tree whose axes are parallel to those before them, or opposite, in two groups with prismatic and screw joints; the
/// second one branches.
const PARALLEL: &str = "
    struct Tree { tip: tool, gravity: [1.1, -2.3, 8.7] }
    link base;
    joint one: revolute(z) { from: base, to: a, at: xyz(0.1, 0.2, 0.3) rpy(0.4, 0.5, 0.6) }
    joint two: revolute(-z) { from: a, to: b, at: xyz(-0.3, 0.1, 0.2) rz(1.1) }
    joint three: prismatic(z) { from: b, to: c, at: xyz(0.2, 0.3, -0.1) rz(-0.7) }
    joint four: screw(z, pitch: 0.037) { from: c, to: d, at: xyz(0.05, -0.2, 0.15) }
    joint five: revolute(x) { from: d, to: e, at: xyz(0.1, 0.1, 0.1) }
    joint six: revolute(x) { from: e, to: f, at: xyz(0.3, 0.2, 0.1) rx(0.35) }
    joint seven: revolute(-x) { from: e, to: g, at: xyz(0.2, -0.1, 0.1) rx(-0.2) }
    joint eight: revolute(y) { from: f, to: h, at: xyz(0.1, 0.3, 0.2) }
    joint weld: fixed { from: h, to: tool, at: xyz(0.1, 0.03, 0.02) rpy(0.2, 0.1, 0.4) }
    link a { mass: 2.1, com: [0.11, 0.07, -0.05], inertia: [0.031, 0.002, -0.003, 0.043, 0.001, 0.052] }
    link b { mass: 1.7, com: [-0.03, 0.09, 0.06], inertia: [0.021, 0.003, 0.001, 0.033, -0.002, 0.042] }
    link c { mass: 1.3, com: [0.05, -0.04, 0.08], inertia: [0.017, -0.001, 0.002, 0.023, 0.003, 0.027] }
    link d { mass: 0.9, com: [0.02, 0.03, 0.07], inertia: [0.011, 0.001, 0.001, 0.012, 0.002, 0.014] }
    link e { mass: 1.1, com: [0.06, 0.01, -0.02], inertia: [0.013, 0.002, -0.001, 0.016, 0.001, 0.019] }
    link f { mass: 0.7, com: [0.01, -0.05, 0.03], inertia: [0.007, 0.001, 0.001, 0.008, 0.001, 0.009] }
    link g { mass: 0.5, com: [0.03, -0.02, 0.04], inertia: [0.006, 0.001, 0.001, 0.007, 0.001, 0.008] }
    link h { mass: 0.6, com: [0.02, -0.03, 0.01], inertia: [0.005, 0.001, 0.001, 0.006, 0.001, 0.007] }
    link tool { mass: 0.4, com: [0.01, 0.02, 0.05], inertia: [0.001, 0, 0, 0.001, 0, 0.002] }";

#[test]
fn a_tree_of_parallel_axes_has_the_same_torques_in_every_layout() {
    agree("parallel", &fine(PARALLEL));
}

#[test]
fn a_tree_with_fields_has_the_same_torques_in_every_layout() {
    let (description, mut request) = read(&OBLIQUE.replace("gravity: [1.1, -2.3, 8.7]", ""));
    for target in [
        Target::MassOf(named("d")),
        Target::CenterOfMassOf(named("c")),
        Target::OriginOf(named("three")),
        Target::MassOf(named("tool")),
        Target::Gravity,
    ] {
        let field = quote::format_ident!("field_{}", request.parameters.len());
        request.parameters.push(Parameter {
            field,
            target,
            range: None,
        });
    }
    let chain = build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    agree("tree with fields", &chain);
}

#[test]
fn a_locked_joint_is_a_joint_at_rest() {
    let joints = ["one", "two", "three", "four", "five", "six"];
    let free = fine(OBLIQUE);
    let (graph, algorithm) = (free.graph.clone(), Algorithm::PLAIN);
    let bodies = arrange(&graph, &free, Layout::DESCRIBED);
    for (k, joint) in joints.into_iter().enumerate() {
        let lock = format!("tip: tool, lock({joint} = 0.3)");
        let locked = fine(&OBLIQUE.replace("tip: tool", &lock));
        assert_eq!(locked.joints.len(), joints.len() - 1);
        // The state of the remaining joints, with the locked one among them at rest.
        let held = u16::try_from(k).expect("few joints");
        let shift = |of: u16| (of != held).then(|| of - u16::from(of > held));
        let still = |input| match input {
            Input::Variable(Variable::Q, of) => shift(of).map_or(Double::from(0.3), |of| {
                state(Input::Variable(Variable::Q, of))
            }),
            Input::Variable(Variable::Qd, of) => {
                shift(of).map_or(Double::ZERO, |of| state(Input::Variable(Variable::Qd, of)))
            }
            Input::Variable(Variable::Qdd, of) => {
                shift(of).map_or(Double::ZERO, |of| state(Input::Variable(Variable::Qdd, of)))
            }
            _ => state(input),
        };
        let terms = Function::InverseDynamics.build(&graph, &bodies, FrameId::FIRST, algorithm);
        let all: Vec<Expr> = terms
            .into_iter()
            .map(crate::expression::Term::expr)
            .collect();
        let mut expected = evaluate(&graph, &all, still);
        expected.remove(k);
        let results = results(
            &locked,
            Function::InverseDynamics,
            Layout::DESCRIBED,
            algorithm,
        );
        let difference = difference(&results, &expected);
        assert!(difference < TOLERANCE, "{joint}: {difference:.1e}");
    }
}

#[test]
fn regrouping_removes_the_parameters_without_effect_on_the_joint() {
    let (mut chain, layout) = (
        fine(OBLIQUE),
        Layout {
            regroup: true,
            ..Layout::DESCRIBED
        },
    );
    // The zero parameters of a body, by its joint: m, q_z, J_zz; all second moments; J_zz.
    let graph = std::mem::take(&mut chain.graph);
    let bodies = arrange(&graph, &chain, layout).bodies;
    for body in bodies {
        let [xx, yy, zz, xy, xz, yz] = body.inertia.second.0;
        let gone = match body.motion {
            Motion::Revolute => vec![zz, body.inertia.q.z(), body.inertia.mass],
            Motion::Prismatic => vec![xx, yy, zz, xy, xz, yz],
            Motion::Screw(_) => vec![zz],
        };
        assert!(gone.iter().all(|entry| entry.is_zero()));
        let kept = body
            .inertia
            .entries()
            .into_iter()
            .filter(|entry| !entry.is_zero());
        assert_eq!(kept.count(), 10 - gone.len());
    }
}
