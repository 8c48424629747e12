//! After a mistake the stubs bear every use that the functions bear.

use homogen::Robot;
use homogen::robot::{Gravity, MassMatrix};

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "for", frames("upper"))]
#[robot(generate(forward_kinematics, gravity, mass_matrix, all_of(mass_matrix, bias)))]
pub struct Arm;

const CHAIN: homogen::Chain<2, 2> = Arm::chain();

fn hold<R: Gravity<N> + MassMatrix<N, f32>, const N: usize>(robot: &R) -> [f64; N] {
    let _ = robot.mass_matrix(&[0.0; N]);
    robot.gravity(&[0.0; N])
}

fn main() {
    let _: [f64; 2] = hold(&Arm);
    let (mass, bias) = Arm.mass_matrix_and_bias(&[0.0_f64; 2], &[0.0; 2]);
    let _ = mass[0][0] + bias[0];
    let _ = Arm.forward_kinematics(&[0.0_f64; 2]).translation();
    let _ = Arm.forward_kinematics_of_upper(&[0.0_f64; 2]).translation();
    let _ = CHAIN.joints.len();
}
