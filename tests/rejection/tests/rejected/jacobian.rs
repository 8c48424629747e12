use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "rejected/arm.urdf", tip = "fore", generate(jacobian))]
struct Arm;

fn main() {}
