//! Build script: generates files for `core` alone of every robot that ships, in single precision, and of a robot with
//! every type of joint, in both precisions and as the source of its Python package.
//!
//! In: robots/*.urdf and tests/robots/every_joint.urdf. Out, in `OUT_DIR`: `ROBOT_own.rs` with its own sines,
//! `ROBOT_named.rs` with the runtime's sines for any angle; `joints_f32.rs`, `joints_f64.rs` and `joints_lanes.rs`.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use homogen_codegen::{Builder, Function, Real};

/// The files and their end effectors.
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
    println!("cargo::rerun-if-changed=robots");
    let folder = env::var("OUT_DIR")?;
    for (robot, tip) in ROBOTS {
        let own = Builder::from_urdf(format!("../robots/{robot}.urdf"))
            .name("Standalone")
            .tip(tip)
            .scalar(Real::F32)
            .generate(Function::ALL);
        write_both(own, robot, &folder)?;
    }
    let with_actuators = Builder::from_urdf("../robots/scara.urdf")
        .name("Standalone")
        .scalar(Real::F32)
        .armature("shoulder", [0.25])
        .rotor("lift", 2e-5, 300.0)
        .damping("elbow", [0.75])
        .coulomb_friction("elbow", [0.5])
        .coulomb_friction("lift", [3.0])
        .generate(Function::ALL);
    write_both(with_actuators, "with_actuators", &folder)?;
    write_joints(Path::new(&folder))
}

/// Writes the robot with every type of joint.
fn write_joints(folder: &Path) -> Result<(), Box<dyn Error>> {
    let builder = Builder::from_urdf("robots/every_joint.urdf")
        .name("Joints")
        .generate([Function::Gravity]);
    for (name, scalar) in [("f32", Real::F32), ("f64", Real::F64)] {
        let source = builder.clone().scalar(scalar).to_source()?;
        fs::write(folder.join(format!("joints_{name}.rs")), source.to_string())?;
    }
    let package = builder.to_python("joints")?;
    let mut files = package.files.into_iter();
    let robot = files.find(|(path, _)| path == "src/robot.rs");
    let (_, text) = robot.ok_or("a package has its robot")?;
    fs::write(folder.join("joints_lanes.rs"), text)?;
    Ok(())
}

/// Writes both files of a robot: with its own sines and with the runtime's.
fn write_both(own: Builder, robot: &str, folder: &str) -> Result<(), Box<dyn Error>> {
    let named = own
        .clone()
        .sin_cos("::homogen::trigonometry::single::sin_cos");
    for (file, builder) in [("own", own), ("named", named)] {
        let path = Path::new(folder).join(format!("{robot}_{file}.rs"));
        fs::write(path, builder.to_source()?.to_string())?;
    }
    Ok(())
}
