//! A state in 256 bits.
//!
//! In: arguments, and the indices of quaternions among the coordinates. Out: the same numbers, with quaternions
//! normalised in 256 bits. Quaternions in `f64` are not exactly of length 1, except for trivial ones, and reference
//! computations that use them differently would disagree.

use homogen_codegen::space::{self, Variable};

use crate::arguments::Arguments;
use crate::big::Big;

/// A value of every argument in 256 bits.
pub type State = space::Arguments<Big>;

/// The state of the arguments; `quaternions` has the index of the first entry of each.
#[must_use]
pub fn exact(arguments: &Arguments, quaternions: impl IntoIterator<Item = usize>) -> State {
    let mut state =
        State::of(|variable| arguments[variable].iter().map(|&x| Big::new(x)).collect());
    for start in quaternions {
        let quaternion = &mut state[Variable::Q][start..start + 4];
        let square = quaternion.iter().fold(Big::zero(), |sum, x| sum + x * x);
        let length = square.sqrt();
        for entry in quaternion {
            *entry = &*entry / &length;
        }
    }
    state
}
