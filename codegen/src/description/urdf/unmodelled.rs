//! What stands in a file and is not in the model.
//!
//! In: each thing that was met, with its place. Out: one doubt for each kind, at the first of its
//! things, so that a vendor's file with friction in thirty joints gets one line. It never refuses
//! anything.

use crate::error::{Complaint, Place};
use crate::wording::list;

/// What was met.
#[derive(Default)]
pub(super) struct Unmodelled {
    friction: Met,
    gears: Met,
    limits: Met,
}

/// Things of one kind.
#[derive(Default)]
struct Met {
    /// The first of them and its place.
    first: Option<(Place, String)>,
    /// How many there are besides.
    others: usize,
    /// What they are made of, each word once.
    words: Vec<String>,
}

impl Unmodelled {
    /// Friction of a joint that moves: the attributes that are not zero.
    pub(super) fn friction(&mut self, place: Place, joint: &str, words: &[&str]) {
        self.friction.add(place, joint, words);
    }

    /// A gear between a motor and its joint.
    pub(super) fn gear(&mut self, place: Place, transmission: &str) {
        self.gears.add(place, transmission, &[]);
    }

    /// Limits of a coordinate that has none.
    pub(super) fn limits(&mut self, place: Place, joint: &str) {
        self.limits.add(place, joint, &[]);
    }

    /// A doubt for each kind that was met.
    pub(super) fn doubts(self) -> impl Iterator<Item = Complaint> {
        let words = list(self.friction.words.iter().map(String::as_str));
        let friction = self.friction.doubt(
            |of| format!("not modelled: {words} of {of}"),
            "torques and accelerations are those of rigid bodies without friction",
        );
        let gears = self.gears.doubt(
            |of| format!("not modelled: the reduction of {of}"),
            "coordinates, torques and inertias are those of the joint, without the motor",
        );
        let limits = self.limits.doubt(
            |of| format!("not used: the limits of {of}, of type continuous"),
            "the type that has limits is revolute",
        );
        [friction, gears, limits].into_iter().flatten()
    }
}

impl Met {
    fn add(&mut self, place: Place, item: &str, words: &[&str]) {
        match self.first {
            None => self.first = Some((place, item.to_owned())),
            Some(_) => self.others += 1,
        }
        for word in words {
            if !self.words.iter().any(|known| known == word) {
                self.words.push((*word).to_owned());
            }
        }
    }

    fn doubt(self, message: impl FnOnce(&str) -> String, hint: &str) -> Option<Complaint> {
        let (place, first) = self.first?;
        let of = match self.others {
            0 => first,
            1 => format!("{first} and 1 other"),
            others => format!("{first} and {others} others"),
        };
        Some(Complaint {
            place,
            message: message(&of),
            hint: Some(hint.to_owned()),
        })
    }
}
