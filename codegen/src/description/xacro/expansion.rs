//! State of an expansion, and the evaluation of texts in it.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::budget::{Budget, HEAVY};
use super::expression::function::{float_of, global_value, integer_of};
use super::expression::surroundings::Surroundings;
use super::expression::value::{LARGEST_INTEGER, ScopeId, Value};
use super::expression::{evaluate, parse::parse};
use super::failure::{Failure, Mistake, failure, failure_with_hint};
use super::files::Files;
use super::scope::{Scopes, Symbol};
use super::text::{Piece, pieces};
use super::tree::{Element, FileId, Origin, Written};
use super::yaml;
use crate::wording::{named, quoted};

/// An error or a warning with its place.
pub(super) struct Report {
    pub(super) origin: Origin,
    pub(super) what: String,
    pub(super) hint: Option<String>,
}

/// An argument of the file.
pub(super) struct XacroArgument {
    pub(super) value: String,
    /// True if the user gives it.
    pub(super) is_given: bool,
    /// True if the file declares or reads it.
    pub(super) is_used: bool,
}

/// State of an expansion.
pub(super) struct Expansion {
    pub(super) files: Files,
    /// The parsed files.
    pub(super) trees: HashMap<FileId, Rc<Element>>,
    pub(super) scopes: Scopes,
    pub(super) arguments: HashMap<String, XacroArgument>,
    pub(super) budget: Budget,
    /// The files that are read at the moment, the innermost one last.
    pub(super) reading: Vec<FileId>,
    /// The macros that are expanded at the moment, with the places of their calls.
    pub(super) calls: Vec<(Rc<str>, Origin)>,
    pub(super) errors: Vec<Report>,
    pub(super) warnings: Vec<Report>,
    reported: HashSet<(Origin, String)>,
    /// True if the end of the budget is reported.
    is_over: bool,
    /// The place of the text that is evaluated at the moment.
    at: Origin,
}

impl Expansion {
    pub(super) fn new(
        files: Files,
        arguments: HashMap<String, XacroArgument>,
        budget: Budget,
    ) -> Self {
        let first = FileId(0);
        Self {
            files,
            trees: HashMap::new(),
            scopes: Scopes::default(),
            arguments,
            budget,
            reading: vec![first],
            calls: Vec::new(),
            errors: Vec::new(),
            warnings: Vec::new(),
            reported: HashSet::new(),
            is_over: false,
            at: Origin {
                file: first,
                offset: 0,
            },
        }
    }

    /// The file that is read at the moment.
    pub(super) fn current(&self) -> FileId {
        self.reading.last().copied().unwrap_or(FileId(0))
    }

    /// Reports an error at a place, once.
    pub(super) fn report(&mut self, origin: Origin, failure: Failure) {
        let Failure::Mistake(Mistake { what, hint, .. }) = failure else {
            return;
        };
        // Everything fails after the last step.
        if self.budget.is_spent() && std::mem::replace(&mut self.is_over, true) {
            return;
        }
        if !self.reported.insert((origin, what.clone())) {
            return;
        }
        let call = self.calls.last().map(|(name, call)| {
            let place = self.files.positions(call.file).place(call.offset);
            let line = place.order().map_or(0, |(_, line, _)| line);
            let (name, file) = (quoted(name), self.files.name(call.file));
            format!(" (in macro {name}, called in line {line} of {file})")
        });
        self.errors.push(Report {
            origin,
            what: what + &call.unwrap_or_default(),
            hint,
        });
    }

    /// Reports the error in a text.
    pub(super) fn report_in(&mut self, written: &Written, failure: Failure) {
        let at = match &failure {
            Failure::Mistake(mistake) => mistake.at,
            Failure::Reported => 0,
        };
        self.report(written.place(at), failure);
    }

    /// Adds a warning, once a place.
    pub(super) fn warn(&mut self, origin: Origin, what: String, hint: Option<String>) {
        if self.reported.insert((origin, what.clone())) {
            self.warnings.push(Report { origin, what, hint });
        }
    }

