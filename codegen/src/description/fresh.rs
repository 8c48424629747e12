//! New names beside those in use.

use std::collections::HashSet;

/// The names of one kind that are in use.
#[derive(Default)]
pub(crate) struct FreshNames(HashSet<String>);

impl FreshNames {
    /// Some names.
    pub(crate) fn of<'d>(names: impl IntoIterator<Item = &'d str>) -> Self {
        Self(names.into_iter().map(str::to_owned).collect())
    }

    /// True if a name is in use.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.0.contains(name)
    }

    /// Reserves a name.
    pub(crate) fn take(&mut self, name: &str) {
        self.0.insert(name.to_owned());
    }

    /// Reserves the wanted name, or the first unused one of `wanted_2`, `wanted_3`, ….
    pub(crate) fn fresh(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut count = 1;
        while !self.0.insert(name.clone()) {
            count += 1;
            name = format!("{wanted}_{count}");
        }
        name
    }
}
