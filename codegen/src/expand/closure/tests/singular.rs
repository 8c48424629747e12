//! Residuals that are zero whatever the joints do, that depend on others, and that lose their slope.

use super::{FOUR_BAR, PIN, chain, closed_four_bar, plain, values};
use crate::chain::Chain;
use crate::closure::Row;
use crate::expand::program_by;
use crate::expression::Input;
use crate::function::Function;
use crate::layout::Layout;
use crate::model::Way;
use crate::real::Real;
use crate::schedule::run;
use crate::space::{FrameId, Space, Variable};

#[test]
fn what_is_closed_in_every_posture_is_left_out_and_told() {
    let chain = chain(&(FOUR_BAR.to_owned() + PIN)).expect("a robot");
    let rows = &chain.loops[0].rows;
    assert_eq!(*rows, [Row::Along(0), Row::Along(1)]);
    assert_eq!(chain.report.closed, ["pin.z", "pin.xz", "pin.yz"]);
    let names: Vec<&str> = chain.spaces().names(Space::Constraints).collect();
    assert_eq!(names, ["pin.x", "pin.y"]);
}

#[test]
fn dependent_residuals_change_nothing() {
    // The same four-bar, with frames of coupler and rocker that are turned about their bars: to within the
    // digits of the axes, what is across the plane is closed, and nobody can know.
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
loop pin: revolute([0.0, 0.29552020666133955, 0.955336489125606]) {
    from: coupler, to: rocker, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) rpy(1.0, 0.0, 0.0) }";
    let [plane, turned] =
        [&*(FOUR_BAR.to_owned() + PIN), turned].map(|text| chain(text).expect("a robot"));
    assert_eq!(
        turned.spaces().len(Space::Constraints),
        5,
        "{:?}",
        turned.report.closed
    );
    for crank in [0.4, 1.3, 2.9] {
        let q = closed_four_bar(crank);
        let j = values(
            &plain(&plane, Function::ConstraintJacobian),
            [&q, &[], &[], &[]],
        );
        // Rates that keep the loop closed: perpendicular to both rows.
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
        // Accelerations; multipliers are of other residuals.
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
        assert_eq!(nothing.count(), 3, "{multipliers:?}");
    }
}

#[test]
fn a_dead_centre_gives_numbers() {
    // All bars of one length, and folded onto one line: both equations lose the line's own direction.
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
        let narrow = Way {
            scalar: Real::F32,
            ..Way::PLAIN
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
