//! Files and their fingerprint.
//!
//! In: a path, or a text and a name. Out: a [`Description`] read by the reader of that language.
//! It never looks into the environment: whoever calls says where a relative path begins.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use proc_macro2::Span;

use super::{Description, urdf};
use crate::error::{Errors, Place};

/// Reads a URDF file.
pub fn read_file(path: &Path, anchor: Option<Span>, errors: &mut Errors) -> Option<Description> {
    let name = path
        .file_name()
        .map_or_else(|| path.to_string_lossy(), |name| name.to_string_lossy());
    errors.set_file(name.clone(), anchor);
    let bytes = match load(path) {
        Ok(bytes) => bytes,
        Err(reason) => {
            let place = anchor.map_or(Place::Unknown, Place::Token);
            let message = format!("cannot read {}: {reason}", path.display());
            match anchor {
                Some(_) => {
                    let hint = "a path begins at the folder of Cargo.toml";
                    errors.push_with_hint(place, message, hint);
                }
                None => errors.push(place, message),
            }
            return None;
        }
    };
    match String::from_utf8(bytes) {
        Ok(text) => read_text(&text, &name, anchor, errors),
        Err(error) => {
            refuse_encoding(error.as_bytes(), error.utf8_error().valid_up_to(), errors);
            None
        }
    }
}

/// Reads a text that came from a file of that name, or from anywhere else under any name.
pub fn read_text(
    text: &str,
    file: &str,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    urdf::read(text, file, anchor, errors)
}

/// FNV-1a hash of 64 bits.
pub(super) fn fingerprint(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// The bytes of a file of reasonable size, or why there are none, in words that are the same on
/// every platform where they can be.
fn load(path: &Path) -> Result<Vec<u8>, String> {
    let reason = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "no permission".to_owned(),
        _ => error.to_string(),
    };
    let file = File::open(path).map_err(reason)?;
    if file.metadata().is_ok_and(|about| about.is_dir()) {
        return Err("it is a folder".to_owned());
    }
    // Read no further than that: a device may have no end.
    let limit = urdf::LARGEST_FILE as u64 + 1;
    let mut bytes = Vec::new();
    file.take(limit).read_to_end(&mut bytes).map_err(reason)?;
    if bytes.len() > urdf::LARGEST_FILE {
        return Err(format!("it is larger than {} MB", urdf::LARGEST_FILE >> 20));
    }
    Ok(bytes)
}

fn refuse_encoding(bytes: &[u8], valid: usize, errors: &mut Errors) {
    let place = std::str::from_utf8(&bytes[..valid]).map_or(Place::Unknown, |text| {
        super::position::Positions::new(text).place(valid)
    });
    let message = if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        "the file is written in UTF-16"
    } else {
        "the file is not written in UTF-8"
    };
    errors.push_with_hint(place, message, "save it as UTF-8");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of a file of these bytes.
    fn errors(name: &str, bytes: &[u8]) -> String {
        let folder = std::env::temp_dir().join(format!("homogen-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join(name);
        std::fs::write(&path, bytes).unwrap();
        let mut errors = Errors::new();
        let _ = read_file(&path, None, &mut errors);
        errors.to_string()
    }

    #[test]
    fn fingerprints_are_those_of_fnv_1a() {
        assert_eq!(fingerprint(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fingerprint(b"a"), 0xaf63_dc4c_8601_ec8c);
    }

    #[test]
    fn a_file_that_cannot_be_read_is_said() {
        let mut errors = Errors::new();
        assert!(read_file(Path::new("no/such.urdf"), None, &mut errors).is_none());
        assert_eq!(
            errors.to_string(),
            "error: cannot read no/such.urdf: there is no such file\n"
        );
        let mut errors = Errors::new();
        assert!(read_file(Path::new("."), None, &mut errors).is_none());
        assert_eq!(errors.to_string(), "error: cannot read .: it is a folder\n");
    }

    #[test]
    fn other_encodings_are_said() {
        assert_eq!(
            errors("latin1.urdf", b"<robot\nname=\"b\xe4r\"/>"),
            "error: latin1.urdf:2:8: the file is not written in UTF-8\n  hint: save it as UTF-8\n"
        );
        assert_eq!(
            errors("utf16.urdf", b"\xff\xfe<\0r\0"),
            "error: utf16.urdf:1:1: the file is written in UTF-16\n  hint: save it as UTF-8\n"
        );
    }
}
