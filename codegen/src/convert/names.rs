//! New names of auxiliary links and joints.

use std::collections::HashSet;

/// The names of one kind that are in use.
pub(super) struct FreshNames<'d>(HashSet<std::borrow::Cow<'d, str>>);

impl<'d> FreshNames<'d> {
    /// The names of a description.
    pub(super) fn of(names: impl Iterator<Item = &'d str>) -> Self {
        Self(names.map(Into::into).collect())
    }

    /// The wanted name, or the first unused one of `wanted_2`, `wanted_3`, ….
    pub(super) fn fresh(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut count = 1;
        while !self.0.insert(name.clone().into()) {
            count += 1;
            name = format!("{wanted}_{count}");
        }
        name
    }
}
