//! Warnings of mechanics that are not modelled.
//!
//! One warning for each kind, at its first occurrence. Kinds that the table of elements reports by itself are not noted
//! here.

use crate::description::xml::elements::NotModelled;
use crate::error::{Complaint, Place};

/// The noted kinds.
#[derive(Default)]
pub(super) struct Noted(Vec<Kind>);

struct Kind {
    lost: &'static NotModelled,
    place: Place,
    item: String,
    others: usize,
}

impl Noted {
    /// Notes an occurrence.
    pub(super) fn note(&mut self, lost: &'static NotModelled, place: Place, item: String) {
        match self.0.iter_mut().find(|kind| kind.lost.what == lost.what) {
            Some(known) => known.others += 1,
            None => self.0.push(Kind {
                lost,
                place,
                item,
                others: 0,
            }),
        }
    }

    /// The warnings.
    pub(super) fn warnings(self) -> impl Iterator<Item = Complaint> {
        self.0.into_iter().map(|kind| {
            let Kind {
                lost,
                place,
                item,
                others,
            } = kind;
            let more = match others {
                0 => String::new(),
                1 => " and 1 other".to_owned(),
                count => format!(" and {count} others"),
            };
            Complaint {
                place,
                message: format!("not modelled: {item}{more}: {}", lost.what),
                hint: Some(lost.hint.to_owned()),
            }
        })
    }
}
