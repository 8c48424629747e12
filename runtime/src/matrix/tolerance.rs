//! Equality within a tolerance (feature `approx`).
//!
//! In: two typed matrices. Out: true if every stored number agrees, absolutely, relatively or in
//! units in the last place. Numbers are compared one by one, whatever their units.

use super::acceleration::Acceleration;
use super::action::Action;
use super::displacement::Displacement;
use super::inertia::Inertia;
use super::momentum::Momentum;
use super::point::{Direction, Point};
use super::pose::Pose;
use super::screw::Screw;
use super::velocity::Velocity;
use approx::{AbsDiffEq, RelativeEq, UlpsEq};

/// Implements the three traits of `approx` by the numbers that `parts` returns for each type.
macro_rules! within_tolerance {
    ($($kind:ident, |$x:ident| [$($part:expr),+];)*) => {$(
        impl<T: Copy + AbsDiffEq<Epsilon: Copy>> AbsDiffEq for $kind<T> {
            type Epsilon = T::Epsilon;

            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                let parts = |$x: &Self| [$($part),+].into_iter().flatten().flatten();
                parts(self).zip(parts(other)).all(|(a, b)| a.abs_diff_eq(&b, epsilon))
            }
        }

        impl<T: Copy + RelativeEq<Epsilon: Copy>> RelativeEq for $kind<T> {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }

            fn relative_eq(&self, other: &Self, epsilon: T::Epsilon, max_relative: T::Epsilon) -> bool {
                let parts = |$x: &Self| [$($part),+].into_iter().flatten().flatten();
                parts(self)
                    .zip(parts(other))
                    .all(|(a, b)| a.relative_eq(&b, epsilon, max_relative))
            }
        }

        impl<T: Copy + UlpsEq<Epsilon: Copy>> UlpsEq for $kind<T> {
            fn default_max_ulps() -> u32 {
                T::default_max_ulps()
            }

            fn ulps_eq(&self, other: &Self, epsilon: T::Epsilon, max_ulps: u32) -> bool {
                let parts = |$x: &Self| [$($part),+].into_iter().flatten().flatten();
                parts(self).zip(parts(other)).all(|(a, b)| a.ulps_eq(&b, epsilon, max_ulps))
            }
        }
    )*};
}

within_tolerance! {
    Pose, |x| [*x.rotation(), row(x.translation())];
    Displacement, |x| [*x.rotation(), row(x.translation())];
    Screw, |x| [row(x.u()), row(x.b())];
    Velocity, |x| [row(x.omega()), row(x.v())];
    Acceleration, |x| [*x.g(), row(x.a())];
    Inertia, |x| [x.second_moments(), row(x.q()), row([x.mass(); 3])];
    Momentum, |x| [row(x.gamma()), row(x.rho())];
    Action, |x| [row(x.c()), row(x.f())];
    Point, |x| [row(x.0)];
    Direction, |x| [row(x.0)];
}

/// A vector as three equal rows, so that it can stand in an array beside blocks.
fn row<T: Copy>(v: [T; 3]) -> [[T; 3]; 3] {
    [v; 3]
}
