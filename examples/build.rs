//! Compiler and flags of the examples, which they print beside their times.
//!
//! In: cargo's environment of build scripts. Out: two environment variables at compile time. The processor is
//! read at run time, because the program may run on another machine.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
    let variable = |name| env::var(name).unwrap_or_default();
    let version = Command::new(variable("RUSTC")).arg("--version").output();
    let version = version.map_or_else(
        |_| "rustc".to_owned(),
        |output| String::from_utf8_lossy(&output.stdout).trim().to_owned(),
    );
    println!("cargo::rustc-env=EXAMPLES_RUSTC={version}");
    let flags = variable("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    let flags = if flags.is_empty() {
        "no RUSTFLAGS".to_owned()
    } else {
        format!("RUSTFLAGS=\"{flags}\"")
    };
    let (target, level) = (variable("TARGET"), variable("OPT_LEVEL"));
    println!("cargo::rustc-env=EXAMPLES_FLAGS={target}, opt-level {level}, {flags}");
}
