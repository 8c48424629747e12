//! `<joint>`: type, links, frame, axes, limits, friction, rotor.
//!
//! The frame of a joint may be away from that of its child, and its axis may be written in another frame. The joint then
//! moves an auxiliary link, which has the axes of that frame and the origin of the joint, and the child is fixed to it:
//! no number of an axis is rotated, so digits of right angles are kept.

use super::element::Element;
use super::frames::{WORLD_FRAME, is_nothing};
use super::index::{FrameIndex, ScopeIndex};
use super::reading::{Ends, PendingJoint, Sdf};
use super::scope::{MODEL, WORLD};
use crate::description::spatial::{Pose, inverse, to_number};
use crate::description::{Joint, Limits, Link, Name, Number, Step, axis, number};
use crate::error::Place;
use crate::expression::Double;
use crate::joint::JointKind;
use crate::joint::actuator::{Actuator, ActuatorQuantity, Motor};
use crate::wording::{known, quoted};

/// Type of a joint in SDF.
#[derive(Clone, Copy, PartialEq, Eq)]
enum JointType {
    Revolute,
    Continuous,
    Prismatic,
    Screw,
    /// Two rotations in series.
    Universal,
    Ball,
    Fixed,
    Gearbox,
}

const JOINT_TYPES: [(&str, JointType); 9] = [
    ("revolute", JointType::Revolute),
    ("continuous", JointType::Continuous),
    ("prismatic", JointType::Prismatic),
    ("screw", JointType::Screw),
    ("universal", JointType::Universal),
    ("revolute2", JointType::Universal),
    ("ball", JointType::Ball),
    ("fixed", JointType::Fixed),
    ("gearbox", JointType::Gearbox),
];

impl JointType {
    const fn axes(self) -> usize {
        match self {
            Self::Revolute | Self::Continuous | Self::Prismatic | Self::Screw => 1,
            Self::Universal => 2,
            Self::Ball | Self::Fixed | Self::Gearbox => 0,
        }
    }
}

impl<'a> Sdf<'a> {
    /// Attaches the frames of joints to their children, before poses are resolved.
    pub(super) fn attach_joints(&mut self) {
        for joint in self.pending.clone() {
            let child = self.text(joint.element, "child");
            if let Some(child) = child.and_then(|name| self.lookup(joint.scope, &name)) {
                let own = self.frames.get_mut(joint.frame);
                own.attached = child;
                own.parent = child;
            }
        }
    }

    /// Makes the joints, once all frames are placed.
    pub(super) fn build_joints(&mut self) {
        for pending in self.pending.clone() {
            self.joint(pending);
        }
        self.gearboxes();
    }

    fn joint(&mut self, pending: PendingJoint<'a>) -> Option<()> {
        let PendingJoint {
            element,
            scope,
            frame,
        } = pending;
        let name = self.frames.get(frame).name.clone();
        let subject = format!("joint {}", quoted(&name.text));
        let form = self.joint_type(element, &subject)?;
        if form == JointType::Gearbox {
            return None;
        }
        let place = self.place(element);
        let ends = self.ends(element, scope, &subject)?;
        let child_frame = self.link_frame(ends.child);
        let parent_frame = match ends.parent {
            Some(parent) => self.link_frame(parent),
            None => WORLD_FRAME,
        };
        let axes: Vec<Element<'a>> = ["axis", "axis2"]
            .into_iter()
            .take(form.axes())
            .filter_map(|tag| {
                let axis = element.first(tag);
                if axis.is_none() {
                    let message = format!("{subject} has no <{tag}>");
                    self.refuse(element, message, "write <axis><xyz>0 0 1</xyz></axis>");
                }
                axis
            })
            .collect();
        if axes.len() < form.axes() {
            return None;
        }
        // From the child to the frame of the axes, at the origin of the joint.
        let mut at = self.between(child_frame, frame);
        let expressed = axes
            .first()
            .and_then(|axis| self.expressed_in(*axis, scope));
        if let Some(expressed) = expressed {
            let back = rotations(&inverse(&rotations(&at)));
            at.extend(back);
            at.extend(rotations(&self.between(child_frame, expressed)));
        }
        let frame_of_axes = expressed.unwrap_or(frame);
        let mut directions = [[0.0, 0.0, 1.0].map(|entry| number::computed(entry, place)); 2];
        for (direction, axis) in directions.iter_mut().zip(&axes) {
            let own = self.expressed_in(*axis, scope).unwrap_or(frame);
            *direction = self.direction(*axis, own, frame_of_axes, &subject)?;
        }
        let limits = match &axes[..] {
            [axis] => self.limits(*axis, form, &subject),
            _ => None,
        };
        let kind = self.kind(element, form, limits, &subject)?;
        let actuator = self.actuator(element, &axes, kind, &subject);
        let child = self.link_name(ends.child).clone();
        let parent = match ends.parent {
            Some(parent) => self.link_name(parent).clone(),
            None => self.world_name(place),
        };
        let mut origin = self.between(parent_frame, child_frame);
        let is_away = kind.moves() && !is_nothing(&at);
        let moved = if is_away {
            origin.extend(&at);
            let link = Name {
                text: self
                    .link_names
                    .fresh(&format!("{}.{}", child.text, name.text)),
                place,
            };
            self.links.push(Link {
                name: link.clone(),
                inertial: None,
            });
            link
        } else {
            child.clone()
        };
        let [axis, second_axis] = directions;
        self.parts.insert(frame, self.joints.len());
        self.joints.push(Joint {
            name: name.clone(),
            kind,
            parent,
            child: moved.clone(),
            origin,
            axis,
            second_axis,
            limits,
            mimic: None,
            actuator,
            place,
        });
        if is_away {
            let weld = self
                .joint_names
                .fresh(&format!("{}.{}", child.text, name.text));
            self.weld(weld, &moved, &child, inverse(&at), place);
        }
        Some(())
    }

