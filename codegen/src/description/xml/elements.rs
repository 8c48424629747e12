//! Tables of the elements and attributes of an XML format, and the treatment of each.
//!
//! [`survey`](super::survey) reports warnings by these tables, and the guide's page "What is read" is printed from
//! them.

use std::fmt::Write;

/// A format of XML.
pub(in crate::description) struct Format {
    /// Content of the root element.
    pub(in crate::description) root: &'static Content,
    /// Each element with content, under its heading in the guide.
    pub(in crate::description) places: &'static [(&'static str, &'static Content)],
    /// Elements that messages call by a word instead of their tag, with this word.
    pub(in crate::description) called: &'static [(&'static str, &'static str)],
    /// Mechanical elements, which are counted inside an ignored element for the hint.
    pub(in crate::description) counted: &'static [&'static str],
    /// Elements that are allowed anywhere, and are not part of the element around them.
    pub(in crate::description) elsewhere: &'static [&'static str],
}

/// Attributes and elements that an element may contain.
pub(in crate::description) struct Content {
    pub(in crate::description) attributes: &'static [Entry],
    pub(in crate::description) elements: &'static [Entry],
    pub(in crate::description) others: Others,
}

/// Treatment of elements and attributes without a row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::description) enum Others {
    /// Ignored, with a warning.
    Warned,
    /// As `Warned`; text is a warning, too, because the element's values are attributes.
    WarnedLikeText,
    /// Ignored as settings without mechanics. Elements inside are surveyed by the same rows.
    Ignored,
}

/// A row: an element or an attribute.
pub(in crate::description) struct Entry {
    /// The name in the file; a name with Drake's prefix is recognised without it, too.
    pub(in crate::description) name: &'static str,
    pub(in crate::description) when: When,
    pub(in crate::description) becomes: Becomes,
    /// Content of the element; `None` if it is not surveyed.
    pub(in crate::description) content: Option<&'static Content>,
}

/// Values that cause a warning: of an attribute, or of an element's attribute `value` or text.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::description) enum When {
    Always,
    /// Anything but the number 0.
    NotZero,
    /// Anything but the number 1.
    NotOne,
    /// `true` or `1`.
    True,
    /// `false` or `0`.
    False,
    /// Three numbers that are not 0 0 -9.81.
    NotStandardGravity,
}

