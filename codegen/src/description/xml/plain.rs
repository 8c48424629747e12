//! Prepares a text for the XML parser by replacing constructs that other readers of robots accept.
//!
//! Undeclared namespace prefixes, document types, a declaration after blank lines, `--` in comments and `&` without a
//! reference are replaced by text of the same length, so that all places stay the same. Numbers and names are read from
//! the file's own text.

use std::borrow::Cow;

/// Replaces `:` in names of elements and attributes, so that `<drake:joint>` differs from `<joint>` and needs no
/// declaration.
pub(in crate::description) const FOR_COLON: char = '.';

/// The text for the XML parser.
pub(in crate::description) fn plain(text: &str) -> Cow<'_, str> {
    let mut copy = Copy { text, bytes: None };
    let mut at = 0;
    while let Some(start) = text[at..].find('<').map(|offset| at + offset) {
        copy.outside_tags(at, start);
        let rest = &text[start..];
        let end = |word: &str| rest.find(word).map(|offset| start + offset + word.len());
        let next = if let Some(inside) = rest.strip_prefix("<!--") {
            // The dashes of `<!--` belong to the start only: `<!-->` does not end the comment.
            let end = inside.find("-->").map(|offset| start + 4 + offset + 3);
            if end.is_some_and(|end| text[start + 4..end - 3].contains("--")) {
                copy.blank(start, end);
            }
            end
        } else if rest.starts_with("<![CDATA[") {
            end("]]>")
        } else if rest.starts_with("<?") {
            let end = end("?>");
            if start > 0 {
                copy.blank(start, end);
            }
            end
        } else if rest.starts_with("<!DOCTYPE") {
            let end = end_of_type(rest).map(|end| start + end);
            copy.blank(start, end);
            end
        } else {
            Some(copy.tag(start))
        };
        // Unfinished constructs are reported by the XML parser.
        let Some(next) = next else {
            return copy.finish();
        };
        at = next;
    }
    copy.outside_tags(at, text.len());
    copy.finish()
}

/// The end of `<!DOCTYPE …>`, including its declarations.
pub(super) fn end_of_type(text: &str) -> Option<usize> {
    let end = text.find('>')?;
    match text[..end].find('[') {
        None => Some(end + 1),
        Some(open) => {
            let close = open + text[open..].find(']')?;
            Some(close + text[close..].find('>')? + 1)
        }
    }
}

/// A text, and its copy from the first change on.
struct Copy<'t> {
    text: &'t str,
    bytes: Option<Vec<u8>>,
}

impl<'t> Copy<'t> {
    fn put(&mut self, at: usize, byte: u8) {
        let text = self.text;
        self.bytes.get_or_insert_with(|| text.as_bytes().to_vec())[at] = byte;
    }

    /// Replaces a range by blanks, keeping line breaks.
    fn blank(&mut self, start: usize, end: Option<usize>) {
        let Some(end) = end else { return };
        for (at, byte) in (start..end).zip(self.text[start..end].bytes()) {
            if !matches!(byte, b'\n' | b'\r') {
                self.put(at, b' ');
            }
        }
    }

    fn outside_tags(&mut self, start: usize, end: usize) {
        for (at, byte) in (start..end).zip(self.text[start..end].bytes()) {
            match byte {
                // Some programs end their texts with a zero byte.
                b'\0' => self.put(at, b' '),
                b'&' => self.ampersand(at),
                _ => {}
            }
        }
    }

    /// Changes a tag; returns its end, or the beginning of another tag in it.
    fn tag(&mut self, start: usize) -> usize {
        let mut quote = None;
        for (at, byte) in (start..).zip(self.text[start..].bytes()) {
            match (quote, byte) {
                (_, b'<') if at > start => return at,
                (Some(open), _) if byte == open => quote = None,
                (Some(_), b'&') => self.ampersand(at),
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b':') => self.put(at, FOR_COLON as u8),
                (None, b'>') => return at + 1,
                _ => {}
            }
        }
        self.text.len()
    }

    /// Replaces an ampersand that does not begin a reference.
    fn ampersand(&mut self, at: usize) {
        if reference(&self.text[at..]).is_none() {
            self.put(at, b'_');
        }
    }

    fn finish(self) -> Cow<'t, str> {
        match self.bytes.map(String::from_utf8) {
            Some(Ok(copy)) => Cow::Owned(copy),
            // Does not occur: whole characters are replaced by ASCII.
            Some(Err(_)) | None => Cow::Borrowed(self.text),
        }
    }
}

