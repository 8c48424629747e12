//! Warnings of mechanics that are not modelled.
//!
//! One warning for each kind, at its first occurrence. Kinds that the table of elements reports by itself are not noted
//! here.

use crate::description::xml::elements::NotModelled;
use crate::error::{Diagnostic, Place};

/// The noted kinds.
#[derive(Default)]
pub(super) struct Noted(Vec<NotedKind>);

struct NotedKind {
    unmodelled: &'static NotModelled,
    place: Place,
    item: String,
    others: usize,
}

impl Noted {
    /// Notes an occurrence.
    pub(super) fn note(&mut self, unmodelled: &'static NotModelled, place: Place, item: String) {
        match self
            .0
            .iter_mut()
            .find(|kind| kind.unmodelled.what == unmodelled.what)
        {
            Some(known) => known.others += 1,
            None => self.0.push(NotedKind {
                unmodelled,
                place,
                item,
                others: 0,
            }),
        }
    }

    /// The warnings.
    pub(super) fn warnings(self) -> impl Iterator<Item = Diagnostic> {
        self.0.into_iter().map(|kind| {
            let NotedKind {
                unmodelled,
                place,
                item,
                others,
            } = kind;
            let more = match others {
                0 => String::new(),
                1 => " and 1 other".to_owned(),
                count => format!(" and {count} others"),
            };
            Diagnostic {
                place,
                message: format!("not modelled: {item}{more}: {}", unmodelled.what),
                hint: Some(unmodelled.hint.to_owned()),
            }
        })
    }
}
