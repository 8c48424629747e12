//! Writes every robot that ships as a file for `core` alone, in single precision.
//!
//! In: robots/*.urdf. Out: `ROBOT_own.rs` with the sines that a file brings along, and
//! `ROBOT_named.rs` with those of the runtime for any angle, in `OUT_DIR`.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use homogen_codegen::{Builder, Function, Real};

/// The files, and the links whose frames poses are of.
const ROBOTS: [(&str, &str); 9] = [
    ("two_link", "tip"),
    ("scara", "tool"),
    ("stanford", "tool"),
    ("stanford_general", "tool"),
    ("puma560", "tool"),
    ("puma560_general", "tool"),
    ("ur5_class", "tool0"),
    ("panda_class", "link8"),
    ("quadruped", "hr_foot"),
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../robots");
    let folder = env::var("OUT_DIR")?;
    for (robot, tip) in ROBOTS {
        let own = Builder::from_urdf(format!("../robots/{robot}.urdf"))
            .name("Standalone")
            .tip(tip)
            .scalar(Real::F32)
            .generate(Function::ALL);
        both(own, robot, &folder)?;
    }
    let driven = Builder::from_urdf("../robots/scara.urdf")
        .name("Standalone")
        .scalar(Real::F32)
        .armature("shoulder", [0.25])
        .rotor("lift", 2e-5, 300.0)
        .damping("elbow", [0.75])
        .coulomb_friction("elbow", [0.5])
        .coulomb_friction("lift", [3.0])
        .generate(Function::ALL);
    both(driven, "driven", &folder)
}

/// Both files of a robot.
fn both(own: Builder, robot: &str, folder: &str) -> Result<(), Box<dyn Error>> {
    let named = own
        .clone()
        .sin_cos("::homogen::trigonometry::single::sin_cos");
    for (file, builder) in [("own", own), ("named", named)] {
        let path = Path::new(folder).join(format!("{robot}_{file}.rs"));
        fs::write(path, builder.to_source()?.to_string())?;
    }
    Ok(())
}
