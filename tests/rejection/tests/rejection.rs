//! Compile-fail tests: each mistake gives one error, under the word that caused it, though the file goes on to call
//! the functions that it requests.
//!
//! In: `rejected/*.rs`, one mistake each, with the expected messages in `*.stderr`, and the descriptions that they
//! name. Each is compiled alone, with the crate `homogen` as it was built for this test. `INSTA_UPDATE=always` rewrites
//! the expected messages.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::SystemTime;
use std::{env, fs, thread};

/// The folder that paths in messages are relative to.
const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Files of a folder with this extension, sorted by name.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("it can be read").path());
    let ends = |path: &PathBuf| path.extension().is_some_and(|found| found == ending);
    let mut paths: Vec<_> = paths.filter(ends).collect();
    paths.sort();
    paths
}

/// Files in `rejected/` with this extension.
fn rejected(ending: &str) -> Vec<PathBuf> {
    files(&Path::new(ROOT).join("tests/rejected"), ending)
}

/// A compiled library of the crate `homogen`.
struct Homogen(PathBuf);

impl Homogen {
    /// The library that was built for this test.
    ///
    /// Cargo keeps builds with other features in the same folder. Every build that is up to date has the current
    /// sources; the latest one that has the features of `probe.rs` is used.
    fn of_this_test() -> Self {
        let built = |path: &PathBuf| fs::metadata(path).and_then(|file| file.modified());
        let mut found = files(&dependencies(), "rlib");
        found.retain(|path| {
            let name = path.file_name().and_then(OsStr::to_str);
            name.is_some_and(|name| name.starts_with("libhomogen-"))
        });
        found.sort_by_key(|path| built(path).unwrap_or(SystemTime::UNIX_EPOCH));
        let probe = Path::new(env!("CARGO_TARGET_TMPDIR")).join("probe.rs");
        fs::write(
            &probe,
            "pub use homogen::{Robot, chain, generic::gravity};\n",
        )
        .expect("a file");
        let mut found = found.into_iter().rev().map(Self);
        found
            .find(|homogen| {
                let mut compiler = homogen.compiler(&probe);
                let output = compiler.arg("--crate-type=lib").output();
                output.is_ok_and(|output| output.status.success())
            })
            .expect("this test depends on it")
    }

    /// The compiler with all arguments but the crate's type.
    fn compiler(&self, file: &Path) -> Command {
        let mut compiler = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
        let name = file.file_stem().expect("a file has a name");
        compiler
            .current_dir(ROOT)
            // Paths in macros are relative to this folder.
            .env("CARGO_MANIFEST_DIR", Path::new(ROOT).join("tests"))
            .args([
                "--edition=2024",
                "--emit=metadata",
                "--diagnostic-width=140",
            ])
            .args(["--allow=dead_code", "--extern"])
            .arg([OsStr::new("homogen="), self.0.as_os_str()].join(OsStr::new("")))
            .arg("-L")
            .arg([OsStr::new("dependency="), dependencies().as_os_str()].join(OsStr::new("")))
            .arg("--out-dir")
            .arg(env!("CARGO_TARGET_TMPDIR"))
            .arg("--crate-name")
            .arg(name)
            .arg(file);
        compiler
    }

    /// Messages for a file, without the summary at their end.
    fn shown(&self, file: &Path) -> String {
        let file = file.strip_prefix(ROOT).expect("it is of this crate");
        let output = self.compiler(file).output();
        let Output { status, stderr, .. } = output.expect("the compiler is at hand");
        assert!(!status.success(), "{} compiles", file.display());
        let text = String::from_utf8(stderr).expect("UTF-8");
        let shown = match text.rfind("error: aborting due to ") {
            Some(end) => &text[..end],
            None => &text,
        };
        format!("{}\n", shown.trim_end())
    }
}

/// The folder of this test's dependencies.
fn dependencies() -> PathBuf {
    let program = env::current_exe().expect("it runs");
    program.parent().expect("it is in a folder").to_path_buf()
}

/// A report if the messages for a file differ from the expected ones.
fn difference(homogen: &Homogen, file: &Path) -> Option<String> {
    let stderr_file = file.with_extension("stderr");
    let expected = fs::read_to_string(&stderr_file).unwrap_or_default();
    let found = homogen.shown(file);
    if found == expected {
        return None;
    }
    if env::var_os("INSTA_UPDATE").is_some_and(|update| update == "always") {
        fs::write(&stderr_file, found).expect("a file");
        return None;
    }
    let name = file.display();
    Some(format!(
        "=== {name} should show\n{expected}=== and shows\n{found}"
    ))
}

#[test]
fn each_mistake_is_reported_where_it_is() {
    let homogen = Homogen::of_this_test();
    let files = rejected("rs");
    assert!(!files.is_empty());
    let next = AtomicUsize::new(0);
    // As many compilers as cores, each with one file at a time.
    let work = || {
        let mut wrong = Vec::new();
        while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
            wrong.extend(difference(&homogen, file));
        }
        wrong
    };
    let count = thread::available_parallelism().map_or(1, Into::into);
    let wrong: Vec<String> = thread::scope(|scope| {
        let threads: Vec<_> = (0..count).map(|_| scope.spawn(work)).collect();
        let each = threads.into_iter();
        each.flat_map(|thread| thread.join().expect("no mistake compiles"))
            .collect()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn each_mistake_gives_only_our_errors() {
    let shown = rejected("stderr");
    assert_eq!(shown.len(), rejected("rs").len());
    for file in shown {
        let text = fs::read_to_string(&file).expect("text");
        let lines = || text.lines().filter(|line| line.starts_with("error"));
        assert!(lines().count() > 0, "{}", file.display());
        // The compiler's own errors have a number.
        assert!(lines().all(|line| line.starts_with("error: ")), "{text}");
    }
}

/// The compiler words the rest of the error, which differs between its versions.
#[test]
fn the_message_for_a_missing_function_names_it() {
    for (file, note) in [
        (
            "function_not_generated.rs",
            "= note: add `bias` to `generate(…)` of the robot\n",
        ),
        (
            "loop_not_described.rs",
            "= note: describe its loops and add `constraint` to `generate(…)` of the robot\n",
        ),
    ] {
        let file = Path::new(ROOT).join("tests/missing").join(file);
        let shown = Homogen::of_this_test().shown(&file);
        let message = "error[E0277]: the robot `Arm` lacks a function that is needed here\n";
        for part in [message, note] {
            assert!(shown.contains(part), "{shown}");
        }
    }
}
