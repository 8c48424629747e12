//! Mutation tests: makes wrong edits, one at a time, and requires that a named test fails.
//!
//! `cargo run -p homogen-tests --bin mutations [part of a mutation's name]`
//!
//! In: the tracked files of this repository, and the mutations of [`all`]. Out: a table of the edits and the tests
//! that noticed them; exit status of failure if one was not noticed. Edits are made in a copy in the temporary folder,
//! never in the repository; the copy's build is kept for the next run.

mod list;

use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Output};

use list::{Mutation, Test, all};

fn main() -> ExitCode {
    let wanted = env::args().nth(1).unwrap_or_default();
    let mutations: Vec<&Mutation> = all()
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

/// Runs the mutations. Returns the number of those that no test noticed.
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
        let text = fs::read_to_string(&file).map_err(|error| with_path(&file, &error))?;
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

/// The outcome of a test.
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
    /// Updates the copy to the tracked files. Unchanged files keep their times and changed ones get new times, by which
    /// cargo knows what to build again.
    fn of(root: &Path) -> Result<Self, String> {
        let folder = env::temp_dir().join("homogen-mutations");
        let copy = Self {
            files: folder.join("repository"),
            target: folder.join("target"),
        };
        let tracked: BTreeSet<PathBuf> = tracked(root)?.into_iter().collect();
        for file in files_below(&copy.files).map_err(|error| with_path(&copy.files, &error))? {
            let name = file.strip_prefix(&copy.files).unwrap_or(&file);
            if !tracked.contains(name) {
                fs::remove_file(&file).map_err(|error| with_path(&file, &error))?;
            }
        }
        for name in &tracked {
            let (from, to) = (root.join(name), copy.files.join(name));
            copy_if_different(&from, &to).map_err(|error| with_path(&from, &error))?;
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

/// The files that git tracks, relative to the root.
fn tracked(root: &Path) -> Result<Vec<PathBuf>, String> {
    let mut git = Command::new("git");
    let output = git.args(["ls-files", "-z"]).current_dir(root).output();
    let output = output.map_err(|error| format!("git: {error}"))?;
    if !output.status.success() {
        return Err(text(&output.stderr));
    }
    let names = text(&output.stdout);
    Ok(names.split_terminator('\0').map(PathBuf::from).collect())
}

/// All files below a folder; none if it does not exist.
fn files_below(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    if folder.exists() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                files.extend(files_below(&path)?);
            } else {
                files.push(path);
            }
        }
    }
    Ok(files)
}

fn copy_if_different(from: &Path, to: &Path) -> io::Result<()> {
    let wanted = fs::read(from)?;
    if fs::read(to).is_ok_and(|found| found == wanted) {
        return Ok(());
    }
    if let Some(folder) = to.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(to, wanted)
}

fn write(file: &Path, text: &str) -> Result<(), String> {
    fs::write(file, text).map_err(|error| with_path(file, &error))
}

fn with_path(file: &Path, error: &io::Error) -> String {
    format!("{}: {error}", file.display())
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