    /// The value of a text: typed if it is one expression.
    pub(super) fn value(&mut self, written: &Written, scope: ScopeId) -> Result<Value, Failure> {
        let outer = std::mem::replace(&mut self.at, written.origin);
        let value = self.value_of(&written.text, Some(scope));
        self.at = outer;
        value
    }

    /// The value of a text as text.
    pub(super) fn text(&mut self, written: &Written, scope: ScopeId) -> Result<Rc<str>, Failure> {
        let value = self.value(written, scope)?;
        self.budget.spend(value.steps())?;
        let text = value.text();
        self.budget.spend_text(text.len())?;
        Ok(text)
    }

    /// The value of a text; `None` for a scope with global names only.
    pub(super) fn value_of(
        &mut self,
        text: &str,
        scope: Option<ScopeId>,
    ) -> Result<Value, Failure> {
        self.budget.spend_text(text.len())?;
        if !text.contains('$') {
            return Ok(text.into());
        }
        let mut values = Vec::new();
        for (at, piece) in pieces(text)? {
            let value = match piece {
                Piece::Text(text) => Ok(text.into()),
                Piece::Expression(inside) => self.expression(inside, scope),
                Piece::Substitution(inside) => self.substitution(inside, scope),
            };
            values.push(value.map_err(|failure| match failure {
                Failure::Mistake(mistake) => Failure::Mistake(Mistake { at, ..mistake }),
                Failure::Reported => Failure::Reported,
            })?);
        }
        if values.len() == 1
            && let Some(only) = values.pop()
        {
            return Ok(only);
        }
        let mut joined = String::new();
        for value in values {
            self.budget.spend(value.steps())?;
            let text = value.text();
            self.budget.spend_text(text.len())?;
            joined.push_str(&text);
        }
        Ok(joined.into())
    }

    /// The value of the inside of `${…}`.
    fn expression(&mut self, inside: &str, scope: Option<ScopeId>) -> Result<Value, Failure> {
        let inner = self.value_of(inside, scope)?.text();
        self.plain_expression(&inner, scope)
            .map_err(|failure| match failure {
                Failure::Mistake(mistake) => Failure::Mistake(Mistake {
                    what: format!("{} in {}", mistake.what, quoted(&format!("${{{inner}}}"))),
                    ..mistake
                }),
                Failure::Reported => Failure::Reported,
            })
    }

    /// The value of an expression without `$`.
    fn plain_expression(&mut self, text: &str, scope: Option<ScopeId>) -> Result<Value, Failure> {
        self.budget.enter(HEAVY)?;
        let value = parse(text).and_then(|expression| {
            evaluate(
                &expression,
                &mut At {
                    expansion: self,
                    scope,
                },
            )
        });
        self.budget.leave(HEAVY);
        value
    }

    /// The value of the inside of `$(…)`.
    fn substitution(&mut self, inside: &str, scope: Option<ScopeId>) -> Result<Value, Failure> {
        let inner = self.value_of(inside, scope)?.text();
        if let Some(text) = inner.strip_prefix("eval ") {
            return self.eval(text);
        }
        self.substituted(&inner)
    }

    /// The value of `$(eval …)`: an expression whose names are arguments.
    fn eval(&mut self, text: &str) -> Result<Value, Failure> {
        self.budget.enter(HEAVY)?;
        let value =
            parse(text).and_then(|expression| evaluate(&expression, &mut Eval { expansion: self }));
        self.budget.leave(HEAVY);
        Ok(Value::Text(value?.text()))
    }

