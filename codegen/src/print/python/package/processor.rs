//! Vector operations of processors.
//!
//! A type of size zero is the token that shows that the processor has the instructions.

use crate::pack::Pack;
use crate::real::Real;

/// Operations of a processor on `L` numbers, each rounded as for a single number.
pub trait Vectors<const L: usize>: Copy {
    /// The sums.
    fn add(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The differences.
    fn sub(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The products.
    fn mul(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The quotients.
    fn div(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The numbers with opposite signs.
    fn neg(self, a: [Real; L]) -> [Real; L];

    /// The square roots.
    fn sqrt(self, a: [Real; L]) -> [Real; L];

    /// Replaces angles by their sines and cosines.
    fn sin_cos_all(self, sines: &mut [Pack<Self, L>], cosines: &mut [Pack<Self, L>]);

    /// Transposes four rows of four numbers.
    fn turned(self, rows: [[Real; 4]; 4]) -> [[Real; 4]; 4];
}

/// Processors that may have more instructions than the compilation target.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    use pulp::bytemuck::cast;
    use pulp::x86::{V3, V4};
    use pulp::{NullaryFnOnce, Simd};

    use super::Vectors;
    use crate::pack::{Pack, sines_and_cosines};
    use crate::real::{NARROW, Real, WIDE};
    use crate::turned::turned;

    /// Angles whose sines are compiled as a separate function: within a long one, compilers do not always vectorise
    /// them.
    struct Angles<'a, P, const L: usize>(&'a mut [Pack<P, L>], &'a mut [Pack<P, L>]);

    impl<P, const L: usize> NullaryFnOnce for Angles<'_, P, L> {
        type Output = ();

        #[inline(always)]
        fn call(self) {
            sines_and_cosines(self.0, self.1);
        }
    }

    macro_rules! vectors {
        ($($processor:ident $count:ident;)*) => {$(
            impl Vectors<$count> for $processor {
                #[inline(always)]
                fn add(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    cast(self.add_f64s(cast(a), cast(b)))
                }

                #[inline(always)]
                fn sub(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    cast(self.sub_f64s(cast(a), cast(b)))
                }

                #[inline(always)]
                fn mul(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    cast(self.mul_f64s(cast(a), cast(b)))
                }

                #[inline(always)]
                fn div(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    cast(self.div_f64s(cast(a), cast(b)))
                }

                #[inline(always)]
                fn neg(self, a: [Real; $count]) -> [Real; $count] {
                    cast(self.neg_f64s(cast(a)))
                }

                #[inline(always)]
                fn sqrt(self, a: [Real; $count]) -> [Real; $count] {
                    cast(self.sqrt_f64s(cast(a)))
                }

                #[inline(always)]
                fn sin_cos_all(
                    self,
                    sines: &mut [Pack<Self, $count>],
                    cosines: &mut [Pack<Self, $count>],
                ) {
                    self.vectorize(Angles(sines, cosines));
                }

                #[inline(always)]
                fn turned(self, rows: [[Real; 4]; 4]) -> [[Real; 4]; 4] {
                    turned(&self, rows)
                }
            }
        )*};
    }
    vectors! {
        V3 NARROW;
        V4 WIDE;
    }
}

/// Processors whose vector instructions are always available.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
mod of_target {
    use std::array::from_fn;

    use super::Vectors;
    use crate::pack::{Pack, sines_and_cosines};
    use crate::real::Real;

    /// The lanes are written out: compilers cannot unroll a loop for every operation of a long function.
    macro_rules! vectors {
        ($($count:literal [$($lane:literal)*];)*) => {$(
            impl Vectors<$count> for () {
                #[inline(always)]
                fn add(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    [$(a[$lane] + b[$lane]),*]
                }

                #[inline(always)]
                fn sub(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    [$(a[$lane] - b[$lane]),*]
                }

                #[inline(always)]
                fn mul(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    [$(a[$lane] * b[$lane]),*]
                }

                #[inline(always)]
                fn div(self, a: [Real; $count], b: [Real; $count]) -> [Real; $count] {
                    [$(a[$lane] / b[$lane]),*]
                }

                #[inline(always)]
                fn neg(self, a: [Real; $count]) -> [Real; $count] {
                    [$(-a[$lane]),*]
                }

                #[inline(always)]
                fn sqrt(self, a: [Real; $count]) -> [Real; $count] {
                    [$(a[$lane].sqrt()),*]
                }

                #[inline(always)]
                fn sin_cos_all(
                    self,
                    sines: &mut [Pack<Self, $count>],
                    cosines: &mut [Pack<Self, $count>],
                ) {
                    sines_and_cosines(sines, cosines);
                }

                #[inline(always)]
                fn turned(self, rows: [[Real; 4]; 4]) -> [[Real; 4]; 4] {
                    from_fn(|i| rows.map(|row| row[i]))
                }
            }
        )*};
    }
    vectors! {
        4 [0 1 2 3];
        8 [0 1 2 3 4 5 6 7];
    }
}
