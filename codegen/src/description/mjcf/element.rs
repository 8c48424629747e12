//! Elements of a file and its included files, as one tree.
//!
//! Each `<include>` is replaced by the children of the root element of the file that it names. A `<model>` leads to the
//! root element of its file.

use roxmltree::{Attribute, Node};

use super::files::{INCLUDE, MODEL};
use crate::description::xml::texts::Parsed;

/// An element with its file.
#[derive(Clone, Copy)]
pub(super) struct Element<'a> {
    files: &'a [Parsed<'a>],
    file: usize,
    pub(super) node: Node<'a, 'a>,
}

/// An attribute of an element or of its class of defaults.
#[derive(Clone, Copy)]
pub(super) struct Written<'a> {
    pub(super) element: Element<'a>,
    pub(super) attribute: Attribute<'a, 'a>,
}

impl<'a> Element<'a> {
    /// The root element of the first file.
    pub(super) fn root(files: &'a [Parsed<'a>]) -> Self {
        Self {
            files,
            file: 0,
            node: files[0].document.root_element(),
        }
    }

    /// The file that contains the element.
    pub(super) fn file(self) -> &'a Parsed<'a> {
        &self.files[self.file]
    }

    pub(super) fn tag(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// The child elements, with each `<include>` replaced by the elements of its file.
    pub(super) fn children(self) -> Vec<Self> {
        let mut found = Vec::new();
        let mut waiting: Vec<Self> = self.own_children().collect();
        waiting.reverse();
        // This ends because a model includes no file twice.
        while let Some(element) = waiting.pop() {
            let Some(root) = element.included() else {
                found.push(element);
                continue;
            };
            let before = waiting.len();
            waiting.extend(root.own_children());
            waiting[before..].reverse();
        }
        found
    }

    /// The child elements as written in its file.
    pub(super) fn own_children(self) -> impl Iterator<Item = Self> {
        let children = self.node.children().filter(Node::is_element);
        children.map(move |node| Self { node, ..self })
    }

    /// The root element of the included file, if the element is an `<include>`.
    pub(super) fn included(self) -> Option<Self> {
        (self.tag() == INCLUDE).then(|| self.named_file()).flatten()
    }

    /// The root element of the model's file, if the element is a `<model>`.
    pub(super) fn model(self) -> Option<Self> {
        (self.tag() == MODEL).then(|| self.named_file()).flatten()
    }

    fn named_file(self) -> Option<Self> {
        let file = self.file().included(self.node)?;
        let node = self.files[file].document.root_element();
        Some(Self { file, node, ..self })
    }

    /// The child elements with a tag.
    pub(super) fn named(self, tag: &str) -> Vec<Self> {
        let mut children = self.children();
        children.retain(|child| child.tag() == tag);
        children
    }

    /// An attribute of the element itself.
    pub(super) fn attribute(self, name: &str) -> Option<Written<'a>> {
        let attribute = self.node.attribute_node(name)?;
        Some(Written {
            element: self,
            attribute,
        })
    }
}
