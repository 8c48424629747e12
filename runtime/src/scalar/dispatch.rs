//! Choice of the processor's instructions when the program runs.
//!
//! In: [`Work`], which is generic over the rounding of its products. Out: its result, computed with AVX2 and FMA if the
//! processor has them, with products fused with sums then.
//!
//! AVX-512 is left to batches: while an instruction of 512 bits is under way, an Intel Xeon has one unit instead of two
//! for the scalar products around it, and inverse dynamics of an arm takes 134 instead of 76 ns.
//!
//! Only x86 with the feature `std` chooses; where the target itself has fused products, nothing is left to choose.

use super::rounding::{Rounding, Unfused};

/// Equations on numbers `T` to be compiled for several kinds of processor: a function of a robot with its arguments.
///
/// Internal: generated code implements it for each function.
pub trait Work<T>: Sized {
    /// The result.
    type Output;

    /// True if no product is fused with a sum, so that results have the same bits on every processor.
    const REPRODUCIBLE: bool = false;

    /// A number that it reads, if it is to be compiled in a function of its own where numbers are registers: they carry
    /// the proof that the processor has their instructions.
    fn number(&self) -> Option<T> {
        None
    }

    /// Computes the result. It must be inlined, since only what is inlined is compiled for the processor that was
    /// found.
    fn run<R: Rounding>(self) -> Self::Output;

    /// Computes the result with this rounding, or with none fused if it is reproducible.
    #[expect(
        clippy::inline_always,
        reason = "only what is inlined is compiled for the processor that was found"
    )]
    #[inline(always)]
    fn rounded<R: Rounding>(self) -> Self::Output {
        if Self::REPRODUCIBLE {
            self.run::<Unfused>()
        } else {
            self.run::<R>()
        }
    }
}

#[cfg(all(
    any(feature = "std", feature = "libm"),
    not(all(
        feature = "std",
        any(target_arch = "x86", target_arch = "x86_64"),
        not(target_feature = "fma")
    ))
))]
pub(super) use here::at_hand;
#[cfg(all(
    feature = "std",
    any(target_arch = "x86", target_arch = "x86_64"),
    not(target_feature = "fma")
))]
pub(super) use x86::at_hand;

/// Targets without a choice. Without `std` and `libm` there are no numbers to compute with, and neither module is needed.
#[cfg(all(
    any(feature = "std", feature = "libm"),
    not(all(
        feature = "std",
        any(target_arch = "x86", target_arch = "x86_64"),
        not(target_feature = "fma")
    ))
))]
mod here {
    use super::Work;
    use crate::scalar::rounding::OfTarget;

    /// Does the work by the instructions of the target.
    #[expect(
        clippy::inline_always,
        reason = "nothing may come between a function and its equations"
    )]
    #[inline(always)]
    pub(in crate::scalar) fn at_hand<T, W: Work<T>>(work: W) -> W::Output {
        work.rounded::<OfTarget>()
    }
}

/// Work as pulp compiles it for a processor.
#[cfg(all(
    feature = "std",
    any(target_arch = "x86", target_arch = "x86_64"),
    any(feature = "batch", not(target_feature = "fma"))
))]
pub(crate) mod rounded {
    use core::marker::PhantomData;
    use pulp::NullaryFnOnce;

    use super::Work;
    use crate::scalar::rounding::Rounding;

    /// Work with the rounding `R`.
    pub(crate) struct Rounded<R, T, W>(W, PhantomData<(R, T)>);

    impl<R, T, W> Rounded<R, T, W> {
        #[expect(
            clippy::inline_always,
            reason = "only what is inlined is compiled for the processor that was found"
        )]
        #[inline(always)]
        pub(crate) fn of(work: W) -> Self {
            Self(work, PhantomData)
        }
    }

    impl<R: Rounding, T, W: Work<T>> NullaryFnOnce for Rounded<R, T, W> {
        type Output = W::Output;

        #[expect(
            clippy::inline_always,
            reason = "only what is inlined is compiled for the processor that was found"
        )]
        #[inline(always)]
        fn call(self) -> W::Output {
            self.0.rounded::<R>()
        }
    }
}

/// Processors with more instructions than their target.
#[cfg(all(
    feature = "std",
    any(target_arch = "x86", target_arch = "x86_64"),
    not(target_feature = "fma")
))]
mod x86 {
    use pulp::x86::V3;

    use super::Work;
    use super::rounded::Rounded;
    use crate::scalar::rounding::{Fused, OfTarget};

    /// Does the work by the instructions of this processor.
    #[inline]
    pub(in crate::scalar) fn at_hand<T, W: Work<T>>(work: W) -> W::Output {
        if let Some(processor) = V3::try_new() {
            processor.vectorize(Rounded::<Fused, T, W>::of(work))
        } else {
            of_target(work)
        }
    }

    /// Does the work by the instructions of the target, in a function of its own, so that the others do not save the
    /// registers that it needs.
    #[inline(never)]
    fn of_target<T, W: Work<T>>(work: W) -> W::Output {
        work.rounded::<OfTarget>()
    }

    #[cfg(test)]
    mod tests {
        use super::{Fused, Rounded, V3, Work, at_hand, of_target};
        use crate::scalar::rounding::Rounding;

        /// (1 + ε)(1 − ε) − 1, which is 0 if the product is rounded, and −ε² otherwise.
        struct Product<const REPRODUCIBLE: bool>;

        impl<const REPRODUCIBLE: bool> Work<f64> for Product<REPRODUCIBLE> {
            type Output = f64;
            const REPRODUCIBLE: bool = REPRODUCIBLE;

            #[expect(clippy::inline_always, reason = "as in generated code")]
            #[inline(always)]
            fn run<R: Rounding>(self) -> f64 {
                R::mul_add(1.0 + f64::EPSILON, 1.0 - f64::EPSILON, -1.0)
            }
        }

        const FUSED: f64 = -f64::EPSILON * f64::EPSILON;

        #[test]
        fn processors_with_the_instruction_fuse() {
            let fuses = V3::try_new().is_some();
            if let Some(processor) = V3::try_new() {
                let found = processor.vectorize(Rounded::<Fused, f64, _>::of(Product::<false>));
                assert_eq!(found, FUSED);
            }
            assert_eq!(of_target(Product::<false>), 0.0);
            let expected = if fuses { FUSED } else { 0.0 };
            assert_eq!(at_hand(Product::<false>), expected);
        }

        #[test]
        fn reproducible_work_is_unfused_on_every_processor() {
            if let Some(processor) = V3::try_new() {
                assert_eq!(
                    processor.vectorize(Rounded::<Fused, f64, _>::of(Product::<true>)),
                    0.0
                );
            }
            assert_eq!(of_target(Product::<true>), 0.0);
            assert_eq!(at_hand(Product::<true>), 0.0);
        }
    }
}
