//! What was read of the tree of bodies.
//!
//! A shared noun: links and joints, and where everything stands as described.

use std::collections::HashMap;
use std::rc::Rc;

use super::class::Class;
use super::element::Element;
use super::names::Names;
use super::spatial::inverse;
use crate::description::{Joint, JointId, Link, Number, Step};
use crate::list::List;

/// The link that is fixed.
pub(super) const WORLD: &str = "world";

/// What was read of the tree.
#[derive(Default)]
pub(super) struct Tree {
    pub(super) links: Vec<Link>,
    pub(super) joints: List<JointId, Joint>,
    /// Of each link that is a body or a site: the link that it stands in, and where it is there as described.
    pub(super) stands: HashMap<String, (String, Vec<Step>)>,
    /// The links that sites are, by the names of these.
    pub(super) sites: HashMap<String, String>,
    /// The coordinate that a joint has as described, by its name.
    pub(super) references: HashMap<String, Number>,
    /// How many copies were made.
    pub(super) copies: usize,
    pub(super) link_names: Names,
    pub(super) joint_names: Names,
}

/// An element of a body, in the frames that stand around it.
#[derive(Clone)]
pub(super) struct Item<'a> {
    pub(super) element: Element<'a>,
    /// From the frame of the body.
    pub(super) frame: Vec<Step>,
    pub(super) class: Rc<Class<'a>>,
    /// What names end with.
    pub(super) suffix: String,
}

impl Tree {
    /// The joint of a name.
    pub(super) fn joint(&self, name: &str) -> Option<JointId> {
        self.joints.find(|joint| joint.name.text == name)
    }

    /// Where a link is as described, seen from another.
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

    /// The links from the world to one of them, each with where it is in the one before.
    fn path<'t>(&'t self, link: &str) -> Vec<(&'t str, &'t [Step])> {
        let mut path = Vec::new();
        let mut at = self.stands.get_key_value(link);
        while let Some((name, (parent, steps))) = at {
            path.push((name.as_str(), steps.as_slice()));
            at = self.stands.get_key_value(parent);
        }
        path.reverse();
        path
    }
}
