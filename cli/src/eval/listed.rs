//! Reads states from JSON: `{"states":[{"q":[…],"qd":[…],"qdd":[…],"tau":[…],"actions":[[…], …]}]}`.
//!
//! Yields the finite numbers of the function's arguments. Each error names its state. Keys that the function does not
//! need are ignored.

use serde_json::{Map, Value};

use homogen_codegen::error::{Errors, Place};
use homogen_codegen::space::{ACTION, Spaces, Variable};

/// The arguments of a function in the order of its parameters.
pub(super) type State = Vec<Vec<f64>>;

/// Reads states from the text of a file with this name.
pub(super) fn read(
    text: &str,
    file: &str,
    arguments: &[Variable],
    spaces: &Spaces,
) -> Result<Vec<State>, Errors> {
    let mut errors = Errors::new();
    match serde_json::from_str(text) {
        Ok(value) => {
            let states = states(&value, file, arguments, spaces, &mut errors);
            errors.into_result(states)
        }
        Err(reason) => {
            // Some programs write NaN into JSON: its state and key can still be named.
            if let Ok(value) = serde_json::from_str(&without_nan(text)) {
                states(&value, file, arguments, spaces, &mut errors);
            }
            if errors.is_empty() {
                refuse_syntax(&reason, file, &mut errors);
            }
            Err(errors)
        }
    }
}

fn states(
    value: &Value,
    file: &str,
    arguments: &[Variable],
    spaces: &Spaces,
    errors: &mut Errors,
) -> Vec<State> {
    let Some(states) = value.get("states").and_then(Value::as_array) else {
        let message = format!("{file}: the list \"states\" is missing");
        let hint = "write {\"states\":[{\"q\":[0.1, 0.2]}]}";
        errors.push_with_hint(Place::Unknown, message, hint);
        return Vec::new();
    };
    let mut read = Vec::with_capacity(states.len());
    for (index, state) in states.iter().enumerate() {
        let mut complain = |what: String| {
            errors.push(Place::Unknown, format!("{file}: state {index} {what}"));
        };
        let Some(state) = state.as_object() else {
            complain("is not an object".to_owned());
            continue;
        };
        let mut values = State::new();
        for &argument in arguments {
            match values_of(state, argument, spaces.len(argument.space())) {
                Ok(numbers) => values.push(numbers),
                Err(what) => complain(what),
            }
        }
        read.push(values);
    }
    read
}

/// The numbers of one key, or the end of a sentence that begins with the state.
fn values_of(
    state: &Map<String, Value>,
    argument: Variable,
    length: usize,
) -> Result<Vec<f64>, String> {
    let key = argument.name();
    let Some(values) = state.get(key) else {
        return Err(format!("has no \"{key}\""));
    };
    let Some(values) = values.as_array() else {
        return Err(format!("has a \"{key}\" that is not a list"));
    };
    let flat: Vec<Value>;
    let values = if argument == Variable::Actions {
        flat = actions(values, length)?;
        &flat
    } else {
        values
    };
    if values.len() != length {
        let found = values.len();
        return Err(format!(
            "has {found} numbers in \"{key}\" for {length} joints"
        ));
    }
    let number = |(entry, value): (usize, &Value)| match value.as_f64() {
        Some(number) => Ok(number),
        None => Err(format!(
            "has a \"{key}\" whose entry {entry} is not a finite number"
        )),
    };
    values.iter().enumerate().map(number).collect()
}

/// The entries of external wrenches, one after the other.
fn actions(values: &[Value], length: usize) -> Result<Vec<Value>, String> {
    let (count, each) = (length / ACTION.len(), ACTION.len());
    if values.len() != count {
        let found = values.len();
        return Err(format!("has {found} actions for {count} links"));
    }
    let mut entries = Vec::with_capacity(length);
    for (k, action) in values.iter().enumerate() {
        match action.as_array() {
            Some(action) if action.len() == each => entries.extend(action.iter().cloned()),
            _ => {
                return Err(format!(
                    "has an action {k} that is not a list of {each} numbers"
                ));
            }
        }
    }
    Ok(entries)
}

/// The text with `null` in place of NaN and infinity, which JSON does not have; names stay the same.
fn without_nan(text: &str) -> String {
    let mut without = String::with_capacity(text.len());
    let mut is_name = false;
    for (k, part) in text.split('"').enumerate() {
        if k > 0 {
            without.push('"');
        }
        if is_name {
            without.push_str(part);
            let backslashes = part.len() - part.trim_end_matches('\\').len();
            is_name = backslashes % 2 == 1;
        } else {
            let words = part.replace("NaN", "null").replace("-Infinity", "null");
            without.push_str(&words.replace("Infinity", "null"));
            is_name = true;
        }
    }
    without
}

fn refuse_syntax(reason: &serde_json::Error, file: &str, errors: &mut Errors) {
    let place = |number: usize| u32::try_from(number).unwrap_or(u32::MAX);
    let (line, column) = (place(reason.line()), place(reason.column()));
    let text = reason.to_string();
    // The place is already in front of the message.
    let message = text.split(" at line ").next().unwrap_or_default();
    errors.set_file(file, None);
    errors.push(Place::File { line, column }, format!("not JSON: {message}"));
}

#[cfg(test)]
mod tests {
    use super::without_nan;

    #[test]
    fn names_keep_what_they_contain() {
        let text = r#"{"NaN \" of Infinity\\": NaN, "a": [-Infinity, Infinity]}"#;
        let expected = r#"{"NaN \" of Infinity\\": null, "a": [null, null]}"#;
        assert_eq!(without_nan(text), expected);
    }
}
