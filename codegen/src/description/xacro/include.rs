//! `<xacro:include>`.

use std::rc::Rc;

use super::element::{Expanded, required};
use super::expansion::{Expansion, boolean};
use super::expression::value::Value;
use super::failure::{Failure, failure, failure_with_hint};
use super::scope::Here;
use super::tree::{Element, FileId, elements};
use crate::description::xml::{self, plain};
use crate::error::{Errors, Place};
use crate::wording::quoted;

impl Expansion {
    /// Expands the included files.
    pub(super) fn include(
        &mut self,
        element: &Element,
        here: Here,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        self.check_attributes(element, &["filename", "ns", "optional"]);
        let written = required(element, "filename")?;
        let inner = match element.attribute("ns") {
            Some(namespace) if !namespace.text.is_empty() => {
                let name = self.text(namespace, here.symbols)?;
                self.scopes.namespace(&name, here)
            }
            _ => here,
        };
        let is_optional = match element.attribute("optional") {
            Some(optional) => boolean(&Value::Text(Rc::clone(&optional.text)), &optional.text)?,
            None => false,
        };
        let name = match self.text(written, here.symbols) {
            Ok(name) => name,
            Err(failure) => {
                self.report_in(written, failure);
                return Err(Failure::Reported);
            }
        };
        let path = self.files.path(&name, self.current())?;
        let paths = if path.contains(['*', '?', '[']) {
            let paths = self.files.matching(&path)?;
            if paths.is_empty() {
                let what = format!("no file matches {}", quoted(&name));
                self.warn(written.origin, what, None);
            }
            paths
        } else if is_optional && !self.files.exists(&path) {
            Vec::new()
        } else {
            vec![path]
        };
        for path in paths {
            let file = self.files.open(&path)?;
            let root = self.root(file)?;
            self.reading.push(file);
            let expanded = self.expand(&root, inner);
            self.reading.pop();
            into.children.extend(expanded.children);
        }
        Ok(())
    }

    /// The root element of a file.
    pub(super) fn root(&mut self, file: FileId) -> Result<Rc<Element>, Failure> {
        if let Some(known) = self.trees.get(&file) {
            return Ok(Rc::clone(known));
        }
        let positions = self.files.positions(file);
        let text = plain::plain(positions.text());
        self.budget.spend_text(text.len())?;
        let mut errors = Errors::new();
        let document = xml::parse(&text, &positions, BEGINS, &mut errors);
        let Some(document) = document else {
            let place = |place: Place| match place.order() {
                Some((_, line, column)) => format!("{}:{line}:{column}: ", self.files.name(file)),
                None => format!("{}: ", self.files.name(file)),
            };
            return Err(match errors.diagnostics().first() {
                None => Failure::Reported,
                Some(first) => {
                    let what = format!("{}{}", place(first.place), first.message);
                    match &first.hint {
                        Some(hint) => failure_with_hint(what, hint.clone()),
                        None => failure(what),
                    }
                }
            });
        };
        let tree = elements(document.root_element(), &positions, file);
        let tree = tree.map_err(|origin| {
            let name = self.files.name(file);
            let line = positions
                .place(origin.offset)
                .order()
                .map_or(0, |(_, line, _)| line);
            failure(format!(
                "{name}: the elements in line {line} are nested too deeply"
            ))
        })?;
        self.trees.insert(file, Rc::clone(&tree));
        Ok(tree)
    }
}

/// Hint for a text without the root element.
const BEGINS: &str =
    "a xacro file begins with <robot name=\"…\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">";
