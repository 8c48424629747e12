//! Residuals that are zero in every configuration, that depend on others, and whose gradient vanishes.

use super::{FOUR_BAR, PIN, chain, closed_four_bar, described, plain, values};
use crate::chain::Chain;
use crate::closure::ResidualKind;
use crate::expand::{expand, understand};
use crate::expression::Input;
use crate::function::Function;
use crate::layout::Layout;
use crate::model::Algorithm;
use crate::plan::program_by;
use crate::real::Real;
use crate::request::Request;
use crate::schedule::run;
use crate::space::{FrameId, Space, Variable};

#[test]
fn residuals_that_are_zero_in_every_configuration_are_left_out_and_reported() {
    let chain = chain(&(FOUR_BAR.to_owned() + PIN)).expect("a robot");
    let rows = &chain.loops[0].rows;
    assert_eq!(*rows, [ResidualKind::Along(0), ResidualKind::Along(1)]);
    assert_eq!(chain.report.closed, ["pin.z", "pin.xz", "pin.yz"]);
    let names: Vec<&str> = chain.spaces().names(Space::Constraints).collect();
    assert_eq!(names, ["pin.x", "pin.y"]);
}

#[test]
fn dependent_residuals_change_nothing() {
    // The same four-bar, with frames of coupler and rocker rotated about their bars, and closed by a spherical loop:
    // one of its three residuals follows from the others, and none is zero.
    let turned = "
pub struct FourBar { gravity: [0.0, -9.81, 0.0] }
link ground;
joint a: revolute(z);
link crank { mass: 0.5, com: [0.05, 0.01, 0.0], inertia: [1e-4, 4e-4, 5e-4] }
joint b: revolute([0.0, 0.29552020666133955, 0.955336489125606]) { at: xyz(0.1, 0.0, 0.0) rpy(0.3, 0.0, 0.0) }
link coupler { mass: 0.8, com: [0.15, 0.0, 0.0], inertia: [1e-4, 6e-3, 6e-3] }
joint c: revolute([0.0, -0.644217687237691, 0.7648421872844884]) {
    from: ground, at: xyz(0.35, 0.0, 0.0) rpy(-0.7, 0.0, 0.0) }
link rocker { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
loop pin: spherical { from: coupler, to: rocker, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) }";
    let [plane, turned] =
        [&*(FOUR_BAR.to_owned() + PIN), turned].map(|text| chain(text).expect("a robot"));
    assert_eq!(turned.spaces().len(Space::Constraints), 3);
    assert_eq!(turned.report.dependent, ["pin.z"]);
    assert!(turned.report.warnings.is_empty());
    for crank in [0.4, 1.3, 2.9] {
        let q = closed_four_bar(crank);
        let j = values(
            &plain(&plane, Function::ConstraintJacobian),
            [&q, &[], &[], &[]],
        );
        // Velocities that keep the loop closed: perpendicular to both rows.
        let qd = [
            j[1] * j[5] - j[2] * j[4],
            j[2] * j[3] - j[0] * j[5],
            j[0] * j[4] - j[1] * j[3],
        ]
        .map(|rate| 20.0 * rate);
        let tau = [0.3, 0.0, -0.2];
        let of = |chain: &Chain, function| values(&plain(chain, function), [&q, &qd, &[], &tau]);
        let [flat, found] =
            [&plane, &turned].map(|chain| of(chain, Function::ConstrainedForwardDynamics));
        // Accelerations agree; multipliers belong to other residuals.
        let joints = plane.joints.len();
        let (accelerations, multipliers) = found.split_at(joints);
        for (found, flat) in accelerations.iter().zip(&flat[..joints]) {
            assert!(
                (found - flat).abs() < 1e-9 * flat.abs().max(1.0),
                "{found} is {flat}"
            );
        }
        let nothing = multipliers
            .iter()
            .filter(|multiplier| multiplier.abs() < 1e-6);
        assert_eq!(nothing.count(), 1, "{multipliers:?}");
    }
}

