//! The arguments of a function or a method.

use std::rc::Rc;

use super::surroundings::Surroundings;
use super::value::Value;
use crate::description::xacro::failure::{Failure, failure};
use crate::wording::quoted;

/// A call with its arguments.
pub(super) struct Call<'c> {
    pub(super) name: &'c str,
    pub(super) values: Vec<Value>,
    pub(super) named: Vec<(Rc<str>, Value)>,
    pub(super) surroundings: &'c mut dyn Surroundings,
}

impl Call<'_> {
    /// The arguments, if there are as many as the function takes, and none by name.
    pub(super) fn exactly<const N: usize>(&mut self) -> Result<[Value; N], Failure> {
        self.unnamed()?;
        let count = self.values.len();
        let values = std::mem::take(&mut self.values);
        values
            .try_into()
            .map_err(|_| self.wrong_count(&N.to_string(), count))
    }

    /// The first argument, and the second if there is one.
    pub(super) fn one_or_two(&mut self) -> Result<(Value, Option<Value>), Failure> {
        self.unnamed()?;
        let count = self.values.len();
        let mut values = std::mem::take(&mut self.values).into_iter();
        match (values.next(), values.next(), values.next()) {
            (Some(first), second, None) => Ok((first, second)),
            _ => Err(self.wrong_count("1 or 2", count)),
        }
    }

    /// The only argument, if there is one.
    pub(super) fn optional(&mut self) -> Result<Option<Value>, Failure> {
        self.unnamed()?;
        if self.values.is_empty() {
            return Ok(None);
        }
        self.exactly().map(|[value]| Some(value))
    }

    /// Rejects arguments with names.
    pub(super) fn unnamed(&self) -> Result<(), Failure> {
        match self.named.first() {
            None => Ok(()),
            Some((name, _)) => Err(failure(format!(
                "{} has no argument {}",
                self.name,
                quoted(name)
            ))),
        }
    }

    pub(super) fn wrong_count(&self, wanted: &str, count: usize) -> Failure {
        failure(format!(
            "{} takes {wanted} arguments and has {count}",
            self.name
        ))
    }

    /// An argument that must be a text.
    pub(super) fn text(&self, value: &Value) -> Result<Rc<str>, Failure> {
        match value {
            Value::Text(text) => Ok(Rc::clone(text)),
            other => Err(self.wrong_kind("a text", other)),
        }
    }

    /// An argument that must be a number.
    pub(super) fn number(&self, value: &Value) -> Result<f64, Failure> {
        let number = value.as_number();
        number.ok_or_else(|| self.wrong_kind("a number", value))
    }

    /// An argument that must be an integer.
    pub(super) fn integer(&self, value: &Value) -> Result<i64, Failure> {
        let integer = value.as_integer();
        integer.ok_or_else(|| self.wrong_kind("an integer", value))
    }

    /// The items of a list, the keys of a dictionary or the letters of a text.
    pub(super) fn items(&mut self, value: &Value) -> Result<Vec<Value>, Failure> {
        let items = items(value).ok_or_else(|| self.wrong_kind("a list", value))?;
        self.surroundings.budget().spend(items.len())?;
        Ok(items)
    }

    pub(super) fn wrong_kind(&self, wanted: &str, value: &Value) -> Failure {
        failure(format!(
            "{} needs {wanted}, not {}",
            self.name,
            value.kind()
        ))
    }
}

/// The items of a value that has some.
pub(super) fn items(value: &Value) -> Option<Vec<Value>> {
    match value {
        Value::List(list) => Some(list.items().clone()),
        Value::Map(map) => {
            let entries = map.entries();
            Some(entries.iter().map(|(key, _)| key.clone()).collect())
        }
        Value::Text(text) => {
            let letters = text.chars();
            Some(letters.map(|letter| letter.to_string().into()).collect())
        }
        _ => None,
    }
}
