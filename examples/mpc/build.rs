//! The linker script with the memory of the board.
//!
//! In: the memory of the firmwares by `homogen new`. Out: `memory.x` in `OUT_DIR`, and the options of the linker.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

const MEMORY: &str = "../../page/src/firmware/memory.x";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed={MEMORY}");
    if env::var("CARGO_CFG_TARGET_OS")? == "none" {
        let out = env::var("OUT_DIR")?;
        fs::copy(MEMORY, Path::new(&out).join("memory.x"))?;
        println!("cargo::rustc-link-search={out}");
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
    Ok(())
}
