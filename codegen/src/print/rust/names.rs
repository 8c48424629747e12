//! Names of Rust.
//!
//! In: texts. Out: reserved words, names of methods and types, identifiers.

use proc_macro2::{Ident, Span};

use crate::module::Module;
use crate::schedule::{Names, sanitize};

/// Private function of a struct for sine and cosine.
pub(super) const SIN_COS: &str = "sin_cos";

/// Names of a new scope.
pub(super) fn unscoped() -> Names {
    Names::beside(&KEYWORDS)
}

/// Names of all methods, in the order of the module, without clashes with other functions of the struct.
pub(in crate::print) fn of_methods(module: &Module) -> Vec<Ident> {
    let mut names = unscoped();
    names.take("chain");
    names.take(SIN_COS);
    let functions = module.functions.iter();
    functions
        .map(|generated| ident(&names.fresh(&generated.name())))
        .collect()
}

/// Name as a token.
pub(in crate::print) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// Text as the name of a type: `DoublePendulum` for `double pendulum`.
pub(in crate::print) fn type_name(text: &str) -> String {
    let words = sanitize(text);
    let words = words.split('_').map(|word| {
        let mut letters = word.chars();
        let first = letters.next().into_iter().flat_map(char::to_uppercase);
        first.chain(letters).collect::<String>()
    });
    let name: String = words.collect();
    unscoped().alone(&name)
}

/// Name of a type; a primitive type of Rust gets an underscore.
pub(super) fn of_type(name: Ident) -> Ident {
    if PRIMITIVE.contains(&&*name.to_string()) {
        return ident(&format!("{name}_"));
    }
    in_every_edition(name)
}

/// The same name, raw if an edition reserves it.
pub(crate) fn in_every_edition(name: Ident) -> Ident {
    let text = name.to_string();
    if KEYWORDS.contains(&&*text) {
        Ident::new_raw(&text, name.span())
    } else {
        name
    }
}

/// Primitive types of Rust.
const PRIMITIVE: [&str; 17] = [
    "bool", "char", "f32", "f64", "i128", "i16", "i32", "i64", "i8", "isize", "str", "u128", "u16",
    "u32", "u64", "u8", "usize",
];

/// Reserved words of all editions up to 2024.
#[rustfmt::skip]
pub(in crate::print) const KEYWORDS: [&str; 54] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "Self", "self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "union", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "_",
];

#[cfg(test)]
mod tests {
    use super::{type_name, unscoped};

    #[test]
    fn ambiguous_and_invisible_letters_are_replaced() {
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
}
