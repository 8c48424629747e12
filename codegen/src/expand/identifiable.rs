//! Whether torques are linear in nothing but the parameters of links, as regressors have it.
//!
//! In: a chain. Out: nothing, or the mistake that joints feel more than their bodies. It never looks at numbers.

use crate::chain::Chain;
use crate::error::{Errors, Place};

/// Asks for joints without friction and armature: τ = Y π has no columns of theirs.
///
/// # Errors
/// Where a joint has either, or a field that may be.
pub fn identifiable(chain: &Chain) -> Result<(), Errors> {
    let mut errors = chain.source.errors();
    if chain.is_driven() {
        errors.push_with_hint(
            Place::Unknown,
            "regressors have columns of links alone, and friction or armature is modelled: τ would not be Y π",
            "ask for them of the same robot without friction and armature, and put q̈, q̇ and sign q̇ of each joint \
             beside them",
        );
    }
    errors.into_result(())
}
