//! Unique identifiers.
//!
//! In: reserved words, and preferred names. Out: identifiers that are unique in their scope. A name that is taken gets
//! underscores at its end.

use std::collections::BTreeSet;

/// Names of one scope.
#[derive(Clone, Debug, Default)]
pub struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// No names but the reserved words of a language.
    #[must_use]
    pub fn beside(words: &[&str]) -> Self {
        Self {
            taken: words.iter().map(ToString::to_string).collect(),
        }
    }

    /// Reserves a name.
    pub fn take(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// The preferred name as an identifier, with as many underscores at its end as make it unique.
    pub fn fresh(&mut self, wish: &str) -> String {
        self.alone(&sanitize(wish))
    }

    /// The same for a text that is an identifier already.
    pub fn alone(&mut self, wish: &str) -> String {
        let mut name = wish.to_owned();
        while self.taken.contains(&name) {
            name.push('_');
        }
        self.taken.insert(name.clone());
        name
    }
}

/// Text as an identifier: lower case, with one underscore for every run of other characters. It may be a reserved word.
pub(crate) fn sanitize(text: &str) -> String {
    let mut name = String::with_capacity(text.len());
    for letter in text.chars().flat_map(char::to_lowercase) {
        if is_continue(letter) {
            name.push(letter);
        } else if !name.ends_with('_') {
            name.push('_');
        }
    }
    let trimmed = name.trim_matches('_');
    // Any letter that may continue a name may follow another letter.
    let prefix = match trimmed.chars().next() {
        Some(first) if first.is_alphabetic() => "",
        Some(_) => "n",
        None => "unnamed",
    };
    format!("{prefix}{trimmed}")
}

/// True if a letter other than the underscore may stand within an identifier: Latin script, Chinese characters,
/// Japanese kana, Korean syllables. Many letters of other scripts look like one of these, have no width, or are the
/// same letter in two encodings, which compilers treat as one.
fn is_continue(letter: char) -> bool {
    match letter {
        // Ligatures, and letters that stand for two others.
        '×' | '÷' | 'ĳ' | 'ŀ' | 'ŉ' | 'ſ' => false,
        'ß'..='ž' | 'ぁ'..='ゖ' | 'ァ'..='ヺ' | '一'..='鿿' | '가'..='힣' => true,
        letter => letter.is_ascii_alphanumeric(),
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    fn fresh(mut names: Names, wishes: &[&str]) -> Vec<String> {
        wishes.iter().map(|wish| names.fresh(wish)).collect()
    }

    #[test]
    fn names_are_unique() {
        assert_eq!(
            fresh(Names::default(), &["m_0_3", "m_0_3", "m_0_3_", "M-0-3"]),
            ["m_0_3", "m_0_3_", "m_0_3__", "m_0_3___"]
        );
    }

    #[test]
    fn names_are_valid_and_not_reserved() {
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
            fresh(Names::beside(&["fn", "gen", "self"]), &wishes),
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
}
