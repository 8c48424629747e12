//! Completeness of pages: those of the macros explain every word of the readers; those of the guide list the elements of
//! URDF and MJCF and the options.
//!
//! In: the pages, and the lists of the readers themselves. Out: nothing where each word is told, and where it
//! describes a robot or asks for something stands in an example that is compiled; else the words that are
//! missing. The guide's tables are rewritten where `HOMOGEN_UPDATE` is set.

use homogen_codegen::description::words::{GrammarPlace, words};
use homogen_codegen::description::{mjcf, sdf, urdf};
use homogen_codegen::request::setting;

const DERIVE: &str = include_str!("../src/derive.md");
const CHAIN: &str = include_str!("../src/chain.md");

/// The page that explains the words of a place.
fn page(place: GrammarPlace) -> &'static str {
    match place {
        GrammarPlace::Robot
        | GrammarPlace::Field
        | GrammarPlace::Column
        | GrammarPlace::Function
        | GrammarPlace::Scalar
        | GrammarPlace::Formulation
        | GrammarPlace::Processor => DERIVE,
        GrammarPlace::Link
        | GrammarPlace::Joint
        | GrammarPlace::JointType
        | GrammarPlace::Step
        | GrammarPlace::Loop
        | GrammarPlace::LoopType
        | GrammarPlace::Row => CHAIN,
    }
}

/// True for places whose words each need an example; names chosen from a list do not.
fn is_shown(place: GrammarPlace) -> bool {
    let chosen = [
        GrammarPlace::Column,
        GrammarPlace::Function,
        GrammarPlace::Scalar,
        GrammarPlace::LoopType,
        GrammarPlace::Formulation,
        GrammarPlace::Processor,
    ];
    !chosen.contains(&place)
}

/// The words of a text, in which `cortex-m4` is one.
fn words_of(text: &str) -> Vec<&str> {
    let splits = |c: char| !(c.is_alphanumeric() || c == '_' || c == '-');
    let words = text.split(splits).map(|word| word.trim_start_matches('-'));
    words.collect()
}

/// The text between backquotes, and the blocks of code that are compiled.
fn prose_and_compiled(page: &str) -> (String, String) {
    let (mut prose, mut compiled) = (String::new(), String::new());
    let mut block: Option<&str> = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), block) {
            (Some(kind), None) => block = Some(kind),
            (Some(_), Some(_)) => block = None,
            (None, Some("")) => compiled.extend([line, "\n"]),
            (None, Some(_)) => {}
            (None, None) => {
                prose.extend(line.split('`').skip(1).step_by(2).flat_map(|x| [x, "\n"]));
            }
        }
    }
    (prose, compiled)
}

#[test]
fn every_word_is_explained_and_shown() {
    let mut missing = Vec::new();
    for (place, known) in words() {
        assert!(!known.is_empty(), "{place:?}");
        let (prose, compiled) = prose_and_compiled(page(place));
        let (prose, compiled) = (words_of(&prose), words_of(&compiled));
        for word in known {
            if !prose.contains(&word) {
                missing.push(format!("{place:?}: `{word}` is not told"));
            }
            if is_shown(place) && !compiled.contains(&word) {
                missing.push(format!("{place:?}: no example of `{word}`"));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn the_guide_shows_the_tables() {
    for (page, table) in [
        (
            "what-is-read.md",
            format!(
                "{}# Elements of MJCF\n\n{}# Elements of SDF\n\n{}",
                urdf::page(),
                mjcf::page(),
                sdf::page()
            ),
        ),
        ("command-line.md", setting::page()),
    ] {
        let path = format!("{}/../guide/src/{page}", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).expect("the page");
        let mark = "<!-- table -->\n";
        let (before, found) = text.split_once(mark).expect("a mark before the table");
        let wanted = format!("\n{table}");
        if std::env::var_os("HOMOGEN_UPDATE").is_some() {
            std::fs::write(&path, format!("{before}{mark}{wanted}"))
                .expect("a page that can be written");
            continue;
        }
        let differ = found
            .lines()
            .zip(wanted.lines())
            .find(|(found, wanted)| found != wanted);
        assert!(
            found == wanted,
            "{page}: {differ:?}: run HOMOGEN_UPDATE=1 cargo test -p homogen-macros --test pages"
        );
    }
}
