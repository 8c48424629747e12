//! Every function of a robot for column-major states.
//!
//! In: a robot, and a slice for each entry of each argument. Out: a slice for each number of the result, bit for bit as
//! from single calls. Numbers are not transposed in memory.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use core::array::from_fn;
use std::vec::Vec;

use super::error::ColumnsError;
use super::packed::{Number, Packed, Packs};
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::processor;
use super::run::{self, Vectors};
use crate::robot;

/// A robot whose functions take column-major states: for each entry of an argument a slice with one number a state, as
/// in tables, and in arrays of shape (states, entries) in Fortran order.
///
/// [`Batch::columns`](super::Batch::columns) makes it. Results are written to a slice for each of their numbers:
///
/// | result | order of the numbers |
/// |---|---|
/// | matrix, list | row by row |
/// | pose | R by rows, t |
/// | screw | u, b |
/// | velocity | ω, v |
/// | acceleration | G by rows, a |
/// | momentum | γ, ρ |
/// | wrench | c, f |
/// | struct | field by field |
///
/// ```
/// use homogen::batch::Batch;
/// # use homogen::{Scalar, robot::Gravity};
/// # struct Arm;
/// # impl homogen::robot::Batched for Arm {}
/// # impl<T: Scalar> Gravity<2, T> for Arm {
/// #     fn gravity(&self, q: &[T; 2]) -> [T; 2] {
/// #         let (sines, _) = T::sin_cos_all(*q);
/// #         sines
/// #     }
/// # }
/// # let arm = Arm;
/// // An array of shape (1000, 2) in Fortran order: q_1 of all states, then q_2.
/// let q: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
/// let mut tau = vec![0.0; 2000];
///
/// let (q_1, q_2) = q.split_at(1000);
/// let (tau_1, tau_2) = tau.split_at_mut(1000);
/// Batch::of(&arm).columns().gravity([q_1, q_2], &mut [tau_1, tau_2])?;
/// assert_eq!([tau[7], tau[1007]], arm.gravity(&[q[7], q[1007]]));
/// # Ok::<(), homogen::batch::ColumnsError>(())
/// ```
#[derive(Debug)]
pub struct Columns<'a, R: ?Sized> {
    robot: &'a R,
    most: Vectors,
}

impl<'a, R: ?Sized> Columns<'a, R> {
    pub(super) const fn of(robot: &'a R, most: Vectors) -> Self {
        Self { robot, most }
    }
}

/// The columns of an argument: one for each coordinate for `q`, six for `wrench`, one for each velocity for all others.
macro_rules! columns_of {
    (q, $column:ty) => {
        [$column; Q]
    };
    (wrench, $column:ty) => {
        [$column; 6]
    };
    ($other:ident, $column:ty) => {
        [$column; N]
    };
}

/// The number of numbers in the result of a function, by its type; the function is not called.
fn numbers<P: Packed>(_: impl FnOnce() -> P) -> usize {
    P::NUMBERS
}

/// Packs of `count` numbers of each column, from `first` on.
#[inline(always)]
fn gather<T: Default, P: Packs<T>, const N: usize>(
    processor: P::Processor,
    columns: &[&[T]; N],
    first: usize,
    count: usize,
) -> [P; N] {
    let mut packs = [P::filled(processor, T::default()); N];
    for (pack, column) in packs.iter_mut().zip(columns) {
        *pack = P::gather(processor, &column[first..first + count]);
    }
    packs
}

