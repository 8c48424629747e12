//! The paper, row by row: every equation as a property over random and degenerate inputs.
//!
//! Tolerances are in units of rounding of the type under test. The table in `src/checklist.md` lists these
//! tests; `index` checks it.
#![cfg(any(feature = "std", feature = "libm"))]

/// Runs a test that is generic over the scalar in f32 and in f64.
macro_rules! in_both_precisions {
    ($($name:ident)*) => {$(
        mod $name {
            #[test]
            fn f32() {
                super::$name::<f32>();
            }

            #[test]
            fn f64() {
                super::$name::<f64>();
            }
        }
    )*};
}

mod angles;
mod bad_input;
mod composition;
#[cfg(feature = "nalgebra")]
mod conversion;
mod dense;
mod display;
mod dynamics;
mod frames;
mod generic;
mod geometry;
mod index;
mod inertia;
#[path = "../chains/jet.rs"]
mod jet;
mod kinematics;
mod logarithm;
mod nearest;
mod newton_euler;
mod normalize;
mod particles;
mod pose;
mod sample;
mod screw;
#[cfg(feature = "serde")]
mod serialization;
#[cfg(feature = "approx")]
mod tolerance;
mod translation;
mod vector;
