//! A product and a sum in one operation, where the target has it.
//!
//! In: two factors and a term. Out: `factor · other + term` of the primitive types, rounded once
//! where an instruction does so and twice elsewhere; never a call of a library routine.

/// The function of a type, by the name of the type.
macro_rules! implement {
    ($float:ident) => {
        // The inherent method becomes a library call where the instruction is missing, so it
        // is named only where the target is known to have it.
        #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
        #[inline]
        pub(crate) fn $float(factor: $float, other: $float, term: $float) -> $float {
            $float::mul_add(factor, other, term)
        }

        #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
        #[inline]
        pub(crate) fn $float(factor: $float, other: $float, term: $float) -> $float {
            factor * other + term
        }
    };
}

implement!(f32);
implement!(f64);
