//! `homogen new firmware`: a crate for a microcontroller with a control loop for a robot, which runs under QEMU.
//!
//! Parts of a description become numbers, fixed file names and escaped strings: no name in it becomes code. Existing
//! folders are not changed.

mod template;

use std::fs;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};

use super::options::{Asked, mistake};
use super::{Answer, Outcome, functions};
use homogen_codegen::builder::Builder;
use homogen_codegen::description::{Name, mjcf, sdf};
use homogen_codegen::error::Errors;
use homogen_codegen::function::Function;
use homogen_codegen::module::Module;
use homogen_codegen::processor::Processor;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::SCOPE;
use homogen_codegen::space::{Entry, Kind};

/// Write a crate to begin with
#[derive(Args, Clone, Debug)]
pub(super) struct New {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    Firmware(Box<Firmware>),
}

/// Write a crate for a Cortex-M with a control loop for a robot
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen new firmware arm.urdf --homogen ../homogen -o arm-firmware
  cd arm-firmware && cargo run --release")]
struct Firmware {
    /// A URDF, xacro, MJCF or SDF file, or a Denavit–Hartenberg table
    file: PathBuf,
    #[command(flatten)]
    scope: Asked<SCOPE>,
    /// The processor to compile for
    #[arg(long, value_enum, default_value = "thumbv7em-none-eabihf")]
    target: Target,
    /// The folder of a clone of homogen, relative to the current folder
    /// [default: the version of this program, from the registry]
    #[arg(long, value_name = "FOLDER")]
    homogen: Option<PathBuf>,
    /// The folder to write [default: the robot's name with -firmware]
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// A processor of a firmware that QEMU has a board for.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Target {
    #[value(name = "thumbv7em-none-eabihf")]
    M4F,
    #[value(name = "thumbv7em-none-eabi")]
    M4,
    #[value(name = "thumbv7m-none-eabi")]
    M3,
}

impl Target {
    const fn name(self) -> &'static str {
        match self {
            Self::M4F => "thumbv7em-none-eabihf",
            Self::M4 => "thumbv7em-none-eabi",
            Self::M3 => "thumbv7m-none-eabi",
        }
    }

    /// Its name, QEMU's board that has it, and the operations that are used for it.
    const fn board(self) -> [&'static str; 3] {
        match self {
            Self::M4F => ["cortex-m4", "mps2-an386", "CortexM4"],
            Self::M4 => ["cortex-m4", "mps2-an386", "Portable"],
            Self::M3 => ["cortex-m3", "mps2-an385", "Portable"],
        }
    }

    const fn processor(self) -> Processor {
        match self {
            Self::M4F => Processor::CortexM4,
            Self::M4 | Self::M3 => Processor::Portable,
        }
    }
}

impl New {
    pub(super) fn run(&self, _: &mut dyn Read) -> Outcome {
        let What::Firmware(firmware) = &self.what;
        firmware.run()
    }
}

impl Firmware {
    fn run(&self) -> Outcome {
        let (builder, calls) = self.builder();
        let builder = builder
            .generate([Function::Gravity, Function::InverseDynamics])
            .processor(self.target.processor())
            .scalar(Real::F32);
        let module = builder.file_module()?;
        let robot = package(&module.about.robot);
        let folder = self.output.clone();
        let folder = folder.unwrap_or_else(|| PathBuf::from(format!("{robot}-firmware")));
        if fs::symlink_metadata(&folder).is_ok() {
            let message = format!("{} exists already, and is not changed", folder.display());
            return Err(mistake(message));
        }
        if let Some(other) = module.about.source.beside.first() {
            let message = format!(
                "{} includes {}, but a firmware has one file of its robot",
                self.file.display(),
                other.display()
            );
            return Err(mistake(message));
        }
        let read = |reason| mistake(format!("cannot read {}: {reason}", self.file.display()));
        let text = fs::read(&self.file).map_err(read)?;
        let description = self.description(&text);
        let words = self.words(&module, &calls, &folder, description)?;
        let mut files = template::firmware(&words);
        files.push((".gitignore", "/target\n".to_owned()));
        template::write_fresh(&folder, &files, (description, &text))
            .map_err(|reason| mistake(format!("cannot write {}: {reason}", folder.display())))?;
        Ok(Answer {
            output: format!("cd {} && cargo run --release\n", folder.display()),
            remarks: functions::warnings(&module.about),
            code: 0,
        })
    }

