//! Two links and two joints of one name.

use homogen::chain;

chain! {
    struct Arm { generate(inverse_dynamics, gravity) }
    link base;
    joint elbow: revolute(z);
    link upper { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint elbow: revolute(z) { at: xyz(0.2, 0.0, 0.0) }
    link fore { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint wrist: fixed { from: fore }
    link upper;
}

fn main() {
    let _: [f64; 2] = Arm.inverse_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2]);
    let _ = Arm.gravity(&[0.0; 2]);
    let chain: homogen::Chain<2, 1> = Arm::chain();
    let _ = homogen::generic::gravity(&chain, &[0.0; 2]);
}
