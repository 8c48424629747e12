//! `<default>`: classes of attributes, each with those of the class that it stands in.
//!
//! In: the sections of defaults, in the order of the text. Out: classes by name. A class begins with what the class
//! around it has by then, as in MuJoCo: what a later section adds to that one does not reach it. It reads no value.

use std::rc::Rc;

use super::class::{Class, MAIN};
use super::element::{Element, Written};
use super::reading::Mjcf;
use crate::wording::{known, quoted};

/// How deep classes may stand in each other.
const DEEPEST: usize = 100;

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
