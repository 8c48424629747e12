//! Poses of a robot with two ends.

use homogen::chain;

chain! {
    struct Arm { generate(forward_kinematics, gravity) }
    link base;
    joint shoulder: revolute(z);
    link upper { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint elbow: revolute(z) { at: xyz(0.2, 0.0, 0.0) }
    link fore { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint hand: fixed { from: upper, to: eye }
    link eye;
}

fn main() {
    let _ = Arm.forward_kinematics(&[0.0; 2]);
    let _ = Arm.gravity(&[0.0; 2]);
}
