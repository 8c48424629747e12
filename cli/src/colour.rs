//! Colours of messages on standard error.
//!
//! Words at the beginning of lines are coloured if standard error is a terminal that shows colours. Standard output
//! stays plain for other programs.

use std::env;
use std::io::{IsTerminal, stderr};

/// Words at the beginning of lines, with the codes of their colours.
const WORDS: [(&str, &str); 4] = [
    ("error", "1;31"),
    ("warning", "1;33"),
    ("note", "1"),
    ("  hint", "36"),
];

/// True if standard error is a terminal that shows colours; any value of `NO_COLOR` forbids them.
pub(super) fn is_wanted() -> bool {
    let is_set = |name: &str| env::var_os(name).is_some_and(|value| !value.is_empty());
    let is_dumb = env::var_os("TERM").is_none_or(|term| term == "dumb");
    stderr().is_terminal() && !is_set("NO_COLOR") && !is_dumb
}

/// The messages in colours.
pub(super) fn coloured(remarks: &str) -> String {
    let lines = remarks.split_inclusive('\n').map(|line| {
        let mut words = WORDS.iter();
        let word = words.find_map(|(word, colour)| {
            let rest = line.strip_prefix(word)?.strip_prefix(':')?;
            Some(format!("\x1b[{colour}m{word}:\x1b[0m{rest}"))
        });
        word.unwrap_or_else(|| line.to_owned())
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::coloured;

    #[test]
    fn what_begins_a_line_has_a_colour_and_nothing_else_changes() {
        let remarks = "error: arm: error: no\n  hint: look\nwarnings\n";
        let shown =
            "\x1b[1;31merror:\x1b[0m arm: error: no\n\x1b[36m  hint:\x1b[0m look\nwarnings\n";
        assert_eq!(coloured(remarks), shown);
    }
}
