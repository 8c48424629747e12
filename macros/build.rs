//! Names the engine: expansions that another one has kept are not its own.
//!
//! In: the version, and in a checkout the sources of the engine. Out: the variable `HOMOGEN_ENGINE`.

use std::error::Error;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let mut hasher = DefaultHasher::new();
    let engine = Path::new("../codegen");
    // A published engine is named by its version.
    for path in ["Cargo.toml", "src"].map(|name| engine.join(name)) {
        if path.exists() {
            println!("cargo::rerun-if-changed={}", path.display());
            add(&path, &mut hasher)?;
        }
    }
    println!("cargo::rerun-if-changed=build.rs");
    let version = env::var("CARGO_PKG_VERSION")?;
    println!(
        "cargo::rustc-env=HOMOGEN_ENGINE={version} {:016x}",
        hasher.finish()
    );
    Ok(())
}

/// Adds a file, or those of a folder in the order of their names.
fn add(path: &Path, hasher: &mut impl Hasher) -> Result<(), Box<dyn Error>> {
    if path.is_file() {
        path.hash(hasher);
        fs::read(path)?.hash(hasher);
        return Ok(());
    }
    let entries = fs::read_dir(path)?;
    let paths: Result<Vec<_>, _> = entries
        .map(|entry| entry.map(|entry| entry.path()))
        .collect();
    let mut paths = paths?;
    paths.sort();
    paths.iter().try_for_each(|path| add(path, hasher))
}
