//! Elements with the places of their words: those of a file, and those that it expands to.

use std::rc::Rc;

use roxmltree::Node as XmlNode;

use crate::description::position::Positions;
use crate::description::xml::element::raw_value;
use crate::description::xml::plain::unescaped;

/// Maximum depth of elements in a file.
const MOST_NESTED: usize = 100;

/// The number of a file that was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct FileId(pub(super) usize);

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Origin {
    pub(super) file: FileId,
    pub(super) offset: usize,
}

/// A text of a file, or one that was computed from it.
#[derive(Clone, Debug)]
pub(super) struct Written {
    pub(super) text: Rc<str>,
    pub(super) origin: Origin,
    /// True if offsets in the text are those of the file.
    pub(super) is_verbatim: bool,
}

impl Written {
    /// The place of a byte of the text.
    pub(super) fn place(&self, at: usize) -> Origin {
        Origin {
            offset: self.origin.offset + if self.is_verbatim { at } else { 0 },
            ..self.origin
        }
    }
}

/// An attribute, with the prefix of its name.
#[derive(Clone, Debug)]
pub(super) struct Attribute {
    pub(super) name: Rc<str>,
    /// The place of its name.
    pub(super) origin: Origin,
    pub(super) value: Written,
}

/// An element, with the prefix of its name.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: Rc<str>,
    pub(super) attributes: Vec<Attribute>,
    pub(super) children: Vec<Node>,
    pub(super) origin: Origin,
}

impl Element {
    pub(super) fn attribute(&self, name: &str) -> Option<&Written> {
        let mut attributes = self.attributes.iter();
        let found = attributes.find(|attribute| &*attribute.name == name);
        found.map(|attribute| &attribute.value)
    }
}

/// A child of an element.
#[derive(Clone, Debug)]
pub(super) enum Node {
    Element(Rc<Element>),
    Text(Written),
    /// Text that is not evaluated: `<![CDATA[…]]>`.
    Literal(Written),
}

/// The elements of a parsed file. `Err` with the place of an element that is nested too deeply.
pub(super) fn elements(
    root: XmlNode<'_, '_>,
    positions: &Positions<'_>,
    file: FileId,
) -> Result<Rc<Element>, Origin> {
    let reader = TreeReader {
        text: positions.text(),
        file,
    };
    reader.element(root, 0).map(Rc::new)
}

struct TreeReader<'t> {
    text: &'t str,
    file: FileId,
}

impl TreeReader<'_> {
    fn origin(&self, offset: usize) -> Origin {
        Origin {
            file: self.file,
            offset,
        }
    }

    fn element(&self, node: XmlNode<'_, '_>, depth: usize) -> Result<Element, Origin> {
        let start = node.range().start;
        if depth > MOST_NESTED {
            return Err(self.origin(start));
        }
        let mut children = Vec::new();
        for child in node.children() {
            if child.is_element() {
                let element = self.element(child, depth + 1)?;
                children.push(Node::Element(Rc::new(element)));
            } else if child.is_text() {
                self.texts(child, &mut children);
            }
        }
        Ok(Element {
            name: self.name(start + 1, &['/', '>']),
            attributes: node
                .attributes()
                .map(|attribute| Attribute {
                    name: self.name(attribute.range().start, &['=']),
                    origin: self.origin(attribute.range().start),
                    value: self.value(attribute.range()),
                })
                .collect(),
            children,
            origin: self.origin(start),
        })
    }

    /// A name with its prefix.
    fn name(&self, start: usize, ends: &[char]) -> Rc<str> {
        let text = &self.text[start..];
        let is_end = |letter: char| letter.is_ascii_whitespace() || ends.contains(&letter);
        text[..text.find(is_end).unwrap_or(text.len())].into()
    }

    /// The value of an attribute, with line breaks as spaces.
    fn value(&self, range: std::ops::Range<usize>) -> Written {
        let (offset, value) = raw_value(self.text, range);
        let is_verbatim = matches!(value, std::borrow::Cow::Borrowed(_));
        let text = if value.contains(['\t', '\n', '\r']) {
            value.replace(['\t', '\n', '\r'], " ").into()
        } else {
            value.into()
        };
        Written {
            text,
            origin: self.origin(offset),
            is_verbatim,
        }
    }

    /// The pieces of a text: what is evaluated and what is literal.
    fn texts(&self, node: XmlNode<'_, '_>, into: &mut Vec<Node>) {
        const OPEN: &str = "<![CDATA[";
        const CLOSE: &str = "]]>";
        // The parser joins texts, and keeps the range of the first one.
        let end = match (node.next_sibling(), node.parent()) {
            (Some(next), _) => next.range().start,
            (None, Some(parent)) => {
                let parent = &self.text[..parent.range().end];
                parent.rfind("</").unwrap_or(parent.len())
            }
            (None, None) => node.range().end,
        };
        let mut at = node.range().start;
        while at < end {
            let rest = &self.text[at..end];
            if let Some(inside) = rest.strip_prefix(OPEN) {
                let length = inside.find(CLOSE).unwrap_or(inside.len());
                into.push(Node::Literal(Written {
                    text: inside[..length].into(),
                    origin: self.origin(at + OPEN.len()),
                    is_verbatim: true,
                }));
                at += OPEN.len() + length + CLOSE.len();
            } else {
                let length = rest.find(OPEN).unwrap_or(rest.len());
                let raw = &rest[..length];
                let is_verbatim = !raw.contains('&');
                into.push(Node::Text(Written {
                    text: if is_verbatim {
                        raw.into()
                    } else {
                        unescaped(raw).into()
                    },
                    origin: self.origin(at),
                    is_verbatim,
                }));
                at += length;
            }
        }
    }
}
