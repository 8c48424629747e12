//! The stack depth of a call.
//!
//! In: a call. Out: the bytes of stack that it used below its caller, by the words of a painted stack that it
//! overwrote. The stack must grow down towards unused memory, and interrupts must be off.

use core::ptr::{
    read_volatile, with_exposed_provenance, with_exposed_provenance_mut, write_volatile,
};

use cortex_m::register::msp;

/// The depth that is painted, in words.
const WORDS: usize = 2048;

/// A word that no computation writes.
const PAINT: u32 = 0xdead_beef;

/// The bytes of stack that `call` used.
#[inline(never)]
pub fn depth(call: impl Fn()) -> usize {
    let top = msp::read() as usize;
    let words = (1..=WORDS).rev().map(|below| top - 4 * below);
    for address in words.clone() {
        paint(address);
    }
    call();
    let used = words.clone().find(|address| !is_painted(*address));
    used.map_or(0, |address| top - address)
}

#[expect(
    unsafe_code,
    reason = "memory below the stack pointer belongs to nothing"
)]
fn paint(address: usize) {
    // SAFETY: the address is that of a word of RAM, aligned as the stack pointer is, below the stack
    // pointer of a function that has its frame already, and 4 MB above all statics.
    unsafe { write_volatile(with_exposed_provenance_mut(address), PAINT) }
}

#[expect(
    unsafe_code,
    reason = "memory below the stack pointer belongs to nothing"
)]
fn is_painted(address: usize) -> bool {
    // SAFETY: as above; nothing else runs that could write there.
    unsafe { read_volatile(with_exposed_provenance::<u32>(address)) == PAINT }
}
