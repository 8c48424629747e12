//! The files of robots in a folder.
//!
//! In: robots, each with a number. Out: what the command line writes of each in Rust, in C and for Python, under the
//! number; robots that would be called alike in C have no place in one program.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use homogen_cli::answer;
use homogen_codegen::print::c::prefix;
use homogen_codegen::print::python;

use crate::robot::Robot;

/// Robots of one program.
pub struct Batch {
    /// Where their files are.
    pub folder: PathBuf,
    /// The robots, by number.
    pub robots: Vec<(u64, Robot)>,
    /// The first number behind them.
    pub end: u64,
}

/// A robot that could not be written, and what was said.
pub type Refused = (u64, String);

impl Batch {
    /// So many robots whose numbers begin with one: what would be called in C as another is left out.
    ///
    /// # Panics
    /// Where the folder cannot be written.
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

    /// Writes all files in Rust and C, and tells which could not be written: these robots are left out from then on.
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
                let said = generate("generate", robot, options.chain([output]));
                if let Err(said) = said {
                    refused.push((*number, said));
                    break;
                }
            }
        }
        let is_refused = |number: u64| refused.iter().any(|(other, _)| *other == number);
        self.robots.retain(|(number, _)| !is_refused(*number));
        refused
    }

    /// Writes packages for Python, each a member of one workspace, and tells which could not be written.
    ///
    /// # Panics
    /// Where the folder cannot be written.
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
                Err(said) => refused.push((*number, said)),
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
