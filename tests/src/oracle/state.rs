//! A state at 256 bits.
//!
//! In: arguments, and where quaternions stand among the coordinates. Out: the same numbers, with
//! quaternions of length 1 to the last of the 256 bits: none that `f64` holds is one, but for the trivial
//! ones, and two truths about a robot agree at those alone.

use homogen_codegen::space::{self, Variable};

use crate::arguments::Arguments;
use crate::big::Big;

/// One value of every argument.
pub type State = space::Arguments<Big>;

/// The state that arguments stand for; a quaternion begins at each of the places given.
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
