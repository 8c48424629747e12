//! The files of an expansion: the first one, and what it includes.
//!
//! Files have paths that are the same on every machine: `/package/NAME/…` in a package, `/folder/…` in the folder of a
//! first file that belongs to no package. Files elsewhere are rejected. Links are followed, because ROS links installed
//! files to their sources.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::failure::{Failure, failure, failure_with_hint};
use super::tree::FileId;
use crate::description::Given;
use crate::description::load::{absolute, load_text};
use crate::description::position::Positions;
use crate::description::xml::{self, LARGEST_FILE};
use crate::error::Errors;
use crate::wording::quoted;

/// Maximum number of files.
const MOST_FILES: usize = 1000;

/// Folders up the tree in which packages are looked for.
const MOST_FOLDERS_UP: usize = 8;

/// Beginning of the paths of files in packages.
const PACKAGE: &str = "/package/";

/// Beginning of the paths of files beside a first file that belongs to no package.
const FOLDER: &str = "/folder";

/// A folder whose files may be read.
struct Root {
    /// The beginning of the paths of its files.
    prefix: String,
    folder: PathBuf,
}

/// A file that was read.
struct Text {
    /// Its name in messages.
    name: String,
    /// Its path; `None` for a text without a file.
    path: Option<String>,
    content: String,
}

/// All files.
pub(super) struct Files {
    roots: Vec<Root>,
    /// The folder of the first file.
    folder: Option<PathBuf>,
    /// The path of that folder.
    beginning: String,
    packages: Vec<(String, PathBuf)>,
    texts: Vec<Text>,
    known: HashMap<String, FileId>,
    beside: Vec<PathBuf>,
}

impl Files {
    /// The first file.
    pub(super) fn new(text: &str, file: &str, folder: Option<&Path>, given: &Given) -> Self {
        let folder = folder.and_then(absolute);
        let home = folder.as_ref().map(|folder| home(folder));
        let beginning = match (&home, &folder) {
            (Some(root), Some(folder)) => {
                let below = folder.strip_prefix(&root.folder).unwrap_or(Path::new(""));
                let names = below
                    .components()
                    .map(|name| name.as_os_str().to_string_lossy());
                names.fold(root.prefix.clone(), |path, name| path + "/" + &name)
            }
            _ => String::new(),
        };
        Self {
            roots: home.into_iter().collect(),
            texts: vec![Text {
                name: file.to_owned(),
                path: folder.as_ref().map(|_| format!("{beginning}/{file}")),
                content: text.to_owned(),
            }],
            folder,
            beginning,
            packages: given.packages.clone(),
            known: HashMap::new(),
            beside: Vec::new(),
        }
    }

    /// The text of a file.
    pub(super) fn content(&self, file: FileId) -> &str {
        &self.texts[file.0].content
    }

    /// The name of a file in messages.
    pub(super) fn name(&self, file: FileId) -> &str {
        &self.texts[file.0].name
    }

