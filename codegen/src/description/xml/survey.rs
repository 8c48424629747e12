//! Warns of everything in a file that is not read.
//!
//! There is one warning for each kind of element, attribute or text that the table of the format
//! ([`elements`](super::elements)) does not name or marks as not modelled, at its first occurrence. Elements left by
//! xacro are noted. Time and memory are proportional to the document.

use std::collections::HashMap;

use roxmltree::{Attribute, Node};

use super::element::{MOST_WARNINGS, Reader};
use super::elements::{Becomes, Content, Entry, Format, NotModelled, Others, When};
use crate::error::Place;
use crate::wording::{list, nearest, quoted};

/// Attributes of XML itself, allowed in any element.
const OF_XML: [&str; 3] = ["xmlns", "xml", "xsi"];

/// Maximum number of tags that name an element without a name attribute: its own and those around it.
const NAMED: usize = 3;

/// Adds the warnings of the root element.
pub(in crate::description) fn survey<'t>(
    reader: &mut Reader<'_, 't>,
    root: Node<'_, 't>,
    format: &'static Format,
) {
    inside(reader, vec![(root, format.root)], format);
}

#[cfg(feature = "formats")]
/// Adds the warnings of an included file's root element, whose children belong to an element with this content.
pub(in crate::description) fn survey_included<'t>(
    reader: &mut Reader<'_, 't>,
    root: Node<'_, 't>,
    content: &'static Content,
    format: &'static Format,
) {
    let children = root.children().filter(Node::is_element);
    let known = children.filter_map(|child| {
        let entry = content.element(child.tag_name().name())?;
        Some((child, entry.content?))
    });
    let mut known: Vec<_> = known.collect();
    known.reverse();
    inside(reader, known, format);
}

/// Adds the warnings of elements and their descendants; the last element of `open` comes first.
fn inside<'a, 't: 'a>(
    reader: &mut Reader<'_, 't>,
    mut open: Vec<(Node<'a, 't>, &'static Content)>,
    format: &'static Format,
) {
    let mut survey = Survey {
        reader,
        format,
        found: Vec::new(),
        known: HashMap::new(),
    };
    while let Some((node, content)) = open.pop() {
        survey.attributes(node, content);
        if content.others == Others::WarnedLikeText {
            survey.text(node, content);
        }
        let before = open.len();
        for child in node.children().filter(Node::is_element) {
            open.extend(
                survey
                    .element(child, content)
                    .map(|content| (child, content)),
            );
        }
        // Keeps the order of the text.
        open[before..].reverse();
    }
    survey.warn();
}

/// The first occurrence of a kind, and the number of others.
struct FirstOccurrence {
    place: Place,
    message: Message,
    hint: Option<String>,
    others: usize,
}

enum Message {
    /// The item, and its place in words.
    Ignored(String, String),
    NotModelled(&'static NotModelled, String),
}

/// Items with the same key are of one kind.
#[derive(PartialEq, Eq, Hash)]
enum OccurrenceKey<'k> {
    Element(&'k str, &'k str),
    Attribute(&'k str, &'k str),
    Text(&'k str),
    NotModelled(&'static str),
}

struct Survey<'s, 'r, 't> {
    reader: &'s mut Reader<'r, 't>,
    format: &'static Format,
    found: Vec<FirstOccurrence>,
    /// Indices of the kinds in `found`.
    known: HashMap<OccurrenceKey<'t>, usize>,
}

impl<'t> Survey<'_, '_, 't> {
    /// Counts an item of a kind that was found before. True if it was, or if the maximum of warnings is reached.
    fn is_known(&mut self, key: &OccurrenceKey<'t>) -> bool {
        let known = self.known.get(key).copied();
        if let Some(known) = known {
            self.found[known].others += 1;
        }
        known.is_some() || self.found.len() >= MOST_WARNINGS
    }

    fn push(
        &mut self,
        key: OccurrenceKey<'t>,
        place: Place,
        message: Message,
        hint: Option<String>,
    ) {
        self.known.insert(key, self.found.len());
        self.found.push(FirstOccurrence {
            place,
            message,
            hint,
            others: 0,
        });
    }

    /// Surveys an element; returns its content if its children are to be surveyed.
    fn element(
        &mut self,
        node: Node<'_, 't>,
        content: &'static Content,
    ) -> Option<&'static Content> {
        let name = self.name(node);
        if self.format.elsewhere.contains(&name) {
            return None;
        }
        let Some(entry) = content.element(name) else {
            if content.others == Others::Ignored {
                return Some(content);
            }
            match name.strip_prefix("xacro:") {
                Some(name) => self.left_by_xacro(node, name),
                None => self.ignored(node, name, content),
            }
            return None;
        };
        if let Becomes::NotModelled(mechanics) = entry.becomes {
            let value = node.attribute("value").or(node.text()).unwrap_or_default();
            if is_due(entry, value) {
                self.not_modelled(
                    self.reader.place(node),
                    (format!("<{name}>"), "in"),
                    mechanics,
                    node.parent_element(),
                );
            }
            return None;
        }
        entry.content
    }

