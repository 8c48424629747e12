//! Words of messages: quoted names, lists, and the most similar known word.
//!
//! Any text of the user becomes text that fits on a line and is visible.

use std::borrow::Cow;

/// Maximum number of characters of a text that a message repeats in full.
const LONGEST: usize = 60;

/// The text in double quotes, shortened if it is too long for a message.
#[must_use]
pub fn quoted(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("\"{}…\"", visible(&text[..cut])),
        None => format!("\"{}\"", visible(text)),
    }
}

/// The text on one line, with invisible characters escaped as `\u{202e}`. Names of users are always printed this way.
///
/// Terminals obey control characters, rustc rejects comments with characters that change the direction of text, and
/// names that differ only by characters without width look the same.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 8);
    for letter in text.chars() {
        if is_hidden(letter) {
            shown.extend(letter.escape_unicode());
        } else {
            shown.push(letter);
        }
    }
    Cow::Owned(shown)
}

/// True for invisible characters: controls, marks of text direction, characters without width, line and paragraph
/// breaks, byte order marks, tags.
#[must_use]
pub fn is_hidden(letter: char) -> bool {
    letter.is_control()
        || matches!(letter,
            '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{fe00}'..='\u{fe0f}'
            | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}')
}

/// A user's name in documentation, so that neither Markdown nor lints read it as prose.
#[must_use]
pub fn code(name: &str) -> String {
    format!("`{}`", visible(name).replace('`', "'"))
}

/// `a, b and c`.
pub fn list<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words: Vec<&str> = words.into_iter().collect();
    match words.split_last() {
        None => String::new(),
        Some((last, [])) => (*last).to_owned(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
    }
}

/// `did you mean "tip"? known keys: base and tip`. The question names a word that differs by one letter, else up to
/// three words that contain the given one, else the most similar one.
#[must_use]
pub fn known(word: &str, kind: &str, words: &[&str]) -> String {
    let all = format!("known {kind}: {}", list(words.iter().copied()));
    let nearest = by_slips(word, words);
    let meant = match nearest {
        Some((1, nearest)) => vec![nearest],
        _ => longer(word, words),
    };
    let meant = if meant.is_empty() {
        nearest.map(|(_, nearest)| nearest).into_iter().collect()
    } else {
        meant
    };
    if meant.is_empty() {
        return all;
    }
    let meant: Vec<String> = meant.iter().map(|meant| format!("\"{meant}\"")).collect();
    format!("did you mean {}? {all}", meant.join(" or "))
}

/// `did you mean "tool"? links: "base", "tool" and 3 more`; the question only if a name is similar.
#[must_use]
pub fn named(name: &str, kind: &str, names: &[&str]) -> String {
    const LISTED: usize = 12;
    let shown = names.iter().take(LISTED).map(|name| quoted(name));
    let more = names.len().saturating_sub(LISTED);
    let more = (more > 0).then(|| format!("{more} more"));
    let shown: Vec<String> = shown.chain(more).collect();
    let all = format!("{kind}: {}", list(shown.iter().map(String::as_str)));
    match nearest(name, names) {
        Some(meant) => format!("did you mean {}? {all}", quoted(meant)),
        None => all,
    }
}

/// Up to three candidates that contain the word.
fn longer<'a>(word: &str, candidates: &[&'a str]) -> Vec<&'a str> {
    const FEWEST_LETTERS: usize = 3;
    let word = word.to_lowercase();
    let is_part = |candidate: &&&str| word.len() >= FEWEST_LETTERS && candidate.contains(&word);
    candidates.iter().filter(is_part).take(3).copied().collect()
}

/// The candidate with the fewest changed letters, if they are few enough for a typing error.
#[must_use]
pub fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    by_slips(word, candidates).map(|(_, candidate)| candidate)
}

/// The candidate, with the number of changed letters.
fn by_slips<'a>(word: &str, candidates: &[&'a str]) -> Option<(usize, &'a str)> {
    let word = word.to_lowercase();
    let letters = word.chars().count();
    // Longer words are not misspelt known ones, and the comparison would take long.
    if letters > LONGEST {
        return None;
    }
    let slips = letters.div_ceil(3);
    let comparable = |candidate: &&&str| candidate.chars().nth(letters + slips).is_none();
    candidates
        .iter()
        .filter(comparable)
        .map(|candidate| (distance(&word, candidate), *candidate))
        .filter(|(distance, _)| *distance <= slips && *distance < letters)
        .min_by_key(|(distance, _)| *distance)
}

/// Number of letters to insert, delete, replace or swap with a neighbour to get from one word to the other (the
/// restricted Damerau–Levenshtein distance).
fn distance(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=to.len()).collect();
    let mut previous = None;
    for (i, a) in from.chars().enumerate() {
        let mut row = vec![i + 1];
        for (j, &b) in to.iter().enumerate() {
            let mut best = (last[j] + usize::from(a != b))
                .min(last[j + 1] + 1)
                .min(row[j] + 1);
            if j > 0 && previous == Some(b) && to[j - 1] == a {
                best = best.min(before[j - 1] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut last, row);
        previous = Some(a);
    }
    last[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_typing_error_is_recognised_and_another_word_is_not() {
        let known = ["revolute", "continuous", "prismatic", "fixed"];
        assert_eq!(nearest("revolut", &known), Some("revolute"));
        assert_eq!(nearest("Revolute", &known), Some("revolute"));
        assert_eq!(nearest("rveolute", &known), Some("revolute"));
        assert_eq!(nearest("alfa", &["a", "alpha"]), Some("alpha"));
        assert_eq!(nearest("hinge", &known), None);
        assert_eq!(nearest("", &known), None);
        assert_eq!(nearest("x", &["y"]), None);
    }

    #[test]
    fn long_texts_are_shortened() {
        assert_eq!(quoted("arm"), "\"arm\"");
        assert_eq!(quoted("a\nb"), "\"a\\u{a}b\"");
        assert!(quoted(&"x".repeat(1_000_000)).len() < 80);
    }

    #[test]
    fn invisible_characters_are_escaped() {
        assert!(matches!(
            visible("Kamera-öse 机器人 `x²` \\ \"3\""),
            Cow::Borrowed(_)
        ));
        let hidden = "\0\u{7}\t\n\r\u{1b}\u{7f}\u{85}\u{9b}\u{61c}\u{200b}\u{200d}\u{200e}\u{200f}\u{2028}\
            \u{2029}\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2060}\u{2066}\u{2067}\u{2068}\u{2069}\u{feff}";
        assert!(hidden.chars().all(is_hidden));
        assert_eq!(visible("a\u{202e}b\u{1b}[2J"), "a\\u{202e}b\\u{1b}[2J");
        let shown = visible(hidden);
        assert!(!shown.contains(is_hidden) && shown.is_ascii(), "{shown}");
        // Escaping twice changes nothing.
        assert_eq!(visible(&shown), shown);
    }

    #[test]
    fn a_list_ends_in_and() {
        assert_eq!(list(["a", "b", "c"]), "a, b and c");
        assert_eq!(list(["a"]), "a");
        assert_eq!(list([]), "");
    }
}