    /// Lines and columns of a file.
    pub(super) fn positions(&self, file: FileId) -> Positions<'_> {
        Positions::of_file(self.content(file), file.0)
    }

    /// The number of files.
    pub(super) const fn count(&self) -> usize {
        self.texts.len()
    }

    /// The names of all files but the first.
    pub(super) fn included(&self) -> Vec<String> {
        self.texts[1..]
            .iter()
            .map(|text| text.name.clone())
            .collect()
    }

    /// The paths on this machine of all files but the first.
    pub(super) fn beside(&self) -> Vec<PathBuf> {
        self.beside.clone()
    }

    /// The path of a package: `$(find name)`.
    pub(super) fn find(&mut self, package: &str) -> Result<String, Failure> {
        let prefix = format!("{PACKAGE}{package}");
        if self.roots.iter().any(|root| root.prefix == prefix) {
            return Ok(prefix);
        }
        let is_name = |letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '-' | '.');
        if package.is_empty() || !package.chars().all(is_name) || package.starts_with('.') {
            return Err(failure(format!(
                "{} is no name of a package",
                quoted(package)
            )));
        }
        let mut given = self.packages.iter();
        let given = given.find(|(name, _)| name == package);
        let found = match given {
            Some((_, folder)) if folder.is_dir() => Some(folder.clone()),
            Some((_, folder)) => {
                return Err(failure(format!(
                    "package {} is given as {}, which is no folder",
                    quoted(package),
                    quoted(&folder.to_string_lossy())
                )));
            }
            None => self
                .folder
                .as_ref()
                .and_then(|folder| near(folder, package)),
        };
        let Some(folder) = found else {
            return Err(failure_with_hint(
                format!("package {} is not found", quoted(package)),
                format!(
                    "name its folder: packages({package} = \"path\") in attributes, .package(\"{package}\", \"path\") \
                     of the builder, --packages {package}=PATH on the command line"
                ),
            ));
        };
        self.roots.push(Root {
            prefix: prefix.clone(),
            folder,
        });
        Ok(prefix)
    }

    /// The path of a file as written in another one.
    pub(super) fn path(&self, written: &str, current: FileId) -> Result<String, Failure> {
        if written.starts_with('/') {
            return Ok(written.to_owned());
        }
        let current = self.texts[current.0].path.as_deref();
        let folder = current.and_then(|path| path.rsplit_once('/'));
        match folder {
            Some((folder, _)) => Ok(format!("{folder}/{written}")),
            None => Err(failure_with_hint(
                format!(
                    "cannot read {}: a text without a file has no folder",
                    quoted(written)
                ),
                "read the description from a file, so that paths are relative to its folder",
            )),
        }
    }

    /// The path without `.` and `..`, and the path on this machine.
    fn place(&self, path: &str) -> Result<(String, PathBuf), Failure> {
        let outside = || {
            failure_with_hint(
                format!("cannot read {}: it is outside the package", quoted(path)),
                "write $(find package)/…; a first file without a package.xml above it may read its own folder",
            )
        };
        let mut roots: Vec<&Root> = self.roots.iter().collect();
        roots.sort_by_key(|root| std::cmp::Reverse(root.prefix.len()));
        let below = roots.into_iter().find_map(|root| {
            let below = path.strip_prefix(&root.prefix)?;
            (below.is_empty() || below.starts_with('/')).then_some((root, below))
        });
        let (root, below) = below.ok_or_else(outside)?;
        let mut names: Vec<&str> = Vec::new();
        for name in below.split('/') {
            match name {
                "" | "." => {}
                ".." => {
                    names.pop().ok_or_else(outside)?;
                }
                name if name.contains(['\\', '\0', ':']) => return Err(outside()),
                name => names.push(name),
            }
        }
        let real = names
            .iter()
            .fold(root.folder.clone(), |path, name| path.join(name));
        let path = names
            .iter()
            .fold(root.prefix.clone(), |path, name| path + "/" + name);
        Ok((path, real))
    }

    /// True if there is a file with this path.
    pub(super) fn exists(&self, path: &str) -> bool {
        self.place(path).is_ok_and(|(_, real)| real.is_file())
    }

    /// Reads a file; each once.
    pub(super) fn open(&mut self, path: &str) -> Result<FileId, Failure> {
        let (path, real) = self.place(path)?;
        if let Some(known) = self.known.get(&path) {
            return Ok(*known);
        }
        let name = self.name_of(&path);
        let refuse = |reason: &str| failure(format!("cannot read {}: {reason}", quoted(&name)));
        let content = load_text(&real).map_err(|reason| refuse(&reason))?;
        let size: usize = self.texts.iter().map(|text| text.content.len()).sum();
        if size + content.len() > LARGEST_FILE || self.texts.len() >= MOST_FILES {
            return Err(failure(
                "more than 1000 files, or more than 64 MB, are included",
            ));
        }
        let id = FileId(self.texts.len());
        self.texts.push(Text {
            name,
            path: Some(path.clone()),
            content,
        });
        self.known.insert(path, id);
        self.beside.push(real);
        Ok(id)
    }

    /// The name of a file in messages: its path from the folder of the first file, or from a package on.
    fn name_of(&self, path: &str) -> String {
        let below = path.strip_prefix(&self.beginning);
        let below = below.and_then(|below| below.strip_prefix('/'));
        let name = below.or(path.strip_prefix(PACKAGE)).unwrap_or(path);
        name.trim_start_matches('/').to_owned()
    }

    /// The paths that a pattern with `*`, `?` and `[…]` stands for, in alphabetical order.
    pub(super) fn matching(&self, pattern: &str) -> Result<Vec<String>, Failure> {
        let start = pattern.find(['*', '?', '[']).unwrap_or(pattern.len());
        let folder = pattern[..start]
            .rsplit_once('/')
            .map_or("", |(folder, _)| folder);
        let mut found = vec![folder.to_owned()];
        for name in pattern[folder.len()..]
            .split('/')
            .filter(|name| !name.is_empty())
        {
            if !name.contains(['*', '?', '[']) {
                found = found
                    .into_iter()
                    .map(|path| format!("{path}/{name}"))
                    .collect();
                continue;
            }
            let mut deeper = Vec::new();
            for path in found {
                let (_, real) = self.place(&path)?;
                let entries = fs::read_dir(real).into_iter().flatten().flatten();
                let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
                let names = names.filter(|found| name.starts_with('.') || !found.starts_with('.'));
                let names = names.filter(|found| is_match(name, found));
                deeper.extend(names.map(|name| format!("{path}/{name}")));
            }
            found = deeper;
        }
        found.retain(|path| self.exists(path));
        found.sort_unstable();
        Ok(found)
    }
}

