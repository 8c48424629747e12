//! Whether a robot has a centre of mass: whether anything that joints move has mass.
//!
//! In: a chain. Out: nothing, or the mistake that there is none. It never looks where the mass is.

use crate::chain::Chain;
use crate::error::{Errors, Place};

/// What is no mass \[kg\]: its moments, by which it is divided again, would underflow.
const NOTHING: f64 = 1e-200;

/// Asks for mass; a field that may be any number counts as some.
///
/// # Errors
/// Where no joint moves a mass.
pub(super) fn weighable(chain: &Chain) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    let weighs = |mass| {
        let mass = chain.graph.term(mass).value();
        mass.is_none_or(|mass| mass.to_f64().abs() > NOTHING)
    };
    if !(chain.joints.iter()).any(|joint| weighs(joint.inertia.mass)) {
        errors.push_with_hint(
            Place::Unknown,
            "nothing that joints move has mass: there is no centre of mass",
            "give the links their inertials",
        );
    }
    errors.into_result(())
}