    /// Adds a fixed joint.
    pub(super) fn weld(
        &mut self,
        name: String,
        parent: &Name,
        child: &Name,
        origin: Vec<Step>,
        place: Place,
    ) {
        let name = Name { text: name, place };
        self.joints.push(Joint::fixed(name, parent, child, origin));
    }

    /// The name of the fixed link, which becomes one of the links.
    pub(super) fn world_name(&mut self, place: Place) -> Name {
        self.has_world = true;
        Name {
            text: WORLD.to_owned(),
            place,
        }
    }

    fn joint_type(&mut self, element: Element<'a>, subject: &str) -> Option<JointType> {
        let word = self.at(element).name(element.node, "type", subject)?;
        let found = JOINT_TYPES.iter().find(|(known, _)| *known == word.text);
        if found.is_none() {
            let message = format!("{subject} has the unknown type {}", quoted(&word.text));
            let words = JOINT_TYPES.map(|(word, _)| word);
            let hint = known(&word.text, "types", &words);
            self.reader.errors.push_with_hint(word.place, message, hint);
        }
        found.map(|(_, form)| *form)
    }

    /// The links that a joint connects.
    pub(super) fn ends(
        &mut self,
        element: Element<'a>,
        scope: ScopeIndex,
        subject: &str,
    ) -> Option<Ends> {
        let mut end = |tag: &str| {
            let written = self.text(element, tag);
            if written.is_none() {
                let message = format!("{subject} has no <{tag}>");
                let hint = format!("write <{tag}>…</{tag}>, with the name of a link");
                self.refuse(element, message, &hint);
            }
            let written = written?;
            let frame = self.lookup(scope, &written)?;
            Some((written, self.frames.link_of(frame)))
        };
        let parent = end("parent");
        let child = end("child");
        let ((_, parent), (written, child)) = (parent?, child?);
        let Some(child) = child else {
            let message = format!("the child of {subject} is {}", quoted(&written.text));
            let hint = "swap parent and child: the world does not move";
            self.reader
                .errors
                .push_with_hint(written.place, message, hint);
            return None;
        };
        if parent == Some(child) {
            let message = format!("{subject} joins link {} to itself", quoted(&written.text));
            self.reader.errors.push(written.place, message);
            return None;
        }
        Some(Ends { parent, child })
    }

    /// The frame in which an axis is written; `None` for that of the joint.
    pub(super) fn expressed_in(
        &mut self,
        axis: Element<'a>,
        scope: ScopeIndex,
    ) -> Option<FrameIndex> {
        let model = self.scopes[scope.0].model;
        let of_model = self.text(axis, "use_parent_model_frame");
        let is_of_model = match of_model {
            Some(written) => written.text == "true" || written.text == "1",
            None => Self::has_axes_of_model(axis),
        };
        if is_of_model {
            return Some(model);
        }
        let name = axis
            .first("xyz")
            .and_then(|xyz| self.word(xyz, "expressed_in"))?;
        if name.text == MODEL {
            return Some(model);
        }
        self.lookup(scope, &name)
    }

    /// The direction of an axis in the axes of a frame.
    fn direction(
        &mut self,
        axis: Element<'a>,
        own: FrameIndex,
        frame: FrameIndex,
        subject: &str,
    ) -> Option<[Number; 3]> {
        let subject = format!("the axis of {subject}");
        let place = self.place(axis);
        let written: Option<[Number; 3]> = match axis.first("xyz") {
            Some(xyz) => {
                let numbers = self.at(xyz).numbers_in_text(xyz.node, 3..=3, &subject)?;
                numbers.try_into().ok()
            }
            None => Some([0.0, 0.0, 1.0].map(|entry| number::computed(entry, place))),
        };
        let mut entries = written?;
        let between = rotations(&self.between(frame, own));
        if !is_nothing(&between) {
            let exact = entries.map(|entry| entry.exact());
            let seen = Pose::of(&between).direction(exact);
            entries = seen.map(|entry| to_number(entry, place));
        }
        let place = entries[0].place;
        match axis::direction(entries) {
            Ok((direction, warning)) => {
                if let Some(warning) = warning {
                    let message = format!("{subject} {}", warning.what);
                    self.reader.warn(place, message, Some(warning.hint));
                }
                Some(direction)
            }
            Err(refusal) => {
                let message = format!("{subject} {}", refusal.what);
                self.reader
                    .errors
                    .push_with_hint(place, message, refusal.hint);
                None
            }
        }
    }

