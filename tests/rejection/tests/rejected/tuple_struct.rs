//! Fields without names.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(inverse_dynamics, gravity))]
struct Arm(f64);

fn main() {
    let arm = Arm(1.0);
    let _: [f64; 2] = arm.inverse_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2]);
    let _ = arm.0;
}
