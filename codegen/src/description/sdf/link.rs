//! `<link>`: name and inertia.

use super::element::Element;
use super::frames::Role;
use super::index::{FrameIndex, ScopeIndex};
use super::reading::Sdf;
use crate::description::{Inertial, Link, LinkId, Number, Step, number};
use crate::list::Id;
use crate::wording::quoted;

impl<'a> Sdf<'a> {
    /// Declares a link.
    pub(super) fn link(&mut self, element: Element<'a>, scope: ScopeIndex, model: FrameIndex) {
        let Some(name) = self.name(element, "a link") else {
            return;
        };
        let role = Role::Link(LinkId::new(self.links.len()));
        let frame = self.named_frame(element, &name, scope, model, role);
        let own = self.frames.get_mut(frame);
        own.attached = frame;
        let name = own.name.clone();
        let subject = format!("link {}", quoted(&name.text));
        let inertial = self.inertial(element, &subject);
        self.link_frames.push(frame);
        self.links.push(Link { name, inertial });
    }

    /// The inertia of a link. What is not written is 1 kg and 1 kg m² about each axis, as SDF defines.
    fn inertial(&mut self, link: Element<'a>, subject: &str) -> Option<Inertial> {
        let subject = format!("the inertial of {subject}");
        let Some(element) = link.first("inertial") else {
            let message = format!("{subject} is not written: 1 kg and 1 kg m² about each axis");
            self.warn(
                link,
                message,
                "write <inertial>: these are the numbers that SDF defines",
            );
            return self.numbers_of(link, link, Vec::new(), &subject);
        };
        let is_computed = self.word(element, "auto");
        if is_computed.is_some_and(|word| word.text == "true" || word.text == "1") {
            let message = format!("{subject} is to be computed from collisions (auto)");
            let hint = "write its numbers: `gz sdf --inertial-stats FILE` prints them";
            self.refuse(element, message, hint);
            return None;
        }
        let origin = element
            .first("pose")
            .map_or_else(Vec::new, |pose| self.pose(pose, &subject));
        let tensor = element.first("inertia").unwrap_or(element);
        self.numbers_of(element, tensor, origin, &subject)
    }

    fn numbers_of(
        &mut self,
        element: Element<'a>,
        tensor: Element<'a>,
        origin: Vec<Step>,
        subject: &str,
    ) -> Option<Inertial> {
        let place = self.place(element);
        let mut of = |from: Element<'a>, tag: &str, otherwise: f64| -> Option<Number> {
            match from.first(tag) {
                Some(_) => self.number(from, tag, subject),
                None => Some(number::computed(otherwise, place)),
            }
        };
        let mass = of(element, "mass", 1.0);
        let entries = [
            ("ixx", 1.0),
            ("ixy", 0.0),
            ("ixz", 0.0),
            ("iyy", 1.0),
            ("iyz", 0.0),
            ("izz", 1.0),
        ];
        let entries = entries.map(|(tag, otherwise)| of(tensor, tag, otherwise));
        let mut inertia = [Number::default(); 6];
        for (number, entry) in inertia.iter_mut().zip(entries) {
            *number = entry?;
        }
        let mass = mass?;
        if mass.value < 0.0 {
            let message = format!("the mass of {subject} is negative: {}", mass.value);
            self.reader.errors.push(mass.place, message);
        }
        Some(Inertial {
            origin,
            mass,
            inertia,
            place,
        })
    }
}
