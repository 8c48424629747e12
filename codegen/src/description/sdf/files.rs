//! Loads the first file and the files of all included models.
//!
//! Each file is read once. The model of an `<include>` is looked for in the folder of its package, beside the file that
//! includes it, and beside the folders of both; other places are rejected, and so is more text than a single file may
//! have.

use std::path::{Component, Path, PathBuf};

use roxmltree::Node;

use crate::description::Given;
use crate::description::load::{absolute, load_text};
use crate::description::position::Positions;
use crate::description::xml::texts::{LIMITS, Texts};
use crate::description::xml::{self, plain};
use crate::error::Errors;
use crate::wording::quoted;

/// Hint for a text without the root element.
pub(super) const BEGINS: &str = "an SDF file begins with <sdf version=\"…\">";

/// Beginning of the address of a model by its name.
const BY_NAME: &str = "model://";

/// Reads a file and all files of included models, the first file first. `None` if one of them cannot be read.
pub(super) fn load(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    errors: &mut Errors,
) -> Option<Texts> {
    // Models are also looked for around the folder, which a relative path may not name.
    let folder = folder.and_then(absolute);
    let mut texts = Texts::new(text, file);
    let mut at = 0;
    while at < texts.len() {
        errors.set_included(texts.names());
        include(&mut texts, at, folder.as_deref(), given, errors)?;
        at += 1;
    }
    errors.set_included(texts.names());
    Some(texts)
}

/// Finds and reads the files that one file includes.
fn include(
    texts: &mut Texts,
    at: usize,
    folder: Option<&Path>,
    given: &Given,
    errors: &mut Errors,
) -> Option<()> {
    let content = texts.content(at).to_owned();
    let positions = Positions::of_file(&content, at);
    let plain = plain::plain(&content);
    let document = xml::parse(&plain, &positions, BEGINS, errors)?;
    let elements = document.descendants().filter(Node::is_element);
    for node in elements.filter(|node| node.tag_name().name() == "include") {
        let offset = node.range().start;
        let uri = node
            .children()
            .find(|child| child.tag_name().name() == "uri");
        let uri = uri.and_then(|uri| uri.text()).unwrap_or_default().trim();
        let beside = texts.path(at).and_then(Path::parent).or(folder);
        let opened = open(uri, beside, folder, given).and_then(|path| {
            if let Some(known) = texts.find(&path) {
                return Ok(known);
            }
            let refuse = |reason: &str| Refused::new(uri, reason, HINT);
            let text = load_text(&path).map_err(|reason| refuse(&reason))?;
            let name = shown(&path, folder);
            texts.add(name, path, text).ok_or_else(|| refuse(LIMITS))
        });
        match opened {
            Ok(file) => texts.link(at, offset, file),
            Err(Refused { message, hint }) => {
                errors.push_with_hint(positions.place(offset), message, hint);
                return None;
            }
        }
    }
    Some(())
}

/// Hint for a model that is not found.
const HINT: &str =
    "put the folder of the model beside the file, or name its folder with the key packages";

/// An error of an included model.
struct Refused {
    message: String,
    hint: &'static str,
}

impl Refused {
    fn new(uri: &str, reason: &str, hint: &'static str) -> Self {
        let message = format!("cannot include {}: {reason}", quoted(uri));
        Self { message, hint }
    }
}

/// The path of an included model's file.
fn open(
    uri: &str,
    beside: Option<&Path>,
    first: Option<&Path>,
    given: &Given,
) -> Result<PathBuf, Refused> {
    let refuse = |reason: &str, hint| Err(Refused::new(uri, reason, hint));
    if uri.is_empty() {
        return refuse("it has no <uri>", "write <uri>model://…</uri>");
    }
    let by_name = uri.strip_prefix(BY_NAME);
    if by_name.is_none() && uri.contains("://") {
        return refuse(
            "it is not a file of this machine",
            "download the model, and write <uri>model://…</uri>",
        );
    }
    let Some(parts) = parts(by_name.unwrap_or(uri)) else {
        return refuse("it is outside the folder", HINT);
    };
    let (model, inside) = (parts[0].as_str(), &parts[1..]);
    let package = given.packages.iter().find(|(name, _)| name == model);
    if let Some((_, package)) = package.filter(|_| by_name.is_some()) {
        let path = inside
            .iter()
            .fold(package.clone(), |path, part| path.join(part));
        return file_of(&path).map_or_else(|| refuse("there is no such file", HINT), Ok);
    }
    let Some(beside) = beside else {
        return refuse(
            "a text without a file has no folder",
            "read the description from a file, so that models are found beside it",
        );
    };
    // Models that stand beside each other are in one folder, which is that around a model's own.
    let around = by_name.and_then(|_| beside.parent());
    let first_around = by_name.and_then(|_| first.and_then(Path::parent));
    let folders = [Some(beside), around, first, first_around];
    let found = folders.into_iter().flatten().find_map(|folder| {
        let path = parts
            .iter()
            .fold(folder.to_owned(), |path, part| path.join(part));
        let file = file_of(&path)?;
        let is_inside = match (file.canonicalize(), folder.canonicalize()) {
            (Ok(file), Ok(folder)) => file.starts_with(folder),
            _ => true,
        };
        is_inside.then_some(file)
    });
    found.map_or_else(|| refuse("there is no such file", HINT), Ok)
}

/// The names of a path without `.`; `None` if it is absolute, has `..`, or is empty.
fn parts(path: &str) -> Option<Vec<String>> {
    let path = path.replace('\\', "/");
    let mut parts = Vec::new();
    for component in Path::new(&path).components() {
        match component {
            Component::Normal(name) => parts.push(name.to_str()?.to_owned()),
            Component::CurDir => {}
            Component::ParentDir | Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    (!parts.is_empty()).then_some(parts)
}

/// The file of a model: the path itself, or the one that the folder's `model.config` names, or its `model.sdf`.
fn file_of(path: &Path) -> Option<PathBuf> {
    if !path.is_dir() {
        return path.exists().then(|| path.to_owned());
    }
    let config = load_text(&path.join("model.config")).ok();
    let named = config.and_then(|config| {
        let plain = plain::plain(&config);
        let positions = Positions::new(&config);
        let document = xml::parse(&plain, &positions, BEGINS, &mut Errors::new())?;
        // The last one is that of the newest version.
        let files = document.root_element().children();
        let mut files = files.filter(|child| child.tag_name().name() == "sdf");
        let file = files.next_back()?.text()?.trim().to_owned();
        parts(&file)
    });
    let named = named.unwrap_or_else(|| vec!["model.sdf".to_owned()]);
    let file = named
        .iter()
        .fold(path.to_owned(), |path, part| path.join(part));
    file.is_file().then_some(file)
}

/// The path of a file as messages show it.
fn shown(path: &Path, folder: Option<&Path>) -> String {
    let folders = folder.into_iter().chain(folder.and_then(Path::parent));
    let mut inside = folders.filter_map(|folder| path.strip_prefix(folder).ok());
    let shown = inside.next().unwrap_or(path);
    let names: Vec<_> = shown
        .components()
        .map(|part| part.as_os_str().to_string_lossy())
        .collect();
    names.join("/")
}
