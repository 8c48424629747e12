//! Drives that no joint can have, actions that change nothing, and words that are not written as they are meant.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity))]
#[robot(armature(shoulder = -0.5), damping(nobody = 0.5))]
struct Arm {
    #[robot(friction_of = "sholder")]
    brake: f64,
}

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(gravity))]
#[robot(damping(shoulder = often), friction = 0.5, rotor)]
struct Words {
    #[robot(friction_of = "shoulder", range = -1.0)]
    brake: f64,
}

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(inverse_dynamics_derivatives))]
#[robot(external(nothing, frame = 1), ratio(shoulder = 10), rotors = 1)]
struct Acted;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(inverse_dynamics_derivatives, gravity))]
#[robot(external(nothing), ratio(shoulder = 10))]
struct Pushed;

fn main() {
    let arm = Arm { brake: 0.0 };
    let _ = arm.gravity(&[0.0; 2]);
    let words = Words { brake: arm.brake };
    let _ = (words.gravity(&[0.0; 2]), words.brake);
    let _ = (Pushed.gravity(&[0.0; 2]), Acted);
}
