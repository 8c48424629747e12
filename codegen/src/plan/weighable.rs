//! Existence of a centre of mass: whether any body that joints move has mass.
//!
//! In: a chain. Out: an error if there is none.

use crate::chain::Chain;
use crate::error::{Errors, Place};

/// The largest mass that counts as zero \[kg\]: its moments, which are divided by it, would underflow.
const NOTHING: f64 = 1e-200;

/// Checks that there is mass; a field that may have any value counts as mass.
///
/// # Errors
/// If no joint moves a mass.
pub(super) fn weighable(chain: &Chain) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    let weighs = |mass| {
        let mass = chain.graph.term(mass).value();
        mass.is_none_or(|mass| mass.to_f64().abs() > NOTHING)
    };
    if !(chain.joints.iter()).any(|joint| weighs(joint.inertia.mass)) {
        errors.push_with_hint(
            Place::Unknown,
            "no joint moves a mass: there is no centre of mass",
            "give the links their inertials",
        );
    }
    errors.into_result(())
}
