//! What a function should return, to 256 bits, from two sources that share nothing but the numbers of the
//! description.
//!
//! In: a description and a request, or the chain that the generator makes of them. Out: results in
//! the order of the function's shape. [`frame_0`] multiplies the paper's dense matrices in frame 0,
//! every fixed joint included; [`link_frames`] evaluates what the generator is about to print, with
//! its frames, merged bodies and regrouped parameters. That they agree to 10⁻⁵⁰ is tested; from then on
//! either is the truth, and the second is the faster one.

pub mod drive;
pub mod frame_0;
pub mod link_frames;
pub mod matrix;
pub mod motion;
pub mod robot;
pub mod solve;
pub mod state;
