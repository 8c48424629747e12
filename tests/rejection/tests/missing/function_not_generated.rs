//! A controller that needs a function that was not generated.

use homogen::Robot;
use homogen::robot::Bias;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "fore", generate(gravity))]
struct Arm;

fn control<R: Bias<N>, const N: usize>(robot: &R) -> [f64; N] {
    robot.bias(&[0.0; N], &[0.0; N])
}

fn main() {
    let _ = Arm.gravity(&[0.0; 2]);
    let _: [f64; 2] = control(&Arm);
}