    /// The value of a property; `None` if there is none.
    pub(super) fn property(
        &mut self,
        scope: ScopeId,
        name: &str,
    ) -> Result<Option<Value>, Failure> {
        let Some((home, symbol)) = self.scopes.find(scope, name) else {
            return Ok(None);
        };
        let written = match symbol {
            Symbol::Value(value) => return Ok(Some(value.clone())),
            Symbol::Lazy(written) => written.clone(),
            Symbol::Open => {
                return Err(failure_with_hint(
                    format!("property {} is defined by itself", quoted(name)),
                    "write lazy_eval=\"false\" to use its earlier value",
                ));
            }
            Symbol::Failed => return Err(Failure::Reported),
            Symbol::Block(_) => {
                return Err(failure_with_hint(
                    format!("property {} is a block", quoted(name)),
                    "insert it by <xacro:insert_block name=\"…\"/>",
                ));
            }
        };
        let name: Rc<str> = name.into();
        self.scopes.set(home, &name, Symbol::Open);
        self.budget.enter(HEAVY)?;
        let value = self.value(&written, home).map(literal);
        self.budget.leave(HEAVY);
        match value {
            Ok(value) => {
                self.scopes.set(home, &name, Symbol::Value(value.clone()));
                Ok(Some(value))
            }
            Err(failure) => {
                self.scopes.set(home, &name, Symbol::Failed);
                self.report_in(&written, failure);
                Err(Failure::Reported)
            }
        }
    }

    /// The value of an argument.
    pub(super) fn argument(&mut self, name: &str) -> Result<Rc<str>, Failure> {
        if let Some(argument) = self.arguments.get_mut(name) {
            argument.is_used = true;
            return Ok(argument.value.as_str().into());
        }
        let mut names: Vec<&str> = self.arguments.keys().map(String::as_str).collect();
        names.sort_unstable();
        let known = if names.is_empty() {
            String::new()
        } else {
            format!("; {}", named(name, "arguments", &names))
        };
        Err(failure_with_hint(
            format!("argument {} has no value", quoted(name)),
            format!(
                "declare it above by <xacro:arg name=\"{name}\" default=\"…\"/>, or give it: arguments({name} = \"…\") in \
                 attributes, .argument(\"{name}\", \"…\") of the builder, --arguments {name}=… on the command line{known}"
            ),
        ))
    }

    /// The value of an environment variable, if it is given as an argument. The environment itself is never read: the
    /// same file must give the same code on every machine.
    pub(super) fn environment(&mut self, name: &str) -> Option<Rc<str>> {
        let argument = self.arguments.get_mut(name);
        let argument = argument.filter(|argument| argument.is_given)?;
        argument.is_used = true;
        Some(argument.value.as_str().into())
    }

    /// The place of the text that is evaluated at the moment.
    pub(super) const fn here(&self) -> Origin {
        self.at
    }
}

/// An expansion at a scope.
struct At<'e> {
    expansion: &'e mut Expansion,
    scope: Option<ScopeId>,
}

impl Surroundings for At<'_> {
    fn budget(&mut self) -> &mut Budget {
        &mut self.expansion.budget
    }

    fn property(&mut self, name: &str) -> Result<Option<Value>, Failure> {
        match self.scope {
            Some(scope) => self.expansion.property(scope, name),
            None => Ok(None),
        }
    }

    fn property_of(&mut self, scope: ScopeId, name: &str) -> Result<Option<Value>, Failure> {
        self.expansion.property(scope, name)
    }

    fn names(&self) -> Vec<String> {
        let scope = self.scope;
        scope.map_or_else(Vec::new, |scope| self.expansion.scopes.names(scope))
    }

    fn argument(&mut self, name: &str) -> Result<Value, Failure> {
        self.expansion.argument(name).map(Value::Text)
    }

    fn yaml(&mut self, file: &str) -> Result<Value, Failure> {
        let current = self.expansion.current();
        let path = self.expansion.files.path(file, current)?;
        let id = self.expansion.files.open(&path)?;
        let text = self.expansion.files.content(id).to_owned();
        self.expansion.budget.spend(text.len())?;
        let expansion = &mut *self.expansion;
        let mut evaluate = |text: &str| expansion.plain_expression(text, None);
        yaml::read(&text, &mut evaluate).map_err(|(line, failure)| match failure {
            Failure::Mistake(mistake) => {
                let name = self.expansion.files.name(id);
                Failure::Mistake(Mistake {
                    what: format!("{name}:{line}: {}", mistake.what),
                    ..mistake
                })
            }
            Failure::Reported => Failure::Reported,
        })
    }

    fn full_path(&mut self, file: &str) -> Result<Value, Failure> {
        let current = self.expansion.current();
        self.expansion.files.path(file, current).map(Value::from)
    }

    fn warn(&mut self, message: String) {
        let origin = self.expansion.here();
        self.expansion.warn(origin, message, None);
    }
}