/// A four-bar whose plane has the normal (0.36, 0.48, 0.8), with axes of so many digits.
fn askew(axis: &str, pin: &str) -> String {
    format!(
        "
pub struct FourBar {{ gravity: [0.0, -9.81, 0.0] }}
link ground;
joint a: revolute([{axis}]);
link crank {{ mass: 0.5, com: [0.05, 0.01, 0.0], inertia: [1e-4, 4e-4, 5e-4] }}
joint b: revolute([{axis}]) {{ at: xyz(0.24, -0.18, 0.0) }}
link coupler {{ mass: 0.8, com: [0.15, 0.0, 0.0], inertia: [1e-4, 6e-3, 6e-3] }}
joint c: revolute([{axis}]) {{ from: ground, at: xyz(0.4, -0.3, 0.0) }}
link rocker {{ mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }}
loop pin: revolute([{pin}]) {{ from: coupler, to: rocker, at: xyz(0.32, -0.24, 0), to_at: xyz(0.2, -0.15, 0) }}"
    )
}

#[test]
fn a_four_bar_mounted_askew_keeps_the_residuals_of_its_plane() {
    let text = askew("0.36, 0.48, 0.8", "0.36, 0.48, 0.8");
    let chain = chain(&text).expect("a robot");
    assert_eq!(
        chain.loops[0].rows,
        [ResidualKind::Along(0), ResidualKind::Along(1)]
    );
    assert_eq!(chain.report.closed, ["pin.z", "pin.xz", "pin.yz"]);
    assert!(chain.report.warnings.is_empty());
    for scalar in [Real::F64, Real::F32] {
        let (description, request) = described(&text);
        let request = Request { scalar, ..request };
        expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    }
}

#[test]
fn residuals_left_by_rounded_digits_are_taken_as_zero_with_a_warning() {
    let text = askew("0.36, 0.48, 0.8", "0.360004, 0.479998, 0.8");
    let chain = chain(&text).expect("a robot");
    assert_eq!(chain.report.closed, ["pin.z", "pin.xz", "pin.yz"]);
    let reported: Vec<&str> = chain
        .report
        .warnings
        .iter()
        .map(|warning| &*warning.message)
        .collect();
    let expected = "loop \"pin\": \"pin.z\", \"pin.xz\" and \"pin.yz\" are taken as zero, being at most 6e-6 of the joints' motion";
    assert_eq!(reported, [expected]);
    let (description, request) = described(&text);
    let request = Request {
        strict: true,
        ..request
    };
    let reported = understand(&description, &request)
        .map(|_| ())
        .expect_err("strict")
        .to_string();
    assert!(reported.contains("(refused: strict)"), "{reported}");
}

#[test]
fn a_misaligned_axis_that_blocks_the_joints_is_refused() {
    let reported = chain(&askew("0.36, 0.48, 0.8", "0.363, 0.478, 0.8"))
        .map(|_| ())
        .expect_err("a mistake");
    assert!(
        reported.contains("loop \"pin\" blocks the joints: they change \"pin.z\", \"pin.xz\""),
        "{reported}"
    );
}