/// Treatment of an element or attribute.
#[derive(Clone, Copy)]
pub(in crate::description) enum Becomes {
    /// Read as this, in the words of the guide.
    Read(&'static str),
    /// Ignored for this reason: it has no mechanics.
    Ignored(&'static str),
    /// Mechanics that are not modelled: a warning.
    NotModelled(&'static NotModelled),
}

/// Mechanics that are not modelled.
pub(in crate::description) struct NotModelled {
    /// A noun with its article, for the message.
    pub(in crate::description) what: &'static str,
    /// Advice for the user.
    pub(in crate::description) hint: &'static str,
}

impl Entry {
    const fn new(name: &'static str, becomes: Becomes) -> Self {
        Self {
            name,
            when: When::Always,
            becomes,
            content: None,
        }
    }

    /// A row that is read as `what`.
    pub(in crate::description) const fn read(name: &'static str, what: &'static str) -> Self {
        Self::new(name, Becomes::Read(what))
    }

    /// A row without mechanics, ignored because of `what`.
    pub(in crate::description) const fn ignored(name: &'static str, what: &'static str) -> Self {
        Self::new(name, Becomes::Ignored(what))
    }

    /// A row of mechanics that are not modelled.
    pub(in crate::description) const fn not_modelled(
        name: &'static str,
        what: &'static NotModelled,
    ) -> Self {
        Self::new(name, Becomes::NotModelled(what))
    }

    pub(in crate::description) const fn when(self, when: When) -> Self {
        Self { when, ..self }
    }

    pub(in crate::description) const fn with(self, content: &'static Content) -> Self {
        Self {
            content: Some(content),
            ..self
        }
    }

    /// The name as the guide shows it, with the values that cause a warning.
    fn shown(&self, is_attribute: bool) -> String {
        let name = self.name;
        let when = match self.when {
            When::Always => "",
            When::NotZero => " that is not 0",
            When::NotOne => " that is not 1",
            When::True => " that is true",
            When::False => " that is false",
            When::NotStandardGravity => " that is not 0 0 -9.81",
        };
        if is_attribute {
            format!("`{name}`{when}")
        } else {
            format!("`<{name}>`{when}")
        }
    }

    /// True if `written` is the name of this row.
    pub(in crate::description) fn is(&self, written: &str) -> bool {
        self.name == written || self.name.strip_prefix("drake:") == Some(written)
    }
}

impl Becomes {
    pub(in crate::description) const fn is_read(self) -> bool {
        matches!(self, Self::Read(_))
    }

    /// The treatment as the guide shows it. `<` is escaped outside of code.
    fn text(self) -> String {
        match self {
            Self::Read(what) => what.to_owned(),
            Self::Ignored(what) => format!("ignored: {what}"),
            Self::NotModelled(NotModelled { what, hint }) => {
                let text = format!("**a warning**: {what}; {hint}");
                text.replace('<', "&lt;")
            }
        }
    }
}

impl Content {
    pub(in crate::description) fn element(&self, written: &str) -> Option<&'static Entry> {
        self.elements.iter().find(|entry| entry.is(written))
    }

    pub(in crate::description) fn attribute(&self, written: &str) -> Option<&'static Entry> {
        self.attributes.iter().find(|entry| entry.is(written))
    }
}

/// Attributes of many elements, for which no other place is suggested.
const NAMES: [&str; 3] = ["name", "type", "version"];

impl Format {
    /// A hint: the place where a misplaced element would be read, as an element or as an attribute.
    pub(in crate::description) fn home(&self, written: &str) -> Option<String> {
        let place = |reads: &dyn Fn(&Content) -> bool| {
            let place = self.places.iter().find(|(_, content)| reads(content));
            place.map(|(name, _)| name.replace('`', ""))
        };
        let read = |entry: Option<&Entry>| entry.is_some_and(|entry| entry.becomes.is_read());
        let element = place(&|content| read(content.element(written)));
        let element = element.map(|place| format!("move it into {place}"));
        let attribute =
            place(&|content| !NAMES.contains(&written) && read(content.attribute(written)));
        element.or_else(|| attribute.map(|place| format!("write it as an attribute of {place}")))
    }

    /// The table as Markdown for the guide; attributes come before elements.
    #[must_use]
    pub(in crate::description) fn page(&self) -> String {
        let mut page = String::new();
        for (place, content) in self.places {
            // Writing to a string cannot fail.
            let _ = write!(page, "## In {place}\n\n| | becomes |\n|---|---|\n");
            let rows = content.attributes.iter().map(|entry| (entry, true));
            let rows = rows.chain(content.elements.iter().map(|entry| (entry, false)));
            // Adjacent rows with the same treatment are merged.
            let mut written: Vec<(String, String)> = Vec::new();
            for (entry, is_attribute) in rows {
                let name = entry.shown(is_attribute);
                let becomes = entry.becomes.text();
                match written.last_mut().filter(|(_, last)| *last == becomes) {
                    Some((names, _)) => names.extend([", ", &name]),
                    None => written.push((name, becomes)),
                }
            }
            for (names, becomes) in written {
                let _ = writeln!(page, "| {names} | {becomes} |");
            }
            let others = match content.others {
                Others::Warned => "Anything else is ignored, with a warning.",
                Others::WarnedLikeText => {
                    "Anything else is ignored, with a warning; so are values written as elements or text."
                }
                Others::Ignored => "Anything else is a setting and is ignored.",
            };
            let _ = writeln!(page, "\n{others}\n");
        }
        page
    }
}
