//! Writes expanded elements as text, with the place of each word in the files that it comes from.

use super::tree::{Attribute, Element, Node, Origin, Written};

/// A part of the text that comes from one place.
pub(super) struct Fragment {
    /// Offset of its beginning in the text.
    pub(super) start: usize,
    pub(super) origin: Origin,
    /// True if its characters are those of the file.
    pub(super) is_verbatim: bool,
}

/// The text of an element, and the places of its words.
pub(super) fn write(root: &Element) -> (String, Vec<Fragment>) {
    let mut writer = XmlWriter {
        text: String::new(),
        fragments: Vec::new(),
    };
    writer.element(root, 0);
    writer.text.push('\n');
    (writer.text, writer.fragments)
}

struct XmlWriter {
    text: String,
    fragments: Vec<Fragment>,
}

impl XmlWriter {
    /// Notes that the following text comes from a place.
    fn mark(&mut self, origin: Origin, is_verbatim: bool) {
        self.fragments.push(Fragment {
            start: self.text.len(),
            origin,
            is_verbatim,
        });
    }

    fn element(&mut self, element: &Element, depth: usize) {
        self.mark(element.origin, false);
        self.text.push('<');
        self.text.push_str(&element.name);
        for attribute in &element.attributes {
            self.attribute(attribute);
        }
        let is_blank =
            |node: &Node| matches!(node, Node::Text(text) if text.text.trim().is_empty());
        let children = || element.children.iter().filter(|node| !is_blank(node));
        if children().next().is_none() {
            self.text.push_str("/>");
            return;
        }
        self.text.push('>');
        let has_text = children().any(|node| !matches!(node, Node::Element(_)));
        for child in children() {
            match child {
                Node::Element(inner) => {
                    if !has_text {
                        self.line(depth + 1);
                    }
                    self.element(inner, depth + 1);
                }
                Node::Text(text) | Node::Literal(text) => self.value(text, false),
            }
        }
        if !has_text {
            self.line(depth);
        }
        self.text.push_str("</");
        self.text.push_str(&element.name);
        self.text.push('>');
    }

    fn line(&mut self, depth: usize) {
        self.text.push('\n');
        self.text.extend(std::iter::repeat_n("  ", depth));
    }

    fn attribute(&mut self, attribute: &Attribute) {
        self.text.push(' ');
        self.mark(attribute.origin, false);
        self.text.push_str(&attribute.name);
        self.text.push_str("=\"");
        self.value(&attribute.value, true);
        self.text.push('"');
    }

    fn value(&mut self, written: &Written, is_attribute: bool) {
        self.mark(written.origin, written.is_verbatim);
        for letter in written.text.chars() {
            match letter {
                '&' => self.text.push_str("&amp;"),
                '<' => self.text.push_str("&lt;"),
                '>' => self.text.push_str("&gt;"),
                '"' if is_attribute => self.text.push_str("&quot;"),
                // A line break in an attribute is a space to every reader.
                '\n' | '\r' | '\t' if is_attribute => self.text.push(' '),
                letter => self.text.push(letter),
            }
        }
    }
}
