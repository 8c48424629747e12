//! Splits a text into what is evaluated and what is not.

use super::failure::{Failure, failure_with_hint};
use crate::wording::quoted;

/// A piece of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Piece<'t> {
    Text(&'t str),
    /// The inside of `${…}`.
    Expression(&'t str),
    /// The inside of `$(…)`.
    Substitution(&'t str),
}

/// The pieces of a text with their offsets. `$${` and `$$(` are texts with one `$` less.
pub(super) fn pieces(text: &str) -> Result<Vec<(usize, Piece<'_>)>, Failure> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let (length, piece) = if rest.starts_with('$') {
            dollar(rest)?
        } else {
            let length = rest.find('$').unwrap_or(rest.len());
            (length, Piece::Text(&rest[..length]))
        };
        pieces.push((at, piece));
        at += length;
    }
    Ok(pieces)
}

/// The piece that begins with a `$`, and its length.
fn dollar(text: &str) -> Result<(usize, Piece<'_>), Failure> {
    let dollars = text.len() - text.trim_start_matches('$').len();
    let next = text[dollars..].chars().next();
    let unfinished = |close: &str| {
        let what = format!("{} does not end", quoted(text));
        failure_with_hint(
            what,
            format!("close it by {close}, or write $$ for the character"),
        )
    };
    match (dollars, next) {
        (1, Some('{')) => {
            let end = text.find('}').ok_or_else(|| unfinished("}"))?;
            Ok((end + 1, Piece::Expression(&text[2..end])))
        }
        (1, Some('(')) => {
            let end = text.find(')').ok_or_else(|| unfinished(")"))?;
            Ok((end + 1, Piece::Substitution(&text[2..end])))
        }
        (1, None) => Ok((1, Piece::Text(text))),
        (1, Some(_)) => {
            let end = text[1..].find(['{', '(', '$']);
            let end = end.map_or(text.len(), |end| end + 1);
            Ok((end, Piece::Text(&text[..end])))
        }
        (_, Some('{' | '(')) => Ok((dollars + 1, Piece::Text(&text[1..=dollars]))),
        _ => Err(failure_with_hint(
            "two dollar signs stand before no bracket",
            "write one",
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<Piece<'_>> {
        let pieces = pieces(text).unwrap_or_else(|failure| panic!("{text}: {failure:?}"));
        pieces.into_iter().map(|(_, piece)| piece).collect()
    }

    #[test]
    fn expressions_end_at_the_first_brace() {
        use Piece::{Expression, Substitution, Text};
        assert_eq!(found("a b"), [Text("a b")]);
        assert_eq!(
            found("a${b}c$(d e)"),
            [Text("a"), Expression("b"), Text("c"), Substitution("d e")]
        );
        assert_eq!(found("${'{'}"), [Expression("'{'")]);
        assert_eq!(found("$${a}"), [Text("${"), Text("a}")]);
        assert_eq!(found("$$$(a)"), [Text("$$("), Text("a)")]);
        assert_eq!(found("5$ or $5"), [Text("5"), Text("$ or "), Text("$5")]);
        assert_eq!(found("5$"), [Text("5"), Text("$")]);
        for unfinished in ["${a", "$(a", "$$", "a $$ b"] {
            assert!(pieces(unfinished).is_err(), "{unfinished}");
        }
    }
}
