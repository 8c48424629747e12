//! Loads the first file and all included files.
//!
//! Each file is read once, with the places where it is included. Files outside the folder of the first one are
//! rejected, and so are files that are included twice, and more text than a single file may have.

use std::collections::HashMap;
use std::path::{Component, Path};

use roxmltree::{Document, Node};

use crate::description::load::load_text;
use crate::description::position::Positions;
use crate::description::xml::{self, LARGEST_FILE, plain};
use crate::error::Errors;
use crate::wording::quoted;

/// Hint for a text without the root element.
const BEGINS: &str = "an MJCF file begins with <mujoco>";

/// Maximum number of files.
const MOST_FILES: usize = 1000;

/// The element that is replaced by another file.
pub(super) const INCLUDE: &str = "include";

/// The text of a file.
pub(super) struct Text {
    /// Its path from the first file's folder, with `/` between names; for the first file its name.
    pub(super) name: String,
    content: String,
    /// The indices of the included files, by the byte offsets of the `<include>` elements.
    includes: HashMap<usize, usize>,
}

/// A parsed file.
pub(super) struct Parsed<'t> {
    name: &'t str,
    pub(super) positions: Positions<'t>,
    pub(super) document: Document<'t>,
    includes: &'t HashMap<usize, usize>,
}

impl Parsed<'_> {
    /// The folder of the file, relative to that of the first file.
    pub(super) fn folder(&self) -> &str {
        self.name.rsplit_once('/').map_or("", |(folder, _)| folder)
    }

    /// The index of the file that an element includes.
    pub(super) fn included(&self, node: Node<'_, '_>) -> Option<usize> {
        self.includes.get(&node.range().start).copied()
    }
}

/// Reads a file and all included files, the first file first. `None` if one of them cannot be read.
pub(super) fn load(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    errors: &mut Errors,
) -> Option<Vec<Text>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut texts = vec![Text {
        name: file.to_owned(),
        content: text.to_owned(),
        includes: HashMap::new(),
    }];
    let mut at = 0;
    while at < texts.len() {
        errors.set_included(names(&texts));
        let found = included(&texts, at, folder, errors)?;
        for (offset, name, text) in found {
            let number = texts.len();
            texts[at].includes.insert(offset, number);
            texts.push(Text {
                name,
                content: text,
                includes: HashMap::new(),
            });
        }
        at += 1;
    }
    Some(texts)
}

/// The names of the included files.
pub(super) fn names(texts: &[Text]) -> Vec<String> {
    texts[1..].iter().map(|text| text.name.clone()).collect()
}

/// The bytes of all files, in the order in which they are included.
pub(super) fn bytes(texts: &[Text]) -> Vec<u8> {
    texts.iter().flat_map(|text| text.content.bytes()).collect()
}

/// The texts of the files, prepared for the XML parser.
pub(super) fn plains(texts: &[Text]) -> Vec<std::borrow::Cow<'_, str>> {
    texts
        .iter()
        .map(|text| plain::plain(&text.content))
        .collect()
}

/// Parses the files.
pub(super) fn parse<'t>(
    texts: &'t [Text],
    plains: &'t [std::borrow::Cow<'t, str>],
    errors: &mut Errors,
) -> Option<Vec<Parsed<'t>>> {
    let files = texts.iter().zip(plains).enumerate();
    let parsed = files.map(|(at, (text, plain))| {
        let positions = positions(texts, at);
        let document = xml::parse(plain, &positions, BEGINS, errors)?;
        Some(Parsed {
            name: if at == 0 { "" } else { &text.name },
            positions,
            document,
            includes: &text.includes,
        })
    });
    parsed.collect()
}

fn positions(texts: &[Text], at: usize) -> Positions<'_> {
    Positions::of_file(&texts[at].content, at)
}

/// The files that one file includes, each with the offset of its `<include>`, its name and its text.
fn included(
    texts: &[Text],
    at: usize,
    folder: Option<&Path>,
    errors: &mut Errors,
) -> Option<Vec<(usize, String, String)>> {
    let positions = positions(texts, at);
    let plain = plain::plain(&texts[at].content);
    let document = xml::parse(&plain, &positions, BEGINS, errors)?;
    let mut found: Vec<(usize, String, String)> = Vec::new();
    let elements = document.descendants().filter(Node::is_element);
    for node in elements.filter(|node| node.tag_name().name() == INCLUDE) {
        let including = if at == 0 { "" } else { &*texts[at].name };
        let opened = node
            .attribute("file")
            .ok_or_else(|| {
                let hint = "write <include file=\"…\"/>";
                ("<include> has no attribute \"file\"".to_owned(), hint)
            })
            .and_then(|written| open(written, including, folder));
        let opened = opened.and_then(|(name, text)| {
            let before = found.iter().map(|(_, name, _)| name);
            let mut known = texts.iter().map(|text| &text.name).chain(before);
            let size: usize = (texts.iter().map(|text| text.content.len()))
                .chain(found.iter().map(|(_, _, text)| text.len()))
                .sum();
            if known.any(|known| *known == name) {
                let hint = "include each file once, as MuJoCo requires";
                Err((format!("{} is included twice", quoted(&name)), hint))
            } else if size + text.len() > LARGEST_FILE || texts.len() + found.len() >= MOST_FILES {
                let hint = "a robot may have 1000 files, of 64 MB together";
                Err((
                    "the included files are too many or too large".to_owned(),
                    hint,
                ))
            } else {
                Ok((name, text))
            }
        });
        match opened {
            Ok((name, text)) => found.push((node.range().start, name, text)),
            Err((message, hint)) => {
                errors.push_with_hint(positions.place(node.range().start), message, hint);
                return None;
            }
        }
    }
    Some(found)
}

/// Opens an included file. As in MuJoCo, the path is relative to the first file's folder, or else to that of the
/// including file. Returns the path from the first file's folder, and the text.
fn open(
    written: &str,
    including: &str,
    folder: Option<&Path>,
) -> Result<(String, String), (String, &'static str)> {
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
    let beside = including.rsplit_once('/').map(|(folder, _)| folder);
    let from_first = within("", written);
    let from_including = beside.and_then(|beside| within(beside, written));
    let names = [from_first, from_including];
    let names: Vec<String> = names.into_iter().flatten().collect();
    let first = names
        .iter()
        .find(|name| folder.join(name).exists())
        .or(names.first());
    let name = first.ok_or_else(|| refuse("it is outside the folder"))?;
    let path = folder.join(name);
    let real = |path: &Path| path.canonicalize().ok();
    if let (Some(path), Some(folder)) = (real(&path), real(folder))
        && !path.starts_with(folder)
    {
        return Err(refuse("it is a link to a file outside the folder"));
    }
    let text = load_text(&path).map_err(|reason| refuse(&reason))?;
    Ok((name.clone(), text))
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
