//! A file that is not there.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "/nowhere/arm.urdf", generate(inverse_dynamics, gravity))]
struct Arm;

fn clamped<R: Robot<N>, const N: usize>(_: &R, tau: [f64; N]) -> [f64; N] {
    core::array::from_fn(|i| tau[i].clamp(-R::MAX_EFFORT[i], R::MAX_EFFORT[i]))
}

fn main() {
    let _ = (Arm::NQ, Arm::NV, Arm::JOINTS, Arm::COORDINATES, Arm::VELOCITIES, Arm::FRAMES);
    let _ = (Arm::LOWER, Arm::UPPER, Arm::MAX_VELOCITY, Arm::MAX_EFFORT, Arm::NEUTRAL);
    let _ = clamped(&Arm, [0.0; 2]);
    let _: [f64; 2] = Arm.inverse_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2]);
    let _ = Arm.gravity(&[0.0; 2]);
    let chain: homogen::Chain<2, 1> = Arm::chain();
    let _ = homogen::generic::gravity(&chain, &[0.0; 2]);
}
