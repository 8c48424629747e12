//! A controller that needs a function of closed loops, for a robot without loops.

use homogen::{Robot, robot};

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "fore", generate(gravity))]
struct Arm;

fn close<const N: usize, const C: usize>(
    robot: &impl robot::Constraint<N, C>,
    q: &[f64; N],
) -> [f64; C] {
    robot.constraint(q)
}

fn main() {
    let _ = close::<2, 3>(&Arm, &[0.0; 2]);
}
