//! A controller with the functions that the build script generated.

/// The generated file: `struct Arm` and its functions.
mod arm {
    include!(concat!(env!("OUT_DIR"), "/arm.rs"));
}

use arm::Arm;

fn main() {
    let arm = Arm { payload: 1.2 };
    let q = [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8];
    let tau = arm.inverse_dynamics(&q, &[0.1; 7], &[0.0; 7]);
    println!("torques  {tau:8.3?} N m");
    let jacobian = arm.geometric_jacobian(&q);
    println!("joint 7  {:8.3?} (u, b)", jacobian[6]);
}
