//! Square root of a file for `core` alone, which has none.
//!
//! In: the scalar type. Out: a private function of the struct, as text in a file of its own. A quotient iteration gives
//! an estimate within one ulp; the remainder, exact in integers, decides the rounding, so that results have the same
//! bits as the processor's instruction.

use proc_macro2::{Ident, TokenStream};

use super::sines::beside;
use crate::real::Real;

/// Name of the function.
pub(super) const SQRT: &str = "sqrt";

/// The function, without a binding that has the struct's name.
pub(super) fn function(real: Real, robot: &Ident) -> TokenStream {
    let text = match real {
        Real::F32 => include_str!("roots/single.rs"),
        Real::F64 | Real::Generic => include_str!("roots/double.rs"),
    };
    beside(text, robot)
}

#[cfg(test)]
mod tests {
    use homogen_random::Random;

    mod double {
        include!("roots/double.rs");

        pub fn bits(x: f64) -> [u64; 2] {
            [sqrt(x), x.sqrt()].map(f64::to_bits)
        }
    }

    mod single {
        include!("roots/single.rs");

        pub fn bits(x: f32) -> [u32; 2] {
            [sqrt(x), x.sqrt()].map(f32::to_bits)
        }
    }

    #[test]
    fn roots_have_the_bits_of_the_processor() {
        // Zeros, subnormal numbers, powers of two with their neighbours, infinity.
        let sparse = (0..2047_u64).flat_map(|exponent| {
            let power = exponent << 52;
            [power, power + 1, power | ((1 << 52) - 1)]
        });
        let mut random = Random::new(3);
        let dense = std::iter::repeat_with(|| random.bits() >> 1).take(200_000);
        for bits in sparse.chain([0x7ff << 52, 1 << 63]).chain(dense) {
            let x = f64::from_bits(bits);
            let [found, expected] = double::bits(x);
            assert!(x.is_nan() || found == expected, "{x:e}");
        }
        for bits in (0..=255_u32 << 23).step_by(997) {
            let x = f32::from_bits(bits);
            let [found, expected] = single::bits(x);
            assert_eq!(found, expected, "{x:e}");
        }
        assert!(f64::from_bits(double::bits(-1.0)[0]).is_nan());
        assert!(f32::from_bits(single::bits(f32::NAN)[0]).is_nan());
    }
}
