//! A field holds as many numbers as it stands for; and a word is no string.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity), scalar = "f64")]
struct Arm {
    #[robot(mass_of = "fore")]
    payload: [f64; 3],
    #[robot(gravity)]
    gravity: f64,
}

fn main() {
    let arm = Arm {
        payload: [0.0; 3],
        gravity: 9.81,
    };
    let _ = arm.gravity(&[0.0; 2]);
    let _ = (arm.payload, arm.gravity);
}
