//! A number cannot be two fields, and gravity not a field and a vector.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity), gravity = none)]
struct Arm {
    #[robot(mass_of = "fore")]
    payload: f64,
    #[robot(mass_of = "fore")]
    load: f64,
    #[robot(gravity)]
    weight: [f64; 3],
}

fn main() {
    let arm = Arm {
        payload: 1.0,
        load: 1.0,
        weight: [0.0; 3],
    };
    let _ = arm.gravity(&[0.0; 2]);
    let _ = (arm.payload, arm.load, arm.weight);
}
