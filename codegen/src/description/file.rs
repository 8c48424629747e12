//! Reads files: recognises the format and the encoding.
//!
//! Relative paths are resolved by the caller.

use std::path::Path;

use proc_macro2::Span;

use super::inline::text as inline;
use super::load::load;
use super::{Description, FileFormat, Given, denavit_hartenberg, urdf};
#[cfg(feature = "formats")]
use super::{mjcf, sdf, xacro};
use crate::error::{Diagnostic, Errors, Place};

/// Reads a file without arguments: see [`read_file_with`].
pub fn read_file(path: &Path, anchor: Option<Span>, errors: &mut Errors) -> Option<Description> {
    read_file_with(path, &Given::default(), anchor, errors)
}

/// Reads a file: `.dh` as a table; `.urdf`, `.xml` and `.xacro` as XML; other endings as what the text looks like, which
/// may be an inline description, too. XML with the root element of MuJoCo is MJCF, that of Gazebo SDF, other XML is URDF,
/// and xacro is expanded first. `given` has the arguments of a xacro file and the folders of packages.
pub fn read_file_with(
    path: &Path,
    given: &Given,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
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
                    let hint = "paths are relative to the folder of Cargo.toml";
                    errors.push_with_hint(place, message, hint);
                }
                None => errors.push(place, message),
            }
            return None;
        }
    };
    read_bytes_in(&bytes, &name, path.parent(), given, anchor, errors)
}

/// The URDF that a xacro file expands to.
#[cfg(feature = "formats")]
pub fn expand_file(path: &Path, given: &Given, errors: &mut Errors) -> Option<String> {
    let name = path
        .file_name()
        .map_or_else(|| path.to_string_lossy(), |name| name.to_string_lossy());
    let text = load(path)
        .and_then(|bytes| String::from_utf8(bytes).map_err(|_| "it is not UTF-8".to_owned()));
    match text {
        Ok(text) => xacro::expanded(&text, &name, path.parent(), given, errors),
        Err(reason) => {
            let message = format!("cannot read {}: {reason}", path.display());
            errors.push(Place::Unknown, message);
            None
        }
    }
}

/// Reads the bytes of a file, or of standard input, with the given name. Text that is not UTF-8 is read as Latin-1,
/// with a warning, if that gives a valid description.
pub fn read_bytes(
    bytes: &[u8],
    file: &str,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    read_bytes_in(bytes, file, None, &Given::default(), anchor, errors)
}

/// The same, for a file in a folder that its relative paths begin at, with the arguments of a xacro file and the folders
/// of packages.
pub fn read_bytes_in(
    bytes: &[u8],
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    match std::str::from_utf8(bytes) {
        Ok(text) if !is_utf_16(bytes) => text_in(text, file, folder, given, anchor, errors),
        unread => {
            let valid = unread.map_or_else(|error| error.valid_up_to(), |_| 0);
            let warning = encoding_warning(bytes, valid);
            // Characters of Latin-1 have the code points of Unicode.
            let marked = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            let text: String = marked.iter().map(|&byte| char::from(byte)).collect();
            let mut found = Errors::new();
            if let Some(mut description) = text_in(&text, file, folder, given, anchor, &mut found) {
                errors.append(found);
                description.warnings.insert(0, warning);
                return Some(description);
            }
            errors.set_file(file, anchor);
            errors.push_with_hint(
                warning.place,
                warning.message,
                warning.hint.unwrap_or_default(),
            );
            None
        }
    }
}

/// Reads the text of a file, or of another source, with the given name.
pub fn read_text(
    text: &str,
    file: &str,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    text_in(text, file, None, &Given::default(), anchor, errors)
}

