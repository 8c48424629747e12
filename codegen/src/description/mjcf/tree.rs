//! Links and joints read so far, with their poses in the described configuration.

use std::collections::HashMap;
use std::rc::Rc;

use super::class::Class;
use super::element::Element;
use super::names::Names;
use crate::description::spatial::inverse;
use crate::description::{Joint, JointId, Link, Number, Step};
use crate::list::List;

/// The name of the fixed link.
pub(super) const WORLD: &str = "world";

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
    /// The number of copies made so far.
    pub(super) copies: usize,
    pub(super) link_names: Names,
    pub(super) joint_names: Names,
}

/// An element of a body, with the placement of the frames around it.
#[derive(Clone)]
pub(super) struct Item<'a> {
    pub(super) element: Element<'a>,
    /// The placement of the frames between the body and the element.
    pub(super) frame: Vec<Step>,
    pub(super) class: Rc<Class<'a>>,
    /// The suffix of names in this copy.
    pub(super) suffix: String,
}

impl Tree {
    /// The joint with a name.
    pub(super) fn joint(&self, name: &str) -> Option<JointId> {
        self.joints.find(|joint| joint.name.text == name)
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