    fn left_by_xacro(&mut self, node: Node<'_, 't>, name: &str) {
        let place = self.reader.place(node);
        let subject = self.subject(node.parent_element());
        self.reader.left_by_xacro(place, name, &subject);
    }

    /// Warns of an element without a row.
    fn ignored(&mut self, node: Node<'_, 't>, name: &'t str, content: &'static Content) {
        let parent = node.parent_element();
        let within = parent.map_or("", |parent| self.name(parent));
        let key = OccurrenceKey::Element(within, name);
        if self.is_known(&key) {
            return;
        }
        let hint = if content.attribute(name).is_some() {
            let text = node.text().unwrap_or_default().trim();
            let value = if text.is_empty() || text.len() > 40 {
                "…"
            } else {
                text
            };
            Some(format!(
                "write it as an attribute: <{within} {name}=\"{value}\"/>"
            ))
        } else if let Some(meant) = meant(name, content.elements) {
            Some(format!("did you mean <{meant}>?"))
        } else if let Some(home) = self.format.home(name) {
            Some(home)
        } else {
            bodies(node, self.format.counted)
        };
        let within = format!("in {}", self.subject(parent));
        let message = Message::Ignored(format!("<{name}>"), within);
        self.push(key, self.reader.place(node), message, hint);
    }

    fn attributes(&mut self, node: Node<'_, 't>, content: &'static Content) {
        for attribute in node.attributes() {
            let name = self.attribute_name(&attribute);
            if let Some(entry) = content.attribute(name) {
                if let Becomes::NotModelled(mechanics) = entry.becomes
                    && is_due(entry, attribute.value())
                {
                    let place = self.attribute_place(&attribute);
                    self.not_modelled(
                        place,
                        (format!("attribute {}", quoted(name)), "of"),
                        mechanics,
                        Some(node),
                    );
                }
                continue;
            }
            let prefix = name.split(':').next().unwrap_or_default();
            if content.others == Others::Ignored || OF_XML.contains(&prefix) {
                continue;
            }
            let key = OccurrenceKey::Attribute(self.name(node), name);
            if self.is_known(&key) {
                continue;
            }
            let hint = if let Some(meant) = meant(name, content.attributes) {
                Some(format!("did you mean {meant}?"))
            } else if content.element(name).is_some() {
                Some(format!("write it as an element: <{name} …/>"))
            } else {
                let read = content
                    .attributes
                    .iter()
                    .filter(|entry| entry.becomes.is_read());
                let known = list(read.map(|entry| entry.name));
                (!known.is_empty()).then(|| format!("known attributes: {known}"))
            };
            let what = format!("attribute {}", quoted(name));
            let message = Message::Ignored(what, format!("of {}", self.subject(Some(node))));
            self.push(key, self.attribute_place(&attribute), message, hint);
        }
    }

    /// Warns of text in an element whose values are attributes.
    fn text(&mut self, node: Node<'_, 't>, content: &Content) {
        let is_text = |child: &Node<'_, 't>| {
            child.is_text() && child.text().is_some_and(|text| !text.trim().is_empty())
        };
        let Some(text) = node.children().find(is_text) else {
            return;
        };
        let key = OccurrenceKey::Text(self.name(node));
        if self.is_known(&key) {
            return;
        }
        let written = text.text().unwrap_or_default();
        let blanks = written.len() - written.trim_start().len();
        let place = self.reader.positions.place(text.range().start + blanks);
        let read = content
            .attributes
            .iter()
            .filter(|entry| entry.becomes.is_read());
        let names = list(read.map(|entry| entry.name));
        let hint = (!names.is_empty()).then(|| format!("its values are attributes: {names}"));
        let message = Message::Ignored(
            "text".to_owned(),
            format!("in {}", self.subject(Some(node))),
        );
        self.push(key, place, message, hint);
    }

    fn not_modelled(
        &mut self,
        place: Place,
        (what, before): (String, &str),
        mechanics: &'static NotModelled,
        within: Option<Node<'_, 't>>,
    ) {
        let key = OccurrenceKey::NotModelled(mechanics.what);
        if self.is_known(&key) {
            return;
        }
        let item = format!("{what} {before} {}", self.subject(within));
        let hint = Some(mechanics.hint.to_owned());
        self.push(key, place, Message::NotModelled(mechanics, item), hint);
    }

