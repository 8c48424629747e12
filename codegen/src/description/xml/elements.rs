//! Everything that may stand in a format of XML, and what becomes of it.
//!
//! In: nothing. Out: the rows of which the reader of a format makes one table, the only list of elements and
//! attributes that it knows. [`survey`](super::survey) warns by it of what is left out, and the guide's page "What is
//! read and what is not" is printed from it. It never reads a number.

use std::fmt::Write;

/// A format.
pub(in crate::description) struct Format {
    /// What may stand in the root element.
    pub(in crate::description) root: &'static Content,
    /// Each element that has content, as the guide calls it.
    pub(in crate::description) places: &'static [(&'static str, &'static Content)],
    /// The words before the name of an element that messages do not write in angle brackets.
    pub(in crate::description) called: &'static [(&'static str, &'static str)],
    /// The elements that are counted in one that is ignored, because they are mechanics.
    pub(in crate::description) counted: &'static [&'static str],
    /// Elements that may stand anywhere, and are no part of what they stand in.
    pub(in crate::description) elsewhere: &'static [&'static str],
}

/// What may stand in an element.
pub(in crate::description) struct Content {
    pub(in crate::description) attributes: &'static [Entry],
    pub(in crate::description) elements: &'static [Entry],
    pub(in crate::description) others: Others,
}

/// What becomes of elements and attributes that have no row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::description) enum Others {
    /// They are ignored, with a warning.
    Warned,
    /// The same; and the element's values are attributes, so that text in it is one of them gone astray.
    WarnedLikeText,
    /// They are settings without mechanics, but what stands in them is looked at by the same rows.
    PassedOver,
}

/// An element or an attribute.
pub(in crate::description) struct Entry {
    /// As it is written; a name with Drake's prefix is known without it as well.
    pub(in crate::description) name: &'static str,
    pub(in crate::description) when: When,
    pub(in crate::description) becomes: Becomes,
    /// What may stand in it; none where nobody looks.
    pub(in crate::description) content: Option<&'static Content>,
}

/// Values for which a warning is due: of an attribute, or of an element's attribute `value` or text.
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

/// What the reader makes of it.
#[derive(Clone, Copy)]
pub(in crate::description) enum Becomes {
    /// This, in the words of the guide.
    Read(&'static str),
    /// Nothing: it has no mechanics.
    Nothing(&'static str),
    /// Nothing, though it is mechanics: a warning.
    Lost(&'static Lost),
}

/// Mechanics that are left out.
pub(in crate::description) struct Lost {
    /// What it is, with its article.
    pub(in crate::description) what: &'static str,
    /// What the user can do about it.
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

    /// What is read.
    pub(in crate::description) const fn read(name: &'static str, what: &'static str) -> Self {
        Self::new(name, Becomes::Read(what))
    }

    /// What has no mechanics.
    pub(in crate::description) const fn nothing(name: &'static str, what: &'static str) -> Self {
        Self::new(name, Becomes::Nothing(what))
    }

    /// Mechanics that are left out.
    pub(in crate::description) const fn lost(name: &'static str, what: &'static Lost) -> Self {
        Self::new(name, Becomes::Lost(what))
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

    /// As the guide writes it, with the values that are warned of.
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

    /// Whether an element or attribute of this name is meant.
    pub(in crate::description) fn is(&self, written: &str) -> bool {
        self.name == written || self.name.strip_prefix("drake:") == Some(written)
    }
}

impl Becomes {
    pub(in crate::description) const fn is_read(self) -> bool {
        matches!(self, Self::Read(_))
    }

    /// In the words of the guide, in which only what is code begins with `<`.
    fn text(self) -> String {
        match self {
            Self::Read(what) => what.to_owned(),
            Self::Nothing(what) => format!("nothing: {what}"),
            Self::Lost(Lost { what, hint }) => {
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

/// Attributes that many elements have.
const NAMES: [&str; 3] = ["name", "type", "version"];

impl Format {
    /// Where an element that stands elsewhere would be read: as an element, or as an attribute.
    pub(in crate::description) fn home(&self, written: &str) -> Option<String> {
        let place = |reads: &dyn Fn(&Content) -> bool| {
            let place = self.places.iter().find(|(_, content)| reads(content));
            place.map(|(name, _)| name.replace('`', ""))
        };
        let read = |entry: Option<&Entry>| entry.is_some_and(|entry| entry.becomes.is_read());
        let element = place(&|content| read(content.element(written)));
        let element = element.map(|place| format!("it stands in {place}: move it there"));
        let attribute =
            place(&|content| !NAMES.contains(&written) && read(content.attribute(written)));
        element.or_else(|| attribute.map(|place| format!("write it as an attribute of {place}")))
    }

    /// The table as the guide shows it, in Markdown: of each element what may stand in it, attributes first.
    #[must_use]
    pub(in crate::description) fn page(&self) -> String {
        let mut page = String::new();
        for (place, content) in self.places {
            // Writing to a string cannot fail.
            let _ = write!(page, "## In {place}\n\n| | becomes |\n|---|---|\n");
            let rows = content.attributes.iter().map(|entry| (entry, true));
            let rows = rows.chain(content.elements.iter().map(|entry| (entry, false)));
            // Rows of one fate are one.
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
                    "Anything else is ignored, with a warning; so are values that stand in it as elements or text."
                }
                Others::PassedOver => "Anything else is a setting, and passed over.",
            };
            let _ = writeln!(page, "\n{others}\n");
        }
        page
    }
}
