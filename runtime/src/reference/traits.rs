//! The traits of [`robot`] for a robot as data.
//!
//! In: a [`Chain`]. Out: implementations of the traits by the functions of the same names in [`generic`]; functions
//! of a frame are those of the end effector.

use super::generic;
use crate::every_function;
use crate::robot;
use crate::robot::chain::Chain;
use nalgebra::RealField;

macro_rules! of_a_chain {
    ($(
        $(#[doc = $about:literal])+
        $kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty;
    )*) => {$(
        implement!($kind $name $method($($argument),*) -> $result);
    )*};
}

macro_rules! implement {
    // A chain does not know its base parameters.
    (chosen $($row:tt)*) => {};
    (sized $name:ident $method:ident($($argument:ident),*) -> $result:ty) => {
        impl<T, const N: usize, const F: usize, const P: usize, const Q: usize, const B: usize>
            robot::$name<N, P, T, Q> for Chain<N, F, Q, B>
        where
            T: RealField + Copy,
        {
            fn $method(&self, $($argument: &robot::list_of!($argument)),*) -> $result {
                call!(whole self.$method($($argument),*))
            }
        }
    };
    ($kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty) => {
        impl<T, const N: usize, const F: usize, const Q: usize, const B: usize>
            robot::$name<N, T, Q> for Chain<N, F, Q, B>
        where
            T: RealField + Copy,
        {
            fn $method(&self, $($argument: &robot::list_of!($argument)),*) -> $result {
                call!($kind self.$method($($argument),*))
            }
        }
    };
}

macro_rules! call {
    (tip_weighted $($call:tt)*) => { call!(tip $($call)*) };
    (tip $chain:ident.$method:ident($($argument:ident),*)) => {
        generic::$method($chain, &$chain.tip(), $($argument),*)
    };
    ($whole:ident $chain:ident.$method:ident($($argument:ident),*)) => {
        generic::$method($chain, $($argument),*)
    };
}

every_function!(of_a_chain);
