//! The page `checklist.md` of the documentation: every row has tests that use its items.
//!
//! In: the page, and the sources of this crate, of its tests and of the programs that use it. The tests fail
//! unless every item of a row exists, every test of a row runs, and each item is used in a test of the row, or in
//! functions of the same module that the test calls. The list of mutations shows that the tests notice mistakes.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const PAGE: &str = include_str!("../../src/checklist.md");

/// The cells of each row of each table, without headers.
fn rows() -> Vec<Vec<&'static str>> {
    PAGE.lines()
        .filter(|line| line.starts_with("| "))
        .map(|line| {
            line.trim_matches('|')
                .split('|')
                .map(str::trim)
                .collect::<Vec<_>>()
        })
        .filter(|cells| cells.last() != Some(&"proved by"))
        .collect()
}

/// Paths in backquotes.
fn names(cell: &str) -> Vec<&str> {
    cell.split('`')
        .skip(1)
        .step_by(2)
        .filter(|name| !["serde", "approx", "TryFrom", "From"].contains(name))
        .collect()
}

/// The items and the tests of a row.
fn items_and_tests(row: &[&'static str]) -> (Vec<&'static str>, Vec<&'static str>) {
    let [.., items, tests] = row else {
        panic!("a row of {} cells: {row:?}", row.len());
    };
    (names(items), names(tests))
}

/// A file of Rust.
struct Source {
    /// Its name without the extension.
    module: String,
    text: String,
}

/// The sources in folders beside `Cargo.toml`, and in the folders in them.
fn sources(folders: &[&str]) -> Vec<Source> {
    let beside = |folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut folders: Vec<PathBuf> = folders.iter().map(beside).collect();
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let module = path.file_stem().and_then(|stem| stem.to_str());
                sources.push(Source {
                    module: module.expect("a name").to_owned(),
                    text: fs::read_to_string(&path).expect("readable"),
                });
            }
        }
    }
    sources
}

/// The folders of a test, by the package at the start of its name, and the rest of the name.
fn place_of(test: &str) -> (&'static [&'static str], &str) {
    match test.split_once("::") {
        Some(("examples", rest)) => (&["../examples/src/bin", "../examples/tests"], rest),
        Some(("engine", rest)) => (&["../tests/tests/output"], rest),
        _ => (&["tests/paper", "tests/chains"], test),
    }
}

/// The file and the function of a test.
fn find(test: &str) -> (Source, &str) {
    let (folders, rest) = place_of(test);
    let (module, function) = rest.split_once("::").expect("module::function");
    let sources = sources(folders);
    // A file without `mod` in a `main.rs`, or in the file of its folder, is not compiled; programs are files of their own.
    let mut roots = sources
        .iter()
        .filter(|source| ["main", "names"].contains(&source.module.as_str()));
    let is_compiled = test.starts_with("examples::")
        || roots.any(|root| declares(&root.text, &["mod"], &format!("{module};")));
    let found = sources.into_iter().find(|s| s.module == module);
    let source = found.filter(|_| is_compiled);
    (
        source.unwrap_or_else(|| panic!("`{test}`: there is no module of that name")),
        function,
    )
}

/// The positions of a whole word in a text.
fn words<'t>(text: &'t str, word: &'t str) -> impl Iterator<Item = usize> + 't {
    let joins = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(word)
        .map(|(at, _)| at)
        .filter(move |at| {
            let before = text[..*at].chars().next_back();
            let after = text[at + word.len()..].chars().next();
            !before.is_some_and(joins) && !after.is_some_and(joins)
        })
}

fn declares(text: &str, kinds: &[&str], name: &str) -> bool {
    kinds
        .iter()
        .any(|kind| words(text, &format!("{kind} {name}")).next().is_some())
}