    fn warn(self) {
        for found in self.found {
            let more = |one: &str, several: &str| match found.others {
                0 => String::new(),
                1 => format!(" and 1 {one}"),
                count => format!(" and {count} {several}"),
            };
            let message = match found.message {
                Message::Ignored(what, within) => {
                    let more = more("other place", "other places");
                    format!("{what} {within}{more} is ignored")
                }
                Message::NotModelled(mechanics, item) => {
                    format!(
                        "not modelled: {item}{}: {}",
                        more("other", "others"),
                        mechanics.what
                    )
                }
            };
            self.reader.warn(found.place, message, found.hint);
        }
    }

    /// The name of an element in messages.
    fn subject(&self, node: Option<Node<'_, 't>>) -> String {
        let mut text = String::new();
        let mut node = node;
        for _ in 0..NAMED {
            let Some(at) = node else { break };
            let tag = self.name(at);
            let name = at.attribute("name").or(at.attribute("reference"));
            if let Some(name) = name {
                let mut called = self.format.called.iter();
                let word = called.find(|(known, _)| *known == tag);
                let kind = word.map_or_else(|| format!("<{tag}>"), |(_, word)| (*word).to_owned());
                text.extend([&kind, " ", &quoted(name)]);
                return text;
            }
            let end = if at.parent_element().is_some() {
                " of "
            } else {
                ""
            };
            text.extend(["the <", tag, ">", end]);
            node = at.parent_element();
        }
        text.trim_end_matches(" of ").to_owned()
    }

    /// The tag of an element, with its prefix, as in the file.
    fn name(&self, node: Node<'_, 't>) -> &'t str {
        let text = &self.reader.positions.text()[node.range()];
        let text = text.strip_prefix('<').unwrap_or(text);
        let ends = |c: char| c.is_ascii_whitespace() || c == '/' || c == '>';
        &text[..text.find(ends).unwrap_or(text.len())]
    }

    /// The name of an attribute, with its prefix, as in the file.
    fn attribute_name(&self, attribute: &Attribute<'_, 't>) -> &'t str {
        let text = &self.reader.positions.text()[attribute.range()];
        let ends = |c: char| c.is_ascii_whitespace() || c == '=';
        &text[..text.find(ends).unwrap_or(text.len())]
    }

    fn attribute_place(&self, attribute: &Attribute<'_, 't>) -> Place {
        self.reader.positions.place(attribute.range().start)
    }
}

/// True if a value causes the warning of its row.
fn is_due(entry: &Entry, value: &str) -> bool {
    let value = value.trim();
    let mut numbers = value.split_ascii_whitespace().map(str::parse::<f64>);
    match entry.when {
        When::Always => true,
        When::NotZero => numbers.any(|number| number != Ok(0.0)),
        When::NotOne => numbers.any(|number| number != Ok(1.0)),
        When::True => value == "1" || value.eq_ignore_ascii_case("true"),
        When::False => value == "0" || value.eq_ignore_ascii_case("false"),
        When::NotStandardGravity => !numbers.eq([Ok(0.0), Ok(0.0), Ok(-9.81)]),
    }
}

/// The name that was probably meant: similar by spelling, or a longer or shorter form of a name that is read.
fn meant(name: &str, entries: &'static [Entry]) -> Option<&'static str> {
    let known: Vec<_> = entries.iter().map(|entry| entry.name).collect();
    let local = name.rsplit(':').next().unwrap_or(name);
    let word = local.to_lowercase();
    let is_part = |part: &str, whole: &str| part.len() > 2 && whole.contains(part);
    nearest(local, &known).or_else(|| {
        let mut read = entries.iter().filter(|entry| entry.becomes.is_read());
        let form = read.find(|entry| is_part(&word, entry.name) || is_part(entry.name, &word));
        form.map(|entry| entry.name)
    })
}

/// Counts mechanical elements in an ignored element, among its first nodes.
fn bodies(node: Node<'_, '_>, counted: &'static [&'static str]) -> Option<String> {
    const GLANCE: usize = 1000;
    let names = node.descendants().skip(1).take(GLANCE);
    let mut counts = vec![0_usize; counted.len()];
    for name in names
        .filter(Node::is_element)
        .map(|node| node.tag_name().name())
    {
        let place = counted.iter().position(|known| *known == name);
        if let Some(place) = place {
            counts[place] += 1;
        }
    }
    let counts = counts.into_iter().zip(counted);
    let counts: Vec<_> = counts
        .filter(|(count, _)| *count > 0)
        .map(|(count, name)| format!("{count} <{name}>"))
        .collect();
    let found = list(counts.iter().map(String::as_str));
    (!found.is_empty()).then(|| format!("so are the elements in it: {found}"))
}
