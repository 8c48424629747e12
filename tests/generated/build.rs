//! Build script: generates files for `core` alone of robots that ship, in single precision, and of a robot with every
//! type of joint, in both precisions and as the source of its Python package.
//!
//! In: robots/*.urdf and tests/robots/every_joint.urdf. Out, in `OUT_DIR`: `ROBOT_own.rs` with its own sines, and for
//! two robots `ROBOT_named.rs` with the runtime's sines for any angle; `joints_f32.rs`, `joints_f64.rs` and
//! `joints_lanes.rs`.

mod long;

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use homogen_codegen::{Builder, Function, Real};
use long::LONG;

/// The files and their end effectors, and whether a file with the runtime's sines is made as well. An arm with parallel
/// axes, one without a zero among its parameters and with a prismatic joint, one with many zeros, one with a redundant
/// joint, and a tree.
const ROBOTS: [(&str, &str, bool); 5] = [
    ("two_link", "tip", true),
    ("stanford_general", "tool", true),
    ("puma560", "tool", false),
    ("panda_class", "link8", false),
    ("quadruped", "hr_foot", false),
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=long.rs");
    println!("cargo::rerun-if-changed=../../robots");
    println!("cargo::rerun-if-changed=../robots");
    let folder = env::var("OUT_DIR")?;
    // `tests/signed/run.sh` runs the tests of the others that files bring along.
    let compared = || {
        let all = Function::ALL.into_iter();
        all.filter(|function| !LONG.contains(function))
    };
    for (robot, tip, named) in ROBOTS {
        let own = Builder::from_urdf(format!("../../robots/{robot}.urdf"))
            .name("Standalone")
            .tip(tip)
            .scalar(Real::F32)
            .generate(compared());
        write(&own, &format!("{robot}_own"), &folder)?;
        if named {
            let named = own.sin_cos("::homogen::trigonometry::single::sin_cos");
            write(&named, &format!("{robot}_named"), &folder)?;
        }
    }
    let with_actuators = Builder::from_urdf("../../robots/scara.urdf")
        .name("Standalone")
        .scalar(Real::F32)
        .armature("shoulder", [0.25])
        .rotor("lift", 2e-5, 300.0)
        .damping("elbow", [0.75])
        .coulomb_friction("elbow", [0.5])
        .coulomb_friction("lift", [3.0])
        .generate(compared());
    write(&with_actuators, "with_actuators_own", &folder)?;
    write_joints(Path::new(&folder))
}

/// Writes the robot with every type of joint.
fn write_joints(folder: &Path) -> Result<(), Box<dyn Error>> {
    let builder = Builder::from_urdf("../robots/every_joint.urdf")
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

/// Writes the file of a robot.
fn write(robot: &Builder, name: &str, folder: &str) -> Result<(), Box<dyn Error>> {
    let path = Path::new(folder).join(format!("{name}.rs"));
    fs::write(path, robot.to_source()?.to_string())?;
    Ok(())
}
