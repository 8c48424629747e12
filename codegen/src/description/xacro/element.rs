//! Expands elements.
//!
//! Elements are expanded in the order of the file. The result of a macro, an included file or a condition takes the
//! place of its element.

use std::rc::Rc;

use super::budget::HEAVY;
use super::expansion::{Expansion, boolean};
use super::failure::{Failure, failure, failure_with_hint};
use super::scope::{Here, Symbol};
use super::tree::{Attribute, Element, Node, Written};
use crate::wording::{list, quoted};

/// Prefix of the elements of xacro.
pub(super) const PREFIX: &str = "xacro:";

/// The expansion of an element.
#[derive(Default)]
pub(super) struct Expanded {
    /// The attributes of the element around.
    pub(super) attributes: Vec<Attribute>,
    pub(super) children: Vec<Node>,
}

impl Expanded {
    /// Sets an attribute of the element around.
    fn set(&mut self, attribute: Attribute) {
        let mut known = self.attributes.iter_mut();
        match known.find(|known| known.name == attribute.name) {
            Some(known) => *known = attribute,
            None => self.attributes.push(attribute),
        }
    }
}

impl Expansion {
    /// The element with its attributes and children expanded.
    pub(super) fn expand(&mut self, element: &Element, here: Here) -> Element {
        let mut inner = Expanded {
            attributes: self.attributes(element, here),
            children: Vec::new(),
        };
        self.contents(element, here, &mut inner);
        Element {
            name: Rc::clone(&element.name),
            attributes: inner.attributes,
            children: inner.children,
            origin: element.origin,
        }
    }

    /// The children of an element, expanded.
    pub(super) fn contents(&mut self, element: &Element, here: Here, into: &mut Expanded) {
        if let Err(failure) = self.budget.enter(HEAVY) {
            self.report(element.origin, failure);
            return;
        }
        for child in &element.children {
            if self.budget.is_spent() {
                break;
            }
            match child {
                Node::Element(child) => {
                    let steps = 1 + child.attributes.len();
                    let expanded = self.budget.spend(steps);
                    let expanded = expanded.and_then(|()| self.child(child, here, into));
                    if let Err(failure) = expanded {
                        self.report(child.origin, failure);
                    }
                }
                Node::Text(text) => match self.computed(text, here) {
                    Ok(text) => into.children.push(Node::Text(text)),
                    Err(failure) => self.report_in(text, failure),
                },
                Node::Literal(text) => into.children.push(Node::Literal(text.clone())),
            }
        }
        self.budget.leave(HEAVY);
    }

    /// A text with its value.
    fn computed(&mut self, text: &Written, here: Here) -> Result<Written, Failure> {
        if !text.text.contains('$') {
            return Ok(text.clone());
        }
        Ok(Written {
            text: self.text(text, here.symbols)?,
            origin: text.origin,
            is_verbatim: false,
        })
    }

    /// The attributes of an element with their values. Those of xacro and declarations of namespaces are left out.
    pub(super) fn attributes(&mut self, element: &Element, here: Here) -> Vec<Attribute> {
        let mut found = Vec::with_capacity(element.attributes.len());
        for attribute in &element.attributes {
            let is_declaration = attribute.name.starts_with("xmlns");
            if is_declaration || attribute.name.starts_with(PREFIX) {
                continue;
            }
            match self.computed(&attribute.value, here) {
                Ok(value) => found.push(Attribute {
                    name: Rc::clone(&attribute.name),
                    origin: attribute.origin,
                    value,
                }),
                Err(failure) => self.report_in(&attribute.value, failure),
            }
        }
        found
    }

    /// Expands an element into the one around it.
    fn child(
        &mut self,
        element: &Rc<Element>,
        here: Here,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        let Some(word) = element.name.strip_prefix(PREFIX) else {
            let expanded = self.expand(element, here);
            into.children.push(Node::Element(Rc::new(expanded)));
            return Ok(());
        };
        match word {
            "insert_block" => self.insert_block(element, here, into),
            "include" => self.include(element, here, into),
            "property" => self.define_property(element, here.symbols),
            "macro" => self.define_macro(element, here),
            "arg" => self.declare_argument(element, here),
            "element" => self.named_element(element, here, into),
            "attribute" => self.set_attribute(element, here, into),
            "if" | "unless" => self.condition(element, here, word == "if", into),
            _ => self.call(element, here, into),
        }
    }

