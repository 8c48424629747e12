//! Names that cannot clash.
//!
//! In: the name that a reader would like to see. Out: an identifier that is no keyword and that
//! nothing else in the same scope has. It never invents a name that was not wished for: it appends
//! underscores.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span};
use syn::GenericParam;
use syn::ext::IdentExt;

use super::Item;

/// The names of one scope.
#[derive(Clone, Debug, Default)]
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// Names beside those of the user's struct, which in a pattern would be taken for its only value,
    /// and of its generic parameters.
    pub fn beside(item: &Item) -> Self {
        let mut names = Self::default();
        names.take_ident(&item.ident);
        for parameter in &item.generics.params {
            match parameter {
                GenericParam::Type(parameter) => names.take_ident(&parameter.ident),
                GenericParam::Const(parameter) => names.take_ident(&parameter.ident),
                // Lifetimes have a namespace of their own.
                GenericParam::Lifetime(_) => {}
            }
        }
        names
    }

    /// Keeps a name from being given away.
    pub fn take(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    fn take_ident(&mut self, ident: &Ident) {
        self.take(&ident.unraw().to_string());
    }

    /// The name wished for, in the alphabet of identifiers, with as many underscores behind it as
    /// it takes to be alone.
    pub fn fresh(&mut self, wish: &str) -> Ident {
        self.alone(sanitize(wish))
    }

    /// The same for a type parameter, whose letters stay as they are.
    pub fn fresh_type(&mut self, wish: &str) -> Ident {
        self.alone(wish.to_owned())
    }

    fn alone(&mut self, mut name: String) -> Ident {
        while self.taken.contains(&name) || is_keyword(&name) {
            name.push('_');
        }
        let ident = Ident::new(&name, Span::call_site());
        self.taken.insert(name);
        ident
    }
}

/// A text as an identifier: lower case, with one underscore for every run of what no identifier
/// can hold. It may be a keyword.
fn sanitize(text: &str) -> String {
    let mut name = String::with_capacity(text.len());
    for letter in text.chars().flat_map(char::to_lowercase) {
        if is_continue(letter) {
            name.push(letter);
        } else if !name.ends_with('_') {
            name.push('_');
        }
    }
    let trimmed = name.trim_matches('_');
    // Whatever may continue a name may follow a letter.
    let prefix = match trimmed.chars().next() {
        Some(first) if first.is_alphabetic() => "",
        Some(_) => "n",
        None => "unnamed",
    };
    format!("{prefix}{trimmed}")
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
    if is_keyword(&name) {
        format!("{name}_")
    } else {
        name
    }
}

/// Whether a letter other than the underscore may stand within an identifier: those of Latin script,
/// Chinese characters, Japanese kana, Korean syllables. Of other scripts many look like one of those,
/// have no width, or are the same letter in two encodings, which the compiler takes for one.
fn is_continue(letter: char) -> bool {
    match letter {
        // Ligatures, and letters that stand for two others.
        '×' | '÷' | 'ĳ' | 'ŀ' | 'ŉ' | 'ſ' => false,
        'ß'..='ž' | 'ぁ'..='ゖ' | 'ァ'..='ヺ' | '一'..='鿿' | '가'..='힣' => true,
        letter => letter.is_ascii_alphanumeric(),
    }
}

/// Whether Rust reserves the word.
pub(super) fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name)
}

/// Reserved words of all editions up to 2024.
#[rustfmt::skip]
const KEYWORDS: [&str; 54] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "Self", "self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "union", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "_",
];

#[cfg(test)]
mod tests {
    use super::{Item, Names, type_name};
    use proc_macro2::Ident;
    use syn::parse_quote;

    fn fresh(names: &mut Names, wishes: &[&str]) -> Vec<String> {
        let idents = wishes.iter().map(|wish| names.fresh(wish));
        idents.map(|ident: Ident| ident.to_string()).collect()
    }

    #[test]
    fn no_two_are_equal() {
        let mut names = Names::default();
        assert_eq!(
            fresh(&mut names, &["m_0_3", "m_0_3", "m_0_3_", "M-0-3"]),
            ["m_0_3", "m_0_3_", "m_0_3__", "m_0_3___"]
        );
    }

    #[test]
    fn none_is_a_keyword_or_no_name_at_all() {
        let wishes = [
            "fn",
            "gen",
            "self",
            "Self",
            "",
            "—",
            "2nd",
            "a  b",
            "_x",
            "Kamera-öse",
            "x²",
        ];
        assert_eq!(
            fresh(&mut Names::default(), &wishes),
            [
                "fn_",
                "gen_",
                "self_",
                "self__",
                "unnamed",
                "unnamed_",
                "n2nd",
                "a_b",
                "x",
                "kamera_öse",
                "x_"
            ]
        );
    }

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
        let names = fresh(&mut Names::default(), &wishes);
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
            assert!(syn::parse_str::<Ident>(&name).is_ok(), "{name}");
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
        let mut names = Names::beside(&Item::derived(&item));
        assert_eq!(
            fresh(&mut names, &["q_1", "t_1", "k"]),
            ["q_1_", "t_1", "k_"]
        );
        assert_eq!(names.fresh_type("T"), "T_");
        let item: syn::DeriveInput = parse_quote! { struct T; };
        assert_eq!(Names::beside(&Item::derived(&item)).fresh_type("T"), "T_");
    }
}
