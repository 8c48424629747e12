//! `<joint>` and `<freejoint>`: how a body moves against the one that it stands in.
//!
//! In: the joints of a body, in the order of the text. Out: as many joints here, each on a link without mass that the
//! one before it carries; the last carries the body, or a link that the body is fixed to, where its axis does not go
//! through the body's origin. A coordinate that is not 0 as described (`ref`) turns or moves the frame that the joint
//! begins at.

mod drive;

use super::orientation::turn;
use super::reading::Mjcf;
use super::spatial::{Pose, dot, written};
use super::tree::{Item, WORLD};
use super::values::Attributes;
use crate::description::{Joint, Limits, Link, Name, Number, Step, axis, number};
use crate::error::Place;
use crate::expression::Double;
use crate::joint::JointKind;
use crate::joint::drive::Parts;
use crate::wording::quoted;

/// A body, as far as its joints need it.
pub(super) struct Moving<'m, 'a> {
    pub(super) link: &'m Name,
    pub(super) parent: &'m Name,
    /// From the parent's frame to the body's, as described.
    pub(super) steps: Vec<Step>,
    pub(super) subject: &'m str,
    /// Whether bodies stand in it.
    pub(super) has_bodies: bool,
    pub(super) joints: &'m [Item<'a>],
    pub(super) place: Place,
}

/// What a joint allows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Free,
    Ball,
    Slide,
    Hinge,
}

const FORMS: [(&str, Form); 4] = [
    ("free", Form::Free),
    ("ball", Form::Ball),
    ("slide", Form::Slide),
    ("hinge", Form::Hinge),
];

/// A joint before it is known between which links.
struct Read {
    name: Name,
    form: Form,
    kind: JointKind,
    /// Where its axis goes through, in the frame of the body.
    anchor: [Number; 3],
    axis: [Number; 3],
    /// To where the joint is at 0.
    reference: Option<Step>,
    limits: Option<Limits>,
    drive: Parts,
    place: Place,
}

