//! Lists of which few entries have something.
//!
//! In: entries, most of them nothing. Out: the same, at four bytes for each that has nothing: a graph has as many nodes as
//! a robot's programs have operations, and few of them are constants or have labels.

/// A list of which few entries have something.
#[derive(Clone, Debug)]
pub(super) struct Sparse<T> {
    /// For each entry an index in `all`, plus one; zero if it has nothing.
    after: Vec<u32>,
    all: Vec<T>,
}

impl<T: Copy> Sparse<T> {
    /// Adds an entry.
    pub(super) fn push(&mut self, of: Option<T>) {
        self.after.push(0);
        if let Some(of) = of {
            self.set(self.after.len() - 1, of);
        }
    }

    /// The content of an entry.
    pub(super) fn get(&self, entry: usize) -> Option<T> {
        let number = self.after[entry].checked_sub(1)?;
        Some(self.all[number as usize])
    }

    /// True if an entry has something.
    pub(super) fn has(&self, entry: usize) -> bool {
        self.after[entry] != 0
    }

    /// Gives something to an entry that has nothing.
    pub(super) fn set(&mut self, entry: usize, of: T) {
        self.all.push(of);
        self.after[entry] = u32::try_from(self.all.len()).expect("fewer than 2³² entries");
    }
}

impl<T> Default for Sparse<T> {
    fn default() -> Self {
        Self {
            after: Vec::new(),
            all: Vec::new(),
        }
    }
}
