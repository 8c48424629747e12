//! Gearboxes and `<mimic>`: joints that follow others.
//!
//! A gearbox between two links that hinges join to its reference body couples the angles of both hinges:
//! θ₂ = −ratio θ₁, with the angles of parent and child about the axes of the gearbox.

use super::element::Element;
use super::frames::WORLD_FRAME;
use super::index::FrameIndex;
use super::reading::{Ends, PendingJoint, Sdf};
use crate::description::spatial::{Pose, dot, to_number};
use crate::description::{LinkId, Mimic, Name, Number, number};
use crate::expression::Double;
use crate::joint::JointKind;
use crate::wording::quoted;

/// A hinge between a reference body and another link.
struct Hinge {
    /// Its number among the joints.
    number: usize,
    /// True if the angle of the link about the axis of the gearbox is the coordinate, false for its negative.
    is_forward: bool,
}

impl<'a> Sdf<'a> {
    /// Couples the hinges of all gearboxes.
    pub(super) fn gearboxes(&mut self) {
        for pending in self.pending.clone() {
            let kind = pending.element.node.attribute("type");
            if kind.is_some_and(|kind| kind.trim() == "gearbox") {
                self.gearbox(pending);
            }
        }
    }

    fn gearbox(&mut self, pending: PendingJoint<'a>) -> Option<()> {
        let PendingJoint {
            element,
            scope,
            frame,
        } = pending;
        let subject = format!("gearbox {}", quoted(&self.frames.get(frame).name.text));
        let Ends { parent, child } = self.ends(element, scope, &subject)?;
        let place = self.place(element);
        let reference = self.text(element, "gearbox_reference_body");
        let Some(reference) = reference else {
            let message = format!("{subject} has no <gearbox_reference_body>");
            let hint = "write the link that both hinges are joined to";
            self.refuse(element, message, hint);
            return None;
        };
        let reference = self.lookup(scope, &reference)?;
        let reference = self.frames.link_of(reference);
        let ratio = self.number(element, "gearbox_ratio", &subject);
        let ratio = ratio.unwrap_or_else(|| number::computed(1.0, place));
        let first = self.hinge(element, ("axis", frame), reference, parent);
        let second = self.hinge(element, ("axis2", frame), reference, Some(child));
        let coupled = first.zip(second).filter(|(_, second)| {
            let mimic = &self.joints[second.number].mimic;
            mimic.is_none()
        });
        let Some((first, second)) = coupled else {
            let message = format!(
                "not modelled: {subject}, which does not couple two hinges at its reference body"
            );
            let hint = "parent and child need hinges of their own at that body, one of them without a <mimic>";
            self.warn(element, message, hint);
            return None;
        };
        let is_opposite = first.is_forward == second.is_forward;
        let multiplier = if is_opposite {
            Double::ZERO - ratio.exact()
        } else {
            ratio.exact()
        };
        let mimicked = self.joints[first.number].name.clone();
        self.joints[second.number].mimic = Some(Mimic {
            mimicked: Name { place, ..mimicked },
            multiplier: to_number(multiplier, place),
            offset: number::computed(Double::ZERO, place),
            place,
        });
        Some(())
    }

    /// The hinge between a reference body and a link.
    fn hinge(
        &mut self,
        gearbox: Element<'a>,
        (tag, frame): (&str, FrameIndex),
        reference: Option<LinkId>,
        link: Option<LinkId>,
    ) -> Option<Hinge> {
        let pending = self.pending.clone();
        let mut found = pending.into_iter().filter_map(|joint| {
            let number = *self.parts.get(&joint.frame)?;
            let is_hinge = matches!(
                self.joints[number].kind,
                JointKind::Revolute | JointKind::Continuous
            );
            let ends = is_hinge.then(|| self.ends(joint.element, joint.scope, "a hinge"))??;
            let (parent, child) = (ends.parent, Some(ends.child));
            if (parent, child) == (reference, link) {
                Some((joint, number, true))
            } else {
                ((parent, child) == (link, reference)).then_some((joint, number, false))
            }
        });
        let (joint, number, is_outward) = found.next()?;
        drop(found);
        let of_gearbox = self.axis_in_world(gearbox.first(tag)?, frame)?;
        let of_hinge = self.axis_in_world(joint.element.first("axis")?, joint.frame)?;
        let is_along = dot(of_gearbox, of_hinge).sign().to_f64() > 0.0;
        Some(Hinge {
            number,
            is_forward: is_along == is_outward,
        })
    }

    /// The direction of an axis in the world, of any length.
    fn axis_in_world(&mut self, axis: Element<'a>, frame: FrameIndex) -> Option<[Double; 3]> {
        let scope = self.frames.get(frame).scope;
        let own = self.expressed_in(axis, scope).unwrap_or(frame);
        let written = match axis.first("xyz") {
            Some(xyz) => {
                let reader = self.at(xyz);
                reader.numbers_in_text(xyz.node, 3..=3, "the axis of a gearbox")?
            }
            None => [0.0, 0.0, 1.0].map(Number::from).to_vec(),
        };
        let written: [Number; 3] = written.try_into().ok()?;
        let world = WORLD_FRAME;
        let pose = Pose::of(&self.between(world, own));
        Some(pose.direction(written.map(|entry| entry.exact())))
    }

    /// Reads `<mimic>` of each axis, once all joints are known.
    pub(super) fn link_mimics(&mut self) {
        for pending in self.pending.clone() {
            let Some(&number) = self.parts.get(&pending.frame) else {
                continue;
            };
            let axis = pending.element.first("axis");
            let mimic = axis.and_then(|axis| axis.first("mimic"));
            if let Some(mimic) = mimic {
                self.mimic(mimic, pending, number);
            }
        }
    }

    fn mimic(
        &mut self,
        element: Element<'a>,
        pending: PendingJoint<'a>,
        number: usize,
    ) -> Option<()> {
        let subject = format!("joint {}", quoted(&self.joints[number].name.text));
        let subject = format!("the <mimic> of {subject}");
        let place = self.place(element);
        let Some(written) = self.word(element, "joint") else {
            let message = format!("{subject} has no attribute \"joint\"");
            self.refuse(element, message, "write the joint that it follows");
            return None;
        };
        let mimicked = self.lookup(pending.scope, &written)?;
        let Some(mimicked) = self.parts.get(&mimicked) else {
            let message = format!(
                "{subject} names {}, which is no joint",
                quoted(&written.text)
            );
            self.reader.errors.push(written.place, message);
            return None;
        };
        let mimicked = Name {
            place: written.place,
            ..self.joints[*mimicked].name.clone()
        };
        let mut of = |tag: &str, otherwise: f64| {
            let number = self.number(element, tag, &subject);
            number.map_or(Double::from(otherwise), |number| number.exact())
        };
        let (multiplier, offset) = (of("multiplier", 1.0), of("offset", 0.0));
        let offset = offset - multiplier * of("reference", 0.0);
        self.joints[number].mimic = Some(Mimic {
            mimicked,
            multiplier: to_number(multiplier, place),
            offset: to_number(offset, place),
            place,
        });
        Some(())
    }
}
