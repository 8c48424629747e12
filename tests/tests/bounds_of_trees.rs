//! Bounds of errors hold for what a file says, and not only for what was read of it.
//!
//! In: random robots with axes of any length, lengths and angles that are products and quotients, joints that follow
//! others. Out: no error beyond its bound, beside 256 bits computed of the words of the file, which nothing of the
//! generator has read.

use std::ops::Range;

use homogen_codegen::Function;
use homogen_tests::states::Random;
use homogen_tests::tested::{F32, F64};
use homogen_tests::trees::prepared::Prepared;
use homogen_tests::trees::robot::{Kind, Robot};
use homogen_tests::trees::{numbered, of_seed};

/// Functions with few roundings of their own, beside which one more is seen.
const FUNCTIONS: [Function; 9] = [
    Function::ForwardKinematics,
    Function::SpatialJacobian,
    Function::Velocity,
    Function::Gravity,
    Function::InverseDynamics,
    Function::MassMatrix,
    Function::PotentialEnergy,
    Function::CenterOfMass,
    Function::Momentum,
];

const RUN: u64 = 35;

/// The range of a field is not that of what is drawn for it, and no quaternion is of length 1 but for rounding.
fn is_of_the_file(robot: &Robot) -> bool {
    let turns = |kind: &Kind| matches!(kind, Kind::Spherical | Kind::Floating);
    let moved = robot.bodies.iter().any(|body| turns(&body.kind));
    robot.asked.fields.is_empty() && !robot.asked.floating && !moved
}

/// The worst share of a bound that an error takes, of some robots in a row.
fn worst(robots: Range<u64>, states: usize) -> f64 {
    let mut worst = (0.0, String::new());
    let mut beyond = Vec::new();
    for index in robots {
        let seed = numbered(RUN, index);
        let robot = of_seed(seed);
        if !is_of_the_file(&robot) {
            continue;
        }
        let Ok(prepared) = Prepared::of(&robot, seed, 1) else {
            continue;
        };
        for function in FUNCTIONS {
            let mut random = Random::new(seed);
            let double = prepared.share_of_bound::<F64>(function, states, &mut random);
            let single = prepared.share_of_bound::<F32>(function, states, &mut random);
            for (share, what) in [double, single].into_iter().flatten() {
                let told = format!("{function:?} of seed {seed}: {what}\n{robot}");
                if share > 1.0 {
                    beyond.push(told.clone());
                }
                if share > worst.0 {
                    worst = (share, told);
                }
            }
        }
    }
    println!("{}", worst.1);
    assert!(
        beyond.is_empty(),
        "{} beyond\n{}",
        beyond.len(),
        beyond.join("\n")
    );
    worst.0
}

#[test]
fn errors_of_random_robots_stay_within_their_bounds() {
    assert!(worst(0..60, 3) > 0.1);
}

#[test]
#[ignore = "minutes: thousands of robots"]
fn errors_of_thousands_of_random_robots_stay_within_their_bounds() {
    worst(0..3000, 8);
}
