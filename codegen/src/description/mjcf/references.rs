//! Scopes of the elements outside the tree of bodies: the names that they refer to, once for each attachment and copy.
//!
//! As in MuJoCo, such an element counts where all elements exist that it names. In the first file it has to count
//! somewhere.

use std::collections::HashSet;

use super::element::Element;
use super::elements::unmodelled::DETACHED;
use super::parts::{Affix, ModelId, Scope};
use super::reading::Mjcf;
use crate::list::Id;

/// Maximum number of elements, each counted once for every attachment and copy of its model.
const MOST_REFERRING: usize = 1_000_000;

impl<'a> Mjcf<'a> {
    /// Calls `read` with each element of a section, and with the prefix and suffix of the names in it.
    ///
    /// `names` are the attributes with names of joints, bodies and sites. `is_required` is true if an element of an
    /// attached model that counts nowhere is a warning.
    pub(super) fn referring(
        &mut self,
        scopes: &[Scope],
        section: &str,
        names: &[&str],
        is_required: bool,
        mut read: impl FnMut(&mut Self, Element<'a>, &Affix),
    ) {
        let mut count = 0;
        for model in self.models.ids() {
            let mut known = HashSet::new();
            let affixes: Vec<&Affix> = scopes
                .iter()
                .filter(|scope| scope.model == model)
                .map(|scope| &scope.affix)
                .filter(|affix| known.insert(*affix))
                .collect();
            let root = self.models[model].root;
            let sections = root.named(section).into_iter();
            for element in sections.flat_map(Element::children) {
                count += affixes.len();
                if count > MOST_REFERRING {
                    let message =
                        format!("there are more than {MOST_REFERRING} elements of <{section}>");
                    self.refuse(element, message, "attach or replicate less");
                    return;
                }
                let exists = |affix: &&&Affix| self.has_all(element, names, affix);
                let mut found: Vec<&Affix> = affixes.iter().filter(exists).copied().collect();
                let unattached = Affix::default();
                if found.is_empty() && model == ModelId::new(0) {
                    found.push(&unattached);
                } else if found.is_empty() && is_required && !affixes.is_empty() {
                    let place = self.place(element);
                    let item = format!("<{}>", element.tag());
                    self.noted.note(&DETACHED, place, item);
                }
                self.within(model, |mjcf| {
                    for affix in found {
                        read(mjcf, element, affix);
                    }
                });
            }
        }
    }

    /// True if all elements exist that the attributes of an element name, and one of them is in the attachment or copy:
    /// with the suffix 0, the name of joint `j1` is that of a joint `j10`, which may be elsewhere.
    fn has_all(&self, element: Element<'a>, names: &[&str], affix: &Affix) -> bool {
        let tree = &self.tree;
        let mut is_inside = *affix == Affix::default();
        for attribute in names {
            let Some(written) = element.node.attribute(*attribute) else {
                continue;
            };
            let name = affix.name(written.trim());
            let exists = match *attribute {
                "body1" | "body2" => tree.is_body(&name),
                "site1" | "site2" => tree.sites.contains_key(&name),
                _ => tree.joint(&name).is_some(),
            };
            if !exists {
                return false;
            }
            is_inside |= tree.affixes.get(&name).is_some_and(|own| {
                own.suffix == affix.suffix && own.prefix.starts_with(&affix.prefix)
            });
        }
        is_inside
    }
}
