//! Elements and attributes with their places.
//!
//! In: nodes of the document. Out: names and numbers that know where they stand; complaints about
//! those that are missing, given twice, or not what they should be. It never knows what a link or
//! a joint is.

use std::borrow::Cow;

use roxmltree::{Attribute, Node};

use super::plain::{FOR_COLON, unescaped};
use crate::description::number::{self, Refusal};
use crate::description::position::Positions;
use crate::description::{Axis, Name, Number, Step, Unmodelled};
use crate::error::{Complaint, Errors, Place};
use crate::wording::{nearest, quoted};

/// The most warnings, and the most unknown elements that are looked at.
const MOST_DOUBTS: usize = 1000;

/// The elements of xacro itself; of any other name is the call of a macro.
const OF_XACRO: [&str; 10] = [
    "arg",
    "attribute",
    "call",
    "element",
    "if",
    "include",
    "insert_block",
    "macro",
    "property",
    "unless",
];

/// Why a number alone should end with its last digit.
const ENDS_IN_SPACE: &str =
    "urdfdom, with which ROS reads, takes it for no number and leaves out what it is part of";

/// What reading has found so far.
pub(super) struct Reader<'r, 't> {
    pub(super) positions: &'r Positions<'t>,
    pub(super) errors: Errors,
    pub(super) warnings: Vec<Complaint>,
    pub(super) unmodelled: Unmodelled,
    /// How many elements of unknown names were met.
    pub(super) unknown: usize,
    /// Where something stands that xacro should have replaced.
    pub(super) xacro: Option<Place>,
    /// Where a macro is called that xacro may have left because it did not know it.
    pub(super) call: Option<Place>,
}

