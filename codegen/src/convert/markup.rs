//! Writes XML, indented.

/// Indentation beyond which lines of deep trees do not grow.
const DEEPEST: usize = 40;

/// An attribute and its value.
pub(super) type Attribute = (&'static str, String);

/// A text of XML.
#[derive(Default)]
pub(super) struct Markup {
    pub(super) text: String,
    open: Vec<&'static str>,
}

impl Markup {
    /// Begins an element with content.
    pub(super) fn begin(&mut self, tag: &'static str, attributes: &[Attribute]) {
        self.tag(tag, attributes);
        self.text.push_str(">\n");
        self.open.push(tag);
    }

    /// Ends the element that was begun last.
    pub(super) fn end(&mut self) {
        let Some(tag) = self.open.pop() else { return };
        self.indent();
        self.text.extend(["</", tag, ">\n"]);
    }

    /// An element without content.
    pub(super) fn empty(&mut self, tag: &'static str, attributes: &[Attribute]) {
        self.tag(tag, attributes);
        self.text.push_str("/>\n");
    }

    /// An element with text.
    pub(super) fn with_text(&mut self, tag: &'static str, text: &str) {
        self.tag(tag, &[]);
        self.text.extend([">", text, "</", tag, ">\n"]);
    }

    fn tag(&mut self, tag: &str, attributes: &[Attribute]) {
        self.indent();
        self.text.extend(["<", tag]);
        for (name, value) in attributes {
            self.text
                .extend([" ", name, "=\"", &escaped(value), "\""].map(str::to_owned));
        }
    }

    fn indent(&mut self) {
        let depth = self.open.len().min(DEEPEST);
        self.text.extend(std::iter::repeat_n("  ", depth));
    }
}

/// A value in double quotes.
fn escaped(value: &str) -> String {
    let mut text = String::with_capacity(value.len());
    for letter in value.chars() {
        match letter {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            letter => text.push(letter),
        }
    }
    text
}
