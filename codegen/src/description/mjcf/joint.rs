//! `<joint>` and `<freejoint>`: how a body moves against the one that it stands in.
//!
//! In: the joints of a body, in the order of the text. Out: as many joints here, each on a link without mass that the
//! one before it carries; the last carries the body, or a link that the body is fixed to, where its axis does not go
//! through the body's origin. A coordinate that is not 0 as described (`ref`) turns or moves the frame that the joint
//! begins at. Damping, friction and armature are kept and noted, for they are modelled where they are asked for.

use super::Mjcf;
use super::body::{Item, WORLD};
use super::elements::{ALIGNED, CUBIC, OF_WORLD, SPRING};
use super::orientation::turn;
use super::spatial::{Pose, dot, written};
use super::values::Attributes;
use crate::description::{Joint, Limits, Link, Name, Number, Step, axis, number};
use crate::error::Place;
use crate::expression::Double;
use crate::joint::JointKind;
use crate::joint::drive::{Part, Parts};
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

/// Whether something is so, or follows from whether there is a range.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Limited {
    No,
    Yes,
    ByRange,
}

const LIMITED: [(&str, Limited); 3] = [
    ("false", Limited::No),
    ("true", Limited::Yes),
    ("auto", Limited::ByRange),
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

    /// The range, where there is one; of a ball, of its angle.
    fn limits(&mut self, attributes: &Attributes<'a>, form: Form, subject: &str) -> Option<Limits> {
        let range = self.numbers::<2>(attributes.get("range"), subject);
        let limited = self.choice(
            attributes.get("limited"),
            &LIMITED,
            Limited::ByRange,
            subject,
        );
        let effort = self.effort(attributes, form, subject);
        let has_range = range.is_some_and(|range| range.iter().any(|end| end.value != 0.0));
        let is_limited = match limited {
            _ if form == Form::Free => false,
            Limited::No => false,
            Limited::Yes => true,
            Limited::ByRange => has_range && self.compiler.autolimits,
        };
        if limited == Limited::ByRange && has_range && !self.compiler.autolimits {
            let message = format!("{subject} has a range, and whether it is limited is not said");
            let hint = "write limited=\"true\", or leave autolimits of the compiler as it is";
            self.refuse(attributes.own, message, hint);
        }
        let unlimited = Limits {
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
            velocity: f64::INFINITY,
            effort,
        };
        if !is_limited {
            return Some(unlimited).filter(|limits| limits.effort.is_finite());
        }
        let turns = matches!(form, Form::Hinge | Form::Ball);
        let ends = range.map(|range| {
            let ends = range.map(|end| if turns { self.angle(end) } else { end });
            ends.map(|end| end.value)
        });
        let [lower, upper] = ends.unwrap_or_default();
        if lower >= upper && form != Form::Ball {
            let message = format!("the range of {subject} is from {lower} to {upper}");
            let hint = "its first number is the smaller one";
            self.refuse(attributes.own, message, hint);
        }
        Some(Limits {
            lower,
            upper,
            ..unlimited
        })
    }

    /// The largest torque or force that actuators may exert together; infinite where none is written.
    fn effort(&mut self, attributes: &Attributes<'a>, form: Form, subject: &str) -> f64 {
        let range = self.numbers::<2>(attributes.get("actuatorfrcrange"), subject);
        let limited = attributes.get("actuatorfrclimited");
        let limited = self.choice(limited, &LIMITED, Limited::ByRange, subject);
        let is_limited = match limited {
            Limited::No => false,
            Limited::Yes => true,
            Limited::ByRange => self.compiler.autolimits,
        };
        let most = range.map_or(0.0, |[lower, upper]| {
            lower.value.abs().max(upper.value.abs())
        });
        if is_limited && most > 0.0 && matches!(form, Form::Hinge | Form::Slide) {
            most
        } else {
            f64::INFINITY
        }
    }

    /// Notes a free body that MuJoCo moves with its inertial frame.
    fn aligned(&mut self, attributes: &Attributes<'a>, subject: &str) {
        let words = [
            ("false", false),
            ("true", true),
            ("auto", self.compiler.align_free),
        ];
        let by_compiler = self.compiler.align_free;
        if self.choice(attributes.get("align"), &words, by_compiler, subject) {
            let place = self.place(attributes.own);
            self.met.note(&ALIGNED, place, subject.to_owned());
        }
    }

    /// What the joint meets beside the bodies.
    fn drive(&mut self, attributes: &Attributes<'a>, form: Form, subject: &str) -> Parts {
        let mut drive = Parts::default();
        let mut words = Vec::new();
        let resisting = [("damping", Part::Damping), ("frictionloss", Part::Friction)];
        for (name, part) in resisting {
            let [first, second, third] = self.entries::<3>(attributes, name, subject);
            // Friction of a free joint is along the axes of the world, which its velocities here are not.
            let is_of_world = form == Form::Free && part == Part::Friction;
            match first.filter(|number| number.value != 0.0) {
                Some(number) if is_of_world => {
                    self.met.note(&OF_WORLD, number.place, subject.to_owned());
                }
                Some(number) => {
                    drive.say(part, vec![number]);
                    words.push(part.word());
                }
                None => {}
            }
            let mut more = [second, third].into_iter().flatten();
            if let Some(more) = more.find(|more| more.value != 0.0) {
                self.met.note(&CUBIC, more.place, subject.to_owned());
            }
        }
        let place = self.place(attributes.own);
        if !words.is_empty() {
            self.reader.unmodelled.friction(place, subject, words);
        }
        let armature = self.number(attributes.get("armature"), subject);
        let armature = armature.filter(|armature| armature.value != 0.0);
        if let Some(armature) = armature.filter(|_| form == Form::Free) {
            self.met.note(&OF_WORLD, armature.place, subject.to_owned());
        } else if let Some(armature) = armature {
            drive.say(Part::Armature, vec![armature]);
            self.reader.unmodelled.armature(place, subject);
        }
        let [first, second, third] = self.entries::<3>(attributes, "stiffness", subject);
        let [frequency, ratio] = self.entries::<2>(attributes, "springdamper", subject);
        let mut springs = [first, second, third, frequency, ratio]
            .into_iter()
            .flatten();
        if springs.any(|spring| spring.value != 0.0) {
            self.met.note(&SPRING, place, subject.to_owned());
        }
        drive
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
