//! The test of one function of the controller.
//!
//! In: the function, the states and the results of the host. Out: a line of the report, and true if every bit is that
//! of the host and all calls take the same time.

use core::hint::black_box;

use controller::{STATES, State};

use crate::clock::Clock;
use crate::report::Line;
use crate::stack;

/// A result as a list of numbers.
pub trait Numbers {
    /// All numbers.
    fn numbers(&self) -> &[f32];
}

impl<const N: usize> Numbers for [f32; N] {
    fn numbers(&self) -> &[f32] {
        self
    }
}

impl<const N: usize, const M: usize> Numbers for [[f32; M]; N] {
    fn numbers(&self) -> &[f32] {
        self.as_flattened()
    }
}

/// True if `function` returns the bits `expected` and takes the same time for every state.
pub fn examine<R: Numbers, const WORDS: usize>(
    name: &str,
    clock: &Clock,
    states: &[State; STATES],
    expected: &[[u32; WORDS]; STATES],
    function: impl Fn(&State) -> R,
) -> bool {
    let mut different = 0;
    for (state, expected) in states.iter().zip(expected) {
        let result = function(black_box(state));
        let numbers = result.numbers().iter().zip(expected);
        different += numbers
            .filter(|(number, bits)| self::bits(**number) != **bits)
            .count();
    }
    let mut line = Line::new();
    line.text("differences ")
        .text(name)
        .text(" ")
        .integer(different);
    line.print();
    time(name, clock, states, function) && different == 0
}

/// True if `function` takes the same time for every state.
fn time<R>(
    name: &str,
    clock: &Clock,
    states: &[State; STATES],
    function: impl Fn(&State) -> R,
) -> bool {
    let (mut least, mut most, mut deepest) = (u32::MAX, 0, 0);
    for state in states {
        let call = || {
            black_box(&function(black_box(state)));
        };
        deepest = deepest.max(stack::depth(call));
        let duration = clock.one(call);
        least = least.min(duration);
        most = most.max(duration);
    }
    let mut line = Line::new();
    line.text("cost ").text(name);
    for count in [least, most] {
        line.text(" ").integer(count);
    }
    line.text(" ").integer(deepest);
    line.print();
    least == most
}

/// The bits of a number; one pattern for every NaN, because the patterns of processors differ.
fn bits(number: f32) -> u32 {
    if number.is_nan() {
        0x7fc0_0000
    } else {
        number.to_bits()
    }
}
