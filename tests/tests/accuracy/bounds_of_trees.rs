//! Error bounds hold for the numbers in the file, reading included.
//!
//! In: random robots with axes of any length, lengths and angles that are products and quotients, mimic joints. Out:
//! errors within their bounds, relative to true values in 256 bits from the words of the file, read independently.

use std::ops::Range;

use homogen_codegen::Function;
use homogen_tests::states::Random;
use homogen_tests::tested::{F32, F64};
use homogen_tests::trees::prepared::Prepared;
use homogen_tests::trees::robot::{
    Body, FrontEnd, Inertial, Kind, Mimic, Options, Placement, Robot,
};
use homogen_tests::trees::written::Written;
use homogen_tests::trees::{numbered, of_seed};

/// Functions with few roundings of their own, so that one more is noticed.
const FUNCTIONS: [Function; 9] = [
    Function::ForwardKinematics,
    Function::SpatialJacobian,
    Function::TipVelocity,
    Function::Gravity,
    Function::InverseDynamics,
    Function::MassMatrix,
    Function::PotentialEnergy,
    Function::CenterOfMass,
    Function::TotalMomentum,
];

const RUN: u64 = 35;

/// True for robots without fields, whose drawn values may be out of range, and without quaternions, whose length is not
/// 1.
fn is_of_the_file(robot: &Robot) -> bool {
    let has_quaternion = |kind: &Kind| matches!(kind, Kind::Spherical | Kind::Floating);
    let has_any = robot.bodies.iter().any(|body| has_quaternion(&body.kind));
    robot.options.fields.is_empty() && !robot.options.floating && !has_any
}

/// The largest ratio of error to bound of a range of robots.
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
                let report = format!("{function:?} of seed {seed}: {what}\n{robot}");
                if share > 1.0 {
                    beyond.push(report.clone());
                }
                if share > worst.0 {
                    worst = (share, report);
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

/// The largest ratio of error to bound of all functions of one robot.
fn share(robot: &Robot, states: usize) -> f64 {
    let prepared = Prepared::of(robot, 1, 1).unwrap_or_else(|what| panic!("{what}\n{robot}"));
    let shares = FUNCTIONS.into_iter().filter_map(|function| {
        prepared.share_of_bound::<F64>(function, states, &mut Random::new(2))
    });
    shares.fold(0.0, |most, (share, what)| {
        assert!(share <= 1.0, "{what}\n{robot}");
        f64::max(most, share)
    })
}

/// A serial robot.
fn row(joints: Vec<(Kind, [&str; 3], [&str; 3])>) -> Robot {
    let words = |words: [&str; 3]| words.map(Written::new);
    let count = joints.len();
    let bodies = joints
        .into_iter()
        .zip(1..)
        .map(|((kind, rpy, axis), id)| Body {
            id,
            parent: id - 1,
            kind,
            at: Placement {
                xyz: words(["0.21", "-0.4", "0.3"]),
                rpy: words(rpy),
                turns: Vec::new(),
            },
            axis: words(axis),
            mimic: None,
            inertial: Some(Inertial {
                at: Placement {
                    xyz: words(["0.1", "0.03", "-0.02"]),
                    ..Placement::none()
                },
                mass: Written::new("1.3"),
                tensor: ["0.02", "0", "0", "0.03", "0", "0.03"].map(Written::new),
            }),
        });
    Robot {
        root: None,
        bodies: bodies.collect(),
        options: Options {
            tip: Some(count),
            ..Options::default()
        },
        front_end: FrontEnd::Inline,
    }
}

const NO_ROTATION: [&str; 3] = ["0"; 3];

#[test]
fn bounds_include_the_normalisation_of_axes() {
    for axis in [
        ["0.012", "-0.18", "-0.945"],
        ["0.069", "-0.491", "0.327"],
        ["-0.9", "-0.527", "-0.82"],
        ["123.4", "-0.7", "55.1"],
        ["0.0011", "0.0023", "-0.0017"],
        ["1e300", "2e300", "-3e299"],
        ["1e-310", "3e-310", "-2e-310"],
    ] {
        for kind in [
            Kind::Revolute,
            Kind::Prismatic,
            Kind::Screw(Written::new("0.0173")),
            Kind::Cylindrical,
            Kind::Universal(axis.map(Written::new)),
            Kind::Planar,
        ] {
            let others = (Kind::Revolute, NO_ROTATION, ["0", "0", "1"]);
            share(&row(vec![(kind.clone(), NO_ROTATION, axis), others]), 4);
        }
    }
}

#[test]
fn bounds_include_the_rounding_of_computed_angles() {
    for angle in ["pi/3", "2*pi/7", "-pi/180", "1/3", "pi/5000"] {
        let turned = (Kind::Prismatic, ["0", angle, "0"], ["0", "0", "1"]);
        share(&row(vec![turned.clone(), turned]), 20);
    }
}

/// Two halves of a right angle, with inverse rotations between them, leave 6e-17, whose last digits are below 106 bits
/// of 1.
#[test]
fn bounds_include_what_cancels_between_fixed_joints() {
    let half = "-0.7853981633974483";
    let turns = [half, "0.3", "-0.3", "1.1", "-1.1", "0.7", "-0.7", half];
    let fixed = turns.map(|roll| (Kind::Fixed, [roll, "0", "0"], ["1", "0", "0"]));
    let plane = (Kind::Planar, NO_ROTATION, ["0", "0", "-1"]);
    share(&row(fixed.into_iter().chain([plane]).collect()), 100);
}

/// A mimic joint of a locked joint is at an exact product plus offset.
#[test]
fn bounds_include_the_position_of_a_mimic_joint_of_a_locked_one() {
    let axis = ["0", "0", "1"];
    let mut robot = row(vec![
        (Kind::Revolute, NO_ROTATION, axis),
        (Kind::Prismatic, NO_ROTATION, axis),
        (Kind::Prismatic, NO_ROTATION, ["0", "1", "0"]),
    ]);
    robot.bodies[1].mimic = Some(Mimic {
        mimicked: 1,
        multiplier: Written::new("0.1"),
        offset: Written::new("-0.030000000000000002"),
    });
    robot.options.lock = vec![(1, Some(Written::new("0.3")))];
    assert!(share(&robot, 20) > 0.0);
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
