//! Accelerations of a joint that moves nothing.

use homogen::chain;

chain! {
    struct Arm { generate(forward_dynamics, gravity) }
    link base;
    joint shoulder: revolute(z);
    link upper { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint elbow: revolute(z);
    link fore;
}

fn main() {
    let _: [f64; 2] = Arm.forward_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2]);
    let _ = Arm.gravity(&[0.0; 2]);
}
