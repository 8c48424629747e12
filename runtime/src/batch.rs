//! Every function of a robot for many states at once (feature `batch`).
//!
//! In: a robot and slices of states, one array a state. Out: a slice of results, bit for bit those of single calls.
//!
//! [`Batch`] computes one state per SIMD lane, in the widest registers that are found at run time: AVX-512, AVX2 or
//! SSE4.2. On other architectures than x86, and for functions that are not inlined completely, it uses
//! [`Pack`](crate::Pack)s, which the compiler vectorises for the target. With the feature `rayon` it runs on all cores.
//! None of this changes a bit of a result: products are fused with sums exactly where a single call fuses them.
//!
//! ```
//! use homogen::batch::Batch;
//! # use homogen::{Scalar, robot::Gravity};
//! # struct Pendulum;
//! # impl homogen::robot::Batched for Pendulum {}
//! # impl<T: Scalar> Gravity<1, T> for Pendulum {
//! #     fn gravity(&self, q: &[T; 1]) -> [T; 1] {
//! #         let ([sine], _) = T::sin_cos_all(*q);
//! #         [T::constant(9.81) * sine]
//! #     }
//! # }
//! # let arm = Pendulum;
//! let q: Vec<[f64; 1]> = (0..1000).map(|i| [0.01 * f64::from(i)]).collect();
//! let mut tau = vec![[0.0]; q.len()];
//! Batch::of(&arm).gravity(&q, &mut tau)?;
//! assert_eq!(tau[7], arm.gravity(&q[7]));
//! # Ok::<(), homogen::batch::BatchError>(())
//! ```
//!
//! [`Columns`] takes column-major states, as in tables and Fortran arrays: a slice for each coordinate.
//!
//! A robot with the key `batch` has these methods itself, `arm.gravity_batch(&q, &mut tau)`, and its functions are
//! compiled once for each length of registers. Without the key they compute with packs.

mod columns;
mod error;
mod packed;
mod processor;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod registers;
mod run;

pub use columns::Columns;
pub use error::{BatchError, ColumnsError};
pub use packed::{Number, Packed, Packs};
pub use run::Vectors;

use crate::robot;
use error::check;

/// A robot whose functions take slices of states.
#[derive(Debug)]
pub struct Batch<'a, R: ?Sized> {
    robot: &'a R,
    most: Vectors,
}

impl<'a, R: ?Sized> Batch<'a, R> {
    /// The functions of a robot for many states, bit for bit as the functions of one state.
    #[inline]
    #[must_use]
    pub const fn of(robot: &'a R) -> Self {
        Self {
            robot,
            most: Vectors::Bits512,
        }
    }

    /// The same in registers of at most this length, for processors whose clock slows down with longer ones. Functions
    /// that are not inlined choose by themselves.
    #[inline]
    #[must_use]
    pub const fn at_most(mut self, most: Vectors) -> Self {
        self.most = most;
        self
    }

    /// The same for column-major states.
    #[inline]
    #[must_use]
    pub const fn columns(self) -> Columns<'a, R> {
        Columns::of(self.robot, self.most)
    }
}

macro_rules! batches {
    ($(
        #[doc = $noun:literal]
        $(#[doc = $sentence:literal])+
        $kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty;
    )*) => {$(
        batch!($kind #[doc = $noun] $name $method [$($argument)*] $result);
    )*};
}

macro_rules! batch {
    (chosen $($row:tt)*) => { batch!(sized $($row)*); };
    (sized #[$noun:meta] $name:ident $method:ident [$($argument:ident)*] $result:ty) => {
        batch!(@ #[$noun] $name $method [N P Q] [N P] [$($argument)*] $result);
    };
    ($kind:ident #[$noun:meta] $name:ident $method:ident [$($argument:ident)*] $result:ty) => {
        batch!(@ #[$noun] $name $method [N Q] [N] [$($argument)*] $result);
    };
    (@ #[$noun:meta] $name:ident $method:ident [$($size:ident)*] [$($length:ident)*] [$($argument:ident)*] $result:ty) => {
        impl<R: robot::Batched + Sync + ?Sized> Batch<'_, R> {
            #[$noun]
            ///
            #[doc = concat!("[`", stringify!($name), "`](robot::", stringify!($name), ") of each state.")]
            ///
            /// # Errors
            ///
            /// A slice is not as long as `q`. No result is written then.
            #[allow(
                clippy::too_many_arguments,
                reason = "a function with changes has three more than the one that it differentiates"
            )]
            pub fn $method<T: Number, $(const $size: usize),*>(
                &self,
                $($argument: &[robot::list_of!($argument)],)*
                results: &mut [$result],
            ) -> Result<(), BatchError>
            where
                R: robot::$name<$($length,)* T::Plain, Q>
                    + robot::$name<$($length,)* T::Narrow, Q>
                    + robot::$name<$($length,)* T::Wide, Q>
                    + robot::$name<$($length,)* T::InShort, Q>
                    + robot::$name<$($length,)* T::InNarrow, Q>
                    + robot::$name<$($length,)* T::InWide, Q>,
            {
                /// The states of a call, or a part of them.
                struct States<'a, R: ?Sized, T, $(const $size: usize),*> {
                    robot: &'a R,
                    $($argument: &'a [robot::list_of!($argument)],)*
                    results: &'a mut [$result],
                }

                impl<R: ?Sized, T: Number, $(const $size: usize),*> States<'_, R, T, $($size),*> {
                    #[inline(always)]
                    fn by<K: Packs<T>>(self, processor: K::Processor)
                    where
                        R: robot::$name<$($length,)* K, Q>,
                    {
                        $(let mut $argument = (self.$argument, run::empty::<T, K, _>(processor));)*
                        for results in self.results.chunks_mut(K::LANES * run::FILLED) {
                            $(
                                let (states, rest) = $argument.0.split_at(results.len());
                                run::load(states, &mut $argument.1);
                                $argument.0 = rest;
                            )*
                            for (i, results) in results.chunks_mut(K::LANES).enumerate() {
                                self.robot.$method($(&$argument.1[i]),*).store(results);
                            }
                        }
                    }
                }

                impl<R, T: Number, $(const $size: usize),*> run::Work
                    for States<'_, R, T, $($size),*>
                where
                    R: robot::Batched + Sync + ?Sized
                        + robot::$name<$($length,)* T::Plain, Q>
                        + robot::$name<$($length,)* T::Narrow, Q>
                        + robot::$name<$($length,)* T::Wide, Q>
                        + robot::$name<$($length,)* T::InShort, Q>
                        + robot::$name<$($length,)* T::InNarrow, Q>
                        + robot::$name<$($length,)* T::InWide, Q>,
                {
                    #[cfg(feature = "rayon")]
                    fn states(&self) -> usize {
                        self.results.len()
                    }

                    #[cfg(feature = "rayon")]
                    fn split(self, at: usize) -> (Self, Self) {
                        $(let $argument = self.$argument.split_at(at);)*
                        let results = self.results.split_at_mut(at);
                        let Self { robot, .. } = self;
                        (
                            Self { robot, $($argument: $argument.0,)* results: results.0 },
                            Self { robot, $($argument: $argument.1,)* results: results.1 },
                        )
                    }

                    run::by_packs!($method);
                }

                check(&[$((stringify!($argument), $argument.len()),)* ("results", results.len())])?;
                let work = States { robot: self.robot, $($argument,)* results };
                run::run(work, self.most);
                Ok(())
            }
        }
    };
}
crate::every_function!(batches);
crate::every_function_of_spheres!(batches);