impl Source {
    /// The lines of a function without comments, down to the closing brace at the indentation of its head.
    fn body(&self, function: &str) -> Option<String> {
        let is_head = |line: &&str| {
            let head = line.trim_start().trim_start_matches("pub ");
            let head = head.trim_start_matches("const ");
            head.starts_with("fn ") && words(head, function).next() == Some(3)
        };
        let mut lines = self.text.lines().skip_while(|line| !is_head(line));
        let head = lines.next()?;
        let indent = &head[..head.len() - head.trim_start().len()];
        let end = format!("{indent}}}");
        let code = lines
            .take_while(|line| *line != end)
            .filter(|line| !line.trim_start().starts_with("//"));
        Some(code.collect::<Vec<_>>().join("\n"))
    }

    /// The functions that the file declares.
    fn functions(&self) -> BTreeSet<&str> {
        let heads = self.text.split("fn ").skip(1);
        let name = |head: &'_ str| {
            head.find(|c: char| !c.is_alphanumeric() && c != '_')
                .map_or(0, |end| end)
        };
        heads
            .map(|head| &head[..name(head)])
            .filter(|name| !name.is_empty())
            .collect()
    }

    /// The code of a function and of the functions of this file that it calls, directly or not.
    fn reach(&self, function: &str) -> Option<String> {
        let mut all = self.body(function)?;
        let mut reached = BTreeSet::from([function]);
        loop {
            let next = self
                .functions()
                .into_iter()
                .find(|name| !reached.contains(name) && calls(&all, name));
            let Some(name) = next else {
                return Some(all);
            };
            reached.insert(name);
            all += &self.body(name).unwrap_or_default();
        }
    }

    /// True if code calls a function of a program, outside the tests at its end.
    fn runs_the_program(&self, code: &str) -> bool {
        let program = Self {
            module: self.module.clone(),
            text: self
                .text
                .split("mod tests {")
                .next()
                .unwrap_or("")
                .to_owned(),
        };
        let mut functions = program.functions().into_iter();
        functions.any(|name| calls(code, name) || code.contains(&format!(".{name}(")))
    }

    /// True if cargo runs a test of this name.
    fn runs(&self, function: &str) -> bool {
        let listed = self.text.split("in_both_precisions! {").nth(1);
        let listed = listed.is_some_and(|list| list.split_whitespace().any(|w| w == function));
        let marked = ["", "_f32", "_f64"].iter().any(|suffix| {
            let heads = ["fn", "    fn"].map(|fun| format!("#[test]\n{fun} {function}{suffix}()"));
            heads.iter().any(|head| self.text.contains(head))
        });
        listed || marked
    }
}

/// True if a text calls a function, or has it as a value behind a path.
fn calls(text: &str, name: &str) -> bool {
    words(text, name).any(|at| {
        let behind = &text[at + name.len()..];
        behind.starts_with('(') || behind.starts_with("::<") || text[..at].ends_with("::")
    })
}

/// True if code uses an item: a type by its name, a function or method by a call. If the module has a function of
/// the same name itself, the call must have a path.
fn uses(source: &Source, code: &str, item: &str) -> bool {
    let name = item.rsplit("::").next().unwrap_or(item);
    if name.starts_with(char::is_uppercase) {
        return words(code, name).next().is_some();
    }
    if source.functions().contains(name) {
        let parts: Vec<&str> = item.split("::").collect();
        let path = parts[parts.len().saturating_sub(2)..].join("::");
        return calls(code, &path) || code.contains(&format!(".{name}("));
    }
    calls(code, name)
}

/// True if a module re-exports a function of another file, by name or with all others of that file.
fn passes_on(text: &str, item: &str, sources: &[Source]) -> bool {
    let mut lists = text.split("pub use ").skip(1);
    lists.any(|rest| {
        let list = rest.split(';').next().unwrap_or(rest);
        match list.strip_suffix("::*") {
            Some(path) => {
                let module = path.rsplit("::").next().unwrap_or(path);
                let mut files = sources.iter().filter(|source| source.module == module);
                files.any(|source| declares(&source.text, &["pub fn"], item))
            }
            None => words(list, item).next().is_some(),
        }
    })
}

