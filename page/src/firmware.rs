//! A firmware to begin with: a crate for a Cortex-M with a control loop for a robot, which runs under QEMU.
//!
//! In: a generated module with the request that it was made by. Out: paths and texts. Parts of a description become
//! numbers, fixed file names and escaped strings: no name in it becomes code.

use homogen_codegen::builder::Builder;
use homogen_codegen::description::{FileFormat, Name};
use homogen_codegen::function::Function;
use homogen_codegen::module::Module;
use homogen_codegen::processor::Processor;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::space::{Entry, Kind};
use homogen_codegen::template::filled;

use crate::project::stem;

/// The files, with words between `@` to be replaced.
const TEMPLATE: [(&str, &str); 6] = [
    ("Cargo.toml", include_str!("firmware/manifest.toml")),
    (".cargo/config.toml", include_str!("firmware/config.toml")),
    ("README.md", include_str!("firmware/README.md.in")),
    ("build.rs", include_str!("firmware/build.rs.in")),
    ("memory.x", include_str!("firmware/memory.x")),
    ("src/main.rs", include_str!("firmware/main.rs.in")),
];

/// A processor that QEMU has a board for.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// The target of Rust.
    pub target: &'static str,
    /// The processor of the target.
    processor: &'static str,
    /// QEMU's machine.
    machine: &'static str,
    /// The processor whose operations are used, and its name in Rust.
    operations: (Processor, &'static str),
}

impl Board {
    /// A Cortex-M4 with a floating-point unit.
    pub const M4F: Self = Self {
        target: "thumbv7em-none-eabihf",
        processor: "cortex-m4",
        machine: "mps2-an386",
        operations: (Processor::CortexM4, "CortexM4"),
    };

    /// A Cortex-M4 without one.
    pub const M4: Self = Self {
        target: "thumbv7em-none-eabi",
        processor: "cortex-m4",
        machine: "mps2-an386",
        operations: (Processor::Portable, "Portable"),
    };

    /// A Cortex-M3.
    pub const M3: Self = Self {
        target: "thumbv7m-none-eabi",
        processor: "cortex-m3",
        machine: "mps2-an385",
        operations: (Processor::Portable, "Portable"),
    };

    /// The builder of the functions that the firmware calls.
    pub fn functions(&self, builder: Builder) -> Builder {
        builder
            .generate([Function::Gravity, Function::InverseDynamics])
            .processor(self.operations.0)
            .scalar(Real::F32)
    }
}

/// The part of a request that a firmware keeps: which robot it is.
#[must_use]
pub fn scope(request: &Request) -> Request {
    Request {
        base: request.base.clone(),
        floating: request.floating,
        tip: request.tip.clone(),
        path_only: request.path_only,
        lock: request.lock.clone(),
        ..Request::default()
    }
}

/// The files of a firmware besides the description: paths and texts. `engine` is the source of the engine for cargo:
/// a version between quotation marks, or a table.
#[must_use]
pub fn files(
    module: &Module,
    request: &Request,
    board: &Board,
    engine: &str,
) -> Vec<(String, String)> {
    let spaces = &module.spaces;
    let alike = spaces.coordinates.len() == spaces.velocities.len()
        && (spaces.coordinates.iter().zip(&spaces.velocities)).all(|(q, qd)| q.name == qd.name);
    let start = start(&spaces.coordinates);
    let (count, start) = (start.len().to_string(), start.join(", "));
    let description = description(module.about.source.format);
    let format = match description {
        "robot.dh" => "denavit_hartenberg",
        "robot.xml" => "mjcf",
        "robot.sdf" => "sdf",
        _ => "urdf",
    };
    let package = format!("{}-firmware", package(&module.about.robot));
    let calls = calls(request);
    let words = [
        ("@PACKAGE@", &*package),
        ("@CODEGEN@", engine),
        ("@TARGET@", board.target),
        ("@PROCESSOR@", board.processor),
        ("@MACHINE@", board.machine),
        ("@CHOSEN@", board.operations.1),
        ("@DESCRIPTION@", description),
        ("@FORMAT@", format),
        ("@OPTIONS@", &*calls),
        ("@VELOCITIES@", if alike { "JOINTS" } else { "VELOCITIES" }),
        ("@COUNT@", &*count),
        ("@START@", &*start),
    ];
    let files = TEMPLATE.iter();
    let files = files.map(|(path, text)| ((*path).to_owned(), filled(text, &words)));
    files
        .chain([(".gitignore".to_owned(), "/target\n".to_owned())])
        .collect()
}

/// The name of a description in the crate.
#[must_use]
pub const fn description(format: Option<FileFormat>) -> &'static str {
    match format {
        Some(FileFormat::Table) => "robot.dh",
        Some(FileFormat::Mjcf) => "robot.xml",
        Some(FileFormat::Sdf) => "robot.sdf",
        _ => "robot.urdf",
    }
}

/// The calls of a builder that make the scope of a request, in a build script.
fn calls(request: &Request) -> String {
    // `Debug` of a string is a literal of Rust.
    let call = |method: &'static str| move |link: &Name| format!("{method}({:?})", link.text);
    let mut calls = Vec::new();
    calls.extend(request.base.iter().map(call("base")));
    calls.extend(request.floating.then(|| "floating()".to_owned()));
    calls.extend(request.tip.iter().map(call("tip")));
    calls.extend(request.path_only.then(|| "path_only()".to_owned()));
    calls.extend(request.lock.iter().map(|(joint, at)| match at {
        Some(at) => format!("lock_at({:?}, {:?})", joint.text, at.value),
        None => format!("lock({:?})", joint.text),
    }));
    let calls = calls.iter().map(|call| format!("\n        .{call}"));
    calls.collect()
}

/// A configuration to begin with: the middle of the limits, and no rotation.
fn start(coordinates: &[Entry]) -> Vec<String> {
    let mut quaternions = 0;
    let start = coordinates.iter().map(|entry| {
        if entry.kind == Kind::Quaternion {
            quaternions += 1;
            return if quaternions % 4 == 0 { "1.0" } else { "0.0" }.to_owned();
        }
        let middle = entry
            .range
            .map_or(0.0, |[least, most]| f64::midpoint(least, most));
        let middle: f64 = format!("{middle:.3}").parse().unwrap_or(0.0);
        // Avoids −0.
        format!("{:?}", middle + 0.0)
    });
    start.collect()
}

/// The name of a package: lower case letters, digits and dashes, a letter first.
#[must_use]
pub fn package(robot: &str) -> String {
    let name = stem(robot).replace('_', "-");
    if name.starts_with(|letter: char| letter.is_ascii_digit()) {
        format!("robot-{name}")
    } else {
        name
    }
}

#[cfg(test)]
mod tests {
    use super::package;

    #[test]
    fn names_of_packages_are_not_code() {
        let robots = ["Panda", "2nd arm", "\"]\nx = 1", "機器", "../..", "a_b"];
        let names = ["panda", "robot-2nd-arm", "x---1", "robot", "robot", "a-b"];
        assert_eq!(robots.map(package), names);
    }
}
