//! Tells the examples which compiler and which flags they are built with, so that no time they
//! print stands without them.
//!
//! In: what cargo says to build scripts. Out: two environment variables at compile time. It never
//! looks at the machine: the program may run on another one.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=CARGO_ENCODED_RUSTFLAGS");
    let variable = |name| env::var(name).unwrap_or_default();
    let version = Command::new(variable("RUSTC")).arg("--version").output();
    let version = version.map_or_else(
        |_| "rustc".to_owned(),
        |said| String::from_utf8_lossy(&said.stdout).trim().to_owned(),
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
