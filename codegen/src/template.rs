//! Text templates.
//!
//! In: a template with placeholders between `@`, and their values. Out: the text. Values are not searched for
//! placeholders.

/// The template with values for its placeholders; unknown placeholders stay.
#[must_use]
pub fn filled(text: &str, words: &[(&str, &str)]) -> String {
    let mut filled = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('@') {
        let (before, from) = rest.split_at(at);
        filled.push_str(before);
        let mut known = words.iter();
        if let Some((word, value)) = known.find(|(word, _)| from.starts_with(word)) {
            filled.push_str(value);
            rest = &from[word.len()..];
        } else {
            filled.push('@');
            rest = &from[1..];
        }
    }
    filled.push_str(rest);
    filled
}

#[cfg(test)]
mod tests {
    use super::filled;

    #[test]
    fn values_are_not_searched_for_placeholders() {
        let words = [("@A@", "@B@"), ("@B@", "b")];
        assert_eq!(filled("a@A@ @B@ @ @C@", &words), "a@B@ b @ @C@");
    }
}
