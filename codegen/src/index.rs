//! Index of a list by the content of its entries.
//!
//! In: a hash of an entry, and a comparison. Out: the number of the entry that is equal, if there is one. Every operation
//! of every program that is tried begins with this question, and every length of a bound, mostly in procedural macros
//! without optimization, so that this is a plain table with open addressing. It keeps the hashes, so that no other entry
//! is looked at.

/// Numbers of entries, each in the first free slot at or behind the one of its hash.
#[derive(Clone, Debug, Default)]
pub struct Index {
    /// The length is a power of two, and at most half is in use.
    slots: Vec<Slot>,
    used: usize,
}

#[derive(Clone, Copy, Debug, Default)]
struct Slot {
    hash: u32,
    /// A number plus one; zero if the slot is free.
    after: u32,
}

/// A hash of two words: the upper bits of products, which depend on all bits.
pub const fn spread(first: u64, second: u64) -> u32 {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15; // 2⁶⁴ / φ, odd
    let word = first.wrapping_mul(FACTOR) ^ second;
    ((word ^ (word >> 32)).wrapping_mul(FACTOR) >> 32) as u32
}

impl Index {
    /// The number of the entry with this hash for which `is` is true.
    pub fn find(&self, hash: u32, is: impl Fn(u32) -> bool) -> Option<u32> {
        if self.slots.is_empty() {
            return None;
        }
        let mut slot = self.first(hash);
        loop {
            let Slot { hash: of, after } = self.slots[slot];
            let number = after.checked_sub(1)?;
            if of == hash && is(number) {
                return Some(number);
            }
            slot = self.next(slot);
        }
    }

    /// Adds an entry that is not in the index yet.
    pub fn insert(&mut self, number: u32, hash: u32) {
        if 2 * (self.used + 1) > self.slots.len() {
            let length = (2 * self.slots.len()).max(64);
            let before = std::mem::replace(&mut self.slots, vec![Slot::default(); length]);
            for entry in before {
                if entry.after != 0 {
                    self.place(entry);
                }
            }
        }
        let after = number + 1;
        self.place(Slot { hash, after });
        self.used += 1;
    }

    fn place(&mut self, entry: Slot) {
        let mut slot = self.first(entry.hash);
        while self.slots[slot].after != 0 {
            slot = self.next(slot);
        }
        self.slots[slot] = entry;
    }

    fn first(&self, hash: u32) -> usize {
        hash as usize & (self.slots.len() - 1)
    }

    const fn next(&self, slot: usize) -> usize {
        (slot + 1) & (self.slots.len() - 1)
    }
}
