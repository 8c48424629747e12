//! Mechanics that a file has and the model has not.
//!
//! In: each thing that was met. Out: a warning for each kind, at the first of its things. What the table of elements
//! tells by itself is not noted here, but what takes the defaults of a class, or other elements, to see.

use crate::description::xml::elements::Lost;
use crate::error::{Complaint, Place};

/// What was met, each kind once.
#[derive(Default)]
pub(super) struct Met(Vec<Kind>);

struct Kind {
    lost: &'static Lost,
    place: Place,
    item: String,
    others: usize,
}

impl Met {
    /// Notes a thing of a kind.
    pub(super) fn note(&mut self, lost: &'static Lost, place: Place, item: String) {
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
