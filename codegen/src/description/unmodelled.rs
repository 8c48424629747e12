//! What stands in a file and is not in the model, or only where it is asked for.
//!
//! In: each thing that was met, with its place; later, what is modelled. Out: one doubt for each kind, at
//! the first of its things, so that a vendor's file with friction in thirty joints gets one line. It
//! never refuses anything.

use crate::error::{Complaint, Place};
use crate::wording::list;

/// What was met.
#[derive(Clone, Debug, Default)]
pub struct Unmodelled {
    friction: Vec<Met>,
    gears: Vec<Met>,
    rotors: Vec<Met>,
    armatures: Vec<Met>,
    limits: Vec<Met>,
    soft_limits: Vec<Met>,
}

/// What of it is modelled all the same.
#[derive(Clone, Copy)]
pub struct Modelled<'a> {
    /// Damping and friction.
    pub friction: bool,
    /// Inertias of rotors, with their gears.
    pub armature: bool,
    /// Whether a joint has a rotor.
    pub has_rotor: &'a dyn Fn(&str) -> bool,
}

/// A thing.
#[derive(Clone, Debug)]
struct Met {
    place: Place,
    item: String,
    /// What friction is made of.
    words: Vec<&'static str>,
    /// The joint that it is of, where one is told.
    joint: Option<String>,
}

impl Unmodelled {
    /// Friction of a joint that moves: the attributes that are not zero.
    pub(super) fn friction(&mut self, place: Place, joint: &str, words: Vec<&'static str>) {
        self.friction.push(Met::new(place, joint, words, None));
    }

    /// A gear between a motor and its joint.
    pub(super) fn gear(&mut self, place: Place, transmission: &str, joint: Option<String>) {
        let met = Met::new(place, transmission, Vec::new(), joint);
        self.gears.push(met);
    }

    /// The inertia of a rotor, and the joint that gets it.
    pub(super) fn rotor(&mut self, place: Place, transmission: &str, joint: Option<String>) {
        let met = Met::new(place, transmission, Vec::new(), joint);
        self.rotors.push(met);
    }

    /// The armature of a joint.
    pub(super) fn armature(&mut self, place: Place, joint: &str) {
        self.armatures
            .push(Met::new(place, joint, Vec::new(), None));
    }

    /// That there is no joint of that name to get a rotor.
    pub(super) fn dismount(&mut self, joint: &str) {
        for met in self.gears.iter_mut().chain(&mut self.rotors) {
            met.joint.take_if(|of| of == joint);
        }
    }

    /// Limits of a coordinate that has none.
    pub(super) fn limits(&mut self, place: Place, joint: &str) {
        self.limits.push(Met::new(place, joint, Vec::new(), None));
    }

    /// Soft limits that are narrower than the limits.
    pub(super) fn soft_limits(&mut self, place: Place, joint: &str) {
        let met = Met::new(place, joint, Vec::new(), None);
        self.soft_limits.push(met);
    }

    /// A doubt for each kind that was met.
    #[must_use]
    pub fn doubts(&self, modelled: &Modelled<'_>) -> Vec<Complaint> {
        let friction = self.friction.iter().filter(|_| !modelled.friction);
        let friction: Vec<&Met> = friction.collect();
        let mut words: Vec<&str> = Vec::new();
        for &word in friction.iter().flat_map(|met| &met.words) {
            if !words.contains(&word) {
                words.push(word);
            }
        }
        let words = list(words);
        let friction = doubt(
            &friction,
            |of| format!("not modelled: {words} of {of}"),
            "torques and accelerations are those of rigid bodies without friction",
        );
        let gears = self.gears.iter().filter(|met| {
            let joint = met.joint.as_deref();
            !(modelled.armature && joint.is_some_and(modelled.has_rotor))
        });
        let gears = doubt(
            &gears.collect::<Vec<_>>(),
            |of| format!("not modelled: the reduction of {of}"),
            "coordinates, torques and inertias are those of the joint, without the motor",
        );
        let (mounted, lost): (Vec<_>, Vec<_>) =
            self.rotors.iter().partition(|met| met.joint.is_some());
        let mounted = doubt(
            if modelled.armature { &[] } else { &mounted },
            |of| format!("not modelled: the rotor of {of}"),
            "ask for its inertia with the word rotors",
        );
        let lost = doubt(
            &lost,
            |of| format!("not modelled: the rotor of {of}, which is of no joint alone"),
            "name one <joint> and its <actuator> in the transmission; what several move together is not modelled",
        );
        let armatures: Vec<&Met> = self.armatures.iter().collect();
        let armatures = doubt(
            if modelled.armature { &[] } else { &armatures },
            |of| format!("not modelled: the armature of {of}"),
            "ask for it with the word rotors",
        );
        let limits = doubt(
            &self.limits.iter().collect::<Vec<_>>(),
            |of| format!("not used: the limits of {of}, of type continuous"),
            "the type that has limits is revolute",
        );
        let soft_limits = doubt(
            &self.soft_limits.iter().collect::<Vec<_>>(),
            |of| format!("not used: the soft limits of {of}, which are narrower than the limits"),
            "ranges are those of <limit>, and soft limits a controller's: narrow <limit>, if they are meant",
        );
        [
            friction,
            gears,
            mounted,
            lost,
            armatures,
            limits,
            soft_limits,
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

impl Met {
    fn new(place: Place, item: &str, words: Vec<&'static str>, joint: Option<String>) -> Self {
        Self {
            place,
            item: item.to_owned(),
            words,
            joint,
        }
    }
}

fn doubt(all: &[&Met], message: impl FnOnce(&str) -> String, hint: &str) -> Option<Complaint> {
    let (first, others) = all.split_first()?;
    let first_item = &first.item;
    let of = match others.len() {
        0 => first_item.clone(),
        1 => format!("{first_item} and 1 other"),
        others => format!("{first_item} and {others} others"),
    };
    Some(Complaint {
        place: first.place,
        message: message(&of),
        hint: Some(hint.to_owned()),
    })
}
