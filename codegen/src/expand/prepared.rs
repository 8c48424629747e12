//! Precomputation from struct fields alone, which is done once.
//!
//! In: the functions of a module, and the fields that they read. Out: each function in two parts, with the same
//! operations.

use crate::error::{Errors, Place};
use crate::module::{GeneratedFunction, Prepared};
use crate::request::{Parameter, Request};
use crate::schedule::{OperationCount, part};

/// Splits functions into the part that depends on fields alone and the rest.
///
/// # Errors
/// If nothing depends on fields alone.
pub(super) fn prepared(
    functions: &[GeneratedFunction],
    request: &Request,
) -> Result<Prepared, Errors> {
    let programs: Vec<_> = functions.iter().map(|function| &function.program).collect();
    let entries: Vec<Vec<String>> = request.parameters.iter().map(Parameter::entries).collect();
    let parts = part(&programs, &entries);
    let on =
        |operation_count: OperationCount| operation_count.on(request.processor, request.scalar);
    let left = functions.iter().zip(parts.each);
    let left = left.map(|(function, program)| {
        let OperationCount {
            naive_mul,
            naive_add,
            ..
        } = function.operation_count;
        let operation_count = OperationCount::of(&program).beside_dense(naive_mul, naive_add);
        GeneratedFunction {
            operation_count: on(operation_count),
            program,
            ..function.clone()
        }
    });
    let mut errors = Errors::new();
    if parts.names.is_empty() {
        errors.push_with_hint(
            Place::Unknown,
            "`prepare` computes once what depends on fields alone, and no function reads one",
            "leave it out, or ask for functions that read the fields",
        );
    }
    errors.into_result(Prepared {
        functions: left.collect(),
        operation_count: on(OperationCount::of(&parts.once)),
        once: parts.once,
        names: parts.names,
    })
}
