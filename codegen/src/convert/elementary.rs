//! Joints as both formats can say them: one motion each.
//!
//! A joint with several coordinates of its own becomes as many joints in series. A screw becomes a rotation and a
//! translation that mimics it.

use crate::description::{Joint, Limits, Mimic, Name, Number};
use crate::joint::{Along, DegreeOfFreedom, Manifold, Movement, entry};

/// A joint with one motion.
pub(super) struct Elementary<'d> {
    pub(super) of: &'d Joint,
    /// Its index among the velocities of the joint that it is a part of.
    pub(super) index: Option<usize>,
    pub(super) name: String,
    pub(super) motion: ElementaryMotion,
    /// The direction in the frame of the child.
    pub(super) axis: [Number; 3],
    pub(super) limits: Option<Limits>,
    pub(super) mimic: Option<Mimic>,
}

/// The motion of a part.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ElementaryMotion {
    Fixed,
    Rotation,
    Translation,
    Manifold(Manifold),
}

/// The joints in series that a joint is, from the parent outwards.
pub(super) fn elementary(joint: &Joint) -> Vec<Elementary<'_>> {
    let whole = |motion| Elementary {
        of: joint,
        index: None,
        name: joint.name.text.clone(),
        motion,
        axis: joint.axis,
        limits: joint.limits,
        mimic: joint.mimic.clone(),
    };
    if !joint.kind.moves() {
        return vec![whole(ElementaryMotion::Fixed)];
    }
    if let Some(manifold) = joint.kind.manifold() {
        return vec![whole(ElementaryMotion::Manifold(manifold))];
    }
    let velocities = joint.kind.velocities(&joint.name.text).enumerate();
    let mut parts: Vec<Elementary<'_>> = velocities
        .map(|(k, (name, degree_of_freedom))| {
            let motion = match degree_of_freedom.movement {
                Movement::Rotation | Movement::Helix => ElementaryMotion::Rotation,
                Movement::Translation => ElementaryMotion::Translation,
            };
            Elementary {
                name,
                index: Some(k),
                axis: direction(joint, degree_of_freedom),
                ..whole(motion)
            }
        })
        .collect();
    if parts.len() > 1 {
        // Limits of a joint with several coordinates name none of them.
        for part in &mut parts {
            part.limits = None;
        }
    }
    parts.extend(joint.kind.pitch().map(|pitch| advance(joint, pitch)));
    parts
}

/// The translation of a screw.
fn advance(joint: &Joint, pitch: Number) -> Elementary<'_> {
    let name = &joint.name.text;
    Elementary {
        of: joint,
        index: None,
        name: entry(name, "advance"),
        motion: ElementaryMotion::Translation,
        axis: joint.axis,
        limits: None,
        mimic: Some(Mimic {
            mimicked: Name::from(name.as_str()),
            multiplier: pitch,
            offset: Number::default(),
            place: joint.place,
        }),
    }
}

fn direction(joint: &Joint, degree_of_freedom: DegreeOfFreedom) -> [Number; 3] {
    match degree_of_freedom.along {
        Along::Axis => joint.axis,
        Along::Second => joint.second_axis,
        Along::Frame(axis) => {
            std::array::from_fn(|k| Number::from(if k == axis { 1.0 } else { 0.0 }))
        }
    }
}

impl Elementary<'_> {
    /// True for the translation of a screw, which has neither a velocity nor an actuator of its own.
    pub(super) fn is_advance(&self) -> bool {
        self.motion == ElementaryMotion::Translation && self.index.is_none()
    }

    /// True if the coordinate has a lower or an upper limit.
    pub(super) fn is_limited(&self) -> bool {
        let is_limited = |limits: Limits| limits.lower.is_finite() || limits.upper.is_finite();
        self.limits.is_some_and(is_limited)
    }
}
