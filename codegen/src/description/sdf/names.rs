//! Declares names, and finds frames by name.

use super::frames::WORLD_FRAME;
use super::index::{FrameIndex, ScopeIndex};
use super::reading::Sdf;
use super::scope::{BETWEEN, MODEL, WORLD};
use crate::description::Name;
use crate::wording::{named, quoted};

impl Sdf<'_> {
    /// The scope that has the names of a model.
    pub(super) fn owner(&self, mut scope: ScopeIndex) -> ScopeIndex {
        while let Some(outer) = self.scopes[scope.0].merged {
            scope = outer;
        }
        scope
    }

    /// Gives a frame its name in a scope; an error if the name is taken or reserved.
    pub(super) fn declare(&mut self, scope: ScopeIndex, name: &Name, frame: FrameIndex) {
        let owner = self.owner(scope);
        let text = &name.text;
        let is_reserved = text == WORLD
            || text.contains(BETWEEN)
            || text.starts_with("__") && text.ends_with("__");
        if is_reserved {
            let message = format!("the name {} is reserved", quoted(text));
            let hint = "give it a name other than world, without :: and without __ around it";
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
        let names = &mut self.scopes[owner.0].names;
        if names.insert(text.clone(), frame).is_some() {
            let message = format!("there is another element {} in the model", quoted(text));
            let hint = "links, joints, frames and models of one model need different names";
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
    }

    /// The frame with a name, which may be in a nested model; an error if there is none.
    pub(super) fn lookup(&mut self, scope: ScopeIndex, name: &Name) -> Option<FrameIndex> {
        let found = self.find(scope, &name.text);
        if found.is_none() {
            let owner = self.owner(scope);
            let mut names: Vec<&str> = self.scopes[owner.0]
                .names
                .keys()
                .map(String::as_str)
                .collect();
            names.sort_unstable();
            let message = format!("there is no link, joint or frame {}", quoted(&name.text));
            let hint = named(&name.text, "names", &names);
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
        found
    }

    fn find(&self, scope: ScopeIndex, name: &str) -> Option<FrameIndex> {
        if name == MODEL {
            return Some(self.scopes[scope.0].model);
        }
        if name == WORLD {
            return Some(WORLD_FRAME);
        }
        let mut at = self.owner(scope);
        let mut rest = name;
        while let Some((model, inner)) = rest.split_once(BETWEEN) {
            at = self.owner(*self.scopes[at.0].models.get(model)?);
            rest = inner;
        }
        if rest == MODEL {
            return Some(self.scopes[at.0].model);
        }
        self.scopes[at.0].names.get(rest).copied()
    }
}
