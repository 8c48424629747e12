//! Whether one set of base parameters is that of every value of the fields.
//!
//! In: a chain. Out: nothing, or the mistake that fields change what torques can tell. It never finds base
//! parameters itself.

use crate::chain::Chain;
use crate::chain::base_parameters::revealing;
use crate::error::{Errors, Place};
use crate::wording::{code, list};

/// Asks for fields that leave base parameters as they are described.
///
/// # Errors
/// Where torques can tell others of a robot whose fields are not what is described.
///
/// # Panics
/// Where base parameters have not been looked for ([`Chain::identified`]).
pub(super) fn settled(chain: &Chain) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    let found = chain.base_parameters.as_ref();
    let found = found.expect("base parameters are found before their regressor is made");
    let fields = revealing(chain, found).into_iter();
    let fields: Vec<String> = fields.map(|field| code(&field.name())).collect();
    if let [first, ..] = &*fields {
        let (noun, verb) = match &*fields {
            [_] => ("field", "is"),
            _ => ("fields", "are"),
        };
        errors.push_with_hint(
            Place::Unknown,
            format!(
                "torques can tell other base parameters where {noun} {} {verb} not what is described",
                list(fields.iter().map(String::as_str))
            ),
            format!("ask for `regressor`, whose columns are of all parameters, or leave out {first}"),
        );
    }
    errors.into_result(())
}
