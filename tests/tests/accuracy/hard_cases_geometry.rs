//! Hard cases of geometry and simulation: exponentials and logarithms at every switch, singular angles and arms, dead
//! centres, and drift over many steps.
//!
//! In: at least a thousand seeded states per case, and the worst known inputs, in bits. Out: failed assertions. Errors
//! are compared with 256 bits in f64, in f32, and in f32 with subnormal numbers flushed to zero; those of generated
//! functions also with fused products.

mod arms;
mod cardan;
mod exact;
mod exact_arm;
mod exponential;
mod flight;
mod logarithm;
mod measure;
mod screw_axis;
mod slider_crank;
mod worst;
