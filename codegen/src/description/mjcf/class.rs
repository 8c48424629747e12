//! Classes of defaults: for each attribute of a kind of element, the values that a class and its outer classes write.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::element::{Element, Written};

/// The outermost class.
pub(super) const MAIN: &str = "main";

/// The elements of actuators, which share one set of defaults.
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

/// The kind of all actuators in classes of defaults.
pub(super) const ACTUATOR: &str = "actuator";

/// A class of defaults.
#[derive(Clone, Default)]
pub(super) struct Class<'a> {
    /// Elements with default attributes; those of outer classes come first.
    pub(super) elements: Vec<Element<'a>>,
}

/// All classes of defaults, by name.
pub(super) struct Defaults<'a> {
    pub(super) main: Rc<Class<'a>>,
    pub(super) classes: BTreeMap<String, Rc<Class<'a>>>,
}

impl<'a> Class<'a> {
    fn elements(&self, kind: &str) -> impl DoubleEndedIterator<Item = &Element<'a>> {
        let is_kind = move |element: &&Element<'a>| {
            let tag = element.tag();
            tag == kind || (kind == ACTUATOR && ACTUATORS.contains(&tag))
        };
        self.elements.iter().filter(is_kind)
    }

    /// All values of an attribute for a kind of element, the outermost class first.
    pub(super) fn attributes(&self, kind: &str, name: &str) -> Vec<Written<'a>> {
        let written = |element: &Element<'a>| element.attribute(name);
        self.elements(kind).filter_map(written).collect()
    }

    /// The last value of any of the named attributes.
    pub(super) fn last_of(&self, kind: &str, names: &[&str]) -> Option<Written<'a>> {
        let of_names =
            |element: &Element<'a>| names.iter().find_map(|name| element.attribute(name));
        self.elements(kind).rev().find_map(of_names)
    }
}

impl<'a> Defaults<'a> {
    /// The outermost class.
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