    /// The name of the description in the crate.
    fn description(&self, text: &[u8]) -> &'static str {
        let is_table = self.file.extension().is_some_and(|ending| ending == "dh");
        if is_table {
            "robot.dh"
        } else if is_of(text, mjcf::is_mjcf) {
            "robot.xml"
        } else if is_of(text, sdf::is_sdf) {
            "robot.sdf"
        } else {
            "robot.urdf"
        }
    }

    /// The builder of the robot, and the calls that make it in a build script.
    fn builder(&self) -> (Builder, String) {
        let request = self.scope.and(Request::default());
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
        (
            Builder::from_urdf(&self.file).request(request),
            calls.collect(),
        )
    }

    /// The replacements of the words of the template.
    fn words(
        &self,
        module: &Module,
        calls: &str,
        folder: &Path,
        description: &'static str,
    ) -> Result<[(&'static str, String); 12], Errors> {
        let [processor, machine, chosen] = self.target.board();
        let spaces = &module.spaces;
        let alike = spaces.coordinates.len() == spaces.velocities.len()
            && (spaces.coordinates.iter().zip(&spaces.velocities)).all(|(q, qd)| q.name == qd.name);
        let start = start(&spaces.coordinates);
        let format = match description {
            "robot.dh" => "denavit_hartenberg",
            "robot.xml" => "mjcf",
            "robot.sdf" => "sdf",
            _ => "urdf",
        };
        Ok([
            (
                "@PACKAGE@",
                format!("{}-firmware", package(&module.about.robot)),
            ),
            ("@CODEGEN@", self.codegen(folder)?),
            ("@TARGET@", self.target.name().to_owned()),
            ("@PROCESSOR@", processor.to_owned()),
            ("@MACHINE@", machine.to_owned()),
            ("@CHOSEN@", chosen.to_owned()),
            ("@DESCRIPTION@", description.to_owned()),
            ("@FORMAT@", format.to_owned()),
            ("@OPTIONS@", calls.to_owned()),
            (
                "@VELOCITIES@",
                if alike { "JOINTS" } else { "VELOCITIES" }.to_owned(),
            ),
            ("@COUNT@", start.len().to_string()),
            ("@START@", start.join(", ")),
        ])
    }

    /// The source of the engine for cargo.
    fn codegen(&self, folder: &Path) -> Result<String, Errors> {
        let Some(homogen) = &self.homogen else {
            return Ok(format!("\"={}\"", env!("CARGO_PKG_VERSION")));
        };
        let engine = homogen.join("codegen");
        if !engine.join("Cargo.toml").is_file() {
            let message = format!("{} is not a clone of homogen", homogen.display());
            return Err(mistake(message));
        }
        // Paths in Cargo.toml are relative to its folder.
        let plain = |path: &Path| {
            let mut parts = path.components();
            parts.all(|part| matches!(part, Component::Normal(_)))
        };
        let path = if plain(folder) && engine.is_relative() {
            let levels = folder.components().count();
            let up: PathBuf = std::iter::repeat_n("..", levels).collect();
            up.join(engine)
        } else {
            fs::canonicalize(&engine).map_err(|reason| mistake(reason.to_string()))?
        };
        let path = path.display().to_string();
        Ok(format!("{{ path = {path:?} }}"))
    }
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
fn package(robot: &str) -> String {
    let letters = robot
        .chars()
        .map(|letter| match letter.to_ascii_lowercase() {
            letter if letter.is_ascii_alphanumeric() => letter,
            _ => '-',
        });
    let name: String = letters.take(40).collect();
    let name = name.trim_matches('-');
    if name.starts_with(|letter: char| letter.is_ascii_alphabetic()) {
        name.to_owned()
    } else if name.is_empty() {
        "robot".to_owned()
    } else {
        format!("robot-{name}")
    }
}

/// True if the bytes of a file are a text of a format.
fn is_of(text: &[u8], is_format: fn(&str) -> bool) -> bool {
    std::str::from_utf8(text).is_ok_and(is_format)
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
