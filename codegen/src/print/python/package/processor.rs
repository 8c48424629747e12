//! What a processor does with several numbers at once.
//!
//! A type without size is the proof that the processor that runs has the instructions.

use crate::pack::Pack;
use crate::real::Real;

/// The operations of a processor on `L` numbers, each of which rounds as the number alone does.
pub trait Vectors<const L: usize>: Copy {
    /// The sums.
    fn add(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The differences.
    fn sub(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The products.
    fn mul(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The quotients.
    fn div(self, a: [Real; L], b: [Real; L]) -> [Real; L];

    /// The numbers with the other sign.
    fn neg(self, a: [Real; L]) -> [Real; L];

    /// The square roots.
    fn sqrt(self, a: [Real; L]) -> [Real; L];

    /// Puts their sines and cosines in the place of angles.
    fn sin_cos_all(self, sines: &mut [Pack<Self, L>], cosines: &mut [Pack<Self, L>]);

    /// Of rows of four numbers the columns.
    fn turned(self, rows: [[Real; 4]; 4]) -> [[Real; 4]; 4];
}

/// Processors that may have more than their target.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    use pulp::bytemuck::cast;
    use pulp::x86::{V3, V4};
    use pulp::{NullaryFnOnce, Simd};

    use super::Vectors;
    use crate::pack::{Pack, sines_and_cosines};
    use crate::real::{NARROW, Real, WIDE};
    use crate::turned::turned;

    /// Angles, for sines that are compiled by themselves: among a thousand other operations compilers do not
    /// always see that their lanes belong together.
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

/// Processors whose vectors every compiler may use.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
mod of_target {
    use std::array::from_fn;

    use super::Vectors;
    use crate::pack::{Pack, sines_and_cosines};
    use crate::real::Real;

    /// Lanes are written out: a loop for every operation of a long function is more than compilers can follow.
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
