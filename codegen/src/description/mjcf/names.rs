//! Unique names of links and joints.
//!
//! In MJCF few bodies and joints have a name; here each one needs one.

use super::element::Element;
use crate::description::fresh::FreshNames;

/// The names of one kind that are in use.
#[derive(Default)]
pub(super) struct Names {
    taken: FreshNames,
}

impl Names {
    /// Collects the names of all elements with these tags.
    pub(super) fn of_elements(root: Element<'_>, tags: &[&str]) -> Self {
        let mut names = Self::default();
        let mut waiting = vec![root];
        while let Some(element) = waiting.pop() {
            if tags.contains(&element.tag())
                && let Some(name) = element.node.attribute("name")
            {
                names.take(name);
            }
            waiting.extend(element.children());
        }
        names
    }

    /// Reserves a name.
    pub(super) fn take(&mut self, name: &str) {
        self.taken.take(name);
    }

    /// Reserves a name for the link of a site: the site's own name, unless a body has it.
    pub(super) fn of_site(&mut self, site: &str) -> String {
        if self.taken.has(site) {
            self.fresh(&format!("{site}_site"))
        } else {
            self.fresh(site)
        }
    }

    /// Reserves the wanted name, or the first unused one of `wanted_2`, `wanted_3`, ….
    pub(super) fn fresh(&mut self, wanted: &str) -> String {
        self.taken.fresh(wanted)
    }
}
