//! A field cannot be two numbers.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity))]
struct Arm {
    #[robot(com_of = "fore", origin_of = "elbow")]
    center: [f64; 3],
}

fn main() {
    let arm = Arm { center: [0.0; 3] };
    let _ = arm.gravity(&[0.0; 2]);
    let _ = arm.center;
}
