//! Reads a file, with a bound on its size.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::LARGEST_FILE;

/// The bytes of a file, or the reason for an error, in the same words on every platform where possible.
pub(super) fn load(path: &Path) -> Result<Vec<u8>, String> {
    let reason = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "no permission".to_owned(),
        _ => error.to_string(),
    };
    let file = File::open(path).map_err(reason)?;
    if file.metadata().is_ok_and(|about| about.is_dir()) {
        return Err("it is a folder".to_owned());
    }
    // A device may have no end.
    let limit = LARGEST_FILE as u64 + 1;
    let mut bytes = Vec::new();
    file.take(limit).read_to_end(&mut bytes).map_err(reason)?;
    if bytes.len() > LARGEST_FILE {
        return Err(format!("it is larger than {} MB", LARGEST_FILE >> 20));
    }
    Ok(bytes)
}

#[cfg(feature = "formats")]
/// The text of a file without its byte order mark, or the reason for an error.
pub(super) fn load_text(path: &Path) -> Result<String, String> {
    let text = String::from_utf8(load(path)?).map_err(|_| "it is not UTF-8".to_owned())?;
    Ok(match text.strip_prefix('\u{feff}') {
        Some(text) => text.to_owned(),
        None => text,
    })
}

#[cfg(feature = "formats")]
/// The absolute path of a folder; an empty path is the working directory. `None` if that is gone.
pub(super) fn absolute(folder: &Path) -> Option<std::path::PathBuf> {
    let is_empty = folder.as_os_str().is_empty();
    std::path::absolute(if is_empty { Path::new(".") } else { folder }).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `homogen check arm.urdf.xacro` names no folder.
    #[test]
    fn an_empty_path_is_the_working_directory() {
        let here = std::env::current_dir().ok();
        assert_eq!(absolute(Path::new("")), here);
        assert!(absolute(Path::new("")).is_some_and(|path| path.is_dir()));
    }
}
