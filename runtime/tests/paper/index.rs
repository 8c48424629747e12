//! The page `checklist.md` of the documentation: what it names must exist.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const PAGE: &str = include_str!("../../src/checklist.md");

/// The cells of each row of each table, header and rule left out.
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

/// What stands in backquotes and looks like a path.
fn names(cell: &str) -> Vec<&str> {
    cell.split('`')
        .skip(1)
        .step_by(2)
        .filter(|name| !["serde", "approx", "TryFrom", "From"].contains(name))
        .collect()
}

/// All source text in `folders`, by the name of its file.
fn sources(folders: &[&str]) -> Vec<(String, String)> {
    let files = folders.iter().flat_map(|folder| {
        let folder: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        fs::read_dir(folder).expect("the folder is there")
    });
    files
        .filter_map(|entry| {
            let path = entry.expect("readable").path();
            let stem = path.file_stem()?.to_str()?.to_owned();
            let text = fs::read_to_string(&path).ok()?;
            (path.extension()? == "rs").then_some((stem, text))
        })
        .collect()
}

fn declares(text: &str, kinds: &[&str], name: &str) -> bool {
    kinds.iter().any(|kind| {
        let head = format!("{kind} {name}");
        text.match_indices(&head).any(|(at, _)| {
            let next = text[at + head.len()..].chars().next();
            next.is_none_or(|c| !c.is_alphanumeric() && c != '_')
        })
    })
}

#[test]
fn every_row_names_an_item_and_a_test() {
    let rows = rows();
    assert!(rows.len() > 100, "only {} rows", rows.len());
    for row in rows {
        let [.., item, tests] = row.as_slice() else {
            panic!("a row of {} cells: {row:?}", row.len());
        };
        assert!(!item.is_empty() && !names(tests).is_empty(), "{row:?}");
    }
}

#[test]
fn every_item_exists() {
    let sources = sources(&["src", "src/worked_examples"]);
    let all: String = sources.iter().map(|(_, text)| text.as_str()).collect();
    for row in rows() {
        for name in names(row[row.len() - 2]) {
            let parts: Vec<&str> = name.split("::").collect();
            let types = ["pub struct", "pub enum", "pub trait", "pub mod"];
            let functions = ["pub fn", "pub const fn"];
            let found = match parts.as_slice() {
                [single] => declares(&all, &types, single),
                [.., owner, item] if owner.starts_with(char::is_uppercase) => {
                    // A method: in a file that implements its type.
                    declares(&all, &types, owner)
                        && sources.iter().any(|(_, text)| {
                            [" {owner}<T> {", " {owner}<N, F> {"]
                                .iter()
                                .any(|head| text.contains(&head.replace("{owner}", owner)))
                                && declares(text, &functions, item)
                        })
                }
                [module, item] => sources.iter().any(|(stem, text)| {
                    stem == module
                        && (declares(text, &functions, item) || declares(text, &types, item))
                }),
                _ => false,
            };
            assert!(found, "`{name}` is in the table and not in the crate");
        }
    }
}

#[test]
fn every_test_exists() {
    let sources = sources(&["tests/paper", "tests/chains"]);
    for row in rows() {
        for name in names(row[row.len() - 1]) {
            let (module, function) = name.split_once("::").expect("module::function");
            let text = sources
                .iter()
                .find(|(stem, _)| stem == module)
                .map(|(_, text)| text);
            let text = text.unwrap_or_else(|| panic!("no module `{module}` of tests"));
            let listed = text
                .split("in_both_precisions! {")
                .nth(1)
                .is_some_and(|list| list.split_whitespace().any(|word| word == function));
            let single = ["", "_f32", "_f64"]
                .iter()
                .any(|suffix| text.contains(&format!("#[test]\nfn {function}{suffix}()")));
            assert!(
                declares(text, &["fn"], function) || single,
                "`{name}` does not exist"
            );
            assert!(listed || single, "`{name}` is never run");
        }
    }
}

/// The other way round: a property that nobody finds from the table is as good as lost.
#[test]
fn every_test_is_in_the_table() {
    let named: BTreeSet<String> = rows()
        .iter()
        .flat_map(|row| names(row[row.len() - 1]))
        .map(str::to_owned)
        .collect();
    for (module, text) in sources(&["tests/paper"]) {
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

/// Each historical name of the checklist's groups is found on the page.
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
