//! The most that a processor can compute: fused products and sums of which none waits for another.
//!
//! In: how many states. Out: a [`Program`] that does [`OPERATIONS`] of them in the place of each state, on the widest
//! vectors; none where the processor fuses nothing.

use std::hint::black_box;

use pulp::{Arch, Simd, WithSimd};

use crate::program::{Program, Run};

/// Products and sums in the place of a state.
const OPERATIONS: usize = 1024;

/// Sums that are under way at a time: more than two units of a latency of five cycles begin, and no more than
/// sixteen registers hold beside the factors.
const SUMS: usize = 12;

macro_rules! limit {
    ($name:ident, $Work:ident, $number:ident, $lanes:ident, $splat:ident, $mul_add:ident, $reduce:ident) => {
        /// So many operations.
        struct $Work(usize);

        impl WithSimd for $Work {
            /// What is summed; nothing where the processor has no vectors.
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

        /// The limit in this type of number, for so many states a thread.
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
