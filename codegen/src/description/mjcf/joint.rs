//! `<joint>` and `<freejoint>`: joints of a body, relative to its parent.
//!
//! The joints of a body become joints in series, in the order of the text, with massless links between them. The last
//! joint carries the body. If its axis does not pass through the body's origin, it carries a massless link, to which
//! the body is fixed. A reference (`ref`) other than 0 rotates or translates the frame of the joint.

mod actuator;

use super::orientation::rotation_about;
use super::parts::{Item, PartId, WORLD};
use super::reading::Mjcf;
use super::values::Attributes;
use crate::description::spatial::{Pose, dot, to_number};
use crate::description::{Joint, Limits, Link, Name, Number, Step, axis, number};
use crate::error::Place;
use crate::expression::Double;
use crate::joint::JointKind;
use crate::joint::actuator::Actuator;
use crate::wording::quoted;

/// A body, as needed to connect it to its parent.
pub(super) struct ConnectedBody<'m, 'a> {
    pub(super) link: &'m Name,
    pub(super) parent: &'m Name,
    /// From the parent's frame to the body's, as described.
    pub(super) steps: Vec<Step>,
    pub(super) subject: &'m str,
    /// True if the body contains other bodies.
    pub(super) has_bodies: bool,
    pub(super) joints: &'m [(PartId, &'m Item<'a>)],
    pub(super) place: Place,
}

/// Type of a joint in MJCF.
#[derive(Clone, Copy, PartialEq, Eq)]
enum JointType {
    Free,
    Ball,
    Slide,
    Hinge,
}

const JOINT_TYPES: [(&str, JointType); 4] = [
    ("free", JointType::Free),
    ("ball", JointType::Ball),
    ("slide", JointType::Slide),
    ("hinge", JointType::Hinge),
];

/// A joint whose links are not known yet.
struct MjcfJoint {
    part: PartId,
    name: Name,
    form: JointType,
    kind: JointKind,
    /// A point of its axis, in the frame of the body \[m\].
    anchor: [Number; 3],
    axis: [Number; 3],
    /// The motion from the described configuration to coordinate 0.
    reference: Option<Step>,
    limits: Option<Limits>,
    actuator: Actuator,
    place: Place,
}

impl<'a> Mjcf<'a> {
    /// Connects a body to its parent by its joints, or fixes it.
    pub(super) fn connect(&mut self, body: &ConnectedBody<'_, 'a>) {
        let mut read = Vec::new();
        for (part, item) in body.joints {
            read.extend(self.within(item.model, |mjcf| mjcf.joint(*part, item, body)));
        }
        let free = read.iter().position(|joint| joint.form == JointType::Free);
        if let Some(free) = free {
            let element = body.joints[free].1.element;
            if body.parent.text != WORLD {
                let hint = "move the body to the top level of <worldbody>, or give it other joints";
                self.refuse(
                    element,
                    format!("{} has a free joint inside another body", body.subject),
                    hint,
                );
            }
            if read.len() > 1 {
                let message = format!("{} has a free joint beside other joints", body.subject);
                self.refuse(element, message, "leave the others out");
                return;
            }
        }
        if read.is_empty() {
            self.weld(body.link, body.parent, body.steps.clone(), body.place);
            return;
        }
        let count = read.len();
        let mut parent = body.parent.clone();
        // The placement still to be applied before the next joint, or before the body.
        let mut steps = body.steps.clone();
        // The point of the previous joint's axis, in the frame of the body.
        let mut before: Option<[Number; 3]> = None;
        for (k, joint) in read.into_iter().enumerate() {
            let anchor = match joint.form {
                JointType::Slide => before,
                JointType::Free => {
                    // The coordinates of a free joint are its pose, so its frame is that of the parent.
                    steps.clear();
                    None
                }
                JointType::Ball | JointType::Hinge => Some(joint.anchor).filter(is_not_zero),
            };
            move_anchor(&mut steps, before, anchor);
            before = anchor;
            steps.extend(joint.reference);
            let is_last = k + 1 == count;
            let child = if is_last && anchor.is_none() {
                body.link.clone()
            } else {
                let wanted = format!("{}.{}", body.link.text, joint.name.text);
                let name = Name {
                    text: self.tree.link_names.fresh(&wanted),
                    place: joint.place,
                };
                self.tree.links.push(Link {
                    name: name.clone(),
                    inertial: None,
                });
                name
            };
            let zero = number::computed(Double::ZERO, joint.place);
            let id = self.tree.add(Joint {
                name: joint.name,
                kind: joint.kind,
                parent: parent.clone(),
                child: child.clone(),
                origin: std::mem::take(&mut steps),
                axis: joint.axis,
                second_axis: [zero; 3],
                limits: joint.limits,
                mimic: None,
                actuator: joint.actuator,
                place: joint.place,
            });
            self.tree.joints_of_parts.insert(joint.part, id);
            parent = child;
        }
        if before.is_some() {
            move_anchor(&mut steps, before, None);
            self.weld(body.link, &parent, steps, body.place);
        }
    }

