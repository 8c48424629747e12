//! Writes a new folder completely or not at all.

use std::path::Path;
use std::{fs, io, process};

/// Writes a new folder of files: paths in it, and bytes.
pub(super) fn write_fresh(folder: &Path, files: &[(String, Vec<u8>)]) -> io::Result<()> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let fresh = folder.with_file_name(format!(".{name}.new.{}", process::id()));
    let written = || -> io::Result<()> {
        for (path, bytes) in files {
            let path = fresh.join(path);
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent)?;
            }
            fs::write(path, bytes)?;
        }
        fs::rename(&fresh, folder)
    };
    written().inspect_err(|_| {
        // The rest is useless, and the first error is the one to report.
        let _ = fs::remove_dir_all(&fresh);
    })
}