/// The folder that a first file may read: its package, or its own folder.
fn home(folder: &Path) -> Root {
    let above = folder.ancestors().take(MOST_FOLDERS_UP);
    let mut packages = above.filter_map(|folder| Some((folder, package_name(folder)?)));
    match packages.next() {
        Some((folder, name)) => Root {
            prefix: format!("{PACKAGE}{name}"),
            folder: folder.to_owned(),
        },
        None => Root {
            prefix: FOLDER.to_owned(),
            folder: folder.to_owned(),
        },
    }
}

/// The name in the `package.xml` of a folder.
fn package_name(folder: &Path) -> Option<String> {
    let file = folder.join("package.xml");
    if !file.is_file() {
        return None;
    }
    let text = load_text(&file).ok()?;
    let document = xml::parse(&text, &Positions::new(&text), "", &mut Errors::new())?;
    let mut children = document.root_element().children();
    let name = children.find(|child| child.has_tag_name("name"))?;
    Some(name.text()?.trim().to_owned())
}

/// The folder of a package near a folder: above it, in a folder above it, or one deeper.
fn near(folder: &Path, package: &str) -> Option<PathBuf> {
    let is_package = |folder: &PathBuf| folder.join("package.xml").is_file();
    folder.ancestors().take(MOST_FOLDERS_UP).find_map(|above| {
        let is_named = above.file_name().is_some_and(|name| name == package);
        if is_named || package_name(above).is_some_and(|name| name == package) {
            return Some(above.to_owned());
        }
        let beside = above.join(package);
        if is_package(&beside) {
            return Some(beside);
        }
        let entries = fs::read_dir(above).into_iter().flatten().flatten();
        let mut deeper: Vec<PathBuf> = entries.map(|entry| entry.path().join(package)).collect();
        deeper.sort_unstable();
        deeper.into_iter().find(is_package)
    })
}

/// True if a name fits a pattern of `*`, `?`, `[abc]`, `[a-z]` and `[!abc]`.
fn is_match(pattern: &str, name: &str) -> bool {
    let pattern: Vec<char> = pattern.chars().collect();
    let name: Vec<char> = name.chars().collect();
    let (mut p, mut n) = (0, 0);
    // The last star, and the first letter that it does not stand for.
    let mut star: Option<(usize, usize)> = None;
    loop {
        if pattern.get(p) == Some(&'*') {
            star = Some((p, n));
            p += 1;
            continue;
        }
        let next = name.get(n).and_then(|&letter| {
            let (is_one, length) = one(&pattern[p..], letter)?;
            is_one.then_some(p + length)
        });
        match (next, star) {
            (Some(next), _) => {
                p = next;
                n += 1;
            }
            (None, _) if n == name.len() && p == pattern.len() => return true,
            (None, Some((at, from))) if from < name.len() => {
                star = Some((at, from + 1));
                p = at + 1;
                n = from + 1;
            }
            _ => return false,
        }
    }
}

/// True if the beginning of a pattern stands for a letter, and its length.
fn one(pattern: &[char], letter: char) -> Option<(bool, usize)> {
    let first = pattern.first()?;
    let close = pattern.iter().skip(2).position(|&end| end == ']');
    match (first, close) {
        ('?', _) => Some((true, 1)),
        ('[', Some(close)) => {
            let inside = &pattern[1..close + 2];
            let (is_negated, inside) = match inside {
                ['!', rest @ ..] => (true, rest),
                all => (false, all),
            };
            let mut is_in = inside.contains(&letter);
            for range in inside.windows(3) {
                is_in |= range[1] == '-' && (range[0]..=range[2]).contains(&letter);
            }
            Some((is_in != is_negated, close + 3))
        }
        (literal, _) => Some((*literal == letter, 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_stand_for_names() {
        for (pattern, name, is) in [
            ("*.xacro", "arm.xacro", true),
            ("*.xacro", "arm.urdf", false),
            ("a?m*", "arm", true),
            ("a*b*c", "aXbYbZc", true),
            ("a*b", "a", false),
            ("[a-c]1", "b1", true),
            ("[!a-c]1", "b1", false),
            ("[xy]*", "z", false),
            ("*", "", true),
        ] {
            assert_eq!(is_match(pattern, name), is, "{pattern} {name}");
        }
    }
}
