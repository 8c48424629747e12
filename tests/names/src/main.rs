//! Three hundred robots with arbitrary names.
//!
//! `cargo run --release -p homogen-names -- [--seed N] [--robots N] [--python N] [--folder PATH]`
//!
//! In: a seed; the number of robots (300); the number of Python packages that cargo checks (0), which takes the
//! network and some seconds each. Out: the number of robots, each failure, the compilers that are missing, and an exit
//! status of failure if anything failed.

use std::path::PathBuf;
use std::process::ExitCode;

use homogen_names::compilers::{c, cpp, is_here, python_crates, python_texts, rust};
use homogen_names::files::Batch;

/// Robots in one program.
const TOGETHER: usize = 50;

struct Wanted {
    seed: u64,
    robots: usize,
    python: usize,
    folder: PathBuf,
}

impl Wanted {
    fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut wanted = Self {
            seed: 1,
            robots: 300,
            python: 0,
            folder: std::env::temp_dir().join(format!("homogen-names-{}", std::process::id())),
        };
        while let Some(word) = words.next() {
            let mut next = || words.next().ok_or_else(|| format!("{word} needs a value"));
            let refused = |text: &String| format!("{text} is not a number");
            let count = |text: String| text.parse().map_err(|_| refused(&text));
            match word.as_str() {
                "--seed" => {
                    let text = next()?;
                    wanted.seed = text.parse().map_err(|_| refused(&text))?;
                }
                "--robots" => wanted.robots = count(next()?)?,
                "--python" => wanted.python = count(next()?)?,
                "--folder" => wanted.folder = next()?.into(),
                other => return Err(format!("there is no option {other}")),
            }
        }
        Ok(wanted)
    }
}

fn main() -> ExitCode {
    match Wanted::read(std::env::args().skip(1)) {
        Ok(wanted) => run(&wanted),
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(wanted: &Wanted) -> ExitCode {
    let mut diagnostics = Vec::new();
    let mut packages_left = wanted.python;
    let (mut robots, mut packages) = (0, 0);
    let mut from = wanted.seed;
    while robots < wanted.robots {
        let count = TOGETHER.min(wanted.robots - robots);
        let folder = wanted.folder.join(format!("from_{from}"));
        let mut batch = Batch::of(from, count, &folder);
        robots += count;
        from = batch.end;
        let refused = batch.write().into_iter();
        diagnostics.extend(
            refused.map(|(number, message)| format!("robot {number} is refused: {message}")),
        );
        for edition in ["2021", "2024"] {
            diagnostics.extend(rust(&batch, edition).err());
        }
        for (compiler, of_cpp) in [("gcc", "g++"), ("clang", "clang++")] {
            if !is_here(compiler) {
                eprintln!("not compiled with {compiler}, which is missing");
                continue;
            }
            match c(&batch, compiler) {
                Ok(objects) if is_here(of_cpp) => {
                    diagnostics.extend(cpp(&batch, of_cpp, &objects).err());
                }
                Ok(_) => eprintln!("not compiled with {of_cpp}, which is missing"),
                Err(diagnostic) => diagnostics.push(diagnostic),
            }
        }
        let (refused, written) = batch.write_python();
        let refused = refused.into_iter();
        diagnostics.extend(
            refused.map(|(number, message)| format!("robot {number} in Python: {message}")),
        );
        diagnostics.extend(python_texts(&written).err());
        let checked = &written[..written.len().min(packages_left)];
        packages_left -= checked.len();
        diagnostics.extend(python_crates(checked).err());
        packages += checked.len();
        eprintln!("{robots} robots, {} complaints", diagnostics.len());
    }
    for diagnostic in &diagnostics {
        println!("{diagnostic}\n");
    }
    println!(
        "{robots} robots in Rust, C, C++ and Python, {packages} packages checked by cargo, {} complaints",
        diagnostics.len()
    );
    if diagnostics.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