impl<'a> Mjcf<'a> {
    /// Lets a body move by its joints, or fixes it.
    pub(super) fn connect(&mut self, body: &Moving<'_, 'a>) {
        let mut read = Vec::new();
        for item in body.joints {
            read.extend(self.joint(item, body));
        }
        let free = read.iter().position(|joint| joint.form == Form::Free);
        if let Some(free) = free {
            let element = body.joints[free].element;
            if body.parent.text != WORLD {
                let hint = "let the body stand in the world, or give it other joints";
                self.refuse(
                    element,
                    format!("{} is free and stands in another body", body.subject),
                    hint,
                );
            }
            if read.len() > 1 {
                let message = format!("{} has a free joint and others", body.subject);
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
        // What is left to the frame of the next, or of the body.
        let mut steps = body.steps.clone();
        // Where the joint before goes through, in the frame of the body.
        let mut before: Option<[Number; 3]> = None;
        for (k, joint) in read.into_iter().enumerate() {
            let anchor = match joint.form {
                Form::Slide => before,
                Form::Free => {
                    // Its coordinates say where it is.
                    steps.clear();
                    None
                }
                Form::Ball | Form::Hinge => Some(joint.anchor).filter(is_not_zero),
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
            self.tree.joints.push(Joint {
                name: joint.name,
                kind: joint.kind,
                parent: parent.clone(),
                child: child.clone(),
                origin: std::mem::take(&mut steps),
                axis: joint.axis,
                second_axis: [zero; 3],
                limits: joint.limits,
                mimic: None,
                drive: joint.drive,
                place: joint.place,
            });
            parent = child;
        }
        if before.is_some() {
            move_anchor(&mut steps, before, None);
            self.weld(body.link, &parent, steps, body.place);
        }
    }

    fn joint(&mut self, item: &Item<'a>, body: &Moving<'_, 'a>) -> Option<Read> {
        let element = item.element;
        let place = self.place(element);
        let is_free = element.tag() == "freejoint";
        let written_name = self.name_of(item);
        let subject = match &written_name {
            Some(name) => format!("joint {}", quoted(&name.text)),
            None => format!("a joint of {}", body.subject),
        };
        // A `<freejoint>` has nothing of any class.
        let attributes = if is_free {
            Attributes {
                own: element,
                kind: "",
                class: self.defaults.main(),
            }
        } else {
            self.attributes(item, "joint")
        };
        let form = if is_free {
            Form::Free
        } else {
            self.choice(attributes.get("type"), &FORMS, Form::Hinge, &subject)
        };
        let name = written_name.unwrap_or_else(|| {
            let wanted = if body.joints.len() == 1 {
                body.link.text.clone()
            } else {
                let word = FORMS.iter().find(|(_, known)| *known == form);
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
        if form != Form::Free {
            let pos = self.numbers::<3>(attributes.get("pos"), &subject);
            anchor = pos.unwrap_or(anchor);
            if !item.frame.is_empty() {
                let exact = anchor.map(|entry| entry.exact());
                let seen = Pose::of(&item.frame).point(exact);
                anchor = seen.map(|entry| written(entry, place));
            }
        }
        let reference = self.reference(&attributes, form, &axis, &name, &subject);
        let limits = self.limits(&attributes, form, &subject);
        let kind = match form {
            Form::Free => JointKind::Floating,
            Form::Ball => JointKind::Spherical,
            Form::Slide => JointKind::Prismatic,
            Form::Hinge if limits.is_some_and(|limits| limits.lower.is_finite()) => {
                JointKind::Revolute
            }
            Form::Hinge => JointKind::Continuous,
        };
        if form == Form::Free && !body.has_bodies && body.joints.len() == 1 {
            self.aligned(&attributes, &subject);
        }
        let drive = self.drive(&attributes, form, &subject);
        Some(Read {
            name,
            form,
            kind,
            anchor,
            axis,
            reference,
            limits,
            drive,
            place,
        })
    }

    /// The direction of an axis; z where none is written.
    fn axis(
        &mut self,
        attributes: &Attributes<'a>,
        form: Form,
        frame: &[Step],
        subject: &str,
    ) -> Option<[Number; 3]> {
        let place = self.place(attributes.own);
        let z = [0.0, 0.0, 1.0].map(|entry| number::computed(entry, place));
        if matches!(form, Form::Ball | Form::Free) {
            return Some(z);
        }
        let said = attributes.get("axis");
        let entries = match said {
            Some(_) => self.numbers::<3>(said, subject)?,
            None => z,
        };
        let entries = if frame.is_empty() {
            entries
        } else {
            let exact = entries.map(|entry| entry.exact());
            let seen = Pose::of(frame).direction(exact);
            seen.map(|entry| written(entry, place))
        };
        // MuJoCo makes its length 1 without a word.
        match axis::direction(entries) {
            Ok((direction, _)) => Some(direction),
            Err(refusal) => {
                let place = said.map_or(place, |said| self.place_of(said));
                let message = format!("the axis of {subject} {}", refusal.what);
                self.reader
                    .errors
                    .push_with_hint(place, message, refusal.hint);
                None
            }
        }
    }

    /// From where a joint is as described to where it is at 0.
    fn reference(
        &mut self,
        attributes: &Attributes<'a>,
        form: Form,
        axis: &[Number; 3],
        name: &Name,
        subject: &str,
    ) -> Option<Step> {
        let said = self.number(attributes.get("ref"), subject)?;
        let said = match form {
            Form::Hinge => self.angle(said),
            Form::Slide => said,
            Form::Ball | Form::Free => return None,
        };
        self.tree.references.insert(name.text.clone(), said);
        if said.value == 0.0 {
            return None;
        }
        let back = Number {
            value: -said.value,
            rest: -said.rest,
            ..said
        };
        if form == Form::Hinge {
            return turn(axis, back);
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
            offset.map(|entry| written(entry, said.place)),
        ))
    }
}

fn is_not_zero(offset: &[Number; 3]) -> bool {
    offset.iter().any(|entry| entry.value != 0.0)
}

/// From one point of a body to another, where they differ.
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
