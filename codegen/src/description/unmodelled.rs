//! Warnings of mechanics that are in a file and not in the model, or only on request.
//!
//! Collects each occurrence with its place. Once the request is known, it yields one warning for each kind, at the
//! first occurrence, so that a file with friction in thirty joints gets one line.

use crate::error::{Diagnostic, Place};
use crate::wording::list;

/// Occurrences of mechanics that may not be modelled, by kind.
#[derive(Clone, Debug, Default)]
pub struct Unmodelled {
    friction: Vec<Occurrence>,
    gears: Vec<Occurrence>,
    rotors: Vec<Occurrence>,
    armatures: Vec<Occurrence>,
    limits: Vec<Occurrence>,
    soft_limits: Vec<Occurrence>,
}

/// The mechanics that the request models.
#[derive(Clone, Copy)]
pub struct Modelled<'a> {
    /// Damping and friction.
    pub friction: bool,
    /// Inertias of rotors, with their gears.
    pub armature: bool,
    /// True if a joint has a rotor.
    pub has_rotor: &'a dyn Fn(&str) -> bool,
}

/// An occurrence.
#[derive(Clone, Debug)]
struct Occurrence {
    place: Place,
    item: String,
    /// Words for the parts of friction that it has.
    words: Vec<&'static str>,
    /// The joint that it belongs to, if it is a single one.
    joint: Option<String>,
}

impl Unmodelled {
    /// Friction of a moving joint: its attributes that are not zero.
    pub(super) fn friction(&mut self, place: Place, joint: &str, words: Vec<&'static str>) {
        self.friction
            .push(Occurrence::new(place, joint, words, None));
    }

    /// A gear between a motor and its joint.
    pub(super) fn gear(&mut self, place: Place, transmission: &str, joint: Option<String>) {
        let occurrence = Occurrence::new(place, transmission, Vec::new(), joint);
        self.gears.push(occurrence);
    }

    /// The inertia of a rotor, with the joint that it belongs to.
    pub(super) fn rotor(&mut self, place: Place, transmission: &str, joint: Option<String>) {
        let occurrence = Occurrence::new(place, transmission, Vec::new(), joint);
        self.rotors.push(occurrence);
    }

    /// The armature of a joint.
    pub(super) fn armature(&mut self, place: Place, joint: &str) {
        self.armatures
            .push(Occurrence::new(place, joint, Vec::new(), None));
    }

    /// Detaches gears and rotors from a joint that does not exist.
    pub(super) fn dismount(&mut self, joint: &str) {
        for occurrence in self.gears.iter_mut().chain(&mut self.rotors) {
            occurrence.joint.take_if(|of| of == joint);
        }
    }

    /// Limits of a continuous joint.
    pub(super) fn limits(&mut self, place: Place, joint: &str) {
        self.limits
            .push(Occurrence::new(place, joint, Vec::new(), None));
    }

    /// Soft limits that are narrower than the limits.
    pub(super) fn soft_limits(&mut self, place: Place, joint: &str) {
        let occurrence = Occurrence::new(place, joint, Vec::new(), None);
        self.soft_limits.push(occurrence);
    }

    /// One warning for each kind.
    #[must_use]
    pub fn warnings(&self, modelled: &Modelled<'_>) -> Vec<Diagnostic> {
        let friction = self.friction.iter().filter(|_| !modelled.friction);
        let friction: Vec<&Occurrence> = friction.collect();
        let mut words: Vec<&str> = Vec::new();
        for &word in friction.iter().flat_map(|occurrence| &occurrence.words) {
            if !words.contains(&word) {
                words.push(word);
            }
        }
        let words = list(words);
        let friction = warning(
            &friction,
            |of| format!("not modelled: {words} of {of}"),
            "torques and accelerations are those of rigid bodies without friction",
        );
        let gears = self.gears.iter().filter(|occurrence| {
            let joint = occurrence.joint.as_deref();
            !(modelled.armature && joint.is_some_and(modelled.has_rotor))
        });
        let gears = warning(
            &gears.collect::<Vec<_>>(),
            |of| format!("not modelled: the reduction of {of}"),
            "coordinates, torques and inertias are those of the joint, without the motor",
        );
        let (mounted, detached): (Vec<_>, Vec<_>) = self
            .rotors
            .iter()
            .partition(|occurrence| occurrence.joint.is_some());
        let mounted = warning(
            if modelled.armature { &[] } else { &mounted },
            |of| format!("not modelled: the rotor of {of}"),
            "model its inertia with the key rotors",
        );
        let detached = warning(
            &detached,
            |of| format!("not modelled: the rotor of {of}, which has no single joint"),
            "write one <joint> and its <actuator> in the transmission; coupled joints are not modelled",
        );
        let armatures: Vec<&Occurrence> = self.armatures.iter().collect();
        let armatures = warning(
            if modelled.armature { &[] } else { &armatures },
            |of| format!("not modelled: the armature of {of}"),
            "model it with the key rotors",
        );
        let limits = warning(
            &self.limits.iter().collect::<Vec<_>>(),
            |of| format!("not used: the limits of {of}, of type continuous"),
            "limits need the type revolute",
        );
        let soft_limits = warning(
            &self.soft_limits.iter().collect::<Vec<_>>(),
            |of| format!("not used: the soft limits of {of}, which are narrower than the limits"),
            "limits are those of <limit>: narrow them if you need the soft ones",
        );
        [
            friction,
            gears,
            mounted,
            detached,
            armatures,
            limits,
            soft_limits,
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

impl Occurrence {
    fn new(place: Place, item: &str, words: Vec<&'static str>, joint: Option<String>) -> Self {
        Self {
            place,
            item: item.to_owned(),
            words,
            joint,
        }
    }
}

fn warning(
    all: &[&Occurrence],
    message: impl FnOnce(&str) -> String,
    hint: &str,
) -> Option<Diagnostic> {
    let (first, others) = all.split_first()?;
    let first_item = &first.item;
    let of = match others.len() {
        0 => first_item.clone(),
        1 => format!("{first_item} and 1 other"),
        others => format!("{first_item} and {others} others"),
    };
    Some(Diagnostic {
        place: first.place,
        message: message(&of),
        hint: Some(hint.to_owned()),
    })
}
