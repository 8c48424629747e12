//! Generates the same arm for any type of number: with it the host computes the exact results of the controller and
//! the magnitudes of its terms.

#[path = "../arms.rs"]
mod arms;

use std::error::Error;

use homogen_codegen::Builder;
use homogen_codegen::Function::{
    ForwardDynamics, ForwardKinematics, GeometricJacobian, Gravity, InverseDynamics, MassMatrix,
};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=ARM");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../arms.rs");
    let arm = arms::chosen()?;
    let builder = Builder::from_urdf(format!("../{}", arm.urdf))
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
        .runtime("::homogen");
    Ok(builder.write("arm.rs")?)
}