#[test]
fn every_row_names_an_item_and_a_test() {
    let rows = rows();
    assert!(rows.len() > 100, "only {} rows", rows.len());
    for row in rows {
        let (_, tests) = items_and_tests(&row);
        let item = row[row.len() - 2];
        assert!(!item.is_empty() && !tests.is_empty(), "{row:?}");
    }
}

#[test]
fn every_item_exists() {
    let sources = sources(&["src"]);
    let programs = self::sources(&["../examples/src/bin"]);
    let all: String = sources.iter().map(|source| source.text.as_str()).collect();
    let types = ["pub struct", "pub enum", "pub trait", "pub mod"];
    let functions = ["pub fn", "pub const fn"];
    for row in rows() {
        for name in items_and_tests(&row).0 {
            let parts: Vec<&str> = name.split("::").collect();
            let found = match parts.as_slice() {
                [single] => declares(&all, &types, single),
                ["examples", program] => programs.iter().any(|source| source.module == *program),
                [.., owner, item] if owner.starts_with(char::is_uppercase) => {
                    // A method: in a file that implements its type.
                    declares(&all, &types, owner)
                        && sources.iter().any(|source| {
                            [" {owner}<T> {", " {owner}<N, F, Q, B> {", "impl {owner} {"]
                                .iter()
                                .any(|head| source.text.contains(&head.replace("{owner}", owner)))
                                && declares(&source.text, &functions, item)
                        })
                }
                [module, item] => sources.iter().any(|source| {
                    source.module == *module
                        && (declares(&source.text, &functions, item)
                            || declares(&source.text, &types, item)
                            || passes_on(&source.text, item, &sources)
                                && declares(&all, &functions, item))
                }),
                _ => false,
            };
            assert!(found, "`{name}` is in the table and not in the crate");
        }
    }
}

#[test]
fn every_test_runs_and_uses_what_its_row_names() {
    let mut wrong = Vec::new();
    for row in rows() {
        let (items, tests) = items_and_tests(&row);
        let mut unused: BTreeSet<&str> = items.into_iter().collect();
        for test in tests {
            let (source, function) = find(test);
            let suffixed = ["", "_f64"].map(|suffix| format!("{function}{suffix}"));
            let code = suffixed.iter().find_map(|name| source.reach(name));
            let Some(code) = code.filter(|_| source.runs(function)) else {
                wrong.push(format!("`{test}` is never run"));
                continue;
            };
            unused.retain(|item| match item.strip_prefix("examples::") {
                Some(program) => source.module != program || !source.runs_the_program(&code),
                None => !uses(&source, &code, item),
            });
        }
        for item in unused {
            wrong.push(format!("`{item}` is used by no test of the row {}", row[0]));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Conversely, every test is in the table, so that each property can be found.
#[test]
fn every_test_is_in_the_table() {
    let named: BTreeSet<String> = rows()
        .iter()
        .flat_map(|row| items_and_tests(row).1)
        .map(str::to_owned)
        .collect();
    for Source { module, text } in sources(&["tests/paper"]) {
        let Some(list) = text.split("in_both_precisions! {\n").nth(1) else {
            continue;
        };
        for function in list.split('}').next().unwrap_or("").split_whitespace() {
            let name = format!("{module}::{function}");
            assert!(
                module == "main" || named.contains(&name),
                "`{name}` is not in the table"
            );
        }
    }
}

/// Each historical name of SPACELIB is on the page.
#[test]
fn every_historical_name_is_mapped() {
    let names = "dhtom DHtoMstd extract mtoscrew screwtom rotat* traslat* gtom Gtomegapto makeL makeL2 WtoL Wtovel \
        velacctoWH* coriolis jtoJ actom psedot dyn_eq trac_ljlt4 skew normal* norm_simm_skew n_simm* \
        n_skew* trasf_mami trasf_miam trasf_mamt trasf_miamit invers mtov vtom frameP frame4P frameV \
        frame4V axis angle dist intermediate middle vect line2p linepvect intersection projponl distpp \
        project plane plane2 inters2pl interslpl solve minvers linear";
    for name in names.split_whitespace() {
        assert!(PAGE.contains(&format!("`{name}`")), "{name} is not mapped");
    }
}
