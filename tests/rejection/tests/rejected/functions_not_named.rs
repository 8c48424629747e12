use homogen::{Robot, chain};

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "fore")]
struct Silent;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "for")]
struct SilentAndLost;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate())]
struct Nothing;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", generate(all, gravity))]
struct Both;

chain! {
    struct InPlace;
    link base;
    joint j: revolute(z) { at: xyz(0.0, 0.0, 0.4) }
    link arm { mass: 1.0, inertia: [0.1, 0.1, 0.1] }
}

fn main() {}
