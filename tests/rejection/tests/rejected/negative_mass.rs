//! A body that weighs less than nothing.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/negative_mass.urdf", generate(inverse_dynamics, gravity))]
struct Arm;

fn main() {
    let _: [f64; 2] = Arm.inverse_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2]);
    let _ = Arm.gravity(&[0.0; 2]);
    let chain: homogen::Chain<2, 1> = Arm::chain();
    let _ = homogen::generic::gravity(&chain, &[0.0; 2]);
    let mut q = [0.0; Arm::NQ];
    q[1] = Arm::LOWER[1];
    let _ = Arm.gravity(&q);
    let _: [&str; 2] = <Arm as Robot<2>>::COORDINATES;
}
