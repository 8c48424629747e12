//! `<attach>`: a body, a frame or the world of another model, or a body or a frame of the same model that comes before.
//!
//! The elements keep the settings and defaults of their own model. Their names get a prefix, as do those of its classes
//! and assets.

use super::element::{Element, Written};
use super::parts::{Affix, Item, ModelId, PartId, Parts, SpanKind};
use super::reading::Mjcf;
use crate::wording::{known, quoted};

const SUBJECT: &str = "an <attach>";

impl<'a> Mjcf<'a> {
    /// Adds the elements that an `<attach>` names.
    pub(super) fn attach(&mut self, item: &Item<'a>, within: PartId, parts: &mut Parts<'a>) {
        let element = item.element;
        self.copies += 1;
        let Some(prefix) = element.attribute("prefix") else {
            let hint = "write prefix=\"…\"; it may be empty";
            self.refuse(element, format!("{SUBJECT} has no prefix"), hint);
            return;
        };
        let prefix = self.word(prefix).text;
        let (body, frame) = (element.attribute("body"), element.attribute("frame"));
        let named = match (body, frame) {
            (Some(_), Some(_)) => {
                let message = format!("{SUBJECT} has both body and frame");
                self.refuse(element, message, "leave one of them out");
                return;
            }
            (Some(body), None) => Some((SpanKind::Body, body)),
            (None, frame) => frame.map(|frame| (SpanKind::Frame, frame)),
        };
        let written_model = element.attribute("model");
        let attached = match written_model {
            None => None,
            Some(written) => match self.attachable(written) {
                None => return,
                found => found,
            },
        };
        let from = match attached {
            Some(model) => &self.models[model].parts,
            None => &*parts,
        };
        let mut taken = match named {
            Some((kind, written)) => {
                let name = written.attribute.value().trim();
                let Some(taken) = from.take(kind, name) else {
                    let names = from.names(kind);
                    self.refuse_name(kind, written, &names);
                    return;
                };
                taken
            }
            None if attached.is_none() => {
                let hint = "write model=\"…\", or body=\"…\" or frame=\"…\" of this model";
                self.refuse(element, format!("{SUBJECT} has no model"), hint);
                return;
            }
            None => from.take_all(),
        };
        match attached {
            Some(model) => self.import(model, &prefix, element),
            None => taken.forget_keyframes(),
        }
        let mut around = item.clone();
        around.affix = Affix {
            prefix,
            ..around.affix
        };
        self.copies += parts.put(taken, &around, within);
    }

    /// The model that an attribute names; an error if there is none.
    fn attachable(&mut self, written: Written<'a>) -> Option<ModelId> {
        let name = self.word(written);
        let attachable = &self.model().attachable;
        let found = attachable.get(&name.text).copied();
        if found.is_none() {
            let mut models: Vec<&str> = attachable.keys().map(String::as_str).collect();
            models.sort_unstable();
            let hint = known(&name.text, "models", &models);
            let message = format!(
                "{SUBJECT} names a model that does not exist: {}",
                quoted(&name.text)
            );
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
        found
    }

    fn refuse_name(&mut self, kind: SpanKind, written: Written<'a>, names: &[String]) {
        let name = self.word(written);
        let (one, many) = match kind {
            SpanKind::Body => ("body", "bodies"),
            SpanKind::Frame => ("frame", "frames"),
        };
        let message = format!(
            "{SUBJECT} names a {one} that does not exist: {}",
            quoted(&name.text)
        );
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let hint = known(&name.text, many, &names);
        self.reader.errors.push_with_hint(name.place, message, hint);
    }

    /// Makes classes of defaults and assets of an attached model known by their names with the prefix, and merges
    /// gravity; once for each prefix.
    fn import(&mut self, model: ModelId, prefix: &str, attach: Element<'a>) {
        let prefixes = self.model_mut().attached.entry(model).or_default();
        if prefixes.is_empty() {
            self.merge_gravity(model, attach);
        }
        let prefixes = self.model_mut().attached.entry(model).or_default();
        if !prefixes.insert(prefix.to_owned()) {
            return;
        }
        let from = &self.models[model];
        let classes = from.defaults.classes.iter();
        let classes: Vec<_> = classes
            .map(|(name, class)| (format!("{prefix}{name}"), class.clone()))
            .collect();
        let assets = from.assets.with_prefix(prefix);
        let own = self.model_mut();
        for (name, class) in classes {
            own.defaults.classes.entry(name).or_insert(class);
        }
        own.assets.import(assets);
    }
}
