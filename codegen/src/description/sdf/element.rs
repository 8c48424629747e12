//! Elements with their files.

use roxmltree::{Attribute, Node};

use crate::description::xml::texts::Parsed;

/// An element with its file.
#[derive(Clone, Copy)]
pub(super) struct Element<'a> {
    files: &'a [Parsed<'a>],
    /// The number of its file; 0 for the first.
    pub(super) file: usize,
    pub(super) node: Node<'a, 'a>,
}

impl<'a> Element<'a> {
    /// The root element of a file.
    pub(super) fn root(files: &'a [Parsed<'a>], file: usize) -> Self {
        let node = files[file].document.root_element();
        Self { files, file, node }
    }

    /// All files.
    pub(super) const fn files(self) -> &'a [Parsed<'a>] {
        self.files
    }

    /// The number of files.
    pub(super) const fn count(self) -> usize {
        self.files.len()
    }

    /// The root element of the file that an `<include>` names.
    pub(super) fn included(self) -> Option<Self> {
        let file = self.files[self.file].included(self.node)?;
        Some(Self::root(self.files, file))
    }

    pub(super) fn parsed(self) -> &'a Parsed<'a> {
        &self.files[self.file]
    }

    pub(super) fn tag(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// The child elements.
    pub(super) fn children(self) -> impl Iterator<Item = Self> {
        let children = self.node.children().filter(Node::is_element);
        children.map(move |node| Self { node, ..self })
    }

    /// The child elements with a tag.
    pub(super) fn named(self, tag: &str) -> impl Iterator<Item = Self> {
        self.children().filter(move |child| child.tag() == tag)
    }

    /// The first child element with a tag.
    pub(super) fn first(self, tag: &str) -> Option<Self> {
        self.named(tag).next()
    }

    pub(super) fn attribute(self, name: &str) -> Option<Attribute<'a, 'a>> {
        self.node.attribute_node(name)
    }
}
