//! The generated files of a batch of robots.
//!
//! In: robots, each with a number. Out: the files that the command line writes of each in Rust, in C and for Python,
//! named by the number. Robots with the same prefix in C cannot be in one program; only the first is kept.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use homogen_cli::answer;
use homogen_codegen::print::c::prefix;
use homogen_codegen::print::python;

use crate::robot::Robot;

/// Robots that are compiled into one program.
pub struct Batch {
    /// The folder of their files.
    pub folder: PathBuf,
    /// The robots, each with its number, which is its seed.
    pub robots: Vec<(u64, Robot)>,
    /// One past the last number.
    pub end: u64,
}

/// A robot that was rejected, and the error message.
pub type Refused = (u64, String);

impl Batch {
    /// The first `count` robots with numbers from `first` on, without those whose prefix in C is taken.
    ///
    /// # Panics
    /// If the folder cannot be written.
    #[must_use]
    pub fn of(first: u64, count: usize, folder: &Path) -> Self {
        let _ = fs::remove_dir_all(folder);
        fs::create_dir_all(folder).expect("a folder to write in");
        let mut prefixes = BTreeSet::new();
        let robots = (first..).map(|seed| (seed, Robot::of(seed)));
        let robots = robots.filter(|(_, robot)| prefixes.insert(prefix(&robot.name)));
        let robots: Vec<_> = robots.take(count).collect();
        Self {
            folder: folder.to_owned(),
            end: robots.last().map_or(first, |(last, _)| last + 1),
            robots,
        }
    }

    /// Writes all files in Rust and C. Returns the rejected robots and removes them from the batch.
    pub fn write(&mut self) -> Vec<Refused> {
        let mut refused = Vec::new();
        for (number, robot) in &self.robots {
            let c = prefix(&robot.name);
            let files = [
                (vec![], format!("r{number}.rs")),
                (vec!["--language=c".to_owned()], format!("c{number}.c")),
                (vec![format!("--extern-c={c}")], format!("x{number}.rs")),
            ];
            for (more, file) in files {
                let output = self.folder.join(file);
                let output = format!("--output={}", output.display());
                let options = robot.options.iter().chain(&more).cloned();
                let result = generate("generate", robot, options.chain([output]));
                if let Err(message) = result {
                    refused.push((*number, message));
                    break;
                }
            }
        }
        let is_refused = |number: u64| refused.iter().any(|(other, _)| *other == number);
        self.robots.retain(|(number, _)| !is_refused(*number));
        refused
    }

    /// Writes packages for Python, each a member of one workspace. Returns the rejected robots and the packages.
    ///
    /// # Panics
    /// If the folder cannot be written.
    #[must_use]
    pub fn write_python(&self) -> (Vec<Refused>, Vec<PathBuf>) {
        let (mut refused, mut packages) = (Vec::new(), Vec::new());
        let mut modules = BTreeSet::new();
        for (number, robot) in &self.robots {
            let Some(module) = python::module(&robot.name) else {
                continue;
            };
            if module.len() > 100 || !modules.insert(module.clone()) {
                continue;
            }
            let folder = self.folder.join("python").join(&module);
            fs::create_dir_all(folder.parent().expect("a folder")).expect("a folder to write in");
            let output = format!("--output={}", folder.display());
            let options = robot.options.iter().cloned();
            match generate("python", robot, options.chain([output])) {
                Ok(()) => packages.push(folder),
                Err(message) => refused.push((*number, message)),
            }
        }
        (refused, packages)
    }
}

fn generate(
    command: &str,
    robot: &Robot,
    options: impl Iterator<Item = String>,
) -> Result<(), String> {
    let words = ["homogen", command, "-"].map(str::to_owned).into_iter();
    let words = words.chain(options).map(OsString::from);
    let answer = answer(words, &mut robot.urdf.as_bytes());
    if answer.code == 0 {
        Ok(())
    } else {
        Err(answer.remarks)
    }
}
