//! Generates the arm's functions and the linker script with the memory of the board.
//!
//! In: the name of an arm of `arms.rs` in the variable `ARM`; in `PEER` the path of an object with the functions of
//! CasADi, if they are measured. Out: `arm.rs` and `memory.x` in `OUT_DIR`.

mod arms;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use arms::Arm;
use homogen_codegen::Function::{
    ForwardDynamics, ForwardKinematics, GeometricJacobian, Gravity, InverseDynamics, MassMatrix,
};
use homogen_codegen::{Builder, Real};

/// The memory of the boards, the same as in every firmware by `homogen new`.
const MEMORY: &str = "../../page/src/firmware/memory.x";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=ARM");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed={MEMORY}");
    println!("cargo::rerun-if-changed=arms.rs");
    let arm = arms::chosen()?;
    println!("cargo::rustc-env=ARM={}", arm.name);
    println!("cargo::rustc-env=JOINTS={}", arm.joints);
    generate(arm)?;

    if env::var("CARGO_CFG_TARGET_OS")? == "none" {
        let out = env::var("OUT_DIR")?;
        fs::copy(MEMORY, Path::new(&out).join("memory.x"))?;
        println!("cargo::rustc-link-search={out}");
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
        link_peer();
    }
    Ok(())
}

/// Links the object in `PEER` to the firmware that measures it.
fn link_peer() {
    println!("cargo::rerun-if-env-changed=PEER");
    if let Ok(object) = env::var("PEER") {
        println!("cargo::rerun-if-changed={object}");
        println!("cargo::rustc-link-arg-bin=peer={object}");
    }
}

fn generate(arm: &Arm) -> Result<(), Box<dyn Error>> {
    let arm = Builder::from_urdf(arm.urdf)
        .name("Arm")
        .tip(arm.tip)
        .generate([
            ForwardKinematics,
            GeometricJacobian,
            Gravity,
            InverseDynamics,
            MassMatrix,
            ForwardDynamics,
        ])
        .scalar(Real::F32);
    // `write` reports errors to cargo.
    Ok(arm.write("arm.rs")?)
}
