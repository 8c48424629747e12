//! The statements of the README, compared with the project.
//!
//! In: the README, the guide and the project's files. The tests check that the program of the README is the one that
//! runs, that its excerpt of generated code is current, and that every linked file exists. Documentation tests compile
//! its blocks of Rust.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use homogen_codegen::Function;
use homogen_examples::listing;

const README: &str = include_str!("../../README.md");
const FIRST_ROBOT: &str = include_str!("../../guide/src/first-robot.md");

/// The largest number of words of the README.
const MOST_WORDS: usize = 1000;

#[test]
fn it_is_short() {
    let words = README.split_whitespace().count();
    assert!(words <= MOST_WORDS, "{words} words");
}

/// The URDF file of the program is a copy beside `Cargo.toml`.
#[test]
fn the_program_is_the_one_that_runs() {
    let program = include_str!("../src/bin/quick_start.rs");
    let code = program.lines().filter(|line| !line.starts_with("//!"));
    let code: Vec<_> = code.skip_while(|line| line.is_empty()).collect();
    let code = code
        .join("\n")
        .replace("../robots/panda_class.urdf", "arm.urdf");
    for page in [README, FIRST_ROBOT] {
        assert_contains(page, &format!("```rust,ignore\n{code}\n```\n"));
    }
}

#[test]
fn the_excerpt_is_what_the_code_generator_prints() {
    let (_, rest) = README
        .split_once("<!-- two links -->\n")
        .expect("it is there");
    let (_, rest) = rest.split_once("```rust,ignore\n").expect("a block");
    let (excerpt, _) = rest.split_once("```\n").expect("its end");
    let printed = listing::inverse_dynamics_of_two_links().expect("it is valid");
    assert!(printed.contains(excerpt), "{excerpt}\nis not in\n{printed}");
    let operation_count = printed
        .lines()
        .find(|line| line.contains(" mul, "))
        .expect("an operation count");
    assert!(
        operation_count.contains("17 mul, 10 add"),
        "{operation_count}"
    );
    assert_contains(README, "of 17 multiplications and 10 additions");
}

#[test]
fn functions_are_counted() {
    let all = Function::every().count();
    assert_contains(
        README,
        &format!("[{all} functions](guide/src/functions.md)"),
    );
}

/// Files that the README and pages of the guide link to.
#[test]
fn linked_files_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let chapters = fs::read_dir(root.join("guide/src")).expect("the folder is there");
    let chapters = chapters.map(|entry| entry.expect("readable").path());
    let pages = chapters.chain(["README.md", "CONTRIBUTING.md"].map(|name| root.join(name)));
    let mut missing = String::new();
    for page in pages {
        let text = fs::read_to_string(&page).expect("text");
        let folder = page.parent().expect("a folder");
        let links = (text.split("](").skip(1)).filter_map(|rest| rest.split(')').next());
        let links = links.filter(|link| !link.starts_with('#') && !link.contains("://"));
        let links = links.map(|link| folder.join(link.split('#').next().unwrap_or_default()));
        let programs = text.split("--bin ").skip(1);
        let programs = programs.filter_map(|rest| rest.split_whitespace().next());
        // An example is one file; a test is a file or a folder.
        let programs = programs.map(|name| match name.trim_matches('`') {
            "homogen" => "cli/src/main.rs".to_owned(),
            "NAME" => "examples/src/bin".to_owned(),
            name @ "mutations" => format!("tests/src/bin/{name}/main.rs"),
            name @ ("fire" | "trees") => format!("tests/src/bin/{name}.rs"),
            name => format!("examples/src/bin/{name}.rs"),
        });
        for path in links.chain(programs.map(|path| root.join(path))) {
            if !path.exists() {
                // Writing to a string cannot fail.
                let _ = writeln!(missing, "{}: {}", page.display(), path.display());
            }
        }
    }
    assert_eq!(missing, "");
}

fn assert_contains(page: &str, part: &str) {
    assert!(page.contains(part), "the page lacks\n{part}");
}
