//! Reads elements and attributes with their places.
//!
//! Errors about missing, repeated and malformed elements and attributes are reported here. The reader is independent of
//! the format.

use std::borrow::Cow;
use std::ops::{Range, RangeInclusive};

use roxmltree::{Attribute, Node};

use super::plain::unescaped;
use crate::description::number::{self, Refusal};
use crate::description::position::Positions;
use crate::description::{Name, Number, Unmodelled};
use crate::error::{Diagnostic, Errors, Place};
use crate::wording::quoted;

/// Maximum number of warnings.
pub(in crate::description) const MOST_WARNINGS: usize = 1000;

/// The elements of xacro itself; any other name with its prefix is a call of a macro.
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

/// Reason for the warning of trailing white space.
const ENDS_IN_SPACE: &str =
    "urdfdom, which ROS uses, rejects such a number and drops the element around it";

/// State of the reader.
pub(in crate::description) struct Reader<'r, 't> {
    pub(in crate::description) positions: &'r Positions<'t>,
    pub(in crate::description) errors: Errors,
    pub(in crate::description) warnings: Vec<Diagnostic>,
    pub(in crate::description) unmodelled: Unmodelled,
    /// True if the robot's version is missing or 1.0, until the warning of a newer element is reported.
    pub(in crate::description) is_of_version_1_0: bool,
    /// The first place that xacro should have replaced.
    pub(in crate::description) xacro: Option<Place>,
    /// The first call of a macro, which xacro leaves in place if it does not know the macro.
    pub(in crate::description) call: Option<Place>,
}

impl<'r, 't> Reader<'r, 't> {
    /// A reader that has met nothing yet.
    pub(in crate::description) fn new(positions: &'r Positions<'t>) -> Self {
        Self {
            positions,
            errors: Errors::new(),
            warnings: Vec::new(),
            unmodelled: Unmodelled::default(),
            is_of_version_1_0: false,
            xacro: None,
            call: None,
        }
    }
}

