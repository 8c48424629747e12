//! `<default>`: reads classes of attributes by name.
//!
//! A class inherits the attributes that its outer class has at that point of the text. As in MuJoCo, attributes that a
//! later section adds to the outer class are not inherited.

use std::rc::Rc;

use super::class::{Class, MAIN};
use super::element::{Element, Written};
use super::reading::Mjcf;
use crate::wording::{known, quoted};

/// Maximum nesting depth of classes.
const DEEPEST: usize = 100;

impl<'a> Mjcf<'a> {
    /// Reads all sections of defaults.
    pub(super) fn read_defaults(&mut self, root: Element<'a>) {
        for section in root.named("default") {
            if let Some(written) = section.attribute("class") {
                let name = self.word(written);
                if name.text != MAIN && !name.text.is_empty() {
                    let message = format!(
                        "the outermost class of defaults has the name {}",
                        quoted(&name.text)
                    );
                    let hint = "leave the name out (it is main), or nest this class in an unnamed <default>";
                    self.reader.errors.push_with_hint(name.place, message, hint);
                }
            }
            let outer = Rc::clone(&self.model().defaults.main);
            let main = self.read_class(section, &outer, 0);
            self.model_mut().defaults.main = main;
        }
        let main = Rc::clone(&self.model().defaults.main);
        self.model_mut()
            .defaults
            .classes
            .insert(MAIN.to_owned(), main);
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
                let message = format!("classes of defaults are nested more than {DEEPEST} deep");
                self.refuse(
                    inner,
                    message,
                    "put classes beside each other, and name them in class or childclass",
                );
                break;
            }
            let read = self.read_class(inner, &class, depth + 1);
            let name = inner.attribute("class").map(|written| self.word(written));
            let Some(name) = name.filter(|name| !name.text.is_empty()) else {
                let hint = "write <default class=\"…\">";
                self.refuse(inner, "a class of defaults has no name".to_owned(), hint);
                continue;
            };
            if name.text == MAIN || self.model().defaults.classes.contains_key(&name.text) {
                let message = format!(
                    "the class of defaults {} is defined twice",
                    quoted(&name.text)
                );
                self.reader.errors.push(name.place, message);
            }
            self.model_mut().defaults.classes.insert(name.text, read);
        }
        class
    }

    /// The class named by an attribute. `None` if it is not written, or unknown, which is an error.
    pub(super) fn class(&mut self, written: Option<Written<'a>>) -> Option<Rc<Class<'a>>> {
        let name = self.word(written?);
        let found = self.model().defaults.classes.get(&name.text).cloned();
        if found.is_none() {
            let message = format!("there is no class of defaults {}", quoted(&name.text));
            let classes: Vec<&str> = self
                .model()
                .defaults
                .classes
                .keys()
                .map(String::as_str)
                .collect();
            let hint = known(&name.text, "classes", &classes);
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
        found
    }
}
