//! The program of the README, with another folder of the file.

use homogen::Robot;

#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(inverse_dynamics))]
struct Panda {
    #[robot(mass_of = "link8")]
    payload: f64, // kg; every other number is folded into the code
}

fn main() {
    let arm = Panda { payload: 1.2 };
    let q = [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8];
    println!("{:.3?} N m", arm.inverse_dynamics(&q, &[0.1; 7], &[0.0; 7]));
}
