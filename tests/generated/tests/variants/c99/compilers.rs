//! Compilers that are installed.
//!
//! In: a robot. Out: its files in a folder, objects and programs from them, and the programs' results. Any message of a
//! compiler is a failure.

use std::fmt;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use homogen_codegen::Real;

use crate::c99::programs;
use crate::c99::robot::Robot;

/// The folder of a test.
pub struct Folder(PathBuf);

impl Folder {
    pub fn new(name: &str) -> Self {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
            .join("c99")
            .join(name);
        fs::create_dir_all(&folder).expect("a folder to write in");
        Self(folder)
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.join(file)
    }

    pub fn write(&self, file: &str, text: &str) {
        fs::write(self.path(file), text).expect("a file");
    }

    /// True if the name of a symbol of an object contains the text.
    pub fn has_symbol(object: &Path, text: &str) -> bool {
        let bytes = fs::read(object).expect("an object");
        bytes
            .windows(text.len())
            .any(|part| part == text.as_bytes())
    }

    /// Writes the header, the source, and a program that calls all of its functions.
    pub fn write_c(&self, robot: &Robot, real: Real) {
        let source = robot.source(real);
        self.write("arm.h", &source.header);
        self.write("arm.c", &source.text);
        self.write("main.c", &programs::c(robot, real));
        self.write("whole.c", &format!("{}\n{}", source.header, source.text));
    }
}

/// A compiler of C.
#[derive(Clone, Copy)]
pub struct C {
    name: &'static str,
    /// Arguments for its target.
    target: &'static [&'static str],
}

/// The compiler that Rust links with, so it is always installed.
const CC: C = C {
    name: "cc",
    target: &[],
};

/// Other compilers.
const MORE: [C; 2] = [
    C {
        name: "clang",
        target: &[],
    },
    C {
        name: "arm-none-eabi-gcc",
        target: &[
            "-mcpu=cortex-m7",
            "-mthumb",
            "-mfpu=auto",
            "-mfloat-abi=hard",
            "-ffreestanding",
        ],
    },
];

/// Work of compilers on the files of a robot: the bits do not depend on it, only the time.
#[derive(Clone, Copy)]
pub enum Effort {
    /// Optimised: small files, and large ones in the long form.
    Optimised,
    /// Large files, whose optimisation takes a minute.
    Quick,
}

impl Effort {
    /// Options of C. The last one of this kind counts.
    pub fn of_c(self) -> &'static [&'static str] {
        match self {
            Self::Optimised => &[],
            Self::Quick => &["-O0"],
        }
    }

    fn of_rust(self) -> &'static str {
        match self {
            Self::Optimised => "opt-level=1",
            Self::Quick => "opt-level=0",
        }
    }

    /// States with which each function is called.
    pub fn states(self) -> usize {
        match self {
            Self::Optimised => 10_000,
            Self::Quick => 2_000,
        }
    }
}

const FLAGS: [&str; 9] = [
    "-std=c99",
    "-pedantic",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Werror",
    "-O2",
    "-ffp-contract=off",
];

impl fmt::Display for C {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} {}", self.name, self.target.join(" "))
    }
}

impl C {
    /// All that are installed.
    ///
    /// # Panics
    /// If there is none.
    pub fn all() -> Vec<Self> {
        assert!(
            CC.is_here(),
            "`cc` is missing: C is not tested without a compiler of C"
        );
        let more = MORE.into_iter().filter(|compiler| {
            let here = compiler.is_here();
            if !here {
                println!("not tested with {compiler}, which is missing");
            }
            here
        });
        [CC].into_iter().chain(more).collect()
    }

    /// Those whose programs run on this machine.
    pub fn that_run() -> Vec<Self> {
        let all = Self::all().into_iter();
        all.filter(Self::runs_here).collect()
    }

    /// True if its programs run on this machine.
    pub fn runs_here(&self) -> bool {
        self.target.is_empty()
    }

    fn is_here(&self) -> bool {
        let version = Command::new(self.name).arg("--version").output();
        version.is_ok_and(|output| output.status.success())
    }

    fn command(&self) -> Command {
        let mut command = Command::new(self.name);
        command.args(FLAGS).args(self.target);
        command
    }

    /// Compiles a source, without any message.
    pub fn object(&self, folder: &Folder, file: &str, options: &[&str]) -> PathBuf {
        let object = folder.path(&format!("{file}_{}.o", self.name));
        let mut command = self.command();
        // Compilers may call `memset` of the C library.
        command.args(options).args(["-fno-builtin", "-c"]);
        succeed(command.arg(folder.path(file)).arg("-o").arg(&object));
        object
    }

