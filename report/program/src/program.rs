//! The measured programs, compiled without flags and for this processor.
//!
//! In: their sources. Out: executables for each set of flags. The runtime crate has its feature `std` in both: without
//! flags, generated functions choose their instructions at run time, as in `cargo build --release` of a user.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// The flags of a compilation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Flags {
    /// None: for every processor of the architecture, with a choice at run time.
    Without,
    /// For this processor alone.
    Native,
}

impl Flags {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Without, Self::Native];

    /// Its name in the report.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Without => "without flags",
            Self::Native => "native",
        }
    }

    const fn rustflags(self) -> &'static str {
        match self {
            Self::Without => "",
            Self::Native => "-Ctarget-cpu=native",
        }
    }
}

/// The executables of one compilation.
pub struct Executables {
    /// The flags.
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
        let suffix = flags.name().replace(' ', "-");
        let kept = target.join(file(&format!("{name}-{suffix}")));
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
