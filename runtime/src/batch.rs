//! Every function of a robot for many states at once (feature `batch`).
//!
//! In: a robot and slices of states, one array a state. Out: a slice of results, each with the bits of the
//! function of that state alone. [`Batch`] fills the lanes of the widest registers that the processor has when the
//! program runs, AVX-512, AVX2 or SSE4.2, with states; where the target is not of x86, and where a function is not
//! inlined whole, those of [`Pack`](crate::Pack)s, of which the compiler makes vectors. With the feature `rayon` it
//! runs on all cores. Neither changes a bit of any result: products are fused with sums where the target that was
//! compiled for says so, and nowhere else.
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
//! Where a coordinate's numbers stand side by side, as in tables and in Fortran's arrays, [`Columns`] takes a slice
//! for each of them.
//!
//! A robot that is derived with the word `batch` has these as methods of its own,
//! `arm.gravity_batch(&q, &mut tau)`, and is compiled once for each kind of vector; without the word its
//! functions stay what the target makes of them.

mod columns;
mod error;
mod packed;
mod processor;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod registers;
mod run;

pub use columns::Columns;
pub use error::{BatchError, ColumnsError};
pub use packed::{AsAlone, AsFused, Number, Packed, Packs, Rounding};
pub use run::Vectors;

use core::marker::PhantomData;

use crate::robot;
use error::check;

/// A robot whose functions take slices of states.
#[derive(Debug)]
pub struct Batch<'a, R: ?Sized, M = AsAlone> {
    robot: &'a R,
    most: Vectors,
    rounding: PhantomData<M>,
}

impl<'a, R: ?Sized> Batch<'a, R> {
    /// The functions of a robot, for many states: every result has the bits of the function of one state.
    #[inline]
    #[must_use]
    pub const fn of(robot: &'a R) -> Self {
        Self {
            robot,
            most: Vectors::Bits512,
            rounding: PhantomData,
        }
    }
}

impl<'a, R: ?Sized> Batch<'a, R, AsFused> {
    /// The functions of a robot, for many states: products are fused with sums where the processor that
    /// runs has the instruction, known to the compiler or not; there every result has the bits of the
    /// function of one state of [`Fused`](crate::Fused) numbers.
    ///
    /// The robot is to be derived with the word `batch`; what is not inlined calls a library routine for
    /// every product.
    #[inline]
    #[must_use]
    pub const fn fused(robot: &'a R) -> Self {
        Self {
            robot,
            most: Vectors::Bits512,
            rounding: PhantomData,
        }
    }
}

impl<'a, R: ?Sized, M> Batch<'a, R, M> {
    /// The same on no longer vectors than these, where longer ones would slow a processor's clock.
    #[inline]
    #[must_use]
    pub const fn at_most(mut self, most: Vectors) -> Self {
        self.most = most;
        self
    }

    /// The same for states whose numbers stand coordinate by coordinate.
    #[inline]
    #[must_use]
    pub const fn columns(self) -> Columns<'a, R, M> {
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
        impl<R: robot::Batched + Sync + ?Sized, M: Rounding> Batch<'_, R, M> {
            #[$noun]
            ///
            #[doc = concat!("As [`", stringify!($name), "`](robot::", stringify!($name), ") says, for each state.")]
            ///
            /// # Errors
            ///
            /// Where not all slices are as long as `q`; then no result is written.
            pub fn $method<T: Number, $(const $size: usize),*>(
                &self,
                $($argument: &[robot::list_of!($argument)],)*
                results: &mut [$result],
            ) -> Result<(), BatchError>
            where
                R: robot::$name<$($length,)* T::Plain, Q>
                    + robot::$name<$($length,)* T::Narrow, Q>
                    + robot::$name<$($length,)* M::Narrow<T>, Q>
                    + robot::$name<$($length,)* M::Wide<T>, Q>
                    + robot::$name<$($length,)* T::InShort, Q>
                    + robot::$name<$($length,)* M::InNarrow<T>, Q>
                    + robot::$name<$($length,)* M::InWide<T>, Q>,
            {
                /// The states of a call, or some of them.
                struct States<'a, R: ?Sized, M, T, $(const $size: usize),*> {
                    robot: &'a R,
                    $($argument: &'a [robot::list_of!($argument)],)*
                    results: &'a mut [$result],
                    rounding: PhantomData<M>,
                }

                impl<R: ?Sized, M, T: Number, $(const $size: usize),*> States<'_, R, M, T, $($size),*> {
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

                impl<R, M: Rounding, T: Number, $(const $size: usize),*> run::Work
                    for States<'_, R, M, T, $($size),*>
                where
                    R: robot::Batched + Sync + ?Sized
                        + robot::$name<$($length,)* T::Plain, Q>
                        + robot::$name<$($length,)* T::Narrow, Q>
                        + robot::$name<$($length,)* M::Narrow<T>, Q>
                        + robot::$name<$($length,)* M::Wide<T>, Q>
                        + robot::$name<$($length,)* T::InShort, Q>
                        + robot::$name<$($length,)* M::InNarrow<T>, Q>
                        + robot::$name<$($length,)* M::InWide<T>, Q>,
                {
                    #[cfg(feature = "rayon")]
                    fn states(&self) -> usize {
                        self.results.len()
                    }

                    #[cfg(feature = "rayon")]
                    fn split(self, at: usize) -> (Self, Self) {
                        $(let $argument = self.$argument.split_at(at);)*
                        let results = self.results.split_at_mut(at);
                        let Self { robot, rounding, .. } = self;
                        (
                            Self { robot, $($argument: $argument.0,)* results: results.0, rounding },
                            Self { robot, $($argument: $argument.1,)* results: results.1, rounding },
                        )
                    }

                    run::by_packs!($method);
                }

                check(&[$((stringify!($argument), $argument.len()),)* ("results", results.len())])?;
                let work = States { robot: self.robot, $($argument,)* results, rounding: self.rounding };
                run::run(work, self.most);
                Ok(())
            }
        }
    };
}
crate::every_function!(batches);
