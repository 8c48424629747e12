//! Names that Rust takes.
//!
//! In: the struct that functions are methods of, or a text. Out: the names that its functions cannot
//! have, and identifiers. It never decides which of two things keeps the name that both would like.

use proc_macro2::{Ident, Span};
use syn::GenericParam;
use syn::ext::IdentExt;

use super::Item;
use crate::schedule::{Names, sanitize};

/// Names in a scope of their own.
pub(super) fn unscoped() -> Names {
    Names::beside(&KEYWORDS)
}

/// Names beside those of the user's struct, which in a pattern would be taken for its only value,
/// and of its generic parameters.
pub(super) fn beside(item: &Item) -> Names {
    let mut names = unscoped();
    let mut take = |ident: &Ident| names.take(&ident.unraw().to_string());
    take(&item.ident);
    for parameter in &item.generics.params {
        match parameter {
            GenericParam::Type(parameter) => take(&parameter.ident),
            GenericParam::Const(parameter) => take(&parameter.ident),
            // Lifetimes have a namespace of their own.
            GenericParam::Lifetime(_) => {}
        }
    }
    names
}

/// A name as a token.
pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// A text as the name of a type: `double pendulum` is `DoublePendulum`.
#[must_use]
pub fn type_name(text: &str) -> String {
    let words = sanitize(text);
    let words = words.split('_').map(|word| {
        let mut letters = word.chars();
        let first = letters.next().into_iter().flat_map(char::to_uppercase);
        first.chain(letters).collect::<String>()
    });
    let name: String = words.collect();
    unscoped().alone(&name)
}

/// Reserved words of all editions up to 2024.
#[rustfmt::skip]
pub(super) const KEYWORDS: [&str; 54] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "Self", "self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "union", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "_",
];

#[cfg(test)]
mod tests {
    use super::{Item, beside, type_name, unscoped};
    use syn::parse_quote;

    #[test]
    fn letters_that_look_like_others_or_like_nothing_are_no_part_of_a_name() {
        let wishes = [
            "a\u{430}",
            "fi\u{fb01}",
            "\u{f900}",
            "\u{1f71}b",
            "\u{3164}",
            "\u{200d}x\u{202e}",
            "e\u{301}",
            "機器人",
            "각",
            "\u{1100}\u{1161}\u{11a8}",
            "ŉſŀĳ9",
            "İ",
        ];
        let mut names = unscoped();
        let names = wishes.map(|wish| names.fresh(wish));
        assert_eq!(
            names,
            [
                "a",
                "fi",
                "unnamed",
                "b",
                "unnamed_",
                "x",
                "e",
                "機器人",
                "각",
                "unnamed__",
                "n9",
                "i"
            ]
        );
        for name in names {
            assert!(syn::parse_str::<syn::Ident>(&name).is_ok(), "{name}");
        }
    }

    #[test]
    fn types_have_names_of_their_own() {
        let names = ["panda", "double pendulum", "ur5e-robot", "2nd", "self", ""];
        assert_eq!(
            names.map(type_name),
            [
                "Panda",
                "DoublePendulum",
                "Ur5eRobot",
                "N2nd",
                "Self_",
                "Unnamed"
            ]
        );
    }

    #[test]
    fn the_struct_and_its_generic_parameters_are_left_alone() {
        let item: syn::DeriveInput = parse_quote! { struct k<'t_1, T, const q_1: usize>; };
        let mut names = beside(&Item::derived(&item));
        let found = ["q_1", "t_1", "k"].map(|wish| names.fresh(wish));
        assert_eq!(found, ["q_1_", "t_1", "k_"]);
        assert_eq!(names.alone("T"), "T_");
        let item: syn::DeriveInput = parse_quote! { struct T; };
        assert_eq!(beside(&Item::derived(&item)).alone("T"), "T_");
    }
}
