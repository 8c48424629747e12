//! True values of functions, to 256 bits, from two sources that share only the numbers of the description.
//!
//! In: a description and a request, or the chain that the generator makes of them. Out: results in the order of the
//! function's shape. [`frame_0`] multiplies the paper's dense matrices in frame 0, fixed joints included;
//! [`link_frames`] evaluates the graph that the generator would print, with its frames, merged bodies and regrouped
//! parameters. A test shows that they agree to 10⁻⁵⁰; other tests use either, and the second is faster.

pub mod actuator;
pub mod frame_0;
pub mod link_frames;
pub mod matrix;
pub mod motion;
pub mod robot;
pub mod solve;
pub mod state;