    fn limits(&mut self, axis: Element<'a>, form: JointType, subject: &str) -> Option<Limits> {
        let limit = axis.first("limit")?;
        let subject = format!("the limit of {subject}");
        let mut lower = self.limit(limit, "lower", f64::NEG_INFINITY, &subject);
        let mut upper = self.limit(limit, "upper", f64::INFINITY, &subject);
        // Negative limits of effort and velocity are none.
        let mut most = |tag: &str| {
            let most = self.limit(limit, tag, f64::INFINITY, &subject);
            if most < 0.0 { f64::INFINITY } else { most }
        };
        let (velocity, effort) = (most("velocity"), most("effort"));
        if lower > upper {
            let message = format!("{subject} is from {lower} to {upper}: read as unlimited");
            self.warn(limit, message, "the lower limit must be the smaller one");
            (lower, upper) = (f64::NEG_INFINITY, f64::INFINITY);
        }
        if form == JointType::Continuous {
            (lower, upper) = (f64::NEG_INFINITY, f64::INFINITY);
        }
        Some(Limits {
            lower,
            upper,
            velocity,
            effort,
        })
    }

    fn kind(
        &mut self,
        element: Element<'a>,
        form: JointType,
        limits: Option<Limits>,
        subject: &str,
    ) -> Option<JointKind> {
        let is_limited =
            limits.is_some_and(|limits| limits.lower.is_finite() || limits.upper.is_finite());
        Some(match form {
            JointType::Revolute if is_limited => JointKind::Revolute,
            JointType::Revolute | JointType::Continuous => JointKind::Continuous,
            JointType::Prismatic => JointKind::Prismatic,
            JointType::Universal => JointKind::Universal,
            JointType::Ball => JointKind::Spherical,
            JointType::Fixed | JointType::Gearbox => JointKind::Fixed,
            JointType::Screw => JointKind::Screw {
                pitch: self.pitch(element, subject)?,
            },
        })
    }

    /// The translation of a screw per radian: of `screw_thread_pitch` in metres per revolution, or of the older
    /// `thread_pitch` in radians per metre of a left-handed thread.
    fn pitch(&mut self, element: Element<'a>, subject: &str) -> Option<Number> {
        if element.first("screw_thread_pitch").is_some() {
            let pitch = self.number(element, "screw_thread_pitch", subject)?;
            let revolution = Double::PI + Double::PI;
            return Some(to_number(pitch.exact() / revolution, pitch.place));
        }
        let Some(pitch) = self.number(element, "thread_pitch", subject) else {
            if element.first("thread_pitch").is_none() {
                let message = format!("{subject} has no <screw_thread_pitch>");
                let hint =
                    "write <screw_thread_pitch>…</screw_thread_pitch>, in metres per revolution";
                self.refuse(element, message, hint);
            }
            return None;
        };
        if pitch.value == 0.0 {
            let message = format!("the <thread_pitch> of {subject} is 0");
            let hint = "it is in radians per metre: write the pitch as <screw_thread_pitch>";
            self.reader
                .errors
                .push_with_hint(pitch.place, message, hint);
            return None;
        }
        let advance = Double::from(-1.0) / pitch.exact();
        Some(to_number(advance, pitch.place))
    }

    /// Damping and friction of the axes, and the rotor that Drake reads.
    fn actuator(
        &mut self,
        element: Element<'a>,
        axes: &[Element<'a>],
        kind: JointKind,
        subject: &str,
    ) -> Actuator {
        let mut actuator = Actuator::default();
        let place = self.place(element);
        let mut words = Vec::new();
        for quantity in [ActuatorQuantity::Damping, ActuatorQuantity::Friction] {
            let numbers = axes.iter().map(|axis| {
                let dynamics = axis.first("dynamics");
                let number = dynamics.and_then(|of| self.number(of, quantity.word(), subject));
                number.unwrap_or_else(|| number::computed(Double::ZERO, place))
            });
            let numbers: Vec<Number> = numbers.collect();
            if numbers.iter().any(|number| number.value != 0.0) {
                actuator.say(quantity, numbers);
                words.push(quantity.word());
            }
        }
        if !words.is_empty() {
            self.reader.unmodelled.friction(place, subject, words);
        }
        if !kind.moves() {
            return actuator;
        }
        let rotor = self.number(element, "drake.rotor_inertia", subject);
        let ratio = self.number(element, "drake.gear_ratio", subject);
        if let Some(rotor) = rotor.filter(|rotor| rotor.value != 0.0) {
            actuator.mount(Motor {
                rotor: Some(rotor),
                ratio,
            });
            self.reader.unmodelled.armature(place, subject);
        }
        actuator
    }
}

/// The rotations of a placement.
fn rotations(steps: &[Step]) -> Vec<Step> {
    let steps = steps.iter().copied();
    steps
        .filter(|step| !matches!(step, Step::Translate(_)))
        .collect()
}
