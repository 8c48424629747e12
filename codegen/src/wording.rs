//! The words of messages: names in quotes, lists, and the known word that was probably meant.
//!
//! In: text that anyone may have written, of any length. Out: text that fits a line. It never
//! decides whether something is a mistake.

/// The longest text that a message repeats in full, in characters.
const LONGEST: usize = 60;

/// The text in double quotes, cut where it is too long for a message.
pub(crate) fn quoted(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("\"{}…\"", text[..cut].escape_debug()),
        None => format!("\"{}\"", text.replace(char::is_control, "\u{fffd}")),
    }
}

/// `a, b and c`.
pub(crate) fn list<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let words: Vec<&str> = words.into_iter().collect();
    match words.split_last() {
        None => String::new(),
        Some((last, [])) => (*last).to_owned(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
    }
}

/// `did you mean "tip"? known keys: base and tip`, the question only where a known word is near.
pub(crate) fn known(word: &str, kind: &str, words: &[&str]) -> String {
    let all = format!("known {kind}: {}", list(words.iter().copied()));
    match nearest(word, words) {
        Some(meant) => format!("did you mean \"{meant}\"? {all}"),
        None => all,
    }
}

/// The candidate that differs from the word by the fewest changed letters, if they are few enough
/// to be a slip.
pub(crate) fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    let letters = word.chars().count();
    // Longer words are no slip of a known one, and would cost time for nothing.
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
        .map(|(_, candidate)| candidate)
}

/// Letters to insert, delete, replace or swap with their neighbour to get from one word to the
/// other (the distance of Damerau and Levenshtein in its restricted form).
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
    fn a_slip_is_recognised_and_another_word_is_not() {
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
    fn a_message_repeats_no_endless_text() {
        assert_eq!(quoted("arm"), "\"arm\"");
        assert_eq!(quoted("a\nb"), "\"a\u{fffd}b\"");
        assert!(quoted(&"x".repeat(1_000_000)).len() < 80);
    }

    #[test]
    fn a_list_ends_in_and() {
        assert_eq!(list(["a", "b", "c"]), "a, b and c");
        assert_eq!(list(["a"]), "a");
        assert_eq!(list([]), "");
    }
}