    fn joint(
        &mut self,
        part: PartId,
        item: &Item<'a>,
        body: &ConnectedBody<'_, 'a>,
    ) -> Option<MjcfJoint> {
        let element = item.element;
        let place = self.place(element);
        let is_free = element.tag() == "freejoint";
        let written_name = self.name_of(item);
        let subject = match &written_name {
            Some(name) => format!("joint {}", quoted(&name.text)),
            None => format!("a joint of {}", body.subject),
        };
        // Classes of defaults do not apply to a `<freejoint>`.
        let attributes = if is_free {
            Attributes {
                own: element,
                kind: "",
                class: self.model().defaults.main(),
            }
        } else {
            self.attributes(item, "joint")
        };
        let form = if is_free {
            JointType::Free
        } else {
            self.choice(
                attributes.get("type"),
                &JOINT_TYPES,
                JointType::Hinge,
                &subject,
            )
        };
        let name = written_name.unwrap_or_else(|| {
            let wanted = if body.joints.len() == 1 {
                body.link.text.clone()
            } else {
                let word = JOINT_TYPES.iter().find(|(_, known)| *known == form);
                format!("{}_{}", body.link.text, word.map_or("", |(word, _)| word))
            };
            Name {
                text: self.tree.joint_names.fresh(&wanted),
                place,
            }
        });
        let axis = self.axis(&attributes, form, &item.frame, &subject)?;
        let zero = number::computed(Double::ZERO, place);
        let mut anchor = [zero; 3];
        if form != JointType::Free {
            let pos = self.numbers::<3>(attributes.get("pos"), &subject);
            anchor = pos.unwrap_or(anchor);
            if !item.frame.is_empty() {
                let exact = anchor.map(|entry| entry.exact());
                let seen = Pose::of(&item.frame).point(exact);
                anchor = seen.map(|entry| to_number(entry, place));
            }
        }
        let reference = self.reference(&attributes, form, &axis, &name, &subject);
        let limits = self.limits(&attributes, form, &subject);
        let kind = match form {
            JointType::Free => JointKind::Floating,
            JointType::Ball => JointKind::Spherical,
            JointType::Slide => JointKind::Prismatic,
            JointType::Hinge if limits.is_some_and(|limits| limits.lower.is_finite()) => {
                JointKind::Revolute
            }
            JointType::Hinge => JointKind::Continuous,
        };
        if form == JointType::Free && !body.has_bodies && body.joints.len() == 1 {
            self.aligned(&attributes, &subject);
        }
        let actuator = self.friction_and_armature(&attributes, form, &subject);
        Some(MjcfJoint {
            part,
            name,
            form,
            kind,
            anchor,
            axis,
            reference,
            limits,
            actuator,
            place,
        })
    }

    /// The direction of the axis; z if none is written.
    fn axis(
        &mut self,
        attributes: &Attributes<'a>,
        form: JointType,
        frame: &[Step],
        subject: &str,
    ) -> Option<[Number; 3]> {
        let place = self.place(attributes.own);
        let z = [0.0, 0.0, 1.0].map(|entry| number::computed(entry, place));
        if matches!(form, JointType::Ball | JointType::Free) {
            return Some(z);
        }
        let written = attributes.get("axis");
        let entries = match written {
            Some(_) => self.numbers::<3>(written, subject)?,
            None => z,
        };
        let entries = if frame.is_empty() {
            entries
        } else {
            let exact = entries.map(|entry| entry.exact());
            let seen = Pose::of(frame).direction(exact);
            seen.map(|entry| to_number(entry, place))
        };
        // MuJoCo normalises axes without a warning.
        match axis::direction(entries) {
            Ok((direction, _)) => Some(direction),
            Err(refusal) => {
                let place = written.map_or(place, |written| self.place_of(written));
                let message = format!("the axis of {subject} {}", refusal.what);
                self.reader
                    .errors
                    .push_with_hint(place, message, refusal.hint);
                None
            }
        }
    }

    /// The motion from the described configuration to coordinate 0; `None` if there is none.
    fn reference(
        &mut self,
        attributes: &Attributes<'a>,
        form: JointType,
        axis: &[Number; 3],
        name: &Name,
        subject: &str,
    ) -> Option<Step> {
        let reference = self.number(attributes.get("ref"), subject)?;
        let reference = match form {
            JointType::Hinge => self.angle(reference),
            JointType::Slide => reference,
            JointType::Ball | JointType::Free => return None,
        };
        self.tree.references.insert(name.text.clone(), reference);
        if reference.value == 0.0 {
            return None;
        }
        let back = Number {
            value: -reference.value,
            rest: -reference.rest,
            ..reference
        };
        if form == JointType::Hinge {
            return rotation_about(axis, back);
        }
        let direction = axis.map(|entry| entry.exact());
        let length = dot(direction, direction).sqrt();
        let offset = direction.map(|entry| {
            if entry.is_zero() {
                Double::ZERO
            } else {
                back.exact() * entry / length
            }
        });
        Some(Step::Translate(
            offset.map(|entry| to_number(entry, reference.place)),
        ))
    }
}

fn is_not_zero(offset: &[Number; 3]) -> bool {
    offset.iter().any(|entry| entry.value != 0.0)
}

/// Moves from one point of a body to another, if they differ.
fn move_anchor(steps: &mut Vec<Step>, from: Option<[Number; 3]>, to: Option<[Number; 3]>) {
    let values = |point: Option<[Number; 3]>| {
        point.map_or([[0.0; 2]; 3], |point| {
            point.map(|entry| [entry.value, entry.rest])
        })
    };
    if values(from) == values(to) {
        return;
    }
    if let Some(from) = from {
        let back = from.map(|entry| Number {
            value: -entry.value,
            rest: -entry.rest,
            ..entry
        });
        steps.push(Step::Translate(back));
    }
    steps.extend(to.map(Step::Translate));
}
