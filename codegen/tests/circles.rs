//! Test that no file of this crate uses itself, directly or through others.
//!
//! In: the `use` declarations of all sources without their tests. Out: a failure if there is another cycle than that
//! of a graph and the handle to its nodes. A re-export is no use: a file that imports it uses the place where it is
//! defined. Paths within code are not followed.
#![cfg(feature = "files")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use syn::{Item, ItemUse, UseTree, Visibility};

/// A path from the root of the crate.
type Names = Vec<String>;

/// The uses that every file declares, by its path.
#[derive(Default)]
struct Crate {
    files: BTreeMap<Names, Vec<Names>>,
    /// The re-exports of a file: the path of the name there, and its origin.
    passed_on: BTreeMap<Names, Names>,
}

impl Crate {
    fn read(&mut self, path: &Path, names: &Names) {
        if names.last().is_some_and(|name| name == "tests") {
            return;
        }
        if let Ok(text) = fs::read_to_string(path.with_extension("rs")) {
            let file = syn::parse_file(&text).expect("it compiles");
            let mut uses = Vec::new();
            for item in &file.items {
                if let Item::Use(item) = item {
                    self.declare(item, names, &mut uses);
                }
            }
            self.files.insert(names.clone(), uses);
        }
        let Ok(entries) = fs::read_dir(path) else {
            return;
        };
        let entries = entries.map(|entry| entry.expect("readable").path().with_extension(""));
        for inside in entries.collect::<BTreeSet<_>>() {
            let name = inside.file_name().expect("a name").to_string_lossy();
            if !["lib", "main"].contains(&&*name) {
                self.read(&inside, &[names.clone(), vec![name.into_owned()]].concat());
            }
        }
    }

    fn declare(&mut self, item: &ItemUse, file: &Names, uses: &mut Vec<Names>) {
        let mut ends = Vec::new();
        walk(&item.tree, Vec::new(), &mut ends);
        for (written, name) in ends {
            let path = match written[0].as_str() {
                "crate" => written[1..].to_vec(),
                "self" | "super" => {
                    let up = written.iter().filter(|word| *word == "super").count();
                    let rest = written
                        .iter()
                        .skip_while(|word| ["self", "super"].contains(&word.as_str()));
                    [&file[..file.len() - up], &rest.cloned().collect::<Names>()].concat()
                }
                // A folder of the file's own, or another crate.
                _ => [file.clone(), written].concat(),
            };
            if matches!(item.vis, Visibility::Inherited) {
                uses.push(path);
            } else {
                let here = [file.clone(), vec![name]].concat();
                self.passed_on.insert(here, path);
            }
        }
    }

    /// The file in which a path ends.
    fn file_of(&self, path: &Names) -> Option<&Names> {
        let mut path = path.clone();
        // No name is re-exported more often than this.
        for _ in 0..8 {
            let Some(source) = self.passed_on.get(&path) else {
                break;
            };
            path.clone_from(source);
        }
        let prefixes = (1..=path.len()).rev().map(|length| path[..length].to_vec());
        let mut known = prefixes.filter_map(|prefix| self.files.get_key_value(&prefix));
        known.next().map(|(file, _)| file)
    }

    fn uses(&self, file: &Names) -> BTreeSet<&Names> {
        let used = self.files[file]
            .iter()
            .filter_map(|path| self.file_of(path));
        used.filter(|other| *other != file).collect()
    }

    /// All files that one uses, directly or through others.
    fn reached(&self, file: &Names) -> BTreeSet<&Names> {
        let mut reached = BTreeSet::new();
        let mut waiting: Vec<&Names> = self.uses(file).into_iter().collect();
        while let Some(next) = waiting.pop() {
            if reached.insert(next) {
                waiting.extend(self.uses(next));
            }
        }
        reached
    }
}

/// The paths of a `use`, each with the name that it imports.
fn walk(tree: &UseTree, mut path: Names, ends: &mut Vec<(Names, String)>) {
    match tree {
        UseTree::Path(inner) => {
            path.push(inner.ident.to_string());
            walk(&inner.tree, path, ends);
        }
        UseTree::Name(end) if end.ident == "self" => {
            let name = path.last().expect("self of something").clone();
            ends.push((path, name));
        }
        UseTree::Name(end) => {
            path.push(end.ident.to_string());
            ends.push((path, end.ident.to_string()));
        }
        UseTree::Rename(end) => {
            path.push(end.ident.to_string());
            ends.push((path, end.rename.to_string()));
        }
        UseTree::Glob(_) => ends.push((path, "*".to_owned())),
        UseTree::Group(group) => {
            for tree in &group.items {
                walk(tree, path.clone(), ends);
            }
        }
    }
}

#[test]
fn no_file_uses_itself_through_others() {
    let mut engine = Crate::default();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    engine.read(&source, &Vec::new());
    assert!(engine.files.len() > 100, "{}", engine.files.len());
    let circular = engine
        .files
        .keys()
        .filter(|file| engine.reached(file).contains(file));
    let circular: Vec<String> = circular.map(|file| file.join("::")).collect();
    assert_eq!(circular, ["expression::graph", "expression::term"]);
}
