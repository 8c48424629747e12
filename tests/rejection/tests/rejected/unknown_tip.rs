//! A tip that is called otherwise.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "for", generate(all))]
struct Arm;

fn main() {
    let _: [f64; 2] = Arm.inverse_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2]);
    let _ = Arm.gravity(&[0.0; 2]);
    let chain: homogen::Chain<2, 1> = Arm::chain();
    let _ = homogen::generic::gravity(&chain, &[0.0; 2]);
}