    /// Warns of attributes that an element of xacro does not have.
    pub(super) fn check_attributes(&mut self, element: &Element, known: &[&str]) {
        for attribute in &element.attributes {
            if !known.contains(&&*attribute.name) && !attribute.name.starts_with("xmlns") {
                let what = format!(
                    "attribute {} of <{}> is ignored",
                    quoted(&attribute.name),
                    element.name
                );
                let hint = format!("known attributes: {}", list(known.iter().copied()));
                self.warn(attribute.origin, what, Some(hint));
            }
        }
    }

    /// `<xacro:insert_block name="…"/>`: a parameter of a macro, or a property, that consists of elements.
    fn insert_block(
        &mut self,
        element: &Element,
        here: Here,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        self.check_attributes(element, &["name"]);
        let name = &required(element, "name")?.text;
        let mut found = None;
        for (stars, is_content) in [("**", true), ("*", false)] {
            let symbol = self.scopes.find(here.symbols, &format!("{stars}{name}"));
            if let (None, Some((_, Symbol::Block(block)))) = (&found, symbol) {
                found = Some((Rc::clone(block), is_content));
            }
        }
        let Some((block, is_content)) = found else {
            return Err(failure(format!("there is no block {}", quoted(name))));
        };
        let block = self.expand(&block, here);
        if is_content {
            into.children.extend(block.children);
        } else {
            into.children.push(Node::Element(Rc::new(block)));
        }
        Ok(())
    }

    /// `<xacro:arg name="…" default="…"/>`: an argument, and its value if the user gives none.
    fn declare_argument(&mut self, element: &Element, here: Here) -> Result<(), Failure> {
        self.check_attributes(element, &["name", "default"]);
        let name = required(element, "name")?.text.to_string();
        let default = required(element, "default")?;
        if let Some(argument) = self.arguments.get_mut(&name) {
            argument.is_used = true;
            return Ok(());
        }
        let value = match self.text(default, here.symbols) {
            Ok(value) => value,
            Err(failure) => {
                self.report_in(default, failure);
                return Err(Failure::Reported);
            }
        };
        let declared = super::expansion::XacroArgument {
            value: value.to_string(),
            is_given: false,
            is_used: true,
        };
        self.arguments.insert(name, declared);
        Ok(())
    }

    /// `<xacro:element xacro:name="…" …>`: an element whose tag is computed.
    fn named_element(
        &mut self,
        element: &Element,
        here: Here,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        const NAME: &str = "xacro:name";
        let name = required(element, NAME)?;
        let tag = self.text(name, here.symbols)?;
        check_name(&tag)?;
        let attributes = element.attributes.iter();
        let attributes = attributes.filter(|attribute| &*attribute.name != NAME);
        let named = Element {
            name: tag,
            attributes: attributes.cloned().collect(),
            children: element.children.clone(),
            origin: element.origin,
        };
        self.child(&Rc::new(named), here, into)
    }

    /// `<xacro:attribute name="…" value="…"/>`: an attribute of the element around.
    fn set_attribute(
        &mut self,
        element: &Element,
        here: Here,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        let name = required(element, "name")?;
        let name = self.text(name, here.symbols)?;
        check_name(&name)?;
        let value = required(element, "value")?;
        let value = self.computed(value, here)?;
        into.set(Attribute {
            name,
            origin: element.origin,
            value,
        });
        Ok(())
    }

    /// `<xacro:if value="…">` or `<xacro:unless value="…">`.
    fn condition(
        &mut self,
        element: &Element,
        here: Here,
        wanted: bool,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        self.check_attributes(element, &["value"]);
        let written = required(element, "value")?;
        let value = self.value(written, here.symbols);
        let value = value.and_then(|value| boolean(&value, &written.text));
        match value {
            Ok(value) if value == wanted => {
                let mut inner = Expanded::default();
                self.contents(element, here, &mut inner);
                into.children.extend(inner.children);
            }
            Ok(_) => {}
            Err(failure) => self.report_in(written, failure),
        }
        Ok(())
    }
}

/// A required attribute.
pub(super) fn required<'e>(element: &'e Element, name: &str) -> Result<&'e Written, Failure> {
    element.attribute(name).ok_or_else(|| {
        let name = quoted(name);
        failure(format!("<{}> has no attribute {name}", element.name))
    })
}

/// Rejects a computed name that XML does not allow.
fn check_name(name: &str) -> Result<(), Failure> {
    let is_letter = |letter: char| letter.is_alphanumeric() || "_:.-".contains(letter);
    let starts = name.starts_with(|letter: char| letter.is_alphabetic() || letter == '_');
    if starts && name.chars().all(is_letter) {
        return Ok(());
    }
    Err(failure_with_hint(
        format!("{} is no name of an element or attribute", quoted(name)),
        "a name begins with a letter and has letters, digits, _, - and .",
    ))
}
