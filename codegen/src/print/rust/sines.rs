//! The sines and cosines that a file for `core` alone brings along.
//!
//! In: the type of number. Out: a function that becomes a private one of the struct, as text that
//! is a file of its own here. They are the straight
//! halves of `homogen::trigonometry`, which explains them line by line; the tests of the workspace
//! hold the two together bit for bit.

use std::str::FromStr;

use proc_macro2::TokenStream;

use crate::real::Real;

/// The name of the function.
pub(super) const NAME: &str = "sin_cos";

/// The function.
pub(super) fn function(real: Real) -> TokenStream {
    // The text is Rust: it is compiled below.
    TokenStream::from_str(text(real)).unwrap_or_default()
}

/// What is said of the function, and the function from the word `fn` on: between them stands that it is not inlined.
///
/// # Panics
/// Never: the texts are our own.
#[cfg(feature = "pretty")]
pub(in crate::print) fn parts(real: Real) -> [&'static str; 2] {
    let between = "#[inline(never)]\n";
    let parts = text(real).split_once(between);
    parts.expect("it is not inlined").into()
}

/// The function as it was written.
const fn text(real: Real) -> &'static str {
    match real {
        Real::F32 => include_str!("sines/single.rs"),
        Real::F64 | Real::Generic => include_str!("sines/double.rs"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Real, function};

    mod double {
        include!("sines/double.rs");

        #[test]
        fn they_are_those_of_the_platform() {
            let angles = (-4000..4000).map(|i| f64::from(i) * 0.37);
            let errors = angles.map(|angle| {
                let (sine, cosine) = sin_cos(angle);
                (sine - angle.sin()).abs().max((cosine - angle.cos()).abs())
            });
            assert!(errors.fold(0.0, f64::max) <= f64::EPSILON);
        }
    }

    mod single {
        include!("sines/single.rs");

        #[test]
        fn they_are_those_of_double_precision() {
            let angles = (-4000_i16..4000).map(|i| f32::from(i) * 0.75);
            let errors = angles.map(|angle| {
                let (sine, cosine) = sin_cos(angle);
                let (s, c) = f64::from(angle).sin_cos();
                (f64::from(sine) - s)
                    .abs()
                    .max((f64::from(cosine) - c).abs())
            });
            assert!(errors.fold(0.0, f64::max) <= f64::from(f32::EPSILON) / 2.0);
        }
    }

    #[test]
    fn each_is_one_function() {
        for (real, start) in [
            (Real::F32, "fn sin_cos (angle : f32)"),
            (Real::F64, "fn sin_cos (angle : f64)"),
        ] {
            assert_eq!(function(real).to_string().matches(start).count(), 1);
        }
    }
}
