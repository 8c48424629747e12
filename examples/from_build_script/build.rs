//! Writes the functions of an arm to `OUT_DIR` before the crate is compiled.
//!
//! In: a URDF file. Out: `arm.rs`, a readable file that needs `core` and nothing else. What is
//! doubtful about the robot becomes a warning of cargo, every mistake an error.

use std::process::ExitCode;

use homogen_codegen::Function::{GeometricJacobian, InverseDynamics};
use homogen_codegen::{Builder, Real, Target};

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=build.rs");
    let written = Builder::from_urdf("../../robots/panda_class.urdf")
        .name("Arm")
        .tip("link8")
        .scalar(Real::F32)
        .parameter("payload", Target::MassOf("link8".into()))
        .generate([InverseDynamics, GeometricJacobian])
        .write("arm.rs");
    // The mistakes themselves have been told to cargo.
    written.map_or(ExitCode::FAILURE, |()| ExitCode::SUCCESS)
}
