//! Loops over equal limbs, such as the legs of a quadruped.
//!
//! In: a [`Program`], the sets of equal limbs, and the loops over columns that it has. Out: the same operations in
//! another order: what limbs have in common is a loop with an iteration for each limb, and single steps between loops
//! are what they do not have in common, such as sums over limbs. Results are the same bits. Compilers compute the
//! iterations together, in vector registers.
//!
//! An operation that has another sign in a mirrored limb gets an operand that is multiplied by 1 or −1.

mod cutting;
mod fusing;
mod groups;
mod iteration;
mod loops;
mod order;
#[cfg(test)]
pub mod tests;

pub use cutting::{MOST_ROWS, best_end};
pub use fusing::fused_alike;

use groups::Groups;
use loops::loops;
use order::ordered;

use super::repeats::{Repeat, of_iterations};
use super::{Length, Program};
use crate::space::Limbs;

/// The program in the order of limbs, with loops over limbs and columns; `None` if there is no loop over limbs.
pub fn in_limbs(
    program: &Program,
    limbs: &[Limbs],
    columns: &[Repeat],
    length: Length,
) -> Option<(Program, Vec<Repeat>)> {
    if limbs.is_empty() {
        return None;
    }
    let groups = Groups::of(program, limbs);
    let loops = loops(program, &groups, columns)?;
    let (program, iterations) = ordered(program, &groups, &loops, columns, length.of_section());
    let repeats = of_iterations(&program, iterations);
    Some((program, repeats))
}