impl<'t> Reader<'_, 't> {
    /// The place of an element.
    pub(in crate::description) fn place(&self, node: Node<'_, 't>) -> Place {
        self.positions.place(node.range().start)
    }

    /// The place of an attribute's value.
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
        self.warnings.push(Diagnostic {
            place,
            message,
            hint,
        });
    }

    /// Reports an element that xacro left. Calls of macros that xacro does not know are left by it and ignored by every
    /// other reader, so they are warnings.
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
                "macro {} in {subject} was not expanded by xacro and is ignored",
                quoted(name)
            ),
            Some("xacro found no macro of that name: the elements it adds are missing".to_owned()),
        );
    }

    /// The child elements of an element.
    pub(in crate::description) fn children<'a>(node: Node<'a, 't>) -> Vec<Node<'a, 't>> {
        node.children().filter(Node::is_element).collect()
    }

    /// The only child element with a tag. A second one is a warning if it is equal, and an error if not.
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

    /// The child element with a tag; an error if it is missing.
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

    /// A name; an error if it is missing or empty.
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

    /// A number; an error if it is missing.
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

    /// Exactly `N` numbers.
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
                format!("{subject} ends in white space, which is ignored"),
                Some(ENDS_IN_SPACE.to_owned()),
            );
        }
        list.try_into().ok()
    }

    /// A list of numbers whose count is within bounds.
    pub(in crate::description) fn number_list(
        &mut self,
        attribute: &Attribute<'_, 't>,
        counts: RangeInclusive<usize>,
        subject: &str,
    ) -> Option<Vec<Number>> {
        let (start, text) = self.raw(attribute);
        let is_verbatim = matches!(text, Cow::Borrowed(_));
        self.numbers_of(start, &text, is_verbatim, counts, subject)
    }

    #[cfg(feature = "formats")]
    /// A list of numbers in the text of an element whose count is within bounds.
    pub(in crate::description) fn numbers_in_text(
        &mut self,
        node: Node<'_, 't>,
        counts: RangeInclusive<usize>,
        subject: &str,
    ) -> Option<Vec<Number>> {
        let (start, text) = self.raw_text(node);
        let is_verbatim = matches!(text, Cow::Borrowed(_));
        self.numbers_of(start, &text, is_verbatim, counts, subject)
    }

    #[cfg(feature = "formats")]
    /// The text of an element, without surrounding white space, and its place.
    pub(in crate::description) fn text_of(&self, node: Node<'_, 't>) -> Name {
        let (start, text) = self.raw_text(node);
        let blanks = text.len() - text.trim_start().len();
        Name {
            text: text.trim().replace(['\t', '\n', '\r'], " "),
            place: self.positions.place(start + blanks),
        }
    }

    #[cfg(feature = "formats")]
    /// The first text in an element, with the offset of the file.
    fn raw_text<'a>(&self, node: Node<'a, 't>) -> (usize, Cow<'t, str>) {
        let Some(text) = node.children().find(Node::is_text) else {
            return (node.range().start, Cow::Borrowed(""));
        };
        let range = text.range();
        let written = &self.positions.text()[range.clone()];
        let text = if written.contains('&') {
            Cow::Owned(unescaped(written))
        } else {
            Cow::Borrowed(written)
        };
        (range.start, text)
    }

    /// Reads the numbers of a text that begins at an offset of the file; `is_verbatim` if its characters are those of
    /// the file.
    fn numbers_of(
        &mut self,
        start: usize,
        text: &str,
        is_verbatim: bool,
        counts: RangeInclusive<usize>,
        subject: &str,
    ) -> Option<Vec<Number>> {
        if is_xacro(text) {
            self.xacro.get_or_insert(self.positions.place(start));
            return None;
        }
        if let Some((offset, what, hint)) = number::look_alike(text) {
            // With character references, offsets in the value are not those of the file.
            let offset = if is_verbatim { offset } else { 0 };
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
        for (offset, word) in words(text) {
            let place = self.positions.place(start + offset);
            match number::read(word, place) {
                Ok(found) => read.push(found),
                Err(refusal) => self.refuse(place, subject, &refusal),
            }
        }
        (read.len() == count).then_some(read)
    }

    /// Reports an error of a number.
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

    /// The value of an attribute, with line breaks as spaces.
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

    /// The place of an attribute's value, and the value with the offsets of the file.
    fn raw<'a>(&self, attribute: &Attribute<'a, 't>) -> (usize, Cow<'a, str>)
    where
        't: 'a,
    {
        raw_value(self.positions.text(), attribute.range())
    }
}

/// The value of the attribute in a range of a text, and its offset. Offsets in a borrowed value are those of the text.
pub(in crate::description) fn raw_value(whole: &str, range: Range<usize>) -> (usize, Cow<'_, str>) {
    // Searched anew, because `range_value` stores the number of blanks around `=` in one byte.
    let text = &whole[range.clone()];
    let equals = text.find('=').map_or(0, |at| at + 1);
    let blanks = text[equals..].len() - text[equals..].trim_start().len();
    let start = range.start + equals + blanks + 1;
    let value = &whole[start.min(range.end)..range.end];
    let value = value.strip_suffix(['"', '\'']).unwrap_or(value);
    if value.contains('&') {
        // Character references would shift the offsets.
        (start, Cow::Owned(unescaped(value)))
    } else {
        (start, Cow::Borrowed(value))
    }
}

/// True if the value contains an expression that xacro should have replaced.
fn is_xacro(value: &str) -> bool {
    value.contains("${") || value.contains("$(")
}

/// The words of a text with their offsets.
fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut rest = 0;
    text.split_ascii_whitespace().map(move |word| {
        let offset = rest + text[rest..].find(word).unwrap_or(0);
        rest = offset + word.len();
        (offset, word)
    })
}