#[test]
fn a_weak_constraint_that_some_joint_satisfies_is_kept() {
    // A wedge of a thousandth: translation along it changes the residual by little, translation across it fully.
    let wedge = "
pub struct Wedge;
link ground;
joint along: prismatic(x);
link lower { mass: 1.0, com: [0.0, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
joint up: prismatic(z) { from: ground }
link upper { mass: 1.0, com: [0.0, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
loop face: planar([0.0001, 0.0, 1.0]) { from: lower, to: upper }";
    let chain = chain(wedge).expect("a robot");
    assert_eq!(chain.loops[0].rows, [ResidualKind::Along(2)]);
}

#[test]
fn small_loops_keep_their_residuals() {
    // Micrometres, and a prismatic joint with a range of a metre.
    let small = "
pub struct Small { gravity: none }
link ground;
joint a: revolute(z);
link crank { mass: 1e-9, com: [5e-7, 0.0, 0.0], inertia: [1e-21, 1e-21, 1e-21] }
joint b: revolute(z) { at: xyz(1e-6, 0.0, 0.0) }
link rod { mass: 1e-9, com: [1e-6, 0.0, 0.0], inertia: [1e-21, 1e-21, 1e-21] }
joint slide: prismatic(x) { from: ground, at: xyz(3e-6, 0.0, 0.0) }
link slider { mass: 1e-9, com: [0.0, 0.0, 0.0], inertia: [1e-21, 1e-21, 1e-21] }
loop pin: revolute(z) { from: rod, to: slider, at: xyz(2e-6, 0.0, 0.0) }";
    let chain = chain(small).expect("a robot");
    assert_eq!(
        chain.loops[0].rows,
        [ResidualKind::Along(0), ResidualKind::Along(1)]
    );
}

/// Bennett's linkage: four skew axes that move because of their proportions, a sin β = b sin α.
const BENNETT: &str = "
pub struct Bennett;
link ground;
joint a: continuous(z);
link one { mass: 0.5, com: [0.05, 0.01, 0.0], inertia: [1e-3, 4e-3, 5e-3] }
joint b: continuous(z) { at: rz(1.1) xyz(0.3, 0.0, 0.0) rx(0.7) }
link two { mass: 0.8, com: [0.15, 0.0, 0.0], inertia: [1e-3, 6e-3, 6e-3] }
joint c: continuous(z) { from: ground, at: rx(-1.2) xyz(-0.434032985013344, 0.0, 0.0) }
link three { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-3, 2e-3, 2e-3] }
loop pin: revolute(z) { from: two, to: three, at: xyz(0.434032985013344, 0.0, 0.0) rx(1.2), to_at: rx(-0.7) xyz(-0.3, 0.0, 0.0) }";

#[test]
fn an_over_constrained_linkage_is_generated_and_its_dependent_residuals_are_reported() {
    let (description, request) = described(BENNETT);
    for scalar in [Real::F64, Real::F32] {
        let request = Request {
            scalar,
            functions: Function::OF_LOOPS
                .iter()
                .filter(|function| !function.wants_actuators())
                .map(|&function| vec![function])
                .collect(),
            ..request.clone()
        };
        expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    }
    let chain = chain(BENNETT).expect("a robot");
    assert_eq!(chain.spaces().len(Space::Constraints), 5);
    assert_eq!(
        chain.report.dependent.len(),
        3,
        "{:?}",
        chain.report.dependent
    );
    assert!(chain.report.warnings.is_empty());
}

#[test]
fn a_dead_centre_gives_finite_results() {
    // All bars have one length and are folded onto one line: both equations lose that line's direction.
    let text = "
pub struct Rhombus { gravity: none }
link ground;
joint a: revolute(z);
link crank { mass: 0.5, com: [0.1, 0.0, 0.0], inertia: [1e-4, 4e-3, 5e-3] }
joint b: revolute(z) { at: xyz(0.2, 0.0, 0.0) }
link coupler { mass: 0.8, com: [0.1, 0.0, 0.0], inertia: [1e-4, 6e-3, 6e-3] }
joint c: revolute(z) { from: ground, at: xyz(0.2, 0.0, 0.0) }
link rocker { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
loop pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.2, 0, 0), to_at: xyz(0.2, 0, 0) }";
    let chain = chain(text).expect("a robot");
    let q = [0.0; 3];
    let j = values(
        &plain(&chain, Function::ConstraintJacobian),
        [&q, &[], &[], &[]],
    );
    assert_eq!(j[..3], [0.0; 3], "x is dead");
    for (rate, torque) in [(0.0, 1.0), (1.0, 0.0), (3.0, -2.0)] {
        let (qd, tau) = ([rate, 0.0, rate], [torque, 0.0, 0.0]);
        let function = Function::ConstrainedForwardDynamics;
        let found = values(&plain(&chain, function), [&q, &qd, &[], &tau]);
        assert!(found.iter().all(|x| x.is_finite()), "{found:?}");
        let narrow = Algorithm {
            scalar: Real::F32,
            ..Algorithm::PLAIN
        };
        let program = program_by(
            &chain,
            &[function],
            FrameId::FIRST,
            Layout::DESCRIBED,
            narrow,
        );
        let found = run(&program, |input| match input {
            Input::Variable(Variable::Qd, 0 | 2) => {
                #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
                let rate = rate as f32;
                rate
            }
            Input::Variable(Variable::Tau, 0) => {
                #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
                let torque = torque as f32;
                torque
            }
            _ => 0.0_f32,
        });
        assert!(found.iter().all(|x: &f32| x.is_finite()), "{found:?}");
    }
}
