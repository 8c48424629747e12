//! Something that has no functions of its own.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity))]
enum Arm {
    Left,
}

fn main() {
    let _ = Arm::Left.gravity(&[0.0; 2]);
}
