#![deny(deprecated)]

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "fore", generate(gravity))]
struct Arm {
    #[robot(mass_of = "fore")]
    load: f64,
    payload: f64,
    fore: f64,
    temperature: f64,
}

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "fore", quiet, generate(gravity))]
struct Quiet {
    #[robot(mass_of = "fore")]
    load: f64,
    payload: f64,
}

fn main() {
    let arm = Arm {
        load: 1.0,
        payload: 2.0,
        fore: 3.0,
        temperature: 4.0,
    };
    let _ = arm.gravity(&[0.0; 2]);
    let quiet = Quiet {
        load: 1.0,
        payload: 2.0,
    };
    let _ = quiet.gravity(&[0.0; 2]);
}
