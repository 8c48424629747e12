//! Unique names of links and joints.
//!
//! In MJCF few bodies and joints have a name; here each one needs one.

use crate::description::fresh::FreshNames;

/// The names of one kind that are in use.
#[derive(Default)]
pub(super) struct Names {
    taken: FreshNames,
}

impl Names {
    /// Some names.
    pub(super) fn of<'n>(names: impl IntoIterator<Item = &'n str>) -> Self {
        Self {
            taken: FreshNames::of(names),
        }
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
