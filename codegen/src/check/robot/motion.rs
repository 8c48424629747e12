//! The modelled part of a description, and the motion of each of its joints.
//!
//! In: the joints of the description, and what the request drops, locks and leaves off the path. Out: the joints that
//! are kept, and whether each moves independently, mimics another, or is held. The coordinate of a held mimic joint is
//! computed in 106 bits.

use std::collections::HashMap;

use super::{Approximate, JointCoordinate, RobotReader};
use crate::description::{Joint, LinkId, Mimic, Number};
use crate::expression::Double;
use crate::list::List;

impl<'d> RobotReader<'d> {
    /// The joints of the modelled links, parents before children.
    pub(super) fn kept(&self, base: &'d str, links: &HashMap<&'d str, LinkId>) -> Vec<&'d Joint> {
        let mut carried: List<LinkId, Vec<&Joint>> = List::filled(Vec::new(), links.len());
        for joint in &self.description.joints {
            carried[links[joint.parent.text.as_str()]].push(joint);
        }
        let drop = &self.request.drop;
        let mut kept = Vec::new();
        let mut waiting = vec![base];
        while let Some(link) = waiting.pop() {
            for joint in &carried[links[link]] {
                let child = &joint.child.text;
                if drop.iter().all(|dropped| dropped.text != *child) {
                    kept.push(*joint);
                    waiting.push(child);
                }
            }
        }
        kept
    }

    /// The joints between a link and the root.
    pub(super) fn path(&self, link: Option<&'d str>) -> Vec<&'d str> {
        let carriers = self.description.joints.iter();
        let carriers: HashMap<&str, &Joint> = carriers
            .map(|joint| (joint.child.text.as_str(), joint))
            .collect();
        let mut path = Vec::new();
        let mut at = link;
        while let Some(joint) = at.and_then(|link| carriers.get(link)) {
            path.push(joint.name.text.as_str());
            at = Some(&joint.parent.text);
        }
        path
    }

    /// The motion of one of the kept joints.
    pub(super) fn motion(
        &self,
        joint: &'d Joint,
        kept: &[&'d Joint],
        path: &[&str],
    ) -> JointCoordinate<'d> {
        if let Some(at) = self.locked(joint) {
            return JointCoordinate::Held(at);
        }
        if self.mimicked(joint).is_none() {
            let leads = |other: &&'d Joint| {
                let on_path = path.contains(&other.name.text.as_str());
                on_path && self.leads(joint, other)
            };
            let moves = !self.request.path_only || kept.iter().any(leads);
            return if moves {
                JointCoordinate::Own
            } else {
                JointCoordinate::Held(Double::ZERO)
            };
        }
        let (mut factor, mut offset) = (Approximate::exact(1.0), Approximate::exact(0.0));
        // The coordinate of a held joint, in 106 bits.
        let [mut value, mut along] = [0.0, 1.0].map(Double::from);
        let mut at = joint;
        while let Some((mimic, mimicked)) = self.mimicked(at) {
            let (times, plus) = (mimic.multiplier.exact(), mimic.offset.exact());
            offset = offset + factor * Approximate::written(plus);
            factor = factor * Approximate::written(times);
            value = value + along * plus;
            along = along * times;
            at = mimicked;
        }
        let there = kept.iter().any(|other| other.name.text == at.name.text);
        match self.motion(at, kept, path) {
            JointCoordinate::Own if there && !along.is_zero() => {
                JointCoordinate::Mimic(&at.name.text, factor, offset)
            }
            // A joint that is left out has the coordinate of its lock.
            JointCoordinate::Held(held) => JointCoordinate::Held(along * held + value),
            _ => JointCoordinate::Held(value),
        }
    }

    /// The mimic data and the mimicked joint of a mimic joint.
    fn mimicked(&self, joint: &'d Joint) -> Option<(&'d Mimic, &'d Joint)> {
        let mimic = joint
            .mimic
            .as_ref()
            .filter(|_| self.locked(joint).is_none())?;
        let mut others = self.description.joints.iter();
        let mimicked = others.find(|other| other.name.text == mimic.mimicked.text)?;
        Some((mimic, mimicked))
    }

    /// True if a joint is another one, or is mimicked by it.
    fn leads(&self, joint: &Joint, other: &'d Joint) -> bool {
        let next = |joint: &&'d Joint| self.mimicked(joint).map(|(_, mimicked)| mimicked);
        let mut chain = std::iter::successors(Some(other), next);
        chain.any(|other| other.name.text == joint.name.text)
    }

    /// The coordinate at which a joint is held, by its type or by the request.
    fn locked(&self, joint: &Joint) -> Option<Double> {
        if !joint.kind.moves() {
            return Some(Double::ZERO);
        }
        let mut locks = self.request.lock.iter();
        let (_, at) = locks.find(|(lock, _)| lock.text == joint.name.text)?;
        Some(at.as_ref().map_or(Double::ZERO, Number::exact))
    }
}
