//! Names of links or of joints, and what they refer to.
//!
//! In: the names in the order of the description. Out: numbers by name; for an unknown name an error that lists the
//! known ones.

use std::collections::HashMap;

use crate::description::Name;
use crate::error::Errors;
use crate::list::Id;
use crate::wording::{named, quoted};

/// Largest number of names in which a similar one is searched.
const SEARCHED: usize = 1000;

/// Largest number of errors with such a search.
const HELPED: usize = 20;

/// The numbers of items by name.
pub struct Names<'a, I> {
    what: &'static str,
    order: Vec<&'a str>,
    numbers: HashMap<&'a str, I>,
}

impl<'a, I: Id> Names<'a, I> {
    /// Collects names; a duplicate is an error.
    pub fn of(
        names: impl Iterator<Item = &'a Name>,
        what: &'static str,
        errors: &mut Errors,
    ) -> Self {
        let mut known = Self {
            what,
            order: Vec::new(),
            numbers: HashMap::new(),
        };
        for name in names {
            let number = I::new(known.order.len());
            known.order.push(&name.text);
            if known.numbers.insert(&name.text, number).is_some() {
                let called = quoted(&name.text);
                errors.push(name.place, format!("two {what}s are called {called}"));
            }
        }
        known
    }

    /// The number of the item with a name.
    pub fn get(&self, name: &Name) -> Option<I> {
        self.numbers.get(name.text.as_str()).copied()
    }

    /// The same; an unknown name is an error.
    pub fn find(&self, name: &Name, errors: &mut Errors) -> Option<I> {
        let found = self.get(name);
        if found.is_none() {
            let message = format!("there is no {} {}", self.what, quoted(&name.text));
            // With very many names or errors, the search would take longer than reading them.
            let few = self.order.len() <= SEARCHED && errors.diagnostics().len() < HELPED;
            if few {
                let hint = named(&name.text, &format!("{}s", self.what), &self.order);
                errors.push_with_hint(name.place, message, hint);
            } else {
                errors.push(name.place, message);
            }
        }
        found
    }
}
