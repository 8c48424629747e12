//! Names of links and joints, which every body and every joint needs here, and only few of a file have.
//!
//! In: the names that are written, and what wants one. Out: those, and others that nothing else has. It reads nothing.

use std::collections::HashSet;

use super::element::Element;

/// The names of one kind.
#[derive(Default)]
pub(super) struct Names {
    taken: HashSet<String>,
}

impl Names {
    /// The names that elements of some tags have, wherever they stand.
    pub(super) fn written(root: Element<'_>, tags: &[&str]) -> Self {
        let mut names = Self::default();
        let mut waiting = vec![root];
        while let Some(element) = waiting.pop() {
            if tags.contains(&element.tag()) {
                let name = element.node.attribute("name");
                names.taken.extend(name.map(str::to_owned));
            }
            waiting.extend(element.children());
        }
        names
    }

    /// A name that is written somewhere.
    pub(super) fn take(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// The name of the link that a site is: its own where no body has it.
    pub(super) fn of_site(&mut self, site: &str) -> String {
        if self.taken.contains(site) {
            self.fresh(&format!("{site}_site"))
        } else {
            self.fresh(site)
        }
    }

    /// This name, or where something else has it the first of those that begin with it.
    pub(super) fn fresh(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut count = 1;
        while !self.taken.insert(name.clone()) {
            count += 1;
            name = format!("{wanted}_{count}");
        }
        name
    }
}
