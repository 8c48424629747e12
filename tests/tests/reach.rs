//! Inverse kinematics: what it says is met is met, by poses that share no code with what it was found with, and it
//! always ends with numbers.

use std::f64::consts::TAU;

use homogen::reach::{Outcome, Reach, Solution};
use homogen::robot::{ForwardKinematics, GeometricJacobian};
use homogen::{Chain, Error, Pose, Robot, Scalar, generic, rotation, vector};
use homogen_random::Random;
use homogen_tests::robots::{PandaClass, Ur5Class};

const TARGETS: usize = 500;

const PANDA: [[f64; 2]; 7] = [
    [-2.8973, 2.8973],
    [-1.7628, 1.7628],
    [-2.8973, 2.8973],
    [-3.0718, -0.0698],
    [-2.8973, 2.8973],
    [-0.0175, 3.7525],
    [-2.8973, 2.8973],
];

const UR5: [[f64; 2]; 6] = [[-TAU, TAU]; 6];

fn middle<const N: usize>(limits: &[[f64; 2]; N]) -> [f64; N] {
    limits.map(|[least, most]| 0.5 * (least + most))
}

fn anywhere<const N: usize>(limits: &[[f64; 2]; N], random: &mut Random) -> [f64; N] {
    limits.map(|[least, most]| 0.5 * (least + most + random.unit() * (most - least)))
}

/// How far a pose is from another: the angle and the distance.
fn apart(a: &Pose<f64>, b: &Pose<f64>) -> [f64; 2] {
    let turn = a.inverse() * *b;
    let (_, angle) = rotation::axis_angle(turn.rotation());
    [
        angle,
        vector::norm(vector::sub(a.translation(), b.translation())),
    ]
}

fn is_within<const N: usize>(limits: &[[f64; 2]; N], q: &[f64; N]) -> bool {
    let pairs = limits.iter().zip(q);
    pairs
        .into_iter()
        .all(|([least, most], q)| least <= q && q <= most)
}

/// Of random targets within the limits all but a few are met.
fn are_met<R, const N: usize, const F: usize>(arm: &R, chain: &Chain<N, F>, limits: [[f64; 2]; N])
where
    R: ForwardKinematics<N> + GeometricJacobian<N>,
{
    let reach = Reach::within(limits);
    let mut random = Random::new(3);
    let mut missed = 0;
    for _ in 0..TARGETS {
        let target =
            generic::forward_kinematics(chain, &chain.frames[0], &anywhere(&limits, &mut random));
        let found = reach.solve(arm, &target, &middle(&limits)).expect("a pose");
        assert!(is_within(&limits, &found.q), "{found:?}");
        assert!(found.looks <= reach.looks * reach.starts, "{found:?}");
        if found.outcome == Outcome::Converged {
            let there = generic::forward_kinematics(chain, &chain.frames[0], &found.q);
            let off = apart(&there, &target);
            assert!(off.iter().all(|off| *off <= 1.000_001e-6), "{off:?}");
        } else {
            missed += 1;
        }
    }
    assert!(missed <= TARGETS / 250, "{missed} of {TARGETS}");
}

#[test]
fn targets_of_a_redundant_arm() {
    are_met(&PandaClass, &PandaClass::chain(), PANDA);
}

#[test]
fn targets_of_six_joints() {
    are_met(&Ur5Class, &Ur5Class::chain(), UR5);
}

#[test]
fn in_single_precision() {
    let limits = PANDA.map(|limits| limits.map(f32::constant));
    let reach = Reach::within(limits);
    let start = middle(&PANDA).map(f32::constant);
    let mut random = Random::new(4);
    let mut missed = 0;
    for _ in 0..TARGETS {
        let q = anywhere(&PANDA, &mut random).map(f32::constant);
        let target: Pose<f32> = PandaClass.forward_kinematics(&q);
        let found = reach.solve(&PandaClass, &target, &start).expect("a pose");
        missed += usize::from(found.outcome != Outcome::Converged);
    }
    assert!(missed <= TARGETS / 100, "{missed} of {TARGETS}");
}

#[test]
fn what_no_arm_reaches() {
    let reach = Reach::within(PANDA);
    let target = Pose::from_translation([3.0, 0.5, 0.2]);
    let found = reach
        .solve(&PandaClass, &target, &middle(&PANDA))
        .expect("a pose");
    assert_eq!(found.outcome, Outcome::OutOfReach);
    let there = PandaClass.forward_kinematics(&found.q);
    let [turn, shift] = apart(&there, &target);
    assert!((turn - found.turn).abs() < 1e-12 && (shift - found.shift).abs() < 1e-12);
    assert!(found.shift > 1.5, "{found:?}");
}

