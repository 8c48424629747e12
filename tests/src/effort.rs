//! Numbers of states, robots and steps, in a short and a long form.
//!
//! In: both numbers, and the variable `HOMOGEN_LONG` of the environment, which `.ci/run --long` sets every night. Out:
//! one of them. What a change breaks is found by few states; the rare worst cases of a limit need many.

use std::env;

/// The second number if `HOMOGEN_LONG` is set, otherwise the first.
#[must_use]
pub fn effort<T>(short: T, long: T) -> T {
    if env::var_os("HOMOGEN_LONG").is_some() {
        long
    } else {
        short
    }
}
