//! `<actuator>`: armature that actuators add to joints.
//!
//! Runs once the tree is read. An actuator with an armature of its own becomes a motor of its joint; its gear ratio
//! reflects the armature. Transmissions other than to a single hinge or slide are reported as warnings. Control
//! attributes are ignored.

use super::class::{ACTUATOR, ACTUATORS};
use super::element::Element;
use super::elements::unmodelled::{ACTUATOR_DAMPING, ELSEWHERE};
use super::parts::{Affix, Scope};
use super::reading::Mjcf;
use super::values::Attributes;
use crate::joint::actuator::Motor;
use crate::wording::quoted;

impl<'a> Mjcf<'a> {
    /// Reads all actuators.
    pub(super) fn read_actuators(&mut self, scopes: &[Scope]) {
        let names = ["joint", "jointinparent"];
        self.referring(scopes, "actuator", &names, false, |mjcf, element, affix| {
            if ACTUATORS.contains(&element.tag()) {
                mjcf.actuator(element, affix);
            }
        });
    }

    fn actuator(&mut self, element: Element<'a>, affix: &Affix) {
        let class = self.class(element.attribute("class"));
        let attributes = Attributes {
            own: element,
            kind: ACTUATOR,
            class: class.unwrap_or_else(|| self.model().defaults.main()),
        };
        let subject = match element.attribute("name") {
            Some(name) => format!("actuator {}", quoted(&affix.name(&self.word(name).text))),
            None => "an actuator".to_owned(),
        };
        let place = self.place(element);
        let damping = self.entries::<3>(&attributes, "damping", &subject);
        if damping.iter().flatten().any(|damping| damping.value != 0.0) {
            self.noted.note(&ACTUATOR_DAMPING, place, subject.clone());
        }
        let armature = self.number(attributes.get("armature"), &subject);
        let Some(armature) = armature.filter(|armature| armature.value != 0.0) else {
            return;
        };
        let joint = element
            .attribute("joint")
            .or(element.attribute("jointinparent"));
        let joint = joint.map(|written| affix.name(&self.word(written).text));
        let target = joint.and_then(|name| self.tree.joint(&name));
        let target = target.filter(|joint| !self.tree.joints[*joint].kind.has_several());
        let Some(target) = target else {
            self.noted.note(&ELSEWHERE, place, subject);
            return;
        };
        let [gear] = self
            .entries::<6>(&attributes, "gear", &subject)
            .first_chunk()
            .copied()
            .unwrap_or_default();
        let joint = &mut self.tree.joints[target];
        joint.actuator.mount(Motor {
            rotor: Some(armature),
            ratio: gear,
        });
        let joint = joint.name.text.clone();
        self.reader.unmodelled.rotor(place, &subject, Some(joint));
    }
}
