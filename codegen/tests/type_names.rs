//! Test that no type name of this crate stands for more than three things.
//!
//! In: the sources without their tests. Out: a failure with the places of each name that more than three structs,
//! enums, unions, traits or aliases have, public or private. Associated types and types within functions are not
//! counted.
#![cfg(feature = "files")]

#[path = "sources/code.rs"]
mod sources;

use std::collections::BTreeMap;

use syn::{Ident, Item};

use sources::code;

/// Maximum number of types with one name.
const MOST: usize = 3;

/// The names of the types that items define, also within inline modules.
fn defined(items: &[Item]) -> Vec<&Ident> {
    let mut names = Vec::new();
    for item in items {
        match item {
            Item::Enum(item) => names.push(&item.ident),
            Item::Mod(item) => {
                names.extend(item.content.iter().flat_map(|(_, items)| defined(items)));
            }
            Item::Struct(item) => names.push(&item.ident),
            Item::Trait(item) => names.push(&item.ident),
            Item::Type(item) => names.push(&item.ident),
            Item::Union(item) => names.push(&item.ident),
            _ => {}
        }
    }
    names
}

#[test]
fn no_name_has_more_than_three_types() {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (within, lines) in code() {
        if within.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let text: Vec<&str> = lines.iter().map(|(_, line)| line.as_str()).collect();
        let file = syn::parse_file(&text.join("\n")).expect("it compiles");
        for name in defined(&file.items) {
            let (line, _) = &lines[name.span().start().line - 1];
            let place = format!("{}:{line}", within.display());
            places.entry(name.to_string()).or_default().push(place);
        }
    }
    assert!(places.len() > 300, "only {} names", places.len());
    let overused = places.iter().filter(|(_, places)| places.len() > MOST);
    let overused: Vec<String> = overused
        .map(|(name, places)| format!("{name}: {}", places.join(", ")))
        .collect();
    assert!(overused.is_empty(), "overused:\n{}", overused.join("\n"));
}

#[test]
fn types_of_all_kinds_are_found() {
    let text = "struct A; pub enum B {} trait C { type Output; } type D = A; union E { a: u8 } mod inner { struct F; }
        impl A { type Item = u8; } fn function() { struct Local; }";
    let file = syn::parse_file(text).expect("it parses");
    let names: Vec<String> = defined(&file.items)
        .into_iter()
        .map(Ident::to_string)
        .collect();
    assert_eq!(names, ["A", "B", "C", "D", "E", "F"]);
}
