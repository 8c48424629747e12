//! The sines and cosines that a source brings along.
//!
//! In: the type of number, and how names begin. Out: a function of the file alone, as text that has its
//! own file here, with words between `@` in place of the names that it shares with the source. They are
//! those of `homogen::trigonometry` up to an angle, which explains them line by line; the tests of the
//! workspace hold the two together bit for bit.

use super::Writing;
use crate::real::Real;
use crate::template::filled;

/// The function and what it returns.
pub(super) fn function(real: Real, writing: &Writing<'_>) -> String {
    let text = match real {
        Real::F32 => include_str!("sines/single.c"),
        Real::F64 | Real::Generic => include_str!("sines/double.c"),
    };
    let names = [
        ("@MUL_ADD@", &*writing.mul_add()),
        ("@turn@", &writing.own("turn")),
        ("@sin_cos@", &writing.own("sin_cos")),
    ];
    filled(text, &names)
}
