//! Names that C takes.
//!
//! In: texts. Out: the words that nothing can be called, how names begin, names of functions and of the
//! entries of a space. It never names a value.

use crate::print::Listing;
use crate::schedule::{Names, sanitize};
use crate::space::{Space, Spaces};

/// Names in a scope of their own.
pub(super) fn unscoped() -> Names {
    Names::beside(&KEYWORDS)
}

/// How the names of a robot begin: `double pendulum` is `double_pendulum_`.
pub(super) fn prefix(robot: &str) -> String {
    let name = ascii(&sanitize(robot));
    // Names that begin with an underscore are those of the compiler.
    let letter = if name.starts_with('_') { "n" } else { "" };
    format!("{letter}{name}_")
}

/// The names of the functions behind a prefix, in ASCII, which linkers want.
pub(in crate::print) fn symbols(listing: &Listing, prefix: &str) -> Vec<String> {
    let mut names = Names::default();
    let listed = listing.functions.iter();
    listed
        .map(|listed| format!("{prefix}{}", names.fresh(&ascii(&listed.name()))))
        .collect()
}

/// The text with an underscore for every character that not every compiler takes in a name.
pub(super) fn ascii(text: &str) -> String {
    text.replace(|letter: char| !letter.is_ascii(), "_")
}

/// The names of the entries of a space behind a prefix, in capitals.
pub(super) fn constants(spaces: &Spaces, space: Space, prefix: &str) -> Vec<String> {
    let mut names = Names::default();
    let entries = spaces.names(space);
    entries
        .map(|name| format!("{prefix}{}", names.fresh(&ascii(name))).to_uppercase())
        .collect()
}

/// Words that C or C++ reserves, or Rust, which calls the fields alike; two that common compilers
/// define; and the macros of the files.
#[rustfmt::skip]
const KEYWORDS: [&str; 137] = [
    "abstract", "alignas", "alignof", "and", "and_eq", "as", "asm", "async", "auto", "await",
    "become", "bitand", "bitor", "bool", "box", "break", "case", "catch", "char", "char16_t",
    "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
    "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "crate", "decltype",
    "default", "delete", "do", "double", "dyn", "dynamic_cast", "else", "enum", "explicit",
    "export", "extern", "false", "final", "float", "fn", "for", "friend", "gen", "goto", "if",
    "impl", "in", "inline", "int", "let", "long", "loop", "macro", "match", "mod", "move", "mut",
    "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or",
    "or_eq", "override", "priv", "private", "protected", "pub", "public", "ref", "register",
    "reinterpret_cast", "requires", "restrict", "return", "Self", "self", "short", "signed",
    "sizeof", "static", "static_assert", "static_cast", "struct", "super", "switch", "template",
    "this", "thread_local", "throw", "trait", "true", "try", "type", "typedef", "typeid",
    "typename", "typeof", "typeof_unqual", "union", "unsafe", "unsigned", "unsized", "use", "using",
    "virtual", "void", "volatile", "wchar_t", "where", "while", "xor", "xor_eq", "yield", "linux",
    "unix", "HOMOGEN_FMA", "HOMOGEN_FMAF", "HOMOGEN_FN", "_Bool", "_Complex", "_Imaginary",
];

#[cfg(test)]
mod tests {
    use super::prefix;

    #[test]
    fn names_begin_with_a_letter_and_are_ascii() {
        let robots = [
            "double pendulum",
            "UR5e",
            "2nd",
            "\u{6a5f}\u{5668}",
            "",
            "*/",
        ];
        assert_eq!(
            robots.map(prefix),
            [
                "double_pendulum_",
                "ur5e_",
                "n2nd_",
                "n___",
                "unnamed_",
                "unnamed_"
            ]
        );
    }
}