#[test]
fn a_posture_is_neared_as_far_as_the_target_leaves_free() {
    let free = Reach::within(PANDA);
    let mut random = Random::new(5);
    let mut nearer = 0;
    for _ in 0..50 {
        let target = PandaClass.forward_kinematics(&anywhere(&PANDA, &mut random));
        let posture = middle(&PANDA);
        let start = anywhere(&PANDA, &mut random);
        let held = Reach {
            posture: Some(posture),
            ..free
        };
        let [without, with] =
            [free, held].map(|reach| reach.solve(&PandaClass, &target, &start).expect("a pose"));
        let away = |found: &Solution<f64, 7>| {
            vector::norm::<f64, 7>(std::array::from_fn(|i| found.q[i] - posture[i]))
        };
        assert_eq!(with.outcome, without.outcome);
        assert!(away(&with) <= away(&without) + 1e-12);
        let again = held.solve(&PandaClass, &target, &with.q).expect("a pose");
        assert!(away(&again) > 0.99 * away(&with), "there was more to gain");
        nearer += usize::from(away(&with) < 0.9 * away(&without));
    }
    // One joint more than the target needs moves most arms a little.
    assert!(nearer >= 10, "{nearer}");
}

/// Two feet at once.
#[derive(Robot)]
#[robot(
    urdf = "../robots/quadruped.urdf",
    tip = "hr_foot",
    frames(fl_foot),
    generate(forward_kinematics, geometric_jacobian)
)]
struct Feet;

#[test]
fn several_frames_at_once() {
    let see = |q: &[f64; 12]| {
        [
            (Feet.forward_kinematics(q), Feet.geometric_jacobian(q)),
            (
                Feet.forward_kinematics_of_fl_foot(q),
                Feet.geometric_jacobian_of_fl_foot(q),
            ),
        ]
    };
    let limits = [[-0.8, 0.8]; 12];
    let reach = Reach::within(limits);
    let mut random = Random::new(6);
    for _ in 0..20 {
        let targets = see(&anywhere(&limits, &mut random)).map(|(pose, _)| pose);
        let found = reach
            .solve_frames(see, &targets, &[0.1; 12])
            .expect("poses");
        assert_eq!(found.outcome, Outcome::Converged);
        for ((there, _), target) in see(&found.q).iter().zip(&targets) {
            assert!(apart(there, target).iter().all(|off| *off <= 1.000_001e-6));
        }
    }
}

/// What comes of a call, and that it is finite and right where it says so.
fn called(
    reach: &Reach<f64, 6>,
    target: &Pose<f64>,
    start: [f64; 6],
) -> Result<Solution<f64, 6>, Error> {
    let found = reach.solve(&Ur5Class, target, &start)?;
    let finite = found.q.iter().all(|q| q.is_finite());
    assert!(
        finite && !found.turn.is_nan() && !found.shift.is_nan(),
        "{reach:?} {target:?} {start:?}: {found:?}"
    );
    assert!(is_within(&reach.limits, &found.q), "{found:?}");
    if found.outcome == Outcome::Converged {
        let off = apart(&Ur5Class.forward_kinematics(&found.q), target);
        assert!(off.iter().all(|off| *off <= 1.000_001e-6), "{off:?}");
    }
    Ok(found)
}

#[test]
fn what_is_not_finite_is_an_error_and_never_returned() {
    let reach = Reach::within(UR5);
    let good: Pose<f64> = Ur5Class.forward_kinematics(&[0.5; 6]);
    let [nan, infinite] = [f64::NAN, f64::INFINITY];
    for bad in [nan, infinite, -infinite] {
        let posture = Some([bad; 6]);
        let radius = bad;
        for (reach, target, start) in [
            (reach, Pose::from_translation([0.3, bad, 0.2]), [0.0; 6]),
            (reach, Pose::new([[bad; 3]; 3], [0.1; 3]), [0.0; 6]),
            (reach, good, [bad; 6]),
            (Reach { posture, ..reach }, good, [0.3; 6]),
            (Reach { radius, ..reach }, good, [0.3; 6]),
        ] {
            let error = called(&reach, &target, start).expect_err("not finite");
            assert!(matches!(error, Error::NotFinite { .. }), "{error}");
        }
    }
    for reach in [
        Reach { turn: nan, ..reach },
        Reach {
            shift: nan,
            ..reach
        },
    ] {
        assert!(called(&reach, &good, [0.3; 6]).is_err());
    }
}

