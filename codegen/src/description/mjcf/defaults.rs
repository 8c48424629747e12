//! `<default>`: classes of attributes, each with those of the class that it stands in.
//!
//! In: the sections of defaults, in the order of the text. Out: classes by name. A class begins with what the class
//! around it has by then, as in MuJoCo: what a later section adds to that one does not reach it. It reads no value.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::Mjcf;
use super::element::{Element, Written};
use crate::wording::{known, quoted};

/// The class that everything begins with.
const MAIN: &str = "main";

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

/// How deep classes may stand in each other.
const DEEPEST: usize = 100;

/// A class.
#[derive(Clone, Default)]
pub(super) struct Class<'a> {
    /// Elements that say something, of outer classes first.
    elements: Vec<Element<'a>>,
}

/// All classes.
pub(super) struct Defaults<'a> {
    main: Rc<Class<'a>>,
    classes: BTreeMap<String, Rc<Class<'a>>>,
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

impl<'a> Mjcf<'a> {
    /// Reads all sections.
    pub(super) fn read_defaults(&mut self, root: Element<'a>) {
        for section in root.named("default") {
            if let Some(written) = section.attribute("class") {
                let name = self.word(written);
                if name.text != MAIN && !name.text.is_empty() {
                    let message = format!(
                        "the outermost class of defaults is called {}",
                        quoted(&name.text)
                    );
                    let hint = "its name is main: leave it out, or let another class stand in it";
                    self.reader.errors.push_with_hint(name.place, message, hint);
                }
            }
            let outer = Rc::clone(&self.defaults.main);
            let main = self.read_class(section, &outer, 0);
            self.defaults.main = main;
        }
        let main = Rc::clone(&self.defaults.main);
        self.defaults.classes.insert(MAIN.to_owned(), main);
    }

    fn read_class(
        &mut self,
        section: Element<'a>,
        outer: &Rc<Class<'a>>,
        depth: usize,
    ) -> Rc<Class<'a>> {
        let children = section.children();
        let (nested, own): (Vec<_>, Vec<_>) = children
            .into_iter()
            .partition(|child| child.tag() == "default");
        let mut elements = outer.elements.clone();
        elements.extend(own);
        let class = Rc::new(Class { elements });
        for inner in nested {
            if depth == DEEPEST {
                let message =
                    format!("classes of defaults stand more than {DEEPEST} deep in each other");
                self.refuse(inner, message, "give them names and use those");
                break;
            }
            let read = self.read_class(inner, &class, depth + 1);
            let name = inner.attribute("class").map(|written| self.word(written));
            let Some(name) = name.filter(|name| !name.text.is_empty()) else {
                let hint = "write <default class=\"…\">";
                self.refuse(inner, "a class of defaults has no name".to_owned(), hint);
                continue;
            };
            if name.text == MAIN || self.defaults.classes.contains_key(&name.text) {
                let message = format!("there is another class of defaults {}", quoted(&name.text));
                self.reader.errors.push(name.place, message);
            }
            self.defaults.classes.insert(name.text, read);
        }
        class
    }

    /// The class that an attribute names; none where it is not written, or there is no such class.
    pub(super) fn class(&mut self, written: Option<Written<'a>>) -> Option<Rc<Class<'a>>> {
        let name = self.word(written?);
        let found = self.defaults.classes.get(&name.text).cloned();
        if found.is_none() {
            let message = format!("there is no class of defaults {}", quoted(&name.text));
            let classes: Vec<&str> = self.defaults.classes.keys().map(String::as_str).collect();
            let hint = known(&name.text, "classes", &classes);
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
        found
    }
}
