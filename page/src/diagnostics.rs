//! Warnings and errors with their places.

use serde_json::{Value, json};

use homogen_codegen::error::{Diagnostic, Place};

/// Warnings with their places.
#[must_use]
pub fn warnings(warnings: &[Diagnostic]) -> Value {
    let warnings = warnings.iter().map(|warning| {
        let (line, column) = line_and_column(warning.place);
        json!({ "line": line, "column": column, "message": warning.message, "hint": warning.hint })
    });
    warnings.collect()
}

/// Line and column of a place; null if it is not in the description's own file.
#[must_use]
pub fn line_and_column(place: Place) -> (Value, Value) {
    match place {
        Place::File { line, column } => (json!(line), json!(column)),
        Place::Included { .. } | Place::Token(_) | Place::Unknown => (Value::Null, Value::Null),
    }
}
