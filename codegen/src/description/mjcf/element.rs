//! Elements of a file and of all that it includes, as one tree.
//!
//! In: parsed files. Out: handles of elements, whose children are those that they have once each `<include>` is
//! replaced by what it includes. It reads no number.

use roxmltree::{Attribute, Node};

use super::files::Parsed;

/// An element, and the file that it stands in.
#[derive(Clone, Copy)]
pub(super) struct Element<'a> {
    files: &'a [Parsed<'a>],
    file: usize,
    pub(super) node: Node<'a, 'a>,
}

/// An attribute of an element, which may be that of a class of defaults.
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

    /// The file that it stands in.
    pub(super) fn file(self) -> &'a Parsed<'a> {
        &self.files[self.file]
    }

    pub(super) fn tag(self) -> &'a str {
        self.node.tag_name().name()
    }

    /// The elements in it, with those of included files in the place of what includes them.
    pub(super) fn children(self) -> Vec<Self> {
        let mut found = Vec::new();
        let mut waiting: Vec<Self> = self.own_children().collect();
        waiting.reverse();
        // No file is included twice, so that this ends.
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

    /// The elements in it as they stand in its file.
    pub(super) fn own_children(self) -> impl Iterator<Item = Self> {
        let children = self.node.children().filter(Node::is_element);
        children.map(move |node| Self { node, ..self })
    }

    /// The root element of the file that it includes, if it is an `<include>`.
    pub(super) fn included(self) -> Option<Self> {
        let file = self.file().included(self.node)?;
        let node = self.files[file].document.root_element();
        Some(Self { file, node, ..self })
    }

    /// The elements of a name in it.
    pub(super) fn named(self, tag: &str) -> Vec<Self> {
        let mut children = self.children();
        children.retain(|child| child.tag() == tag);
        children
    }

    /// An attribute that it has itself.
    pub(super) fn attribute(self, name: &str) -> Option<Written<'a>> {
        let attribute = self.node.attribute_node(name)?;
        Some(Written {
            element: self,
            attribute,
        })
    }
}
