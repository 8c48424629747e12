//! Puts the generated robots where `main.rs` includes them.
//!
//! In: the file that the variable `GENERATED` names; the report writes it. Out: `cases.rs` in
//! `OUT_DIR`; without the variable one without robots, so that the crate compiles on its own.

use std::path::Path;
use std::{env, fs, io};

const NONE: &str = "\
/// No robot was given.
fn cases(_: &str, _: &str, _: &Truths) -> Vec<Case> {
    Vec::new()
}
";

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=GENERATED");
    let out = env::var_os("OUT_DIR").expect("cargo sets it for build scripts");
    let cases = match env::var_os("GENERATED") {
        Some(path) => {
            println!("cargo::rerun-if-changed={}", Path::new(&path).display());
            fs::read_to_string(path)?
        }
        None => NONE.to_owned(),
    };
    fs::write(Path::new(&out).join("cases.rs"), cases)
}