impl<'t> Reader<'_, 't> {
    /// Where an element begins.
    pub(super) fn place(&self, node: Node<'_, 't>) -> Place {
        self.positions.place(node.range().start)
    }

    /// Where the value of an attribute begins.
    pub(super) fn value_place(&self, attribute: &Attribute<'_, 't>) -> Place {
        self.positions.place(self.raw(attribute).0)
    }

    pub(super) fn warn(&mut self, place: Place, message: String, hint: Option<String>) {
        if self.warnings.len() == MOST_DOUBTS {
            return;
        }
        self.warnings.push(Complaint {
            place,
            message,
            hint,
        });
    }

    /// An element that xacro should have replaced, unless it is the call of a macro that it did not know: those it
    /// leaves, and every other reader passes over them.
    fn left_by_xacro(&mut self, place: Place, name: &str, subject: &str) {
        if OF_XACRO.contains(&name) {
            self.xacro.get_or_insert(place);
            return;
        }
        self.call.get_or_insert(place);
        self.warn(
            place,
            format!(
                "macro {} that xacro left in {subject} is ignored",
                quoted(name)
            ),
            Some("xacro knew no macro of that name: what it adds is missing".to_owned()),
        );
    }

    /// The elements within an element; warns of those that look like a slip of a known one, since
    /// a misspelt `<origin>` would move the robot.
    pub(super) fn children<'a>(
        &mut self,
        node: Node<'a, 't>,
        subject: &str,
        known: &[&'static str],
    ) -> Vec<Node<'a, 't>> {
        let children: Vec<_> = node.children().filter(Node::is_element).collect();
        for child in &children {
            let name = child.tag_name().name();
            let prefixed = name.split_once(FOR_COLON);
            if let Some(("xacro", name)) = prefixed {
                self.left_by_xacro(self.place(*child), name, subject);
            } else if self.unknown < MOST_DOUBTS && prefixed.is_none() && !known.contains(&name) {
                self.unknown += 1;
                let Some(meant) = nearest(name, known) else {
                    continue;
                };
                self.warn(
                    self.place(*child),
                    format!("<{name}> in {subject} is ignored"),
                    Some(format!("did you mean <{meant}>?")),
                );
            }
        }
        children
    }

    /// The one element of that name; complains of a second one that says anything else.
    pub(super) fn only<'a>(
        &mut self,
        children: &[Node<'a, 't>],
        name: &str,
        subject: &str,
    ) -> Option<Node<'a, 't>> {
        let mut found = children
            .iter()
            .filter(|child| child.tag_name().name() == name);
        let first = found.next();
        if let (Some(first), Some(second)) = (first, found.next()) {
            let place = self.place(*second);
            let text = |node: &Node<'a, 't>| &self.positions.text()[node.range()];
            if text(first) == text(second) {
                self.warn(
                    place,
                    format!("{subject} has the same <{name}> twice"),
                    None,
                );
            } else {
                let message = format!("{subject} has more than one <{name}>");
                self.errors.push(place, message);
            }
        }
        first.copied()
    }

    /// The element of that name; complains where it is missing.
    pub(super) fn required<'a>(
        &mut self,
        parent: Node<'a, 't>,
        children: &[Node<'a, 't>],
        name: &str,
        subject: &str,
        hint: &str,
    ) -> Option<Node<'a, 't>> {
        let found = self.only(children, name, subject);
        if found.is_none() {
            self.errors.push_with_hint(
                self.place(parent),
                format!("{subject} has no <{name}>"),
                format!("add {hint}"),
            );
        }
        found
    }

    /// A name that must not be missing or empty.
    pub(super) fn name(
        &mut self,
        node: Node<'_, 't>,
        attribute: &str,
        subject: &str,
    ) -> Option<Name> {
        let Some(found) = node.attribute_node(attribute) else {
            self.errors.push(
                self.place(node),
                format!("{subject} has no attribute {}", quoted(attribute)),
            );
            return None;
        };
        let place = self.value_place(&found);
        let text = self.value(&found);
        if is_xacro(&text) {
            self.xacro.get_or_insert(place);
        }
        if text.trim().is_empty() {
            let attribute = quoted(attribute);
            self.errors.push(
                place,
                format!("{subject} has an empty attribute {attribute}"),
            );
            return None;
        }
        Some(Name {
            text: text.into_owned(),
            place,
        })
    }

    /// One number that must not be missing.
    pub(super) fn number(
        &mut self,
        node: Node<'_, 't>,
        attribute: &str,
        subject: &str,
    ) -> Option<Number> {
        let Some(found) = node.attribute_node(attribute) else {
            self.errors
                .push(self.place(node), format!("{subject} is missing"));
            return None;
        };
        self.numbers(&found, subject).map(|[number]| number)
    }

    /// As many numbers as are needed.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        attribute: &Attribute<'_, 't>,
        subject: &str,
    ) -> Option<[Number; N]> {
        let (start, text) = self.raw(attribute);
        if is_xacro(&text) {
            self.xacro.get_or_insert(self.positions.place(start));
            return None;
        }
        let count = text.split_ascii_whitespace().count();
        if count != N {
            let numbers = if count == 1 { "number" } else { "numbers" };
            let message = format!("{subject} has {count} {numbers} instead of {N}");
            self.errors.push(self.positions.place(start), message);
            return None;
        }
        if N == 1 && text.ends_with(|end: char| end.is_ascii_whitespace()) {
            self.warn(
                self.positions.place(start),
                format!("{subject} ends in white space, which is passed over"),
                Some(ENDS_IN_SPACE.to_owned()),
            );
        }
        let mut read = [Number::default(); N];
        let mut fine = true;
        for (number, (offset, word)) in read.iter_mut().zip(words(&text)) {
            let place = self.positions.place(start + offset);
            match number::read(word, place) {
                Ok(found) => *number = found,
                Err(refusal) => {
                    self.refuse(place, subject, &refusal);
                    fine = false;
                }
            }
        }
        fine.then_some(read)
    }

    /// Complains of a number.
    pub(super) fn refuse(&mut self, place: Place, subject: &str, refusal: &Refusal) {
        let message = format!("{subject} {}", refusal.what);
        match refusal.hint {
            Some(hint) => self.errors.push_with_hint(place, message, hint),
            None => self.errors.push(place, message),
        }
    }

    /// The placement in `<origin xyz="…" rpy="…"/>`; none means that frames coincide.
    pub(super) fn origin(&mut self, origin: Option<Node<'_, 't>>, subject: &str) -> Vec<Step> {
        origin.map_or_else(Vec::new, |node| self.placement(node, subject, &[]))
    }

    /// The placement that an element has in its own `xyz` and `rpy`, beside attributes that are read
    /// elsewhere.
    pub(super) fn placement(
        &mut self,
        node: Node<'_, 't>,
        subject: &str,
        beside: &[&str],
    ) -> Vec<Step> {
        let mut steps = Vec::new();
        for attribute in node.attributes() {
            let name = attribute.name();
            if name == "quat_xyzw" {
                self.errors.push_with_hint(
                    self.value_place(&attribute),
                    format!("the origin of {subject} has a quaternion, which is not read"),
                    "write rpy=\"roll pitch yaw\"",
                );
            } else if !matches!(name, "xyz" | "rpy") && !beside.contains(&name) {
                self.warn(
                    self.positions.place(attribute.range().start),
                    format!(
                        "attribute {} of the origin of {subject} is ignored",
                        quoted(name)
                    ),
                    Some("an origin has xyz and rpy".to_owned()),
                );
            }
        }
        if let Some(xyz) = node.attribute_node("xyz") {
            let subject = format!("xyz of the origin of {subject}");
            steps.extend(self.numbers(&xyz, &subject).map(Step::Translate));
        }
        if let Some(rpy) = node.attribute_node("rpy") {
            let subject = format!("rpy of the origin of {subject}");
            if let Some([roll, pitch, yaw]) = self.numbers(&rpy, &subject) {
                // Roll, pitch and yaw turn about fixed axes, which is the reverse order about
                // moving ones.
                steps.push(Step::Rotate(Axis::Z, yaw));
                steps.push(Step::Rotate(Axis::Y, pitch));
                steps.push(Step::Rotate(Axis::X, roll));
            }
        }
        steps
    }

    /// The value of an attribute in one line.
    pub(super) fn value<'a>(&self, attribute: &Attribute<'a, 't>) -> Cow<'a, str>
    where
        't: 'a,
    {
        let (_, text) = self.raw(attribute);
        if text.contains(char::is_control) {
            Cow::Owned(text.replace(['\t', '\n', '\r'], " "))
        } else {
            text
        }
    }

    /// Where the value of an attribute begins, and the value with offsets as in the file.
    fn raw<'a>(&self, attribute: &Attribute<'a, 't>) -> (usize, Cow<'a, str>)
    where
        't: 'a,
    {
        // Found anew: `range_value` counts the blanks around `=` in a byte.
        let range = attribute.range();
        let text = &self.positions.text()[range.clone()];
        let equals = text.find('=').map_or(0, |at| at + 1);
        let blanks = text[equals..].len() - text[equals..].trim_start().len();
        let start = range.start + equals + blanks + 1;
        let value = &self.positions.text()[start.min(range.end)..range.end];
        let value = value.strip_suffix(['"', '\'']).unwrap_or(value);
        if value.contains('&') {
            // Offsets within a value with character references would be off by their lengths.
            (start, Cow::Owned(unescaped(value)))
        } else {
            (start, Cow::Borrowed(value))
        }
    }
}

/// Whether xacro should have replaced something in this value.
fn is_xacro(value: &str) -> bool {
    value.contains("${") || value.contains("$(")
}

/// The words of a text and their offsets.
fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut rest = 0;
    text.split_ascii_whitespace().map(move |word| {
        let offset = rest + text[rest..].find(word).unwrap_or(0);
        rest = offset + word.len();
        (offset, word)
    })
}
