//! Loads the first file, all included files, and the files of models that may be attached.
//!
//! Each file is read once for each model, with the places that name it. Files outside the folder of the first one are
//! rejected, and so are files that a model includes twice, models that contain themselves, and more text than a single
//! file may have.

use std::path::{Component, Path, PathBuf};

use roxmltree::Node;

use crate::description::format::is_mjcf;
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

/// The element that names the file of a model.
pub(super) const MODEL: &str = "model";

/// The model that a file is part of.
#[derive(Clone, Copy)]
struct Home {
    /// The first file of the model.
    file: usize,
    /// The first file of the model around it.
    outer: Option<usize>,
}

/// Reads a file and all files that it names, the first file first. `None` if one of them cannot be read.
pub(super) fn load(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    errors: &mut Errors,
) -> Option<Texts> {
    let mut texts = Texts::new(text, file);
    let mut homes = vec![Home {
        file: 0,
        outer: None,
    }];
    let mut at = 0;
    while at < texts.len() {
        errors.set_included(texts.names());
        read_named(&mut texts, &mut homes, at, folder, errors)?;
        at += 1;
    }
    Some(texts)
}

/// Finds and reads the files that one file names.
fn read_named(
    texts: &mut Texts,
    homes: &mut Vec<Home>,
    at: usize,
    folder: Option<&Path>,
    errors: &mut Errors,
) -> Option<()> {
    let content = texts.content(at).to_owned();
    let positions = Positions::of_file(&content, at);
    let plain = plain::plain(&content);
    let document = xml::parse(&plain, &positions, BEGINS, errors)?;
    let elements = document.descendants().filter(Node::is_element);
    for node in elements.filter(|node| [INCLUDE, MODEL].contains(&node.tag_name().name())) {
        let offset = node.range().start;
        match add(texts, homes, at, node, folder) {
            Ok(file) => texts.link(at, offset, file),
            Err((message, hint)) => {
                errors.push_with_hint(positions.place(offset), message, hint);
                return None;
            }
        }
    }
    Some(())
}

/// Opens the file that an element names, and adds it to the texts; returns its index.
fn add(
    texts: &mut Texts,
    homes: &mut Vec<Home>,
    at: usize,
    node: Node<'_, '_>,
    folder: Option<&Path>,
) -> Result<usize, (String, &'static str)> {
    let is_model = node.tag_name().name() == MODEL;
    let verb = if is_model { "attach" } else { INCLUDE };
    let Some(written) = node.attribute("file") else {
        return Err(if is_model {
            let hint = "write <model name=\"…\" file=\"…\"/>";
            ("<model> has no attribute \"file\"".to_owned(), hint)
        } else {
            let hint = "write <include file=\"…\"/>";
            ("<include> has no attribute \"file\"".to_owned(), hint)
        });
    };
    let home = homes[at];
    let folders = Folders {
        first: folder,
        model: texts.folder(home.file),
        // As in MuJoCo: an included file is also looked for beside the file that includes it.
        beside: (!is_model).then(|| texts.folder(at)),
    };
    let Opened { name, path, text } = open(written, verb, &folders)?;
    let home = if is_model {
        if !is_mjcf(&text) {
            let message = format!("cannot attach {}: it is not an MJCF file", quoted(&name));
            return Err((message, BEGINS));
        }
        let mut outer = Some(home.file);
        while let Some(file) = outer {
            if texts.is_named(file, &name) {
                let message = format!("{} is attached within itself", quoted(&name));
                return Err((message, "attached models must not form a loop"));
            }
            outer = homes[file].outer;
        }
        Home {
            file: texts.len(),
            outer: Some(home.file),
        }
    } else {
        let mut files = homes.iter().enumerate();
        if files.any(|(file, other)| other.file == home.file && texts.is_named(file, &name)) {
            let hint = "include each file once, as MuJoCo requires";
            return Err((format!("{} is included twice", quoted(&name)), hint));
        }
        home
    };
    let too_many = "the files of the robot are too many or too large".to_owned();
    let file = texts.add(name, path, text).ok_or((too_many, LIMITS))?;
    homes.push(home);
    Ok(file)
}

/// Folders in which a file is looked for.
struct Folders<'t> {
    /// The folder of the first file; `None` if the text is of no file.
    first: Option<&'t Path>,
    /// The folder of the model's first file, relative to that folder.
    model: &'t str,
    /// Another folder, relative to that folder.
    beside: Option<&'t str>,
}

/// A file that another one names.
struct Opened {
    /// Its path from the first file's folder.
    name: String,
    path: PathBuf,
    text: String,
}

/// Opens a file in the first folder that has it.
fn open(
    written: &str,
    verb: &str,
    folders: &Folders<'_>,
) -> Result<Opened, (String, &'static str)> {
    const HINT: &str = "write a path inside the folder of the first file";
    let refuse = |reason: &str| (format!("cannot {verb} {}: {reason}", quoted(written)), HINT);
    let first = folders.first.ok_or_else(|| {
        let hint = "read the description from a file, so that paths are relative to its folder";
        let message = format!(
            "cannot {verb} {}: a text without a file has no folder",
            quoted(written)
        );
        (message, hint)
    })?;
    let places = [Some(folders.model), folders.beside];
    let names = places.into_iter().flatten();
    let names: Vec<String> = names.filter_map(|place| within(place, written)).collect();
    let name = names
        .iter()
        .find(|name| first.join(name).exists())
        .or(names.first())
        .ok_or_else(|| refuse("it is outside the folder"))?;
    let path = first.join(name);
    let real = |path: &Path| absolute(path)?.canonicalize().ok();
    if let (Some(path), Some(folder)) = (real(&path), real(first))
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
