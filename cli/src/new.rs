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
use homogen_codegen::description::xacro::Given;
use homogen_codegen::description::{FileFormat, Name, expand_file};
use homogen_codegen::error::Errors;
use homogen_codegen::function::Function;
use homogen_codegen::module::Module;
use homogen_codegen::processor::Processor;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::{SCOPE, SOURCE};
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
    asked: Asked<{ SOURCE | SCOPE }>,
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
        let format = module.about.source.format;
        let is_expanded = format == Some(FileFormat::Xacro);
        let mut beside = module.about.source.beside.iter();
        if let Some(other) = beside.next().filter(|_| !is_expanded) {
            let message = format!(
                "{} includes {}, but a firmware has one file of its robot",
                self.file.display(),
                other.display()
            );
            return Err(mistake(message));
        }
        let text = if is_expanded {
            self.expanded()?
        } else {
            let read = |reason| mistake(format!("cannot read {}: {reason}", self.file.display()));
            fs::read(&self.file).map_err(read)?
        };
        let description = description(format);
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

    /// The URDF that a xacro file expands to: the crate has neither its packages nor its arguments.
    fn expanded(&self) -> Result<Vec<u8>, Errors> {
        let given = Given::of(&self.asked.and(Request::default()), Path::new(""));
        let mut errors = Errors::new();
        let urdf = expand_file(&self.file, &given, &mut errors);
        urdf.map(String::into_bytes).ok_or(errors)
    }

    /// The builder of the robot, and the calls that make it in a build script.
    fn builder(&self) -> (Builder, String) {
        let request = self.asked.and(Request::default());
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

/// The name of a description in the crate.
const fn description(format: Option<FileFormat>) -> &'static str {
    match format {
        Some(FileFormat::Table) => "robot.dh",
        Some(FileFormat::Mjcf) => "robot.xml",
        Some(FileFormat::Sdf) => "robot.sdf",
        _ => "robot.urdf",
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

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::fs;

    use super::package;

    #[test]
    fn a_firmware_has_the_expanded_file_of_its_robot() {
        let folder = std::env::temp_dir().join(format!("homogen-new-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let xacro = "<robot name=\"arm\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:arg name=\"mass\" default=\"1\"/>\
            <xacro:include filename=\"joint.xacro\"/><link name=\"a\"/><link name=\"b\"><inertial><mass value=\"$(arg mass)\"/>\
            <inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link></robot>";
        let joint = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><joint name=\"j\" type=\"continuous\"><parent link=\"a\"/>\
            <child link=\"b\"/><axis xyz=\"0 0 1\"/></joint></robot>";
        for (name, text) in [("arm.urdf.xacro", xacro), ("joint.xacro", joint)] {
            fs::write(folder.join(name), text).expect("written");
        }
        let [file, output] = ["arm.urdf.xacro", "firmware"].map(|name| folder.join(name));
        let words = [
            "homogen",
            "new",
            "firmware",
            "--arguments",
            "mass=2.5",
            "-o",
        ]
        .map(OsString::from);
        let words = words
            .into_iter()
            .chain([output.clone().into(), file.into()]);
        let answer = crate::answer(words, &mut std::io::empty());
        assert_eq!(answer.code, 0, "{}", answer.remarks);
        let urdf = fs::read_to_string(output.join("robot.urdf")).expect("it is there");
        assert!(
            urdf.contains("<mass value=\"2.5\"/>") && urdf.contains("<joint"),
            "{urdf}"
        );
        assert!(!urdf.contains("<xacro:"), "{urdf}");
        fs::remove_dir_all(folder).expect("it was there");
    }

    #[test]
    fn names_of_packages_are_not_code() {
        let robots = ["Panda", "2nd arm", "\"]\nx = 1", "機器", "../..", "a_b"];
        let names = ["panda", "robot-2nd-arm", "x---1", "robot", "robot", "a-b"];
        assert_eq!(robots.map(package), names);
    }
}
