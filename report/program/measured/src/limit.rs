//! The limit of the processor: independent fused products and sums.
//!
//! In: the number of states. Out: a [`Program`] with [`OPERATIONS`] operations for each state, in the widest registers;
//! `None` if the processor has no fused operation.

use std::hint::black_box;

use pulp::{Arch, Simd, WithSimd};

use crate::program::{Program, Run};

/// Number of fused products and sums for each state.
const OPERATIONS: usize = 1024;

/// Number of independent sums: more than the ten operations that two units with a latency of five cycles have in
/// flight, and few enough for sixteen registers with the factors.
const SUMS: usize = 12;

macro_rules! limit {
    ($name:ident, $Work:ident, $number:ident, $lanes:ident, $splat:ident, $mul_add:ident, $reduce:ident) => {
        /// A number of operations.
        struct $Work(usize);

        impl WithSimd for $Work {
            /// The sum; `None` without SIMD instructions.
            type Output = Option<$number>;

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) -> Option<$number> {
                if S::$lanes == 1 {
                    return None;
                }
                let [factor, term] = black_box([0.999, 0.001]).map(|x| simd.$splat(x));
                let mut sums = [term; SUMS];
                for _ in 0..self.0.div_ceil(2 * SUMS * S::$lanes) {
                    for sum in &mut sums {
                        *sum = simd.$mul_add(*sum, factor, term);
                    }
                }
                Some(sums.into_iter().map(|sum| simd.$reduce(sum)).sum())
            }
        }

        /// The limit in this type of number, for `states` states a thread.
        pub fn $name(states: usize) -> Option<Program<$number>> {
            let processor = Arch::new();
            processor.dispatch($Work(OPERATIONS))?;
            let run: Run<$number> = Box::new(move |_, _| {
                rayon::broadcast(|_| black_box(processor.dispatch($Work(states * OPERATIONS))));
            });
            Some(Program {
                name: "limit".to_owned(),
                run,
            })
        }
    };
}

limit!(
    in_f64,
    InF64,
    f64,
    F64_LANES,
    splat_f64s,
    mul_add_f64s,
    reduce_sum_f64s
);
limit!(
    in_f32,
    InF32,
    f32,
    F32_LANES,
    splat_f32s,
    mul_add_f32s,
    reduce_sum_f32s
);