/// The same, for a file in a folder that its relative paths begin at.
fn text_in(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    let format = FileFormat::of(text, file);
    if format != Some(FileFormat::Xacro) && !given.arguments.is_empty() {
        let message = "arguments are given, but the file is not xacro";
        let hint = "a xacro file declares xmlns:xacro=\"http://www.ros.org/wiki/xacro\" and uses it, or its name ends in .xacro";
        reject(file, anchor, message, hint, errors);
    }
    match format {
        // A macro has its inline descriptions in its own tokens.
        None if anchor.is_none() && inline::is_inline(text) => inline::read(text, file, errors),
        None | Some(FileFormat::Table) => denavit_hartenberg::read(text, file, anchor, errors),
        Some(FileFormat::Urdf) => urdf::read(text, file, anchor, errors),
        #[cfg(feature = "formats")]
        Some(FileFormat::Mjcf) => mjcf::read(text, file, folder, anchor, errors),
        #[cfg(feature = "formats")]
        Some(FileFormat::Sdf) => sdf::read(text, file, folder, given, anchor, errors),
        #[cfg(feature = "formats")]
        Some(FileFormat::Xacro) => xacro::read(text, file, folder, given, anchor, errors),
        #[cfg(not(feature = "formats"))]
        Some(format) => {
            // Only the readers left out take the folder.
            let _ = folder;
            let message = format!("{} files need the feature `formats`", format.name());
            let hint = "cargo add homogen --features formats";
            reject(file, anchor, &message, hint, errors);
            None
        }
    }
}

/// Adds an error of a whole file, at the token that named it.
fn reject(file: &str, anchor: Option<Span>, message: &str, hint: &str, errors: &mut Errors) {
    errors.set_file(file, anchor);
    let place = anchor.map_or(Place::Unknown, Place::Token);
    errors.push_with_hint(place, message, hint);
}

/// The warning, or error, for bytes that are UTF-8 only up to `valid`.
fn encoding_warning(bytes: &[u8], valid: usize) -> Diagnostic {
    let place = std::str::from_utf8(&bytes[..valid]).map_or(Place::Unknown, |text| {
        super::position::Positions::new(text).place(valid)
    });
    let message = if is_utf_16(bytes) {
        "the file is UTF-16"
    } else {
        "the file is not UTF-8"
    };
    Diagnostic {
        place,
        message: message.to_owned(),
        hint: Some("save it as UTF-8".to_owned()),
    }
}

/// True if a text is UTF-16: by its byte order mark, or by a zero in its first character.
#[must_use]
pub fn is_utf_16(bytes: &[u8]) -> bool {
    matches!(
        bytes,
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, _, ..] | [_, 0, ..]
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The errors of a file with these bytes.
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
    fn unreadable_files_are_errors() {
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
    fn latin_1_is_read_with_a_warning() {
        let bytes = b"<robot\nname=\"b\xe4r\"><link name='a'/><!-- \xdf --></robot>";
        let mut errors = Errors::new();
        let robot = read_bytes(bytes, "latin1.urdf", None, &mut errors).unwrap();
        assert!(errors.is_empty(), "{errors}");
        assert_eq!(robot.name.text, "bär");
        let [warning] = &robot.warnings[..] else {
            panic!("{:?}", robot.warnings);
        };
        assert!(matches!(warning.place, Place::File { line: 2, column: 8 }));
        assert_eq!(warning.message, "the file is not UTF-8");
    }

    #[test]
    fn other_encodings_are_errors() {
        assert_eq!(
            errors("binary.urdf", b"\x7fELF\xff\n"),
            "error: binary.urdf:1:5: the file is not UTF-8\n  hint: save it as UTF-8\n"
        );
        assert_eq!(
            errors("utf16.urdf", b"\xff\xfe<\0r\0"),
            "error: utf16.urdf:1:1: the file is UTF-16\n  hint: save it as UTF-8\n"
        );
        assert_eq!(
            errors("unmarked.urdf", b"<\0r\0/\0>\0"),
            "error: unmarked.urdf:1:1: the file is UTF-16\n  hint: save it as UTF-8\n"
        );
    }

    #[test]
    fn a_byte_order_mark_before_latin_1_is_ignored() {
        let bytes = b"\xef\xbb\xbf<robot name=\"b\xe4r\"><link name='a'/></robot>";
        let mut errors = Errors::new();
        let robot = read_bytes(bytes, "marked.urdf", None, &mut errors).unwrap();
        assert!(errors.is_empty(), "{errors}");
        assert_eq!(robot.name.text, "bär");
    }
}
