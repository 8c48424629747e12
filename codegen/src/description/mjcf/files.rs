//! Loads the first file and all included files.
//!
//! Each file is read once, with the places where it is included. Files outside the folder of the first one are
//! rejected, and so are files that are included twice, and more text than a single file may have.

use std::path::{Component, Path, PathBuf};

use roxmltree::Node;

use crate::description::load::{absolute, load_text};
use crate::description::position::Positions;
use crate::description::xml::texts::{LIMITS, Texts};
use crate::description::xml::{self, plain};
use crate::error::Errors;
use crate::wording::quoted;

/// Hint for a text without the root element.
pub(super) const BEGINS: &str = "an MJCF file begins with <mujoco>";

/// The element that is replaced by another file.
pub(super) const INCLUDE: &str = "include";

/// Reads a file and all included files, the first file first. `None` if one of them cannot be read.
pub(super) fn load(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    errors: &mut Errors,
) -> Option<Texts> {
    let mut texts = Texts::new(text, file);
    let mut at = 0;
    while at < texts.len() {
        errors.set_included(texts.names());
        include(&mut texts, at, folder, errors)?;
        at += 1;
    }
    Some(texts)
}

/// Finds and reads the files that one file includes.
fn include(texts: &mut Texts, at: usize, folder: Option<&Path>, errors: &mut Errors) -> Option<()> {
    let content = texts.content(at).to_owned();
    let positions = Positions::of_file(&content, at);
    let plain = plain::plain(&content);
    let document = xml::parse(&plain, &positions, BEGINS, errors)?;
    let elements = document.descendants().filter(Node::is_element);
    for node in elements.filter(|node| node.tag_name().name() == INCLUDE) {
        let offset = node.range().start;
        let opened = node
            .attribute("file")
            .ok_or_else(|| {
                let hint = "write <include file=\"…\"/>";
                ("<include> has no attribute \"file\"".to_owned(), hint)
            })
            .and_then(|written| open(written, texts.folder(at), folder));
        let opened = opened.and_then(|Opened { name, path, text }| {
            if texts.has(&name) {
                let hint = "include each file once, as MuJoCo requires";
                return Err((format!("{} is included twice", quoted(&name)), hint));
            }
            let too_many = "the included files are too many or too large".to_owned();
            texts.add(name, path, text).ok_or((too_many, LIMITS))
        });
        match opened {
            Ok(file) => texts.link(at, offset, file),
            Err((message, hint)) => {
                errors.push_with_hint(positions.place(offset), message, hint);
                return None;
            }
        }
    }
    Some(())
}

/// An included file.
struct Opened {
    /// Its path from the first file's folder.
    name: String,
    path: PathBuf,
    text: String,
}

/// Opens an included file. As in MuJoCo, the path is relative to the first file's folder, or else to that of the
/// including file.
fn open(
    written: &str,
    including: &str,
    folder: Option<&Path>,
) -> Result<Opened, (String, &'static str)> {
    const HINT: &str = "write a path inside the folder of the first file";
    let refuse = |reason: &str| {
        (
            format!("cannot include {}: {reason}", quoted(written)),
            HINT,
        )
    };
    let folder = folder.ok_or_else(|| {
        let hint = "read the description from a file, so that paths are relative to its folder";
        let message = format!(
            "cannot include {}: a text without a file has no folder",
            quoted(written)
        );
        (message, hint)
    })?;
    let names = [within("", written), within(including, written)];
    let names: Vec<String> = names.into_iter().flatten().collect();
    let first = names
        .iter()
        .find(|name| folder.join(name).exists())
        .or(names.first());
    let name = first.ok_or_else(|| refuse("it is outside the folder"))?;
    let path = folder.join(name);
    let real = |path: &Path| absolute(path)?.canonicalize().ok();
    if let (Some(path), Some(folder)) = (real(&path), real(folder))
        && !path.starts_with(folder)
    {
        return Err(refuse("it is a link to a file outside the folder"));
    }
    let text = load_text(&path).map_err(|reason| refuse(&reason))?;
    Ok(Opened {
        name: name.clone(),
        path,
        text,
    })
}

/// A path relative to the first file's folder, without `.` and `..`; `None` if it leaves that folder.
fn within(beside: &str, written: &str) -> Option<String> {
    let written = written.replace('\\', "/");
    let mut names: Vec<&str> = beside.split('/').filter(|name| !name.is_empty()).collect();
    for component in Path::new(&written).components() {
        match component {
            Component::Normal(name) => names.push(name.to_str()?),
            Component::CurDir => {}
            Component::ParentDir => {
                names.pop()?;
            }
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    (!names.is_empty()).then(|| names.join("/"))
}