/// The surroundings of `$(eval …)`.
struct Eval<'e> {
    expansion: &'e mut Expansion,
}

impl Surroundings for Eval<'_> {
    fn budget(&mut self) -> &mut Budget {
        &mut self.expansion.budget
    }

    fn property(&mut self, name: &str) -> Result<Option<Value>, Failure> {
        match name {
            "true" => return Ok(Some(Value::Bool(true))),
            "false" => return Ok(Some(Value::Bool(false))),
            _ => {}
        }
        if global_value(name).is_some() || !self.expansion.arguments.contains_key(name) {
            return Ok(None);
        }
        self.expansion.argument(name).map(|text| Some(typed(&text)))
    }

    fn property_of(&mut self, _: ScopeId, _: &str) -> Result<Option<Value>, Failure> {
        Ok(None)
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = self.expansion.arguments.keys().cloned().collect();
        names.sort_unstable();
        names
    }

    fn argument(&mut self, name: &str) -> Result<Value, Failure> {
        self.expansion.argument(name).map(|text| typed(&text))
    }

    fn yaml(&mut self, _: &str) -> Result<Value, Failure> {
        Err(failure("$(eval …) reads no files"))
    }

    fn full_path(&mut self, _: &str) -> Result<Value, Failure> {
        Err(failure("$(eval …) reads no files"))
    }

    fn warn(&mut self, message: String) {
        let origin = self.expansion.here();
        self.expansion.warn(origin, message, None);
    }
}

/// The value of an argument in `$(eval …)`.
fn typed(text: &str) -> Value {
    let number = if text.contains('.') {
        float_of(text).map(Value::Float)
    } else {
        integer_of(text).map(Value::Integer)
    };
    number.unwrap_or_else(|| match &*text.to_lowercase() {
        "true" => Value::Bool(true),
        "false" => Value::Bool(false),
        _ => text.into(),
    })
}

/// A text as the number or the boolean that it is, or without its single quotes; other values as they are.
pub(super) fn literal(value: Value) -> Value {
    let Value::Text(text) = &value else {
        return value;
    };
    let quoted = text
        .strip_prefix('\'')
        .and_then(|rest| rest.strip_suffix('\''));
    if let Some(inner) = quoted {
        return inner.into();
    }
    // A number with underscores stays a name.
    if text.contains('_') {
        return value;
    }
    let is_small = |integer: &i64| integer.unsigned_abs() <= LARGEST_INTEGER.unsigned_abs();
    let digits = text.trim().trim_start_matches(['+', '-']);
    if digits.bytes().all(|byte| byte.is_ascii_digit()) {
        // A longer number, such as that of a device, stays as written.
        let small = integer_of(text).filter(is_small);
        return small.map_or(value, Value::Integer);
    }
    if let Some(number) = float_of(text) {
        return Value::Float(number);
    }
    match &**text {
        "true" | "True" => Value::Bool(true),
        "false" | "False" => Value::Bool(false),
        _ => value,
    }
}

/// The boolean of a condition.
pub(super) fn boolean(value: &Value, written: &str) -> Result<bool, Failure> {
    let Value::Text(text) = value else {
        return Ok(value.is_true());
    };
    match &**text {
        "true" | "True" => Ok(true),
        "false" | "False" => Ok(false),
        text => {
            if let Some(integer) = integer_of(text) {
                return Ok(integer != 0);
            }
            let what = if text == written {
                format!("{} is no condition", quoted(text))
            } else {
                format!(
                    "{} is {}, which is no condition",
                    quoted(written),
                    quoted(text)
                )
            };
            Err(failure_with_hint(
                what,
                "write true, false or ${…} with a comparison",
            ))
        }
    }
}
