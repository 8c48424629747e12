//! Fields that stand for what is not there, and for what never moves.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity))]
struct Arm {
    #[robot(mass_of = "for")]
    payload: f64,
    #[robot(mass_of = "base")]
    stand: f64,
    #[robot(payload_on = "base")]
    load: homogen::Payload,
    #[robot(placement_of = "elbo")]
    place: [f64; 6],
}

fn main() {
    let arm = Arm {
        payload: 1.0,
        stand: 1.0,
        load: homogen::Payload::default(),
        place: [0.0; 6],
    };
    let _ = arm.gravity(&[0.0; 2]);
    let _: homogen::Chain<2, 1> = arm.chain();
    let _ = (arm.payload, arm.stand, arm.load, arm.place);
}
