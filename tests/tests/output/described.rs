//! Robots describe themselves: counts, names, limits and the neutral configuration, as constants and by the trait
//! `Robot`.
//!
//! In: robots that ship. Out: the constants, compared with the numbers of their files.

use homogen::robot::{Bias, Gravity, MassMatrix};
use homogen::{Chain, Robot};
use homogen_robots::jointed::{FreeQuadruped, Gripper};
use homogen_robots::shipped::TwoLink;

#[test]
fn counts_names_and_limits_are_those_of_the_file() {
    assert_eq!((TwoLink::NQ, TwoLink::NV), (2, 2));
    assert_eq!(TwoLink::JOINTS, ["shoulder", "elbow"]);
    assert_eq!(TwoLink::FRAMES, ["tip"]);
    assert_eq!(TwoLink::COORDINATES, TwoLink::VELOCITIES);
    assert_eq!(TwoLink::MAX_VELOCITY, [4.0, 4.0]);
    assert_eq!(TwoLink::MAX_EFFORT, [50.0, 20.0]);
    assert!(
        TwoLink::LOWER
            .iter()
            .zip(TwoLink::UPPER)
            .all(|(a, b)| *a < b)
    );
}

#[test]
fn a_floating_base_has_a_quaternion_and_no_limits() {
    assert_eq!((FreeQuadruped::NQ, FreeQuadruped::NV), (19, 18));
    assert_eq!(FreeQuadruped::JOINTS.len(), 13);
    assert_eq!(FreeQuadruped::COORDINATES.len(), FreeQuadruped::NQ);
    assert_eq!(FreeQuadruped::VELOCITIES.len(), FreeQuadruped::NV);
    assert_eq!(FreeQuadruped::NEUTRAL, FreeQuadruped.neutral::<f64>());
    assert!(
        FreeQuadruped::MAX_EFFORT[..6]
            .iter()
            .all(|most| *most == f64::INFINITY)
    );
}

#[test]
fn joints_that_mimic_others_have_a_name_and_no_coordinate() {
    assert_eq!((Gripper::NQ, Gripper::NV), (2, 2));
    assert!(
        ["wrist", "right", "left", "thumb", "guard"]
            .iter()
            .all(|name| Gripper::JOINTS.contains(name))
    );
    assert_eq!(Gripper::LOWER, [f64::NEG_INFINITY; 2]);
}

/// Computed torque, clamped to effort limits, for any robot.
fn within_limits<R, const N: usize>(
    robot: &R,
    q: &[f64; N],
    qd: &[f64; N],
    qdd: &[f64; N],
) -> [f64; N]
where
    R: Robot<N> + MassMatrix<N> + Bias<N>,
{
    let (mass, bias) = (robot.mass_matrix(q), robot.bias(q, qd));
    std::array::from_fn(|i| {
        let tau: f64 = (0..N).map(|j| mass[i][j] * qdd[j]).sum();
        (tau + bias[i]).clamp(-R::MAX_EFFORT[i], R::MAX_EFFORT[i])
    })
}

#[test]
fn a_controller_for_any_robot_stays_within_effort_limits() {
    let small = within_limits(&TwoLink, &[0.1, 0.2], &[0.0; 2], &[0.0; 2]);
    let expected = TwoLink.gravity(&[0.1, 0.2]);
    assert!(
        small
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
    let large = within_limits(&TwoLink, &[0.1, 0.2], &[0.0; 2], &[1e4, 1e4]);
    assert_eq!(large, TwoLink::MAX_EFFORT);
}

#[test]
fn the_trait_has_the_type_of_the_chain() {
    let chain: <TwoLink as Robot<2>>::Chain = TwoLink::chain();
    let same: Chain<2, 1> = chain;
    assert_eq!(same.gravity(&[0.3, -0.4]).len(), TwoLink::NV);
}

mod in_single_precision {
    use homogen::Robot;

    #[derive(Robot)]
    #[robot(urdf = "../robots/two_link.urdf", tip = "tip", scalar = f32, generate(gravity))]
    struct Arm;

    #[test]
    fn constants_have_the_type_of_the_arguments() {
        let efforts: [f32; 2] = Arm::MAX_EFFORT;
        let wide: [f64; 2] = <Arm as Robot<2>>::MAX_EFFORT;
        assert_eq!((efforts, wide), ([50.0, 20.0], [50.0, 20.0]));
    }
}