#[test]
fn numbers_that_are_huge_end_in_numbers() {
    let reach = Reach::within(UR5);
    let good: Pose<f64> = Ur5Class.forward_kinematics(&[0.5; 6]);
    let huge = 1e300;
    let limits = [[-f64::INFINITY, f64::INFINITY]; 6];
    let posture = Some([huge; 6]);
    for (reach, target, start) in [
        (reach, Pose::from_translation([0.3, huge, 0.2]), [0.0; 6]),
        (reach, good, [huge; 6]),
        (Reach { posture, ..reach }, good, [0.3; 6]),
        (
            Reach {
                radius: huge,
                ..reach
            },
            good,
            [0.3; 6],
        ),
        (Reach { limits, ..reach }, good, [huge; 6]),
        (Reach::within([[huge, f64::INFINITY]; 6]), good, [0.3; 6]),
        (Reach::within([[-f64::MAX, f64::MAX]; 6]), good, [0.3; 6]),
    ] {
        called(&reach, &target, start).expect("numbers");
    }
}

/// Where there is no limit to one side, or to both, any finite number is within.
#[test]
fn limits_that_no_number_is_within_are_an_error() {
    let target: Pose<f64> = Ur5Class.forward_kinematics(&[0.5; 6]);
    let [nan, infinite] = [f64::NAN, f64::INFINITY];
    for ends in [
        [1.0, -1.0],
        [0.0, -infinite],
        [infinite, 0.0],
        [infinite, infinite],
        [-infinite, -infinite],
        [nan, 1.0],
        [-1.0, nan],
    ] {
        let mut limits = UR5;
        limits[3] = ends;
        let error = called(&Reach::within(limits), &target, [0.3; 6]).expect_err("no range");
        assert!(
            matches!(error, Error::NoRange { coordinate: 3, .. }),
            "{error}"
        );
    }
    for ends in [
        [-infinite, infinite],
        [-infinite, 3.0],
        [-3.0, infinite],
        [0.5, 0.5],
    ] {
        let mut limits = UR5;
        limits[3] = ends;
        let found = called(&Reach::within(limits), &target, [0.4; 6]).expect("a range");
        assert_eq!(found.outcome, Outcome::Converged, "{ends:?}");
    }
}

/// Of a scaled or sheared matrix axis and angle are those of no turn: it was said to be met, 0.5 rad off.
#[test]
fn a_target_whose_matrix_is_no_rotation_is_an_error() {
    let reach = Reach::within(UR5);
    let good: Pose<f64> = Ur5Class.forward_kinematics(&[0.5; 6]);
    let changed = |change: &dyn Fn(&mut [[f64; 3]; 3])| {
        let mut rotation = *good.rotation();
        change(&mut rotation);
        Pose::new(rotation, good.translation())
    };
    for bad in [
        Pose::new([[0.0; 3]; 3], good.translation()),
        changed(&|r| r.iter_mut().flatten().for_each(|x| *x *= 1.01)),
        changed(&|r| r[0][1] += 0.5),
        changed(&|r| r[2] = r[2].map(|x| -x)),
        changed(&|r| r.iter_mut().flatten().for_each(|x| *x *= 1e200)),
    ] {
        let error = called(&reach, &bad, [0.4; 6]).expect_err("no rotation");
        assert!(matches!(error, Error::NotRotation { .. }), "{error}");
    }
}

/// Such as a matrix of single precision, or one that was printed with seven digits.
#[test]
fn a_target_whose_matrix_is_a_rotation_but_for_its_digits_is_met() {
    let reach = Reach::within(UR5);
    let good: Pose<f64> = Ur5Class.forward_kinematics(&[0.5; 6]);
    #[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    let single = good.rotation().map(|row| row.map(|x| f64::from(x as f32)));
    let printed = good
        .rotation()
        .map(|row| row.map(|x| (x * 1e7).round() / 1e7));
    for rotation in [single, printed] {
        let target = Pose::new(rotation, good.translation());
        let found = reach.solve(&Ur5Class, &target, &[0.4; 6]).expect("a pose");
        assert_eq!(found.outcome, Outcome::Converged);
        let [turn, shift] = apart(&Ur5Class.forward_kinematics(&found.q), &good);
        assert!(turn < 2e-6 && shift < 2e-6, "{turn:e} {shift:e}");
    }
    let target: Pose<f32> = PandaClass.forward_kinematics(&middle(&PANDA).map(f32::constant));
    let printed = target
        .rotation()
        .map(|row| row.map(|x| (x * 1e4).round() / 1e4));
    let target = Pose::new(printed, target.translation());
    let reach = Reach::within(PANDA.map(|limits| limits.map(f32::constant)));
    let found = reach.solve(&PandaClass, &target, &[0.1; 7].map(f32::constant));
    assert_eq!(found.map(|found| found.outcome), Ok(Outcome::Converged));
}
