//! Classes of defaults.
//!
//! In: elements that say something of others. Out: what a class says of an attribute. It reads no value.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::element::{Element, Written};

/// The class that everything begins with.
pub(super) const MAIN: &str = "main";

/// The elements of actuators, which have one set of defaults.
pub(super) const ACTUATORS: [&str; 12] = [
    "general",
    "motor",
    "position",
    "velocity",
    "intvelocity",
    "damper",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
    "pid",
    "orientation",
];

/// What actuators are called among defaults.
pub(super) const ACTUATOR: &str = "actuator";

/// A class.
#[derive(Clone, Default)]
pub(super) struct Class<'a> {
    /// Elements that say something, of outer classes first.
    pub(super) elements: Vec<Element<'a>>,
}

/// All classes.
pub(super) struct Defaults<'a> {
    pub(super) main: Rc<Class<'a>>,
    pub(super) classes: BTreeMap<String, Rc<Class<'a>>>,
}

impl<'a> Class<'a> {
    fn elements(&self, kind: &str) -> impl DoubleEndedIterator<Item = &Element<'a>> {
        let is_meant = move |element: &&Element<'a>| {
            let tag = element.tag();
            tag == kind || (kind == ACTUATOR && ACTUATORS.contains(&tag))
        };
        self.elements.iter().filter(is_meant)
    }

    /// All that is written of an attribute of such elements, the outermost class first.
    pub(super) fn attributes(&self, kind: &str, name: &str) -> Vec<Written<'a>> {
        let written = |element: &Element<'a>| element.attribute(name);
        self.elements(kind).filter_map(written).collect()
    }

    /// The last that is written of any of some attributes.
    pub(super) fn last_of(&self, kind: &str, names: &[&str]) -> Option<Written<'a>> {
        let of_names =
            |element: &Element<'a>| names.iter().find_map(|name| element.attribute(name));
        self.elements(kind).rev().find_map(of_names)
    }
}

impl<'a> Defaults<'a> {
    /// The class that everything begins with.
    pub(super) fn main(&self) -> Rc<Class<'a>> {
        Rc::clone(&self.main)
    }

    pub(super) fn none() -> Self {
        Self {
            main: Rc::default(),
            classes: BTreeMap::new(),
        }
    }
}
