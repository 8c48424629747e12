//! Elements and attributes with their places.
//!
//! In: nodes of the document. Out: names and numbers that know where they stand; complaints about
//! those that are missing, given twice, or not what they should be. It never knows what a link or
//! a joint is.

use std::borrow::Cow;
use std::ops::RangeInclusive;

use roxmltree::{Attribute, Node};

use super::plain::unescaped;
use crate::description::number::{self, Refusal};
use crate::description::position::Positions;
use crate::description::{Name, Number, Unmodelled};
use crate::error::{Complaint, Errors, Place};
use crate::wording::quoted;

/// The most warnings.
pub(in crate::description) const MOST_WARNINGS: usize = 1000;

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
pub(in crate::description) struct Reader<'r, 't> {
    pub(in crate::description) positions: &'r Positions<'t>,
    pub(in crate::description) errors: Errors,
    pub(in crate::description) warnings: Vec<Complaint>,
    pub(in crate::description) unmodelled: Unmodelled,
    /// Whether the robot has no version, or 1.0, and nobody has said yet that it should have another.
    pub(in crate::description) is_of_version_1_0: bool,
    /// Where something stands that xacro should have replaced.
    pub(in crate::description) xacro: Option<Place>,
    /// Where a macro is called that xacro may have left because it did not know it.
    pub(in crate::description) call: Option<Place>,
}

impl<'t> Reader<'_, 't> {
    /// Where an element begins.
    pub(in crate::description) fn place(&self, node: Node<'_, 't>) -> Place {
        self.positions.place(node.range().start)
    }

    /// Where the value of an attribute begins.
    pub(in crate::description) fn value_place(&self, attribute: &Attribute<'_, 't>) -> Place {
        self.positions.place(self.raw(attribute).0)
    }

    pub(in crate::description) fn warn(
        &mut self,
        place: Place,
        message: String,
        hint: Option<String>,
    ) {
        if self.warnings.len() == MOST_WARNINGS {
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
    pub(in crate::description) fn left_by_xacro(
        &mut self,
        place: Place,
        name: &str,
        subject: &str,
    ) {
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

    /// The elements within an element.
    pub(in crate::description) fn children<'a>(node: Node<'a, 't>) -> Vec<Node<'a, 't>> {
        node.children().filter(Node::is_element).collect()
    }

    /// The one element of that name; complains of a second one that says anything else.
    pub(in crate::description) fn only<'a>(
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
    pub(in crate::description) fn required<'a>(
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
    pub(in crate::description) fn name(
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
    pub(in crate::description) fn number(
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
    pub(in crate::description) fn numbers<const N: usize>(
        &mut self,
        attribute: &Attribute<'_, 't>,
        subject: &str,
    ) -> Option<[Number; N]> {
        let list = self.number_list(attribute, N..=N, subject)?;
        let (start, text) = self.raw(attribute);
        if N == 1 && text.ends_with(|end: char| end.is_ascii_whitespace()) {
            self.warn(
                self.positions.place(start),
                format!("{subject} ends in white space, which is passed over"),
                Some(ENDS_IN_SPACE.to_owned()),
            );
        }
        list.try_into().ok()
    }

    /// Between so many numbers and so many.
    pub(in crate::description) fn number_list(
        &mut self,
        attribute: &Attribute<'_, 't>,
        counts: RangeInclusive<usize>,
        subject: &str,
    ) -> Option<Vec<Number>> {
        let (start, text) = self.raw(attribute);
        if is_xacro(&text) {
            self.xacro.get_or_insert(self.positions.place(start));
            return None;
        }
        if let Some((offset, what, hint)) = number::look_alike(&text) {
            // In a value with references, offsets are not those of the file.
            let offset = if matches!(text, Cow::Borrowed(_)) {
                offset
            } else {
                0
            };
            let place = self.positions.place(start + offset);
            self.errors
                .push_with_hint(place, format!("{subject} {what}"), hint);
            return None;
        }
        let count = text.split_ascii_whitespace().count();
        if !counts.contains(&count) {
            let numbers = if count == 1 { "number" } else { "numbers" };
            let (least, most) = counts.into_inner();
            let wanted = if least == most {
                most.to_string()
            } else {
                format!("{least} to {most}")
            };
            let message = format!("{subject} has {count} {numbers} instead of {wanted}");
            let place = self.positions.place(start);
            if text.contains([',', ';']) {
                let hint = "write spaces between numbers, and decimal points in them";
                self.errors.push_with_hint(place, message, hint);
            } else {
                self.errors.push(place, message);
            }
            return None;
        }
        let mut read = Vec::with_capacity(count);
        for (offset, word) in words(&text) {
            let place = self.positions.place(start + offset);
            match number::read(word, place) {
                Ok(found) => read.push(found),
                Err(refusal) => self.refuse(place, subject, &refusal),
            }
        }
        (read.len() == count).then_some(read)
    }

    /// Complains of a number.
    pub(in crate::description) fn refuse(
        &mut self,
        place: Place,
        subject: &str,
        refusal: &Refusal,
    ) {
        let message = format!("{subject} {}", refusal.what);
        match refusal.hint {
            Some(hint) => self.errors.push_with_hint(place, message, hint),
            None => self.errors.push(place, message),
        }
    }

    /// The value of an attribute in one line.
    pub(in crate::description) fn value<'a>(&self, attribute: &Attribute<'a, 't>) -> Cow<'a, str>
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
