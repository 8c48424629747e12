//! The measured programs, compiled for the baseline and for this processor.
//!
//! In: their sources. Out: executables for each set of flags.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// The target of a compilation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Flags {
    /// The baseline: every processor of the architecture.
    Baseline,
    /// This processor.
    Native,
}

impl Flags {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Baseline, Self::Native];

    /// Its name in the report.
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

/// The executables of one compilation.
pub struct Executables {
    /// Their target.
    pub flags: Flags,
    /// One state a call.
    pub measured: PathBuf,
    /// Many states at once.
    pub many: PathBuf,
}

/// Compiles the measured programs, whose sources are in a folder.
///
/// # Errors
/// A failure of cargo, with its output.
pub fn compile(sources: &Path, target: &Path, flags: Flags) -> Result<Executables, Box<dyn Error>> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("measured/Cargo.toml");
    let output = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["build", "--release", "--quiet", "--manifest-path"])
        .arg(manifest)
        .arg("--target-dir")
        .arg(target)
        .env("GENERATED", sources)
        .env("CARGO_ENCODED_RUSTFLAGS", flags.rustflags())
        .output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let kept = |name: &str| {
        let file = |name: &str| format!("{name}{}", env::consts::EXE_SUFFIX);
        let kept = target.join(file(&format!("{name}-{}", flags.name())));
        // The compilation with the other flags overwrites it.
        fs::copy(target.join("release").join(file(name)), &kept)?;
        Ok::<_, io::Error>(kept)
    };
    Ok(Executables {
        flags,
        measured: kept("measured")?,
        many: kept("many")?,
    })
}
