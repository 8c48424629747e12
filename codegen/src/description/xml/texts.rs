//! Texts of a file and of the files that it includes.
//!
//! Each file has an index, which places refer to; the first file has 0. Formats differ in where they look for included
//! files, and find them themselves. All files together are as large as one file may be.

use std::borrow::Cow;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

use proc_macro2::Span;
use roxmltree::{Document, Node};

use super::{LARGEST_FILE, parse, plain};
use crate::description::fingerprint::fingerprint;
use crate::description::position::Positions;
use crate::description::{FileFormat, Source};
use crate::error::Errors;

/// Maximum number of files.
const MOST_FILES: usize = 1000;

/// Limits of the files of a robot, for messages.
pub const LIMITS: &str = "a robot may have 1000 files, of 64 MB together";

/// The texts of all files, in the order in which they are included.
pub struct Texts(Vec<Text>);

/// The text of a file.
struct Text {
    /// Its name in messages: its path from the first file's folder, with `/` between names; for the first file its name.
    name: String,
    /// Its path; `None` for the first file.
    path: Option<PathBuf>,
    content: String,
    /// The indices of the included files, by the byte offsets of the `<include>` elements.
    includes: HashMap<usize, usize>,
}

/// A parsed file.
pub struct Parsed<'t> {
    /// Its name; empty for the first file.
    name: &'t str,
    /// Places in its text.
    pub positions: Positions<'t>,
    /// Its elements.
    pub document: Document<'t>,
    includes: &'t HashMap<usize, usize>,
}

impl Parsed<'_> {
    /// The folder of the file, relative to that of the first file.
    pub fn folder(&self) -> &str {
        folder_of(self.name)
    }

    /// The index of the file that an element includes.
    pub fn included(&self, node: Node<'_, '_>) -> Option<usize> {
        self.includes.get(&node.range().start).copied()
    }
}

/// The folder in a path with `/` between names; empty if it has none.
fn folder_of(name: &str) -> &str {
    name.rsplit_once('/').map_or("", |(folder, _)| folder)
}

impl Texts {
    /// The text of the first file.
    pub fn new(text: &str, file: &str) -> Self {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self(vec![Text::new(file.to_owned(), None, text.to_owned())])
    }

    /// The number of files.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// The content of a file.
    pub fn content(&self, file: usize) -> &str {
        &self.0[file].content
    }

    /// The folder of a file, relative to that of the first file.
    pub fn folder(&self, file: usize) -> &str {
        match file {
            0 => "",
            _ => folder_of(&self.0[file].name),
        }
    }

    /// The path of an included file.
    pub fn path(&self, file: usize) -> Option<&Path> {
        self.0[file].path.as_deref()
    }

    /// The index of the included file with a path.
    pub fn find(&self, path: &Path) -> Option<usize> {
        self.0
            .iter()
            .position(|text| text.path.as_deref() == Some(path))
    }

    /// The names of the included files.
    pub fn names(&self) -> Vec<String> {
        self.0[1..].iter().map(|text| text.name.clone()).collect()
    }

    /// True if a file has this name.
    pub fn is_named(&self, file: usize, name: &str) -> bool {
        self.0[file].name == name
    }

    /// Adds an included file, and returns its index; `None` if the files become too many or too large.
    pub fn add(&mut self, name: String, path: PathBuf, content: String) -> Option<usize> {
        let size: usize = self.0.iter().map(|text| text.content.len()).sum();
        if size + content.len() > LARGEST_FILE || self.0.len() >= MOST_FILES {
            return None;
        }
        self.0.push(Text::new(name, Some(path), content));
        Some(self.0.len() - 1)
    }

    /// Records that the element at a byte offset of one file includes another.
    pub fn link(&mut self, file: usize, offset: usize, included: usize) {
        self.0[file].includes.insert(offset, included);
    }

    /// The texts of the files, prepared for the XML parser.
    pub fn plains(&self) -> Vec<Cow<'_, str>> {
        let plains = self.0.iter().map(|text| plain::plain(&text.content));
        plains.collect()
    }

    /// Parses the files; `begins` is the hint for a text without the root element.
    pub fn parse<'t>(
        &'t self,
        plains: &'t [Cow<'t, str>],
        begins: &str,
        errors: &mut Errors,
    ) -> Option<Vec<Parsed<'t>>> {
        let files = self.0.iter().zip(plains).enumerate();
        let parsed = files.map(|(file, (text, plain))| {
            let positions = Positions::of_file(&text.content, file);
            let document = parse(plain, &positions, begins, errors)?;
            Some(Parsed {
                name: if file == 0 { "" } else { &text.name },
                positions,
                document,
                includes: &text.includes,
            })
        });
        parsed.collect()
    }

    /// The files from which a description was read, with their fingerprint.
    pub fn source(&self, format: FileFormat, anchor: Option<Span>) -> Source {
        let bytes: Vec<u8> = self
            .0
            .iter()
            .flat_map(|text| text.content.bytes())
            .collect();
        Source {
            file: Some(self.0[0].name.clone()),
            format: Some(format),
            anchor,
            included: self.names(),
            beside: self.0.iter().filter_map(|text| text.path.clone()).collect(),
            hash: fingerprint(&bytes),
        }
    }
}

impl Text {
    fn new(name: String, path: Option<PathBuf>, content: String) -> Self {
        Self {
            name,
            path,
            content,
            includes: HashMap::new(),
        }
    }
}
