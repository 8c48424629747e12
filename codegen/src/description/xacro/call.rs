//! Macros: `<xacro:macro>`, and the elements that call them.

use std::rc::Rc;

use super::budget::HEAVY;
use super::element::{Expanded, PREFIX, required};
use super::expansion::{Expansion, literal};
use super::failure::{Failure, failure, failure_with_hint};
use super::scope::{Default, Here, Macro, Parameter, Symbol};
use super::tree::{Element, Node, Written};
use crate::wording::{list, named, quoted};

/// Steps of a call, which makes two scopes.
const STEPS: usize = 100;

impl Expansion {
    /// Defines a macro.
    pub(super) fn define_macro(
        &mut self,
        element: &Rc<Element>,
        here: Here,
    ) -> Result<(), Failure> {
        self.check_attributes(element, &["name", "params"]);
        let name = &required(element, "name")?.text;
        let name: Rc<str> = name.strip_prefix(PREFIX).unwrap_or(name).into();
        if &*name == "call" || name.contains('.') {
            return Err(failure_with_hint(
                format!("{} is no name of a macro", quoted(&name)),
                "`call` is an element of xacro, and a point stands behind a namespace",
            ));
        }
        let parameters = element.attribute("params").map(parameters);
        let defined = Macro {
            name,
            body: Rc::clone(element),
            parameters: parameters.unwrap_or_default(),
        };
        self.scopes.define(here.macros, defined);
        Ok(())
    }

    /// Expands the call of a macro: `<xacro:name …>` or `<xacro:call macro="name" …>`.
    pub(super) fn call(
        &mut self,
        element: &Element,
        here: Here,
        into: &mut Expanded,
    ) -> Result<(), Failure> {
        const MACRO: &str = "macro";
        let word = element.name.strip_prefix(PREFIX).unwrap_or_default();
        let is_dynamic = word == "call";
        let name = if is_dynamic {
            let name = required(element, MACRO)?;
            self.text(name, here.symbols)?
        } else {
            word.into()
        };
        let Some((home, called)) = self.scopes.resolve(here, &name) else {
            let names = self.scopes.macro_names(here.macros);
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let what = format!("there is no macro {}", quoted(&name));
            return Err(match names[..] {
                [] => failure_with_hint(what, "define it above, or include the file that does"),
                _ => failure_with_hint(what, named(&name, "macros", &names)),
            });
        };
        self.budget.spend(STEPS)?;
        self.budget.enter(HEAVY)?;
        let inner = self.scopes.inside(Some(home));
        let bound = self.bind(element, here, &called, inner, is_dynamic.then_some(MACRO));
        if bound.is_ok() {
            self.calls.push((name, element.origin));
            let body = self.expand(&called.body, inner);
            self.calls.pop();
            into.children.extend(body.children);
        }
        self.budget.leave(HEAVY);
        bound
    }

    /// Sets the parameters of a macro from its call.
    fn bind(
        &mut self,
        element: &Element,
        here: Here,
        called: &Macro,
        inner: Here,
        skipped: Option<&str>,
    ) -> Result<(), Failure> {
        let macro_name = quoted(&called.name);
        let mut left: Vec<&Parameter> = called.parameters.iter().collect();
        let mut is_complete = true;
        for attribute in &element.attributes {
            if skipped == Some(&*attribute.name) {
                continue;
            }
            let Some(at) = left.iter().position(|known| known.name == attribute.name) else {
                let names = called.parameters.iter().map(|parameter| &*parameter.name);
                let names: Vec<&str> = names.collect();
                let what = format!(
                    "macro {macro_name} has no parameter {}",
                    quoted(&attribute.name)
                );
                let failed = failure_with_hint(what, named(&attribute.name, "parameters", &names));
                self.report(attribute.origin, failed);
                is_complete = false;
                continue;
            };
            left.remove(at);
            let symbol = match self.value(&attribute.value, here.symbols) {
                Ok(value) => Symbol::Value(literal(value)),
                Err(failure) => {
                    self.report_in(&attribute.value, failure);
                    Symbol::Failed
                }
            };
            self.scopes.set(inner.symbols, &attribute.name, symbol);
        }
        // Blocks are expanded by the caller, and once more where they are inserted.
        let mut blocks = Expanded::default();
        self.contents(element, here, &mut blocks);
        let mut blocks = blocks.children.into_iter().filter_map(|node| match node {
            Node::Element(block) => Some(block),
            Node::Text(_) | Node::Literal(_) => None,
        });
        let mut missing = Vec::new();
        for parameter in left {
            if parameter.name.starts_with('*') {
                match blocks.next() {
                    Some(block) => {
                        let block = Symbol::Block(block);
                        self.scopes.set(inner.symbols, &parameter.name, block);
                    }
                    None => missing.push(format!("<{}>", parameter.name.trim_start_matches('*'))),
                }
            } else {
                match self.default_of(parameter, here) {
                    Ok(Some(symbol)) => self.scopes.set(inner.symbols, &parameter.name, symbol),
                    Ok(None) => missing.push(quoted(&parameter.name)),
                    Err(failure) => {
                        self.report(element.origin, failure);
                        is_complete = false;
                    }
                }
            }
        }
        if let Some(extra) = blocks.next() {
            let what = format!("macro {macro_name} has no block for <{}>", extra.name);
            return Err(failure(what));
        }
        if !missing.is_empty() {
            let missing = list(missing.iter().map(String::as_str));
            return Err(failure(format!("macro {macro_name} needs {missing}")));
        }
        if is_complete {
            Ok(())
        } else {
            Err(Failure::Reported)
        }
    }

