//! Copies the generated robots to `OUT_DIR`, for `main.rs` and `many.rs` to include.
//!
//! In: the folder in the variable `GENERATED`, by the report. Out: `cases.rs` and `many.rs` in `OUT_DIR`; without the
//! variable they have no robots, so that the crate compiles alone.

use std::path::Path;
use std::{env, fs, io};

const NONE: [(&str, &str); 2] = [
    (
        "cases.rs",
        "\
/// No robot was given.
fn cases(_: &str, _: &str, _: &Truths) -> Vec<Case> {
    Vec::new()
}
",
    ),
    (
        "many.rs",
        "\
/// No robot was given.
fn in_f64(_: &str, _: &str) -> Vec<Program<f64>> {
    Vec::new()
}
/// No robot was given.
fn in_f32(_: &str, _: &str) -> Vec<Program<f32>> {
    Vec::new()
}
",
    ),
];

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=GENERATED");
    let out = env::var_os("OUT_DIR").expect("cargo sets it for build scripts");
    let folder = env::var_os("GENERATED");
    for (name, none) in NONE {
        let text = match &folder {
            Some(folder) => {
                let path = Path::new(folder).join(name);
                println!("cargo::rerun-if-changed={}", path.display());
                fs::read_to_string(path)?
            }
            None => none.to_owned(),
        };
        fs::write(Path::new(&out).join(name), text)?;
    }
    Ok(())
}
