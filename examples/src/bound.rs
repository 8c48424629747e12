//! The functions of a robot, called by name.
//!
//! In: a robot with all functions, generated or generic. Out: closures of one type for all functions, for
//! tables row by row. Calls inside a batch stay direct, and are timed as a controller would make them.

use std::hint::black_box;

use homogen::Real;
use homogen::robot;
use homogen_codegen::Function;

use crate::entries::Entries;
use crate::states::State;

/// The functions that a chain has as well: it knows neither its base parameters nor which frames were asked for.
pub fn functions() -> impl Iterator<Item = Function> {
    let all = Function::ALL.into_iter();
    all.filter(|function| ![Function::BaseRegressor, Function::FramePoses].contains(function))
}

/// Makes, from the list of every function, the trait of a robot that has them all, and a function that binds
/// one by its name; `P` is the length of the rows of a regressor.
macro_rules! bound_by_name {
    (@[] [$($name:ident<$($size:ident),+> $method:ident($($argument:ident),*);)*]) => {
        /// A robot that has every function.
        pub trait Complete<const N: usize, const P: usize, T>: $(robot::$name<$($size),+> +)* {}

        impl<R, const N: usize, const P: usize, T> Complete<N, P, T> for R
        where
            R: $(robot::$name<$($size),+> +)*
        {
        }

        /// A function of a robot.
        ///
        /// # Panics
        /// If the runtime has no trait for the function.
        pub fn bind<R: Complete<N, P, T>, T: Number, const N: usize, const P: usize>(
            robot: &R,
            function: Function,
        ) -> Bound<'_, T, N> {
            match function {
                $(Function::$name => bound(|s: &State<T, N>| {
                    robot::$name::<$($size),+>::$method(robot, $(&s.$argument),*)
                }),)*
                other => panic!("{} has no trait", other.name()),
            }
        }
    };
    (@[$(#[doc = $about:literal])+ chosen $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] $found:tt) => {
        bound_by_name!(@[$($rest)*] $found);
    };
    (@[$(#[doc = $about:literal])+ sized $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] [$($found:tt)*]) => {
        bound_by_name!(@[$($rest)*] [$($found)* $name<N, P, T> $method $arguments;]);
    };
    (@[$(#[doc = $about:literal])+ $kind:ident $name:ident $method:ident $arguments:tt -> $result:ty; $($rest:tt)*] [$($found:tt)*]) => {
        bound_by_name!(@[$($rest)*] [$($found)* $name<N, T> $method $arguments;]);
    };
    ($($all:tt)*) => { bound_by_name!(@[$($all)*] []); };
}
homogen::every_function!(bound_by_name);

/// A type of number whose results can be listed entry by entry.
pub trait Number: Real + Entries {}

impl Number for f32 {}
impl Number for f64 {}

type OneCall<'r, S> = Box<dyn Fn(&S) -> Vec<f64> + 'r>;
type ManyCalls<'r, S> = Box<dyn Fn(&[S]) + 'r>;

/// A function of a robot.
pub struct Bound<'r, T, const N: usize> {
    entries: OneCall<'r, State<T, N>>,
    batch: ManyCalls<'r, State<T, N>>,
}

impl<T, const N: usize> Bound<'_, T, N> {
    /// All numbers of the result.
    #[must_use]
    pub fn entries(&self, state: &State<T, N>) -> Vec<f64> {
        (self.entries)(state)
    }

    /// Calls the function once a state, for its time alone.
    pub fn batch(&self, states: &[State<T, N>]) {
        (self.batch)(states);
    }
}

fn bound<'r, T, O: Entries, const N: usize>(
    call: impl Fn(&State<T, N>) -> O + Copy + 'r,
) -> Bound<'r, T, N> {
    Bound {
        entries: Box::new(move |state| {
            let mut numbers = Vec::new();
            call(state).push(&mut numbers);
            numbers
        }),
        batch: Box::new(move |states| {
            // By reference: a moved result would be loaded again, after its stores.
            for state in states {
                black_box(&call(black_box(state)));
            }
        }),
    }
}
