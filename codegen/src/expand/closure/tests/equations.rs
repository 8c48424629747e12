//! Accelerations, multipliers and actuator torques against the equations that they solve, and every algorithm against
//! the plainest.

use std::rc::Rc;

use super::{
    ARMS, FOUR_BAR, PIN, arms_held_by, chain, closed_four_bar, described, kinds, numbers, plain,
    upright, values,
};
use crate::accuracy::Accuracy;
use crate::check::Check;
use crate::expand::{expand, understand};
use crate::formulation::{Angles, Formulation, Frame};
use crate::function::Function;
use crate::layout::Layout;
use crate::list::Id;
use crate::model::Algorithm;
use crate::plan::{Programs, plan, program_by};
use crate::real::Real;
use crate::request::Request;
use crate::schedule::Program;
use crate::space::{FrameId, Space, VelocityId};

#[test]
fn accelerations_solve_the_equations_of_motion_with_their_multipliers() {
    for (kind, count) in kinds() {
        let chain = chain(&arms_held_by(&kind)).expect("a robot");
        let spaces = chain.spaces();
        let velocities = spaces.velocities.len();
        let program = |function| plain(&chain, function);
        let all = [
            Function::MassMatrix,
            Function::Bias,
            Function::ConstraintJacobian,
            Function::ConstraintBias,
            Function::ConstrainedForwardDynamics,
        ]
        .map(program);
        for seed in 0..4 {
            let q = upright(&chain, seed);
            let (qd, tau) = (numbers(velocities, seed + 7), numbers(velocities, seed + 9));
            let at = |program: &Program| values(program, [&q, &qd, &[], &tau]);
            let [m, h, j, gamma, motion] = all.each_ref().map(at);
            let (qdd, lambda) = motion.split_at(velocities);
            let size = qdd
                .iter()
                .chain(lambda)
                .fold(1.0, |most: f64, x| most.max(x.abs()));
            for row in 0..velocities {
                let moved: f64 = m[row * velocities..]
                    .iter()
                    .zip(qdd)
                    .map(|(m, x)| m * x)
                    .sum();
                let held: f64 = (0..count)
                    .map(|k| j[k * velocities + row] * lambda[k])
                    .sum();
                let left = moved + h[row] - tau[row] - held;
                assert!(left.abs() < 1e-12 * size, "{kind}: {left} of {size}");
            }
            for row in 0..count {
                let terms = j[row * velocities..].iter().zip(qdd);
                let left = gamma[row] + terms.map(|(j, x)| j * x).sum::<f64>();
                assert!(left.abs() < 1e-9 * size, "{kind}: {left} of {size}");
            }
        }
    }
}

#[test]
fn actuated_joints_make_the_required_motion() {
    let text = FOUR_BAR.to_owned() + PIN;
    let (description, request) = described(&text);
    let q = closed_four_bar(0.9);
    for (actuated, place) in [("a", 0), ("b", 1), ("c", 2)] {
        let request = Request {
            actuated: vec![actuated.into()],
            ..request.clone()
        };
        let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
        let of = |function, state| values(&plain(&chain, function), state);
        let j = of(Function::ConstraintJacobian, [&q, &[], &[], &[]]);
        let qd = [
            j[1] * j[5] - j[2] * j[4],
            j[2] * j[3] - j[0] * j[5],
            j[0] * j[4] - j[1] * j[3],
        ]
        .map(|rate| 30.0 * rate);
        let free = [0.4, -0.3, 0.2];
        let motion = of(Function::ConstrainedForwardDynamics, [&q, &qd, &[], &free]);
        let qdd = &motion[..3];
        let tau = of(Function::ActuatedInverseDynamics, [&q, &qd, qdd, &[]]);
        assert!((0..3).all(|k| (k == place) == (tau[k] != 0.0)), "{tau:?}");
        let found = of(Function::ConstrainedForwardDynamics, [&q, &qd, &[], &tau]);
        for (found, qdd) in found.iter().zip(qdd) {
            assert!(
                (found - qdd).abs() < 1e-11 * qdd.abs().max(1.0),
                "{found} is {qdd}"
            );
        }
    }
}

