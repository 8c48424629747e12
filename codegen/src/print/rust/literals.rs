//! Literals of Rust.
//!
//! In: an `f64` that is finite in the scalar type. Out: the shortest decimal that the type reads as the same number.

use std::str::FromStr;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// Form of a literal.
#[derive(Clone, Debug)]
pub(super) enum Numerals {
    /// `0.333`, if its type is known from the context.
    Bare,
    /// `0.333_f32`.
    Single,
    /// `0.333_f64`.
    Double,
    /// `k(0.333)`, by a function that converts to the generic type.
    Through(Ident),
}

impl Numerals {
    /// Literal as an expression that binds tighter than any operator.
    ///
    /// # Panics
    /// If the number is not finite.
    pub fn write(&self, value: f64) -> TokenStream {
        match self {
            Self::Bare => signed(value, &format!("{:?}", value.abs())),
            Self::Single => signed(value, &single(value.abs())),
            Self::Double => signed(value, &format!("{:?}_f64", value.abs())),
            Self::Through(function) => {
                let value = Self::Bare.write(value);
                quote! { #function(#value) }
            }
        }
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the type is the purpose"
)]
fn single(size: f64) -> String {
    format!("{:?}_f32", size as f32)
}

fn signed(value: f64, size: &str) -> TokenStream {
    let number = Literal::from_str(size).expect("what is not finite is refused before");
    if value.is_sign_negative() {
        quote! { -#number }
    } else {
        quote! { #number }
    }
}

#[cfg(test)]
mod tests {
    use super::Numerals;
    use proc_macro2::{Ident, Span};

    #[test]
    fn numbers_read_back() {
        for value in [
            0.0,
            0.1,
            1.0 / 3.0,
            5e-324,
            1e16,
            1.797_693_134_862_315_7e308,
        ] {
            let text = Numerals::Bare.write(value).to_string();
            assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(value.to_bits()));
        }
    }

    #[test]
    fn every_type_has_its_own_shortest_form() {
        let through = Numerals::Through(Ident::new("k", Span::call_site()));
        let write = |numerals: &Numerals, value| numerals.write(value).to_string().replace(' ', "");
        assert_eq!(
            write(&Numerals::Double, 0.1_f32.into()),
            "0.10000000149011612_f64"
        );
        assert_eq!(write(&Numerals::Single, 0.1_f32.into()), "0.1_f32");
        assert_eq!(write(&Numerals::Single, 1e-5), "1e-5_f32");
        assert_eq!(write(&Numerals::Double, -0.0), "-0.0_f64");
        assert_eq!(write(&through, -9.81), "k(-9.81)");
    }
}
