//! Links and joints read so far, with their poses in the described configuration.

use std::collections::HashMap;

use super::names::Names;
use super::parts::{Affix, PartId, WORLD};
use crate::description::spatial::inverse;
use crate::description::{Joint, JointId, Link, Number, Step};
use crate::list::List;

/// The links and joints read so far.
#[derive(Default)]
pub(super) struct Tree {
    pub(super) links: Vec<Link>,
    pub(super) joints: List<JointId, Joint>,
    /// For each body and site, by link name: its parent, and its placement there in the described configuration.
    pub(super) placements: HashMap<String, (String, Vec<Step>)>,
    /// The link names of sites, by site name.
    pub(super) sites: HashMap<String, String>,
    /// The coordinates of joints in the described configuration (`ref`), by joint name.
    pub(super) references: HashMap<String, Number>,
    /// The joints of the tree of bodies, by their numbers there.
    pub(super) joints_of_parts: HashMap<PartId, JointId>,
    joint_ids: HashMap<String, JointId>,
    /// Prefixes and suffixes of joints, bodies and sites, by name.
    pub(super) affixes: HashMap<String, Affix>,
    pub(super) link_names: Names,
    pub(super) joint_names: Names,
}

impl Tree {
    /// Adds a joint.
    pub(super) fn add(&mut self, joint: Joint) -> JointId {
        let name = joint.name.text.clone();
        let id = self.joints.push(joint);
        self.joint_ids.entry(name).or_insert(id);
        id
    }

    /// The joint with a name.
    pub(super) fn joint(&self, name: &str) -> Option<JointId> {
        self.joint_ids.get(name).copied()
    }

    /// True if a link is the world, a body or a site.
    pub(super) fn is_body(&self, name: &str) -> bool {
        name == WORLD || self.placements.contains_key(name)
    }

    /// The pose of one link in another, in the described configuration.
    pub(super) fn between(&self, from: &str, to: &str) -> Vec<Step> {
        let (mut from, mut to) = (self.path(from), self.path(to));
        let shared = from.iter().zip(&to).take_while(|(a, b)| a.0 == b.0).count();
        let below = |path: &mut Vec<(&str, &[Step])>| {
            let steps = path
                .drain(shared..)
                .flat_map(|(_, steps)| steps.iter().copied());
            steps.collect::<Vec<Step>>()
        };
        let mut steps = inverse(&below(&mut from));
        steps.extend(below(&mut to));
        steps
    }

    /// The links from the world to `link`, each with its placement in the previous one.
    fn path<'t>(&'t self, link: &str) -> Vec<(&'t str, &'t [Step])> {
        let mut path = Vec::new();
        let mut at = self.placements.get_key_value(link);
        while let Some((name, (parent, steps))) = at {
            path.push((name.as_str(), steps.as_slice()));
            at = self.placements.get_key_value(parent);
        }
        path.reverse();
        path
    }
}
