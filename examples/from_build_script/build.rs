//! Writes the functions of an arm to `OUT_DIR` before the crate is compiled.
//!
//! In: a URDF file. Out: `arm.rs`, a readable file that needs `core` only. Warnings about the robot are warnings of
//! cargo, errors are errors.

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
    // `write` has reported the errors to cargo.
    written.map_or(ExitCode::FAILURE, |()| ExitCode::SUCCESS)
}
