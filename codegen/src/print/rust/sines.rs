//! Sine and cosine of a file for `core` alone.
//!
//! In: the scalar type. Out: a private function of the struct, as text in a file of its own. It is the branch-free part
//! of `homogen::trigonometry`, which explains it line by line; tests compare both bit for bit.

use std::str::FromStr;

use proc_macro2::{Group, Ident, TokenStream, TokenTree};

use super::names::ident;
use crate::real::Real;
use crate::schedule::Names;

/// The function, without a binding that has the struct's name.
pub(super) fn function(real: Real, robot: &Ident) -> TokenStream {
    beside(text(real), robot)
}

/// A function from its text, without a binding that has the struct's name.
pub(super) fn beside(text: &str, robot: &Ident) -> TokenStream {
    // The text is Rust: it is compiled in tests.
    let function = TokenStream::from_str(text).unwrap_or_default();
    let mut names = Names::default();
    take(&function, &mut names);
    let other = names.alone(&robot.to_string());
    if *robot == other {
        return function;
    }
    renamed(function, robot, &ident(&other))
}

/// Reserves all words of tokens.
fn take(tokens: &TokenStream, names: &mut Names) {
    for token in tokens.clone() {
        match token {
            TokenTree::Ident(word) => names.take(&word.to_string()),
            TokenTree::Group(group) => take(&group.stream(), names),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// The same tokens with a bound name replaced; attributes, functions and members keep theirs.
fn renamed(tokens: TokenStream, from: &Ident, to: &Ident) -> TokenStream {
    let mut before = String::new();
    let tokens = tokens.into_iter().map(|token| {
        let keeps = [".", ":", "fn", "#"].contains(&&*before);
        before = token.to_string();
        match token {
            // The type after a colon does not have the struct's name.
            TokenTree::Ident(word) if word == *from && !keeps => to.clone().into(),
            TokenTree::Group(group) if !keeps => {
                let inside = renamed(group.stream(), from, to);
                let mut renamed = Group::new(group.delimiter(), inside);
                renamed.set_span(group.span());
                renamed.into()
            }
            other => other,
        }
    });
    tokens.collect()
}

/// Documentation of the function, and the function from the word `fn` on; the attribute against inlining between them
/// is left out.
///
/// # Panics
/// Never: the texts are our own.
#[cfg(feature = "files")]
pub(in crate::print) fn parts(real: Real) -> [&'static str; 2] {
    let between = "#[inline(never)]\n";
    let parts = text(real).split_once(between);
    parts.expect("it is not inlined").into()
}

/// Text of the function.
const fn text(real: Real) -> &'static str {
    match real {
        Real::F32 => include_str!("sines/single.rs"),
        Real::F64 | Real::Generic => include_str!("sines/double.rs"),
    }
}

#[cfg(test)]
mod tests {
    use quote::format_ident;

    use super::{Real, function};
    use crate::print::sines::tests::{computed, turned};

    mod double {
        use super::{Real, computed, turned};

        include!("sines/double.rs");

        #[test]
        fn sines_agree_with_the_platform() {
            let angles = (-4000..4000).map(|i| f64::from(i) * 0.37);
            let errors = angles.map(|angle| {
                let (sine, cosine) = sin_cos(angle);
                (sine - angle.sin()).abs().max((cosine - angle.cos()).abs())
            });
            assert!(errors.fold(0.0, f64::max) <= f64::EPSILON);
        }

        /// The statements for other languages give the same bits.
        #[test]
        fn sines_agree_with_the_statements() {
            for angle in (-4000..4000).map(|i| f64::from(i) * 0.37) {
                let [sine, cosine, shifted] = computed(Real::F64, angle, |value| value);
                let (sine, cosine) = turned(sine, cosine, shifted.to_bits());
                let found = sin_cos(angle);
                let same = [(found.0, sine), (found.1, cosine)];
                let same = same.map(|(found, expected)| found.to_bits() == expected.to_bits());
                assert_eq!(same, [true; 2], "{angle}: {found:?}, {sine}, {cosine}");
            }
        }
    }

    mod single {
        use super::{Real, computed, turned};

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

        /// The same in single precision: a sum or a product of two of its numbers is rounded correctly by way of `f64`.
        #[test]
        #[expect(
            clippy::cast_possible_truncation,
            reason = "rounding to the type is the purpose"
        )]
        fn sines_agree_with_the_statements() {
            for angle in (-4000_i16..4000).map(|i| f32::from(i) * 0.75) {
                let round = |value: f64| f64::from(value as f32);
                let [sine, cosine, shifted] = computed(Real::F32, angle.into(), round);
                let quadrant = (shifted as f32).to_bits();
                let (sine, cosine) = turned(sine, cosine, quadrant.into());
                let found = sin_cos(angle);
                let same = [(found.0, sine as f32), (found.1, cosine as f32)];
                let same = same.map(|(found, expected)| found.to_bits() == expected.to_bits());
                assert_eq!(same, [true; 2], "{angle}: {found:?}, {sine}, {cosine}");
            }
        }
    }

    #[test]
    fn the_text_is_one_function() {
        for (real, start) in [
            (Real::F32, "fn sin_cos (angle : f32)"),
            (Real::F64, "fn sin_cos (angle : f64)"),
        ] {
            let function = function(real, &format_ident!("Arm"));
            assert_eq!(function.to_string().matches(start).count(), 1);
        }
    }

    #[test]
    fn no_binding_has_the_name_of_the_struct() {
        for real in [Real::F32, Real::F64] {
            let plain = function(real, &format_ident!("Arm")).to_string();
            for name in ["angle", "near", "r", "z", "quadrant"] {
                let function = function(real, &format_ident!("{name}")).to_string();
                let of = |text: &str, name: &str| {
                    // After its documentation.
                    let (_, code) = text.split_once("fn sin_cos").expect("a function");
                    let words = code.split(|c: char| !c.is_alphanumeric() && c != '_');
                    words.filter(|word| *word == name).count()
                };
                assert_eq!(of(&function, name), 0);
                assert_eq!(of(&function, &format!("{name}_")), of(&plain, name));
            }
            for name in ["inline", "core", "to_bits", "sin_cos"] {
                assert_eq!(function(real, &format_ident!("{name}")).to_string(), plain);
            }
        }
    }
}
