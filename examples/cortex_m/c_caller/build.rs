//! Generates the arm's functions, and the header that declares them to C; and the same written in C.
//!
//! In: the name of an arm of `arms.rs` in the variable `ARM`. Out: `arm.rs` and `arm.h` in `OUT_DIR`, and `arm.c` with
//! another `arm.h` in its folder `c99`.

#[path = "../arms.rs"]
mod arms;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use homogen_codegen::Function::{
    ForwardDynamics, ForwardKinematics, GeometricJacobian, Gravity, InverseDynamics, MassMatrix,
};
use homogen_codegen::{Builder, Real};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=ARM");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../arms.rs");
    let arm = arms::chosen()?;
    let builder = Builder::from_urdf(format!("../{}", arm.urdf))
        .name("Arm")
        .tip(arm.tip)
        .scalar(Real::F32)
        .generate([
            ForwardKinematics,
            GeometricJacobian,
            Gravity,
            InverseDynamics,
            MassMatrix,
            ForwardDynamics,
        ])
        .extern_c("arm_");
    builder.write("arm.rs")?;
    builder.write_c_header("arm.h")?;
    fs::create_dir_all(Path::new(&env::var("OUT_DIR")?).join("c99"))?;
    Ok(builder.write_c("c99/arm.c")?)
}
