//! Mistakes of the grammar, each told once, with the rest read on.

use homogen::chain;

chain! {
    struct Arm { generate(gravity), gravity: 9.81 }
    link base;
    joint shoulder revolute(z);
    joint elbow: revolute { at: xyz(0.2, 0.0, 0.0) }
    link upper { mas: 1.0, com: [0.1, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint wrist: screw(z) { at: xy(0.2, 0.0) }
    link fore { mass: -1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01] }
    lnik hand;
}

fn main() {
    let _ = Arm.gravity(&[0.0; 2]);
}
