//! Index of a list by the content of its entries.
//!
//! In: a hash of an entry, and a comparison. Out: the number of the entry that is equal, if there is one. Every operation
//! of every program that is tried begins with this question, mostly in procedural macros without optimization, so that
//! this is a plain table with open addressing, without keys of its own.

/// Numbers of entries, each in the first free slot at or behind the one of its hash.
#[derive(Clone, Debug, Default)]
pub(super) struct Index {
    /// A number plus one, or zero. The length is a power of two, and at most half is in use.
    slots: Vec<u32>,
    used: usize,
}

impl Index {
    /// The number of the entry with this hash for which `is` is true.
    pub(super) fn find(&self, hash: u32, is: impl Fn(u32) -> bool) -> Option<u32> {
        if self.slots.is_empty() {
            return None;
        }
        let mut slot = self.first(hash);
        while self.slots[slot] != 0 {
            let number = self.slots[slot] - 1;
            if is(number) {
                return Some(number);
            }
            slot = self.next(slot);
        }
        None
    }

    /// Adds an entry that is not in the index yet; `hash` is that of each entry.
    pub(super) fn insert(&mut self, number: u32, hash: impl Fn(u32) -> u32) {
        if 2 * (self.used + 1) > self.slots.len() {
            let length = (2 * self.slots.len()).max(64);
            let before = std::mem::replace(&mut self.slots, vec![0; length]);
            for entry in before {
                if entry != 0 {
                    self.place(entry - 1, hash(entry - 1));
                }
            }
        }
        self.place(number, hash(number));
        self.used += 1;
    }

    fn place(&mut self, number: u32, hash: u32) {
        let mut slot = self.first(hash);
        while self.slots[slot] != 0 {
            slot = self.next(slot);
        }
        self.slots[slot] = number + 1;
    }

    fn first(&self, hash: u32) -> usize {
        hash as usize & (self.slots.len() - 1)
    }

    const fn next(&self, slot: usize) -> usize {
        (slot + 1) & (self.slots.len() - 1)
    }
}
