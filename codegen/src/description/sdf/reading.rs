//! State of the reader, and values of elements.

use std::collections::HashMap;

use super::element::Element;
use super::frames::Frames;
use super::index::{FrameIndex, ScopeIndex};
use super::scope::Scope;
use crate::description::fresh::FreshNames;
use crate::description::xml::element::Reader;
use crate::description::{Joint, Link, LinkId, Name, Number, number};
use crate::error::Place;
use crate::list::Id;
use crate::wording::quoted;

/// State of the reader.
pub(super) struct Sdf<'a> {
    pub(super) reader: Reader<'a, 'a>,
    pub(super) frames: Frames<'a>,
    pub(super) scopes: Vec<Scope>,
    pub(super) links: Vec<Link>,
    /// The frame of each link that is one in the file.
    pub(super) link_frames: Vec<FrameIndex>,
    pub(super) joints: Vec<Joint>,
    /// The number of each joint, by its frame.
    pub(super) parts: HashMap<FrameIndex, usize>,
    /// Joints whose links are not known yet.
    pub(super) pending: Vec<PendingJoint<'a>>,
    /// The files of the models that are being read, which must not include each other in a circle.
    pub(super) open: Vec<usize>,
    /// The names of links and named frames.
    pub(super) link_names: FreshNames,
    pub(super) joint_names: FreshNames,
    /// True if the world is one of the links.
    pub(super) has_world: bool,
}

/// A joint whose links are not known yet.
#[derive(Clone, Copy)]
pub(super) struct PendingJoint<'a> {
    pub(super) element: Element<'a>,
    pub(super) scope: ScopeIndex,
    pub(super) frame: FrameIndex,
}

/// The ends of a joint: frames of links, `None` for the world.
pub(super) struct Ends {
    pub(super) parent: Option<LinkId>,
    pub(super) child: LinkId,
}

impl<'a> Sdf<'a> {
    pub(super) fn link_frame(&self, link: LinkId) -> FrameIndex {
        self.link_frames[link.index()]
    }

    pub(super) fn link_name(&self, link: LinkId) -> &Name {
        &self.links[link.index()].name
    }

    /// The reader, set to the file of an element.
    pub(super) fn at(&mut self, element: Element<'a>) -> &mut Reader<'a, 'a> {
        self.reader.positions = &element.parsed().positions;
        &mut self.reader
    }

    /// The place of an element.
    pub(super) fn place(&mut self, element: Element<'a>) -> Place {
        self.at(element).place(element.node)
    }

    /// Reports an error at an element.
    pub(super) fn refuse(&mut self, element: Element<'a>, message: String, hint: &str) {
        let place = self.place(element);
        self.reader.errors.push_with_hint(place, message, hint);
    }

    /// Reports a warning at an element.
    pub(super) fn warn(&mut self, element: Element<'a>, message: String, hint: &str) {
        let place = self.place(element);
        self.reader.warn(place, message, Some(hint.to_owned()));
    }

    /// The name of an element; an error if it has none.
    pub(super) fn name(&mut self, element: Element<'a>, subject: &str) -> Option<Name> {
        self.at(element).name(element.node, "name", subject)
    }

    /// The text of a child element.
    pub(super) fn text(&mut self, element: Element<'a>, tag: &str) -> Option<Name> {
        let child = element.first(tag)?;
        Some(self.at(child).text_of(child.node)).filter(|text| !text.text.is_empty())
    }

    /// The value of an attribute.
    pub(super) fn word(&mut self, element: Element<'a>, name: &str) -> Option<Name> {
        let attribute = element.attribute(name)?;
        let reader = self.at(element);
        let text = reader.value(&attribute).trim().to_owned();
        let place = reader.value_place(&attribute);
        (!text.is_empty()).then_some(Name { text, place })
    }

    /// The number in a child element. `None` if there is none, or a malformed one, which is an error.
    pub(super) fn number(
        &mut self,
        element: Element<'a>,
        tag: &str,
        subject: &str,
    ) -> Option<Number> {
        let child = element.first(tag)?;
        let subject = format!("the <{tag}> of {subject}");
        let list = self
            .at(child)
            .numbers_in_text(child.node, 1..=1, &subject)?;
        list.first().copied()
    }

    /// A limit in a child element; `otherwise` without one. Numbers from 1e16 on are infinite, as in older versions.
    pub(super) fn limit(
        &mut self,
        element: Element<'a>,
        tag: &str,
        otherwise: f64,
        subject: &str,
    ) -> f64 {
        const NONE: f64 = 1e16;
        let Some(written) = self.text(element, tag) else {
            return otherwise;
        };
        match number::read_bound(&written.text) {
            Ok(bound) if bound.abs() >= NONE => bound * f64::INFINITY,
            Ok(bound) => bound,
            Err(refusal) => {
                let subject = format!("the <{tag}> of {subject}");
                self.reader.refuse(written.place, &subject, &refusal);
                otherwise
            }
        }
    }

    /// `true` or `false` in a child element; false without one.
    pub(super) fn flag(&mut self, element: Element<'a>, tag: &str, subject: &str) -> bool {
        let Some(written) = self.text(element, tag) else {
            return false;
        };
        match written.text.to_ascii_lowercase().as_str() {
            "true" | "1" => true,
            "false" | "0" => false,
            _ => {
                let message = format!("the <{tag}> of {subject} is {}", quoted(&written.text));
                let hint = "write true or false";
                self.reader
                    .errors
                    .push_with_hint(written.place, message, hint);
                false
            }
        }
    }
}
