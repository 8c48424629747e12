//! Inverse kinematics: what it says is met is met, by poses that share no code with what it was found with, and it
//! always ends with numbers.

use std::f64::consts::TAU;

use homogen::reach::{Outcome, Reach, Solution};
use homogen::robot::{ForwardKinematics, GeometricJacobian};
use homogen::{Chain, Pose, Robot, Scalar, generic, rotation, vector};
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
        let found = reach.solve(arm, &target, &middle(&limits));
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
        let found = reach.solve(&PandaClass, &target, &start);
        missed += usize::from(found.outcome != Outcome::Converged);
    }
    assert!(missed <= TARGETS / 100, "{missed} of {TARGETS}");
}

#[test]
fn what_no_arm_reaches() {
    let reach = Reach::within(PANDA);
    let target = Pose::from_translation([3.0, 0.5, 0.2]);
    let found = reach.solve(&PandaClass, &target, &middle(&PANDA));
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
        let [without, with] = [free, held].map(|reach| reach.solve(&PandaClass, &target, &start));
        let away = |found: &Solution<f64, 7>| {
            vector::norm::<f64, 7>(std::array::from_fn(|i| found.q[i] - posture[i]))
        };
        assert_eq!(with.outcome, without.outcome);
        assert!(away(&with) <= away(&without) + 1e-12);
        let again = held.solve(&PandaClass, &target, &with.q);
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
        let found = reach.solve_frames(see, &targets, &[0.1; 12]);
        assert_eq!(found.outcome, Outcome::Converged);
        for ((there, _), target) in see(&found.q).iter().zip(&targets) {
            assert!(apart(there, target).iter().all(|off| *off <= 1.000_001e-6));
        }
    }
}

#[test]
fn what_is_no_number_is_told_and_never_returned() {
    let reach = Reach::within(UR5);
    let good = Ur5Class.forward_kinematics(&[0.5; 6]);
    let [nan, infinite] = [f64::NAN, f64::INFINITY];
    let mut cases: Vec<(Reach<f64, 6>, Pose<f64>, [f64; 6])> = Vec::new();
    for bad in [nan, infinite, -infinite, 1e300] {
        cases.push((reach, Pose::from_translation([0.3, bad, 0.2]), [0.0; 6]));
        cases.push((reach, Pose::new([[bad; 3]; 3], [0.1; 3]), [0.0; 6]));
        cases.push((reach, good, [bad; 6]));
        let posture = Some([bad; 6]);
        cases.push((Reach { posture, ..reach }, good, [0.3; 6]));
        cases.push((
            Reach {
                radius: bad,
                ..reach
            },
            good,
            [0.3; 6],
        ));
        let limits = [[-infinite, infinite]; 6];
        cases.push((Reach { limits, ..reach }, good, [bad; 6]));
        let limits = [[bad, infinite]; 6];
        cases.push((Reach { limits, ..reach }, good, [0.3; 6]));
    }
    for (reach, target, start) in cases {
        let found = reach.solve(&Ur5Class, &target, &start);
        let numbers = found.q.iter().all(|q| !q.is_nan());
        assert!(
            numbers && !found.turn.is_nan() && !found.shift.is_nan(),
            "{reach:?} {target:?} {start:?}: {found:?}"
        );
        if found.outcome == Outcome::Converged {
            let off = apart(&Ur5Class.forward_kinematics(&found.q), &target);
            assert!(off.iter().all(|off| *off <= 1.000_001e-6), "{off:?}");
        }
    }
}
