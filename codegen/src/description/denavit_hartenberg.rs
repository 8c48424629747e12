//! Tables of Denavit and Hartenberg, standard and modified.
//!
//! In: rows (a, α, d, θ), from a file or from tokens. Out: links and joints. The link of a row has
//! the row's frame i of the convention in question, so that poses, masses and inertias mean what
//! they mean in the book; its name is that of the joint with `_link` behind it, unless the row
//! says otherwise. What the table hangs on is the link `base`.
//!
//! Modified (Craig): joint i turns about z of frame i, which stands in frame i−1 at
//! Rx(α) Tx(a) Rz(θ) Tz(d). Standard: joint i turns about z of frame i−1, and frame i stands there
//! at Rz(θ) Tz(d) Tx(a) Rx(α). What moves is then a frame on the joint's axis, Rz(θ) Tz(d), called
//! as the joint with `_axis` behind it, which carries frame i at Tx(a) Rx(α).

mod rows;
mod table;

pub(super) use self::rows::{Convention, Row, assemble};
pub(super) use self::table::COLUMNS;
pub use self::table::read;

/// The version of the format of tables: another one where a table that is read today means something else.
pub const VERSION: u32 = 1;

#[cfg(test)]
mod tests;
