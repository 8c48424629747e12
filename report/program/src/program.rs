//! The measured program, compiled for the baseline and for this processor.
//!
//! In: its source. Out: one executable for each set of flags. It never runs them.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// What a program is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Flags {
    /// Every processor of the architecture.
    Baseline,
    /// This one.
    Native,
}

impl Flags {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Baseline, Self::Native];

    /// What readers call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Native => "native",
        }
    }

    const fn rustflags(self) -> &'static str {
        match self {
            Self::Baseline => "",
            Self::Native => "-Ctarget-cpu=native",
        }
    }
}

/// Compiles the measured program.
///
/// # Errors
/// Where cargo fails; what it says is shown.
pub fn compile(source: &Path, target: &Path, flags: Flags) -> Result<PathBuf, Box<dyn Error>> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("measured/Cargo.toml");
    let output = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["build", "--release", "--quiet", "--manifest-path"])
        .arg(manifest)
        .arg("--target-dir")
        .arg(target)
        .env("GENERATED", source)
        .env("CARGO_ENCODED_RUSTFLAGS", flags.rustflags())
        .output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let built = target
        .join("release")
        .join(format!("measured{}", env::consts::EXE_SUFFIX));
    let kept = target.join(format!(
        "measured-{}{}",
        flags.name(),
        env::consts::EXE_SUFFIX
    ));
    // The other flags overwrite it.
    fs::copy(built, &kept)?;
    Ok(kept)
}
