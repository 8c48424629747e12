//! What depends on fields alone cannot be computed once where there are none.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", prepare, generate(gravity))]
struct Arm;

fn main() {
    let arm = Arm.prepare();
    let _: [f64; 2] = arm.gravity(&[0.0; 2]);
}
