//! `prepare` needs fields.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", prepare, generate(gravity))]
struct Arm;

fn main() {
    let arm = Arm.prepare();
    let _: [f64; 2] = arm.gravity(&[0.0; 2]);
}
