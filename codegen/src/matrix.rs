//! The 4×4 matrices of Legnani et al. 1996 over symbolic scalars.
//!
//! In: [`Term`](crate::expression::Term)s. Out: the paper's M, L, W, H, J and Φ, and Y, each kept as its blocks, with
//! their operations. Zeros and ones in a block cost nothing, because the graph folds them. Frames and the order of
//! computation are chosen by the callers.
//!
//! | letter | type | blocks |
//! |---|---|---|
//! | M | [`Pose`] | R, t |
//! | L | [`Screw`] | u, b |
//! | W | [`Velocity`] | ω, v₀ |
//! | H | [`Acceleration`] | ω, ω̇, a₀, with G = ω̲̇ + ω̲² rebuilt on demand |
//! | J | [`Inertia`] | ∫PPᵗ, q, m |
//! | Φ | [`Action`] | c, f |
//! | Y = W J | [`Flow`] | N, p |

mod acceleration;
pub mod across;
mod action;
mod flow;
mod inertia;
mod pose;
mod screw;
mod vector;
mod velocity;

pub use acceleration::Acceleration;
pub use action::Action;
pub use flow::Flow;
pub use inertia::{Inertia, Symmetric};
pub use pose::{Pose, Rotation};
pub use screw::Screw;
pub use vector::Vector;
pub use velocity::Velocity;
