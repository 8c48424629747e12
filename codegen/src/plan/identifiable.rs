//! Independence of base parameters from the values of fields.
//!
//! In: a chain. Out: an error if fields change which linear combinations torques determine.

use crate::chain::Chain;
use crate::chain::base_parameters::revealing;
use crate::error::{Errors, Place};
use crate::wording::{code, list};

/// Checks that the base parameters are the same for all values of the fields.
///
/// # Errors
/// If torques determine other combinations once fields differ from the description.
///
/// # Panics
/// If base parameters have not been found ([`Chain::identified`]).
pub(super) fn settled(chain: &Chain) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    let found = chain.base_parameters.as_ref();
    let found = found.expect("base parameters are found before their regressor is made");
    let fields = revealing(chain, found).into_iter();
    let fields: Vec<String> = fields.map(|field| code(&field.name())).collect();
    if let [first, ..] = &*fields {
        let (noun, verb) = match &*fields {
            [_] => ("field", "differs"),
            _ => ("fields", "differ"),
        };
        errors.push_with_hint(
            Place::Unknown,
            format!(
                "torques determine other base parameters if {noun} {} {verb} from the description",
                list(fields.iter().map(String::as_str))
            ),
            format!(
                "ask for `regressor`, whose columns are of all parameters, or leave out {first}"
            ),
        );
    }
    errors.into_result(())
}
