//! A minimal robot: two links in a vertical plane.
//!
//! The guide shows its generated code beside the equations of the textbooks.

use homogen::Robot;

#[derive(Robot)]
#[robot(
    urdf = "../robots/two_link.urdf",
    tip = "tip",
    generate(inverse_dynamics)
)]
struct TwoLink;

fn main() {
    let [shoulder, elbow] = TwoLink.inverse_dynamics(&[0.3, 0.4], &[1.0, -2.0], &[0.0, 5.0]);
    println!("{shoulder} N m, {elbow} N m");
}
