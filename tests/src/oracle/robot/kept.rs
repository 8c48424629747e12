//! What is modelled of a description, and what moves each joint of it.
//!
//! In: the links and joints as described, and what the request drops, locks and cuts. Out: the joints that are kept, in the
//! order of the bodies, each with what moves it.

use std::collections::{BTreeMap, BTreeSet};

use homogen_codegen::description::{Joint, Name};

use super::Reader;
use super::written::big;
use crate::big::Big;

/// What moves a joint of a description.
pub(super) enum Moves<'d> {
    /// Its own coordinates.
    Own,
    /// That of another, times a factor and from an offset on.
    As {
        leader: &'d str,
        factor: Big,
        offset: Big,
    },
    /// Nothing: it is held there.
    Not(Big),
}

impl<'d> Reader<'d> {
    pub(super) fn base(&self) -> &'d str {
        if let Some(base) = &self.request.base {
            return &base.text;
        }
        let carried = |link: &Name| {
            let mut joints = self.description.joints.iter();
            joints.any(|joint| joint.child.text == link.text)
        };
        let mut links = self.description.links.iter().map(|link| &link.name);
        let root = links.find(|link| !carried(link));
        &root.expect("a tree has a root").text
    }

    fn below(&self, link: &str) -> impl Iterator<Item = &'d Joint> {
        let dropped = |joint: &Joint| {
            let mut drop = self.request.drop.iter();
            drop.any(|link| link.text == joint.child.text)
        };
        let joints = self.description.joints.iter();
        joints.filter(move |joint| joint.parent.text == link && !dropped(joint))
    }

    /// The link that is named, or the only one at an end.
    pub(super) fn tip(&self, base: &'d str) -> Option<&'d str> {
        if let Some(tip) = &self.request.tip {
            return Some(&tip.text);
        }
        let mut waiting = vec![base];
        let mut ends = Vec::new();
        while let Some(link) = waiting.pop() {
            let before = waiting.len();
            waiting.extend(self.below(link).map(|joint| joint.child.text.as_str()));
            if waiting.len() == before {
                ends.push(link);
            }
        }
        match ends[..] {
            [end] => Some(end),
            _ => None,
        }
    }

    /// The links from one up to the root.
    fn upwards(&self, link: &'d str) -> BTreeSet<&'d str> {
        let above = |link: &&str| {
            let mut joints = self.description.joints.iter();
            let carrier = joints.find(|joint| joint.child.text == **link);
            carrier.map(|joint| joint.parent.text.as_str())
        };
        std::iter::successors(Some(link), above).collect()
    }

    /// The joints that are modelled, branch after branch, siblings as described.
    pub(super) fn kept(&self, base: &str) -> Vec<&'d Joint> {
        let mut kept = Vec::new();
        let mut waiting: Vec<&Joint> = self.below(base).collect();
        // The last one in is the first one out.
        waiting.reverse();
        while let Some(joint) = waiting.pop() {
            kept.push(joint);
            let before = waiting.len();
            waiting.extend(self.below(&joint.child.text));
            waiting[before..].reverse();
        }
        kept
    }

    /// What moves each of the joints that are modelled.
    pub(super) fn moves(
        &self,
        kept: &[&'d Joint],
        tip: Option<&'d str>,
    ) -> BTreeMap<&'d str, Moves<'d>> {
        let path = tip.map_or_else(BTreeSet::new, |tip| self.upwards(tip));
        // Who moves the tip, or moves who does.
        let mut needed: BTreeSet<&str> = BTreeSet::new();
        for joint in kept {
            if !self.request.path_only || path.contains(joint.child.text.as_str()) {
                let led = |joint: &&'d Joint| Some(self.leader(joint)?.0);
                let chain = std::iter::successors(Some(*joint), led);
                needed.extend(chain.map(|joint| joint.name.text.as_str()));
            }
        }
        let modelled = |joint: &Joint| {
            let mut there = kept.iter();
            there.any(|other| other.name.text == joint.name.text)
        };
        let of = |joint: &&'d Joint| {
            let (mut at, mut factor, mut offset) = (*joint, Big::one(), Big::zero());
            while let Some((leader, multiplier, more)) = self.leader(at) {
                offset = offset + &factor * more;
                factor = factor * multiplier;
                at = leader;
            }
            let stands = match self.locked(at) {
                Some(stands) => Some(stands),
                None if modelled(at) && needed.contains(at.name.text.as_str()) => None,
                None => Some(Big::zero()),
            };
            let moves = match stands {
                Some(stands) if modelled(at) => Moves::Not(factor * stands + offset),
                Some(_) => Moves::Not(offset),
                None if at.name.text == joint.name.text => Moves::Own,
                None if factor == Big::zero() => Moves::Not(offset),
                None => Moves::As {
                    leader: &at.name.text,
                    factor,
                    offset,
                },
            };
            (joint.name.text.as_str(), moves)
        };
        kept.iter().map(of).collect()
    }

    /// What a joint follows, times what and from where on, where it follows one.
    fn leader(&self, joint: &'d Joint) -> Option<(&'d Joint, Big, Big)> {
        let mimic = joint.mimic.as_ref()?;
        if self.locked(joint).is_some() {
            return None;
        }
        let mut joints = self.description.joints.iter();
        let leader = joints.find(|other| other.name.text == mimic.leader.text)?;
        Some((leader, big(&mimic.multiplier), big(&mimic.offset)))
    }

    /// Where a joint is held by what it is or by what was asked.
    fn locked(&self, joint: &Joint) -> Option<Big> {
        if !joint.kind.moves() {
            return Some(Big::zero());
        }
        let mut locks = self.request.lock.iter();
        let (_, at) = locks.find(|(name, _)| name.text == joint.name.text)?;
        Some(at.as_ref().map_or_else(Big::zero, big))
    }
}
