//! Values of attributes: numbers, words and names, each with its place.
//!
//! Missing attributes are looked up in the classes of defaults. Malformed values are reported as errors.

use std::ops::RangeInclusive;
use std::rc::Rc;

use super::class::Class;
use super::element::{Element, Written};
use super::reading::Mjcf;
use crate::description::xml::element::Reader;
use crate::description::{Name, Number};
use crate::error::Place;
use crate::wording::{known, quoted};

/// The attributes of an element, with its class of defaults.
#[derive(Clone)]
pub(super) struct Attributes<'a> {
    pub(super) own: Element<'a>,
    /// The tag of such elements in classes of defaults.
    pub(super) kind: &'static str,
    pub(super) class: Rc<Class<'a>>,
}

impl<'a> Attributes<'a> {
    /// The value of an attribute: the element's own, or else that of the class.
    pub(super) fn get(&self, name: &str) -> Option<Written<'a>> {
        let own = self.own.attribute(name);
        own.or_else(|| self.class.attributes(self.kind, name).last().copied())
    }

    /// All values of an attribute, from the outermost class to the element itself.
    pub(super) fn all(&self, name: &str) -> Vec<Written<'a>> {
        let mut found = self.class.attributes(self.kind, name);
        found.extend(self.own.attribute(name));
        found
    }
}

impl<'a> Mjcf<'a> {
    /// The reader, set to the file of an element.
    pub(super) fn at(&mut self, element: Element<'a>) -> &mut Reader<'a, 'a> {
        self.reader.positions = &element.file().positions;
        &mut self.reader
    }

    /// The place of an element.
    pub(super) fn place(&mut self, element: Element<'a>) -> Place {
        self.at(element).place(element.node)
    }

    /// The place of an attribute's value.
    pub(super) fn place_of(&mut self, written: Written<'a>) -> Place {
        self.at(written.element).value_place(&written.attribute)
    }

    /// Reports an error at an element.
    pub(super) fn refuse(&mut self, element: Element<'a>, message: String, hint: &str) {
        let place = self.place(element);
        self.reader.errors.push_with_hint(place, message, hint);
    }

    /// Exactly `N` numbers. `None` if the attribute is missing or malformed; the latter is an error.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        written: Option<Written<'a>>,
        subject: &str,
    ) -> Option<[Number; N]> {
        let list = self.list(written?, N..=N, subject)?;
        list.try_into().ok()
    }

    /// A single number.
    pub(super) fn number(&mut self, written: Option<Written<'a>>, subject: &str) -> Option<Number> {
        self.numbers(written, subject).map(|[number]| number)
    }

    /// A list of numbers whose count is within bounds.
    pub(super) fn list(
        &mut self,
        written: Written<'a>,
        counts: RangeInclusive<usize>,
        subject: &str,
    ) -> Option<Vec<Number>> {
        let subject = format!("{} of {subject}", written.attribute.name());
        let reader = self.at(written.element);
        reader.number_list(&written.attribute, counts, &subject)
    }

    /// Up to `N` numbers: entries that the element leaves out are those of its class.
    pub(super) fn entries<const N: usize>(
        &mut self,
        attributes: &Attributes<'a>,
        name: &str,
        subject: &str,
    ) -> [Option<Number>; N] {
        let mut entries = [None; N];
        for written in attributes.all(name) {
            let list = self.list(written, 0..=N, subject).unwrap_or_default();
            for (entry, number) in entries.iter_mut().zip(list) {
                *entry = Some(number);
            }
        }
        entries
    }

    /// A word, without surrounding spaces.
    pub(super) fn word(&mut self, written: Written<'a>) -> Name {
        let place = self.place_of(written);
        let text = self.at(written.element).value(&written.attribute);
        Name {
            text: text.trim().to_owned(),
            place,
        }
    }

    /// The meaning of one of several words; `otherwise` if the attribute is missing or malformed.
    pub(super) fn choice<T: Copy>(
        &mut self,
        written: Option<Written<'a>>,
        words: &[(&str, T)],
        otherwise: T,
        subject: &str,
    ) -> T {
        let Some(written) = written else {
            return otherwise;
        };
        let word = self.word(written);
        if let Some((_, meant)) = words.iter().find(|(known, _)| *known == word.text) {
            return *meant;
        }
        let name = written.attribute.name();
        let message = format!("{name} of {subject} is {}", quoted(&word.text));
        let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let hint = known(&word.text, "words", &words);
        self.reader.errors.push_with_hint(word.place, message, hint);
        otherwise
    }

    /// `true` or `false`.
    pub(super) fn flag(
        &mut self,
        written: Option<Written<'a>>,
        otherwise: bool,
        subject: &str,
    ) -> bool {
        self.choice(
            written,
            &[("true", true), ("false", false)],
            otherwise,
            subject,
        )
    }
}