/// The value of an attribute with character references replaced; malformed ones are kept.
pub(in crate::description) fn unescaped(value: &str) -> String {
    let mut text = String::with_capacity(value.len());
    let mut rest = value;
    while let Some(at) = rest.find('&') {
        text.push_str(&rest[..at]);
        rest = &rest[at..];
        let (length, character) = reference(rest).unwrap_or((1, '&'));
        text.push(character);
        rest = &rest[length..];
    }
    text + rest
}

/// The character reference at the beginning of a text: its length and its character.
fn reference(text: &str) -> Option<(usize, char)> {
    const NAMED: [(&str, char); 5] = [
        ("&lt;", '<'),
        ("&gt;", '>'),
        ("&amp;", '&'),
        ("&quot;", '"'),
        ("&apos;", '\''),
    ];
    // Long enough for `&#x10FFFF;` with leading zeros.
    const LONGEST: usize = 16;
    if let Some((name, character)) = NAMED.iter().find(|(name, _)| text.starts_with(name)) {
        return Some((name.len(), *character));
    }
    let code = text.strip_prefix("&#")?;
    let code = &code[..code.bytes().take(LONGEST).position(|byte| byte == b';')?];
    let number = match code.strip_prefix('x') {
        Some(digits) => u32::from_str_radix(digits, 16),
        None => code.parse(),
    };
    Some((code.len() + 3, char::from_u32(number.ok()?)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The prepared text; asserts that length and lines are the same.
    fn plained(text: &str) -> String {
        let plain = plain(text);
        assert_eq!(plain.len(), text.len());
        assert_eq!(plain.lines().count(), text.lines().count());
        plain.into_owned()
    }

    #[test]
    fn well_formed_texts_are_not_copied() {
        for text in [
            "<?xml version=\"1.0\"?>\n<robot name=\"a:b\"><!-- a:b & c - d --></robot>\n",
            "<a b='<'/>",
            "<a><![CDATA[ & : <!-- ]]></a>",
            "<!-- open",
            "<!-->",
            "<!--->",
            "<?>",
            "<a b=\"open",
            "",
        ] {
            assert!(matches!(plain(text), Cow::Borrowed(_)), "{text}");
        }
    }

    #[test]
    fn prefixes_become_part_of_the_name() {
        assert_eq!(
            plained("<drake:joint a:b=\"c:d\" xmlns:e = 'f:g'/>x:y</drake:joint>"),
            "<drake.joint a.b=\"c:d\" xmlns.e = 'f:g'/>x:y</drake.joint>"
        );
    }

    #[test]
    fn declarations_before_the_root_are_blanked() {
        assert_eq!(plained("\n\n<?xml?>\n<r/>"), "\n\n       \n<r/>");
        assert_eq!(plained("<!DOCTYPE r>\n<r/>"), "            \n<r/>");
        assert_eq!(
            plained("<!DOCTYPE r [<!ENTITY a \"ä\">\n]><r/>"),
            format!("{}\n  <r/>", " ".repeat(29))
        );
        assert_eq!(plained("<!-- a\n -- b --><r/>"), "      \n         <r/>");
        assert_eq!(plained("<r/>\n\0"), "<r/>\n ");
    }

    #[test]
    fn a_single_ampersand_is_a_character() {
        assert_eq!(
            plained("<a b=\"c & d &amp; &#49; &#x31; &#; &nbsp;\">e & f</a>"),
            "<a b=\"c _ d &amp; &#49; &#x31; _#; _nbsp;\">e _ f</a>"
        );
        assert_eq!(
            unescaped("c & d &amp; &#49;&#x32; &lt;&gt;&quot;&apos; &#; &nbsp; &#xD800; &"),
            "c & d & 12 <>\"' &#; &nbsp; &#xD800; &"
        );
    }
}
