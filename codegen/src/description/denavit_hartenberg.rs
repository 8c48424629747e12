//! Denavit–Hartenberg tables, standard and modified.
//!
//! Rows (a, α, d, θ) from a file or from tokens become links and joints. The link of a row has the frame i of the
//! convention, so that poses, masses and inertias agree with textbooks. Its name is that of the joint with the suffix
//! `_link`, unless the row names it. The base link is `base`.
//!
//! Modified (Craig): joint i rotates about z of frame i, which is placed in frame i−1 by Rx(α) Tx(a) Rz(θ) Tz(d).
//! Standard: joint i rotates about z of frame i−1, and frame i is placed there by Rz(θ) Tz(d) Tx(a) Rx(α). In the
//! standard convention the joint moves a frame on its axis, Rz(θ) Tz(d), whose name is that of the joint with the
//! suffix `_axis`; frame i is fixed to it by Tx(a) Rx(α).

mod rows;
mod table;

pub(super) use self::rows::{Convention, Row, assemble};
pub(super) use self::table::COLUMNS;
pub use self::table::read;

/// Version of the file format; it changes if an existing table would be read differently.
pub const VERSION: u32 = 1;

#[cfg(test)]
mod tests;
