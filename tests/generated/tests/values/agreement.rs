//! Generated code compared with the generic recursions, which share nothing with the generator but the chain as data.
//!
//! Errors are in units of rounding of the type, times the largest entry of the result in any state.
//! Limits are a few times the worst measured error.

use homogen::{Chain, Pose, Real, Robot};
use homogen_robots::for_every_robot;
use homogen_robots::shipped::{
    PandaClass, Puma560, Puma560General, Quadruped, Scara, Stanford, StanfordGeneral, Together,
    TwoLink, Ur5Class,
};
use homogen_tests::effort::effort;
use homogen_tests::functions::{self, Block, EveryFunction, evaluate};
use homogen_tests::rounding::{DOUBLE, SINGLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(25, 1000)
}

/// In single precision nearly all errors are those of generated code: the worst is 4.9 u.
const SINGLE_LIMIT: f64 = 16.0;

/// In double precision the dense products of the generic recursions have larger errors than generated code: the worst
/// is 32 u.
const DOUBLE_LIMIT: f64 = 64.0;

/// Compares every function in both precisions with the generic recursions in double precision.
fn agree<R, const N: usize, const F: usize>(robot: &R, chain: &Chain<N, F>)
where
    R: EveryFunction<N, f64> + EveryFunction<N, f32> + Together<N, f64> + Together<N, f32>,
{
    let mut random = Random::new(1);
    let mut double = Worst::in_units_of(DOUBLE);
    let mut single = Worst::in_units_of(SINGLE);
    for _ in 0..count() {
        let state = State::random(&mut random);
        let expected = evaluate(chain, &state);
        compare::<_, f64, _>(robot, &state, &expected, &mut double);
        compare::<_, f32, _>(robot, &state, &expected, &mut single);
    }
    println!("double precision\n{double}\nsingle precision\n{single}");
    double.assert_within(DOUBLE_LIMIT);
    single.assert_within(SINGLE_LIMIT);
}

/// Compares every function, generated alone and together with others.
fn compare<R, T, const N: usize>(
    robot: &R,
    state: &State<f64, N>,
    expected: &[Block<f64>],
    worst: &mut Worst,
) where
    R: EveryFunction<N, T> + Together<N, T>,
    T: Real,
{
    let state = state.to::<T>();
    let widened = |blocks: &[Block<T>]| -> Vec<Block<f64>> {
        blocks.iter().map(|block| block.map(T::to_f64)).collect()
    };
    worst.note(&widened(&evaluate(robot, &state)), expected);
    let State { q, qd, .. } = &state;
    let (m, columns) = robot.pose_and_jacobian(q);
    let (mass, bias) = robot.mass_and_bias(q, qd);
    for shared in [
        functions::of_the_tip(&m, &columns),
        functions::of_the_whole(&mass, &bias),
    ] {
        let named = |block: &&Block<f64>| shared.iter().any(|other| other.name == block.name);
        let expected: Vec<_> = expected.iter().filter(named).cloned().collect();
        worst.note(&widened(&shared), &expected);
    }
}

macro_rules! agreement {
    ($name:ident, $robot:ident) => {
        #[test]
        fn $name() {
            agree(&$robot, &$robot::chain());
        }
    };
}
for_every_robot!(agreement);

/// The base and the feet of a quadruped that floats.
#[derive(Robot)]
#[robot(urdf = "../../robots/quadruped.urdf", floating, tip = "fl_foot")]
#[robot(frames("base", "fr_foot", "hl_foot", "hr_foot"))]
#[robot(generate(frame_poses, forward_kinematics))]
struct Feet;

#[test]
fn poses_of_all_frames_are_those_of_each_in_the_order_of_their_names() {
    let chain = Feet::chain();
    let mut random = Random::new(2);
    let mut worst = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let State { q, .. } = State::of(&chain, &mut random);
        let each = [
            Feet.forward_kinematics(&q),
            Feet.forward_kinematics_of_base(&q),
            Feet.forward_kinematics_of_fr_foot(&q),
            Feet.forward_kinematics_of_hl_foot(&q),
            Feet.forward_kinematics_of_hr_foot(&q),
        ];
        let blocks = |pose: &Pose<f64>| functions::of_the_tip(pose, &[]);
        for (found, expected) in Feet.frame_poses(&q).iter().zip(&each) {
            worst.note(&blocks(found), &blocks(expected));
        }
    }
    worst.assert_within(8.0);
}
