//! Gravity of a model, and of a model with others attached.
//!
//! As in MuJoCo, `conflict` of the compiler says which gravity counts. Unless it is `merge`, that of the first file
//! counts.

use super::element::Element;
use super::parts::ModelId;
use super::reading::Mjcf;
use super::settings::Conflict;
use crate::description::Number;
use crate::error::Place;
use crate::wording::quoted;

impl<'a> Mjcf<'a> {
    /// Merges the gravity of an attached model with that of the current one.
    pub(super) fn merge_gravity(&mut self, attached: ModelId, attach: Element<'a>) {
        let own = self.model().gravity;
        let other = self.models[attached].gravity;
        let policy = self.model().compiler.conflict;
        let values = |gravity: [Number; 3]| gravity.map(|entry| entry.value);
        let is_written_twice = own.written.is_some();
        if let Some(written) = other.written
            && own.written.map(values) != Some(values(written))
        {
            match policy {
                Conflict::Merge if !is_written_twice => {
                    self.model_mut().gravity.written = Some(written);
                }
                Conflict::Merge | Conflict::Error if is_written_twice => {
                    self.refuse_gravity(attach);
                }
                _ => self.keep_gravity(attach, written[0].place),
            }
        }
        let Some((is_off, place)) = other.is_off else {
            return;
        };
        match (policy, own.is_off) {
            (Conflict::Merge, _) if is_off => self.model_mut().gravity.is_off = other.is_off,
            (Conflict::Merge, _) => {}
            (Conflict::Error, Some((own, _))) if own != is_off => self.refuse_gravity(attach),
            (_, own) if own.is_some_and(|(own, _)| own) != is_off => {
                self.keep_gravity(attach, place);
            }
            _ => {}
        }
    }

    fn refuse_gravity(&mut self, attach: Element<'a>) {
        let message = format!("{} has another gravity", self.attached_model(attach));
        let hint = "write the same gravity in both, or conflict=\"warning\" in <compiler>";
        self.refuse(attach, message, hint);
    }

    fn keep_gravity(&mut self, attach: Element<'a>, place: Place) {
        let message = format!("gravity of {} is ignored", self.attached_model(attach));
        let hint = "that of the model around it counts; conflict=\"merge\" in its <compiler> uses this one if it has none";
        self.reader.warn(place, message, Some(hint.to_owned()));
    }

    /// The attached model in messages.
    fn attached_model(&mut self, attach: Element<'a>) -> String {
        let name = attach.attribute("model");
        let name = name.map_or_else(String::new, |name| self.word(name).text);
        format!("the attached model {}", quoted(&name))
    }
}
