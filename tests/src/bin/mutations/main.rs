//! Breaks a formulation on purpose, one at a time, and demands that a named test fails.
//!
//! `cargo run -p homogen-tests --bin mutations [part of a mutation's name]`
//!
//! In: the tracked files of this repository, and [`MUTATIONS`]. Out: a table of what was broken and which
//! test noticed; a failure where one did not. It works on a copy in the temporary folder, whose build
//! is kept for the next time, and never changes the repository.

mod list;

use std::collections::BTreeSet;
use std::env;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Output};

use list::{MUTATIONS, Mutation, Test};

fn main() -> ExitCode {
    let wanted = env::args().nth(1).unwrap_or_default();
    let mutations: Vec<&Mutation> = MUTATIONS
        .iter()
        .filter(|mutation| mutation.name.contains(&wanted))
        .collect();
    match demonstrate(&mutations) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(unnoticed) => {
            eprintln!(
                "{unnoticed} of {} mutations went unnoticed",
                mutations.len()
            );
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// How many mutations no test noticed.
fn demonstrate(mutations: &[&Mutation]) -> Result<usize, String> {
    let copy = Copy::of(&root())?;
    println!("in {}", copy.files.display());
    let tests: BTreeSet<Test> = mutations
        .iter()
        .map(|mutation| mutation.noticed_by)
        .collect();
    for test in tests {
        let passed = copy.run(test)?;
        if passed != Verdict::Passed {
            return Err(format!(
                "{test} fails before anything is broken: {passed:?}"
            ));
        }
        println!("passes    {test}");
    }
    let mut unnoticed = 0;
    for mutation in mutations {
        let file = copy.files.join(mutation.file);
        let text = fs::read_to_string(&file).map_err(|error| told(&file, &error))?;
        let broken = mutation.apply(&text)?;
        write(&file, &broken)?;
        let verdict = copy.run(mutation.noticed_by);
        write(&file, &text)?;
        let word = match verdict? {
            Verdict::Failed => "noticed",
            Verdict::Passed => "UNNOTICED",
            Verdict::NotBuilt(output) => {
                return Err(format!("{}: it does not compile\n{output}", mutation.name));
            }
        };
        unnoticed += usize::from(word == "UNNOTICED");
        println!("{word:9} {:52} {}", mutation.name, mutation.noticed_by);
    }
    Ok(unnoticed)
}

/// What became of a test.
#[derive(Debug, PartialEq)]
enum Verdict {
    Passed,
    Failed,
    NotBuilt(String),
}

/// A copy of the repository with a build folder beside it.
struct Copy {
    files: PathBuf,
    target: PathBuf,
}

impl Copy {
    /// Copies the tracked files with their times, so that only what changed since the last copy is
    /// built again.
    fn of(root: &Path) -> Result<Self, String> {
        let folder = env::temp_dir().join("homogen-mutations");
        let copy = Self {
            files: folder.join("repository"),
            target: folder.join("target"),
        };
        if copy.files.exists() {
            fs::remove_dir_all(&copy.files).map_err(|error| told(&copy.files, &error))?;
        }
        for file in tracked(root)? {
            let (from, to) = (root.join(&file), copy.files.join(&file));
            copy_with_time(&from, &to).map_err(|error| told(&from, &error))?;
        }
        Ok(copy)
    }

    /// Builds and runs one test, which must exist.
    fn run(&self, test: Test) -> Result<Verdict, String> {
        let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let run = |last: &[&str]| -> Result<Output, String> {
            let mut command = Command::new(&cargo);
            command.current_dir(&self.files);
            command.env("CARGO_TARGET_DIR", &self.target);
            command.args(["test", "--quiet", "--locked", "-p", test.package]);
            command.args(test.target).args(last);
            let output = command.output();
            output.map_err(|error| format!("{}: {error}", cargo.display()))
        };
        let built = run(&["--no-run"])?;
        if !built.status.success() {
            return Ok(Verdict::NotBuilt(text(&built.stderr)));
        }
        let output = run(&["--", "--exact", test.name])?;
        let printed = text(&output.stdout);
        if printed.contains("1 passed; 0 failed") {
            Ok(Verdict::Passed)
        } else if printed.contains("0 passed; 1 failed") {
            Ok(Verdict::Failed)
        } else {
            Err(format!(
                "{test} did not run:\n{printed}{}",
                text(&output.stderr)
            ))
        }
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files that git knows, as they are now.
fn tracked(root: &Path) -> Result<Vec<String>, String> {
    let mut git = Command::new("git");
    let output = git.args(["ls-files", "-z"]).current_dir(root).output();
    let output = output.map_err(|error| format!("git: {error}"))?;
    if !output.status.success() {
        return Err(text(&output.stderr));
    }
    let names = text(&output.stdout);
    Ok(names.split_terminator('\0').map(str::to_owned).collect())
}

fn copy_with_time(from: &Path, to: &Path) -> io::Result<()> {
    if let Some(folder) = to.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::copy(from, to)?;
    let time = fs::metadata(from)?.modified()?;
    File::options().write(true).open(to)?.set_modified(time)
}

fn write(file: &Path, text: &str) -> Result<(), String> {
    fs::write(file, text).map_err(|error| told(file, &error))
}

fn told(file: &Path, error: &io::Error) -> String {
    format!("{}: {error}", file.display())
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