    /// Links an object alone: it calls no library.
    pub fn alone(&self, folder: &Folder, object: &Path) {
        let mut command = self.command();
        command.args(["-nostdlib", "-Wl,-e,0"]).arg(object);
        succeed(command.arg("-o").arg(folder.path("alone")));
    }

    /// Links an object with a program that calls all of its functions.
    pub fn program(&self, folder: &Folder, object: &Path) -> Program {
        let program = folder.path(&format!("main_{}", self.name));
        let mut command = self.command();
        command.arg(folder.path("main.c")).arg(object);
        succeed(command.arg("-o").arg(&program).arg("-lm"));
        Program {
            program,
            folder: folder.path(""),
        }
    }

    /// True for GCC, which states more of its options by macros than other compilers.
    pub fn is_gcc(&self) -> bool {
        let version = output(Command::new(self.name).arg("--version"));
        String::from_utf8_lossy(&version.stdout).contains("Free Software Foundation")
    }

    /// True if it compiles functions for several kinds of processor: GCC from 12 on Linux for x86-64.
    pub fn clones(&self) -> bool {
        let version = output(Command::new(self.name).arg("-dumpversion"));
        let version = String::from_utf8_lossy(&version.stdout);
        let major = version
            .trim()
            .split('.')
            .next()
            .and_then(|major| major.parse().ok());
        let is_new = major.is_some_and(|major: u32| major >= 12);
        cfg!(all(target_arch = "x86_64", target_os = "linux")) && self.is_gcc() && is_new
    }

    /// The command that compiles the source with options, and writes nothing.
    fn check(&self, folder: &Folder, options: &[&str]) -> Command {
        let mut command = self.command();
        command.args(options).arg("-fsyntax-only");
        command.arg(folder.path("arm.c"));
        command
    }

    /// Checks that the source compiles with options.
    pub fn accept(&self, folder: &Folder, options: &[&str]) {
        succeed(&mut self.check(folder, options));
    }

    /// The message when options make the source refuse to compile.
    pub fn refusal(&self, folder: &Folder, options: &[&str]) -> String {
        let output = output(&mut self.check(folder, options));
        assert!(
            !output.status.success(),
            "{self} compiles it with {options:?}"
        );
        String::from_utf8_lossy(&output.stderr).into_owned()
    }
}

/// The assembly of the source for a graphics processor, if a compiler for one is installed.
pub fn ptx(folder: &Folder) -> Option<String> {
    let targets = Command::new("clang").arg("-print-targets").output().ok()?;
    if !String::from_utf8_lossy(&targets.stdout).contains("nvptx64") {
        return None;
    }
    let mut command = Command::new("clang");
    command.args(["-x", "cuda", "--cuda-device-only", "--cuda-gpu-arch=sm_70"]);
    command.args(["-nocudainc", "-nocudalib", "-S", "-O2", "-ffp-contract=off"]);
    command.arg("-DHOMOGEN_FN=__attribute__((device))");
    command.arg(folder.path("arm.c")).args(["-o", "-"]);
    Some(String::from_utf8_lossy(&succeed(&mut command)).into_owned())
}

/// Compiles the Rust file and a program that calls all of its functions.
pub fn rust(folder: &Folder, robot: &Robot, real: Real, effort: Effort) -> Program {
    folder.write("arm.rs", &robot.rust(real));
    folder.write("main.rs", &programs::rust(robot, real));
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let program = folder.path("main_rust");
    let mut command = Command::new(rustc);
    command.args(["--edition", "2021", "-A", "warnings"]);
    command.args(["-C", effort.of_rust(), "-o"]);
    succeed(command.arg(&program).arg(folder.path("main.rs")));
    Program {
        program,
        folder: folder.path(""),
    }
}

/// A program that reads states and writes results.
pub struct Program {
    program: PathBuf,
    folder: PathBuf,
}

impl Program {
    /// The results, in the machine's bytes.
    pub fn run(&self, states: &[u8]) -> Vec<u8> {
        let input = self.folder.join("states");
        fs::write(&input, states).expect("a file");
        let input = File::open(input).expect("it was written");
        let mut command = Command::new(&self.program);
        succeed(command.stdin(Stdio::from(input)))
    }
}

fn output(command: &mut Command) -> Output {
    let output = command.output();
    output.unwrap_or_else(|reason| panic!("{command:?}: {reason}"))
}

/// Runs a command, which must succeed without any message. Returns its output.
fn succeed(command: &mut Command) -> Vec<u8> {
    let output = output(command);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && message.is_empty(),
        "{command:?}\n{message}"
    );
    output.stdout
}