/// The number of states; an error if a column is not as long as the first one of `q`.
fn check(arguments: &[(&'static str, &[usize])]) -> Result<usize, ColumnsError> {
    let columns = arguments.iter();
    let mut columns = columns.flat_map(|(argument, lengths)| {
        let lengths = lengths.iter().enumerate();
        lengths.map(move |(column, &length)| (*argument, column, length))
    });
    let (_, _, expected) = columns.next().unwrap_or_default();
    let wrong = columns.find(|(_, _, length)| *length != expected);
    wrong.map_or(Ok(expected), |(argument, column, length)| {
        Err(ColumnsError::Length {
            argument,
            column,
            length,
            expected,
        })
    })
}

macro_rules! batches {
    ($(
        #[doc = $noun:literal]
        $(#[doc = $sentence:literal])+
        $kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty;
    )*) => {$(
        batch!($kind #[doc = $noun] $name $method [$($argument)*]);
    )*};
}

macro_rules! batch {
    (chosen $($row:tt)*) => { batch!(sized $($row)*); };
    (sized #[$noun:meta] $name:ident $method:ident [$($argument:ident)*]) => {
        batch!(@ #[$noun] $name $method [N P Q] [N P] [$($argument)*]);
    };
    ($kind:ident #[$noun:meta] $name:ident $method:ident [$($argument:ident)*]) => {
        batch!(@ #[$noun] $name $method [N Q] [N] [$($argument)*]);
    };
    (@ #[$noun:meta] $name:ident $method:ident [$($size:ident)*] [$($length:ident)*] [$($argument:ident)*]) => {
        impl<R: robot::Batched + Sync + ?Sized> Columns<'_, R> {
            #[$noun]
            ///
            #[doc = concat!("[`", stringify!($name), "`](robot::", stringify!($name), ") of each state.")]
            ///
            /// # Errors
            ///
            /// A column is not as long as the first of `q`, or the number of columns of `results` is not the number of
            /// numbers in a result. No result is written then.
            #[allow(
                clippy::too_many_arguments,
                reason = "a function with changes has three more than the one that it differentiates"
            )]
            pub fn $method<T: Number, $(const $size: usize),*>(
                &self,
                $($argument: columns_of!($argument, &[T]),)*
                results: &mut [&mut [T]],
            ) -> Result<(), ColumnsError>
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
                    count: usize,
                    $($argument: columns_of!($argument, &'a [T]),)*
                    results: Vec<&'a mut [T]>,
                }

                impl<R: ?Sized, T: Number, $(const $size: usize),*> States<'_, R, T, $($size),*> {
                    fn numbers<K: Packs<T>>(robot: &R) -> usize
                    where
                        R: robot::$name<$($length,)* K, Q>,
                    {
                        numbers(|| {
                            $(let $argument: columns_of!($argument, K) = from_fn(|_| K::constant(0.0));)*
                            robot.$method($(&$argument),*)
                        })
                    }

                    #[inline(always)]
                    fn by<K: Packs<T>>(self, processor: K::Processor)
                    where
                        R: robot::$name<$($length,)* K, Q>,
                    {
                        let mut results = self.results;
                        let mut first = 0;
                        while first < self.count {
                            let lanes = K::LANES.min(self.count - first);
                            $(let $argument = gather::<T, K, _>(processor, &self.$argument, first, lanes);)*
                            let packed = self.robot.$method($(&$argument),*);
                            packed.write(&mut results, first..first + lanes);
                            first += lanes;
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
                        self.count
                    }

                    #[cfg(feature = "rayon")]
                    fn split(self, at: usize) -> (Self, Self) {
                        let Self { robot, count, .. } = self;
                        let results = self.results.into_iter().map(|column| column.split_at_mut(at));
                        let results: (Vec<_>, Vec<_>) = results.unzip();
                        $(let $argument = (self.$argument.map(|column| &column[..at]), self.$argument.map(|column| &column[at..]));)*
                        (
                            Self { robot, count: at, $($argument: $argument.0,)* results: results.0 },
                            Self { robot, count: count - at, $($argument: $argument.1,)* results: results.1 },
                        )
                    }

                    run::by_packs!($method);
                }

                let count = check(&[
                    $((stringify!($argument), &$argument.map(<[T]>::len)),)*
                    ("results", &results.iter().map(|column| column.len()).collect::<Vec<_>>()),
                ])?;
                let expected = States::<R, T, $($size),*>::numbers::<T::Narrow>(self.robot);
                if results.len() != expected {
                    return Err(ColumnsError::Count { columns: results.len(), expected });
                }
                let work = States::<R, T, $($size),*> {
                    robot: self.robot,
                    count,
                    $($argument,)*
                    results: results.iter_mut().map(|column| &mut **column).collect(),
                };
                run::run(work, self.most);
                Ok(())
            }
        }
    };
}
crate::every_function!(batches);
crate::every_function_of_spheres!(batches);
