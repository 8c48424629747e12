//! The joints that are modelled, and the source of each joint's motion.
//!
//! In: links and joints as described; the base, the dropped links and the locked joints of the request. Out: the joints
//! that are modelled, in the order of the bodies, each with its own coordinates, those of a mimicked joint, or none.

use std::collections::{BTreeMap, BTreeSet};

use homogen_codegen::description::{Joint, Name};

use super::Reader;
use super::written::big;
use crate::big::Big;

/// The source of a joint's motion.
pub(super) enum Moves<'d> {
    /// Its own coordinates.
    Own,
    /// The coordinate of the mimicked joint, by factor · coordinate + offset.
    As {
        mimicked: &'d str,
        factor: Big,
        offset: Big,
    },
    /// None: it is locked at this displacement.
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

    /// The named end effector, or the only link without children.
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

    /// The links from one up to the root, itself included.
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
        // The last one pushed is the first one popped.
        waiting.reverse();
        while let Some(joint) = waiting.pop() {
            kept.push(joint);
            let before = waiting.len();
            waiting.extend(self.below(&joint.child.text));
            waiting[before..].reverse();
        }
        kept
    }

    /// The source of motion of each joint that is modelled.
    pub(super) fn moves(
        &self,
        kept: &[&'d Joint],
        tip: Option<&'d str>,
    ) -> BTreeMap<&'d str, Moves<'d>> {
        let path = tip.map_or_else(BTreeSet::new, |tip| self.upwards(tip));
        // The joints on the path to the end effector, and those that they mimic.
        let mut needed: BTreeSet<&str> = BTreeSet::new();
        for joint in kept {
            if !self.request.path_only || path.contains(joint.child.text.as_str()) {
                let mimicked = |joint: &&'d Joint| Some(self.mimicked(joint)?.0);
                let chain = std::iter::successors(Some(*joint), mimicked);
                needed.extend(chain.map(|joint| joint.name.text.as_str()));
            }
        }
        let modelled = |joint: &Joint| {
            let mut there = kept.iter();
            there.any(|other| other.name.text == joint.name.text)
        };
        let of = |joint: &&'d Joint| {
            let (mut at, mut factor, mut offset) = (*joint, Big::one(), Big::zero());
            while let Some((mimicked, multiplier, more)) = self.mimicked(at) {
                offset = offset + &factor * more;
                factor = factor * multiplier;
                at = mimicked;
            }
            let locked = match self.locked(at) {
                Some(position) => Some(position),
                None if modelled(at) && needed.contains(at.name.text.as_str()) => None,
                None => Some(Big::zero()),
            };
            let moves = match locked {
                Some(position) if modelled(at) => Moves::Not(factor * position + offset),
                Some(_) => Moves::Not(offset),
                None if at.name.text == joint.name.text => Moves::Own,
                None if factor == Big::zero() => Moves::Not(offset),
                None => Moves::As {
                    mimicked: &at.name.text,
                    factor,
                    offset,
                },
            };
            (joint.name.text.as_str(), moves)
        };
        kept.iter().map(of).collect()
    }

    /// The joint that a joint mimics, with multiplier and offset; `None` if it mimics none.
    fn mimicked(&self, joint: &'d Joint) -> Option<(&'d Joint, Big, Big)> {
        let mimic = joint.mimic.as_ref()?;
        if self.locked(joint).is_some() {
            return None;
        }
        let mut joints = self.description.joints.iter();
        let mimicked = joints.find(|other| other.name.text == mimic.mimicked.text)?;
        Some((mimicked, big(&mimic.multiplier), big(&mimic.offset)))
    }

    /// The position of a joint that is fixed or locked.
    fn locked(&self, joint: &Joint) -> Option<Big> {
        if !joint.kind.moves() {
            return Some(Big::zero());
        }
        let mut locks = self.request.lock.iter();
        let (_, at) = locks.find(|(name, _)| name.text == joint.name.text)?;
        Some(at.as_ref().map_or_else(Big::zero, big))
    }
}
