//! `homogen new`: a folder to begin with: a crate, a project of C or C++ for CMake, a package for Python, or a firmware for a
//! microcontroller, which runs under QEMU.
//!
//! `homogen_page` has the files, which the site offers, too. Existing folders are not changed.

mod folder;

use std::fs;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};

use super::functions::Generated;
use super::generate::Halves;
use super::options::{Asked, Scalar, mistake};
use super::{Answer, Outcome, functions};
use homogen_codegen::builder::Builder;
use homogen_codegen::description::{FileFormat, Given, expand_file};
use homogen_codegen::error::Errors;
use homogen_codegen::print::arrays::Order;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::{C, SCOPE, SOURCE};
use homogen_page::firmware::{self, Board};
use homogen_page::project::{self, Project};

/// Write a folder to begin with
#[derive(Args, Clone, Debug)]
pub(super) struct New {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// Write a crate without dependencies: its functions need only core
    Crate(Box<Wrapped>),
    Cmake(Box<Cmake>),
    /// Write a package for Python without dependencies
    Python(Box<Wrapped>),
    Firmware(Box<Firmware>),
}

/// A project around generated code.
#[derive(Args, Clone, Debug)]
struct Wrapped {
    #[command(flatten)]
    generated: Generated,
    /// The type of numbers [default: f64]
    #[arg(long, value_enum)]
    scalar: Option<Scalar>,
    /// The folder to write [default: the robot's name with _robot]
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// Write a project for CMake: a static library of C99, or a header of C++17 alone
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen new cmake arm.urdf --language cpp -o arm
  cmake -S arm -B build && cmake --build build && cmake --install build --prefix installed
In the CMakeLists.txt of a program:
  find_package(arm REQUIRED) or add_subdirectory(arm)
  target_link_libraries(program PRIVATE arm::arm)")]
struct Cmake {
    #[command(flatten)]
    wrapped: Wrapped,
    /// The language; cpp is C++17
    #[arg(long, value_enum, default_value = "c")]
    language: Compiled,
    /// In C++ the first half of twists, wrenches and momenta
    /// [default: angular-first]
    #[arg(long, value_enum)]
    order: Option<Halves>,
    #[command(flatten)]
    asked: Asked<C>,
}

/// A language that CMake compiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Compiled {
    C,
    Cpp,
}

impl Cmake {
    fn run(&self, input: &mut dyn Read) -> Outcome {
        let request = self.asked.and(Request::default());
        self.wrapped.run(self.project()?, request, input)
    }

    fn project(&self) -> Result<Project, Errors> {
        match (self.language, self.order) {
            (Compiled::C, None) => Ok(Project::Cmake),
            (Compiled::C, Some(_)) => Err(mistake("--order is for --language cpp")),
            (Compiled::Cpp, order) => {
                let order = order.map_or(Order::AngularFirst, Order::from);
                Ok(Project::Cpp(order))
            }
        }
    }
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
    const fn board(self) -> Board {
        match self {
            Self::M4F => Board::M4F,
            Self::M4 => Board::M4,
            Self::M3 => Board::M3,
        }
    }
}

impl New {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        match &self.what {
            What::Crate(wrapped) => wrapped.run(Project::Crate, Request::default(), input),
            What::Cmake(cmake) => cmake.run(input),
            What::Python(wrapped) => wrapped.run(Project::Python, Request::default(), input),
            What::Firmware(firmware) => firmware.run(),
        }
    }
}

impl Wrapped {
    fn run(&self, project: Project, request: Request, input: &mut dyn Read) -> Outcome {
        let request = Request {
            scalar: self.scalar.map_or(Real::F64, Real::from),
            ..request
        };
        let builder = self.generated.builder(request, input)?;
        let (files, module) = project.files(&builder)?;
        let folder = self.output.clone();
        let folder = folder.unwrap_or_else(|| PathBuf::from(project::folder(&module.about.robot)));
        is_new(&folder)?;
        let files = files.into_iter();
        let files: Vec<_> = files
            .map(|(path, text)| (path, text.into_bytes()))
            .collect();
        write(&folder, &files)?;
        Ok(Answer {
            output: format!("{}\n", folder.display()),
            remarks: functions::remarks(&module),
            code: functions::status(&module),
        })
    }
}

/// Rejects a folder that exists.
fn is_new(folder: &Path) -> Result<(), Errors> {
    if fs::symlink_metadata(folder).is_ok() {
        let message = format!("{} exists already, and is not changed", folder.display());
        return Err(mistake(message));
    }
    Ok(())
}

fn write(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), Errors> {
    folder::write_fresh(folder, files)
        .map_err(|reason| mistake(format!("cannot write {}: {reason}", folder.display())))
}

impl Firmware {
    fn run(&self) -> Outcome {
        let board = self.target.board();
        let request = self.asked.and(Request::default());
        let builder = Builder::from_urdf(&self.file).request(request.clone());
        let module = board.functions(builder).file_module()?;
        let robot = firmware::package(&module.about.robot);
        let folder = self.output.clone();
        let folder = folder.unwrap_or_else(|| PathBuf::from(format!("{robot}-firmware")));
        is_new(&folder)?;
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
        let files = firmware::files(&module, &request, &board, &self.engine(&folder)?);
        let files = files.into_iter();
        let files = files.map(|(path, text)| (path, text.into_bytes()));
        let description = firmware::description(format).to_owned();
        let files: Vec<_> = files.chain([(description, text)]).collect();
        write(&folder, &files)?;
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

    /// The source of the engine for cargo.
    fn engine(&self, folder: &Path) -> Result<String, Errors> {
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

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::fs;
    use std::path::Path;

    #[test]
    fn projects_are_written_and_not_overwritten() {
        let folder = std::env::temp_dir().join(format!("homogen-projects-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let robot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots/two_link.urdf");
        for (kind, options, code) in [
            ("crate", "", "src/robot.rs"),
            ("cmake", "", "two_link.c"),
            (
                "cmake",
                "--language=cpp --order=linear-first",
                "two_link.hpp",
            ),
            ("python", "", "two_link_robot/__init__.py"),
        ] {
            let output = folder.join(code.replace('/', "_"));
            let options = options.split_whitespace();
            let words = ["homogen", "new", kind].into_iter().chain(options);
            let words = words.chain(["--functions", "gravity", "-o"]);
            let words = words.map(OsString::from);
            let words = words.chain([output.clone().into(), robot.clone().into()]);
            let first = crate::answer(words.clone(), &mut std::io::empty());
            assert_eq!(first.code, 0, "{}", first.remarks);
            let text = fs::read_to_string(output.join(code)).expect("it is there");
            assert!(text.contains("gravity"), "{text}");
            let second = crate::answer(words, &mut std::io::empty());
            assert!(
                second.remarks.contains("exists already"),
                "{}",
                second.remarks
            );
        }
        fs::remove_dir_all(folder).expect("it was there");
    }

    #[test]
    fn an_order_is_for_cpp() {
        let words = [
            "homogen",
            "new",
            "cmake",
            "arm.urdf",
            "--order",
            "linear-first",
        ];
        let answer = crate::answer(words.map(OsString::from), &mut std::io::empty());
        assert_eq!(answer.code, 1);
        assert!(answer.remarks.contains("--order is for --language cpp"));
    }

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
}
