//! A tip that is not there, on the way to which a joint would have been held.

use homogen::chain;

chain! {
    struct Arm { tip: hnad, path_only, generate(gravity) }
    link base;
    joint shoulder: revolute(z) { from: base, to: hand }
    joint gaze: revolute(z) { from: base, to: eye }
    link hand { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    link eye { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
}

fn main() {
    let _ = Arm.gravity(&[0.0; 1]);
}