    /// The value of a parameter that a call leaves out; `None` if it must not.
    fn default_of(&mut self, parameter: &Parameter, here: Here) -> Result<Option<Symbol>, Failure> {
        let Some(default) = &parameter.default else {
            return Ok(None);
        };
        if default.is_forwarded
            && let Some(value) = self.visible(&parameter.name, here)?
        {
            return Ok(Some(Symbol::Value(literal(value))));
        }
        let Some(written) = &default.value else {
            if default.is_forwarded {
                let name = quoted(&parameter.name);
                return Err(failure(format!("there is no property {name} to forward")));
            }
            return Ok(None);
        };
        match self.value(written, here.symbols) {
            Ok(value) => Ok(Some(Symbol::Value(literal(value)))),
            Err(failure) => {
                self.report_in(written, failure);
                Ok(Some(Symbol::Failed))
            }
        }
    }

    /// The value of a property or of a global name.
    fn visible(
        &mut self,
        name: &str,
        here: Here,
    ) -> Result<Option<super::expression::value::Value>, Failure> {
        let found = self.property(here.symbols, name)?;
        Ok(found.or_else(|| super::expression::function::global_value(name)))
    }
}

/// The parameters of a macro: `name`, `name:=default`, `name:=^`, `name:=^|default`, `*block` and `**block`, separated
/// by white space. `=` is as good as `:=`.
fn parameters(written: &Written) -> Vec<Parameter> {
    let text = &written.text;
    let mut found = Vec::new();
    let mut at = 0;
    loop {
        at += text[at..].len() - text[at..].trim_start().len();
        if at == text.len() {
            return found;
        }
        let (parameter, length) = parameter(written, at);
        found.push(parameter);
        at += length;
    }
}

/// The parameter at an offset, and its length.
fn parameter(written: &Written, at: usize) -> (Parameter, usize) {
    let rest = &written.text[at..];
    let is_space = |letter: char| letter.is_whitespace();
    let word = rest.find(is_space).unwrap_or(rest.len());
    let plain = || {
        let parameter = Parameter {
            name: rest[..word].into(),
            default: None,
        };
        (parameter, word)
    };
    let name = rest.find(|letter: char| is_space(letter) || matches!(letter, ':' | '='));
    let name = name.unwrap_or(rest.len());
    let after = rest[name..].trim_start();
    let after = after.strip_prefix(":=").or(after.strip_prefix('='));
    let Some(value) = after.map(str::trim_start).filter(|_| name > 0) else {
        return plain();
    };
    let (is_forwarded, value) = match value.strip_prefix('^') {
        Some(value) => (true, value.strip_prefix('|').unwrap_or(value)),
        None => (false, value),
    };
    let Some(length) = default_length(value) else {
        return plain();
    };
    let start = rest.len() - value.len();
    let origin = written.place(at + start);
    let default = (length > 0).then(|| Written {
        text: value[..length].into(),
        origin,
        is_verbatim: written.is_verbatim,
    });
    let parameter = Parameter {
        name: rest[..name].into(),
        default: Some(Default {
            is_forwarded,
            value: default,
        }),
    };
    (parameter, start + length)
}

/// The length of a default: `${…}`, `$(…)`, or words and texts in quotes without white space between them. `None` if
/// white space or the end does not follow.
fn default_length(text: &str) -> Option<usize> {
    let ends = |at: usize| text[at..].chars().next().is_none_or(char::is_whitespace);
    for (open, close) in [("${", '}'), ("$(", ')')] {
        if text.starts_with(open) {
            let mut closes = text.match_indices(close).map(|(at, _)| at + 1);
            if let Some(end) = closes.find(|end| ends(*end)) {
                return Some(end);
            }
        }
    }
    let mut at = 0;
    while !ends(at) {
        let rest = &text[at..];
        let quote = rest
            .chars()
            .next()
            .filter(|quote| matches!(quote, '\'' | '"'));
        at += if let Some(quote) = quote {
            rest[1..].find(quote)? + 2
        } else {
            let is_end = |letter: char| letter.is_whitespace() || matches!(letter, '\'' | '"');
            rest.find(is_end).unwrap_or(rest.len())
        };
    }
    Some(at)
}

#[cfg(test)]
mod tests {
    use super::super::tree::{FileId, Origin};
    use super::*;

    fn read(text: &str) -> Vec<String> {
        let written = Written {
            text: text.into(),
            origin: Origin {
                file: FileId(0),
                offset: 0,
            },
            is_verbatim: true,
        };
        let show = |parameter: Parameter| match parameter.default {
            None => parameter.name.to_string(),
            Some(default) => {
                let value = default.value.map(|value| {
                    assert!(text[value.origin.offset..].starts_with(&*value.text));
                    value.text
                });
                format!("{}|{}|{value:?}", parameter.name, default.is_forwarded)
            }
        };
        parameters(&written).into_iter().map(show).collect()
    }

    #[test]
    fn parameters_have_names_and_defaults() {
        assert_eq!(read(" a  *b **c "), ["a", "*b", "**c"]);
        assert_eq!(
            read("a:=1 b = 2 c:=^ d:=^|x e"),
            [
                "a|false|Some(\"1\")",
                "b|false|Some(\"2\")",
                "c|true|None",
                "d|true|Some(\"x\")",
                "e"
            ]
        );
        assert_eq!(
            read("a:=${x + 1} b:=$(arg y) c:='1 -2' d:=${a}${b} e:=x'y z'w"),
            [
                "a|false|Some(\"${x + 1}\")",
                "b|false|Some(\"$(arg y)\")",
                "c|false|Some(\"'1 -2'\")",
                "d|false|Some(\"${a}${b}\")",
                "e|false|Some(\"x'y z'w\")"
            ]
        );
        assert_eq!(read("a:= b"), ["a|false|Some(\"b\")"]);
        assert_eq!(read("a:=it's b"), ["a:=it's", "b"]);
    }
}