#[test]
fn every_formulation_gives_the_same() {
    let formulations = [
        Formulation::default(),
        Formulation::default().with_angles(Angles::Merged),
        Formulation::default().with_frame(Frame::Base),
    ];
    let four_bar = FOUR_BAR.to_owned() + PIN;
    for text in [
        arms_held_by("revolute(y)"),
        arms_held_by("rod(0.4)"),
        four_bar,
    ] {
        let mut chain = chain(&text).expect("a robot");
        chain.actuated[VelocityId::new(0)] = true;
        let spaces = chain.spaces();
        let velocities = spaces.velocities.len();
        let (q, qd, tau) = (
            upright(&chain, 1),
            numbers(velocities, 2),
            numbers(velocities, 3),
        );
        for function in Function::OF_LOOPS {
            let expected = values(&plain(&chain, function), [&q, &qd, &tau, &tau]);
            for formulation in formulations {
                let request = Rc::make_mut(&mut chain.request);
                (request.formulation, request.scalar) = (formulation, Real::F64);
                let plan = plan(&Programs::of(&chain), vec![function], FrameId::FIRST);
                let plan = plan.unwrap_or_else(|errors| panic!("{errors}"));
                let found = values(&plan.program, [&q, &qd, &tau, &tau]);
                for (found, expected) in found.iter().zip(&expected) {
                    let most = 1e-11 * expected.abs().max(1.0);
                    assert!(
                        (found - expected).abs() < most,
                        "{function:?}: {found} is {expected}"
                    );
                }
            }
        }
    }
}

#[test]
fn every_type_agrees_with_the_description_in_both_precisions() {
    for (kind, _) in kinds() {
        let (description, request) = described(&arms_held_by(&kind));
        let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
        let check = Check::of(&chain);
        let check = check.unwrap_or_else(|errors| panic!("{errors}"));
        for function in Function::OF_LOOPS {
            for scalar in [Real::F32, Real::F64] {
                let algorithm = Algorithm {
                    scalar,
                    ..Algorithm::PLAIN
                };
                let program = program_by(
                    &chain,
                    &[function],
                    FrameId::FIRST,
                    Layout::DESCRIBED,
                    algorithm,
                );
                let judged = check.judge_program(&[function], FrameId::FIRST, &program, scalar);
                judged.unwrap_or_else(|errors| panic!("{kind} {scalar:?}: {errors}"));
            }
        }
    }
}

#[test]
fn more_residuals_than_passive_joints_agree_with_the_description_as_well() {
    // Seven residuals and five velocities without an actuator: two pivots are pure rounding error.
    let text = ARMS.to_owned()
        + "loop hands: fixed { from: left_3, to: right_2, at: xyz(0.1, 0.0, 0.1) rpy(0.1, 0.2, 0.3) }
           loop stay: rod(0.4) { from: base, to: left_2, to_at: xyz(0.0, 0.1, 0.0) }";
    let (description, request) = described(&text);
    let request = Request {
        functions: vec![vec![Function::ActuatedInverseDynamics]],
        actuated: ["trunk", "left_1", "right_1"].map(Into::into).to_vec(),
        ..request
    };
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let check = Check::of(&chain).unwrap_or_else(|errors| panic!("{errors}"));
    let function = [Function::ActuatedInverseDynamics];
    let mut program = module.functions[0].program.clone();
    check
        .judge_program(&function, FrameId::FIRST, &program, Real::F64)
        .unwrap_or_else(|errors| panic!("{errors}"));
    program.results.swap(0, 1);
    assert!(
        check
            .judge_program(&function, FrameId::FIRST, &program, Real::F64)
            .is_err()
    );
}

#[test]
fn bounds_of_residuals_have_their_names() {
    // More residuals than velocities.
    let text = ARMS.to_owned()
        + "loop hands: fixed { from: left_3, to: right_2 }
           loop elbows: fixed { from: left_2, to: right_1 }
           loop ball: spherical { from: base, to: left_1 }";
    let (description, request) = described(&text);
    let request = Request {
        functions: vec![vec![Function::ConstraintJacobian]],
        ..request
    };
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let residuals = module.spaces.names(Space::Constraints).map(str::to_owned);
    let residuals: Vec<String> = residuals.collect();
    assert!(residuals.len() > module.spaces.len(Space::Velocities));
    let [Accuracy::Within(error_bounds)] = &*module.functions[0].accuracy else {
        panic!("{:?}", module.functions[0].accuracy);
    };
    let mut named = error_bounds.bounds.iter().map(|bound| bound.joint.as_ref());
    assert!(named.all(|name| name.is_some_and(|name| residuals.contains(name))));
}
