//! `<xacro:property>`.

use super::element::required;
use super::expansion::{Expansion, boolean, literal};
use super::expression::function::global_value;
use super::expression::parse::is_name;
use super::expression::value::{ScopeId, Value};
use super::failure::{Failure, failure, failure_with_hint};
use super::scope::Symbol;
use super::tree::{Element, Written};
use crate::wording::quoted;

const ATTRIBUTES: [&str; 6] = ["name", "value", "default", "remove", "scope", "lazy_eval"];

impl Expansion {
    /// Defines or removes a property. Its value is evaluated at its first use, unless another scope or
    /// `lazy_eval="false"` asks for it at once.
    pub(super) fn define_property(
        &mut self,
        element: &std::rc::Rc<Element>,
        scope: ScopeId,
    ) -> Result<(), Failure> {
        self.check_attributes(element, &ATTRIBUTES);
        let name = required(element, "name")?;
        let name = self.text(name, scope)?;
        if !is_name(&name) || name.starts_with("__") {
            return Err(failure_with_hint(
                format!("{} is no name of a property", quoted(&name)),
                "a name begins with a letter or _, has letters, digits and _, and is no word of Python",
            ));
        }
        let removes = self.switch(element.attribute("remove"), false, scope)?;
        let value = element.attribute("value");
        let default = element.attribute("default");
        let count = usize::from(value.is_some()) + usize::from(default.is_some());
        if count + usize::from(removes) > 1 {
            return Err(failure(format!(
                "property {} has more than one of value, default and remove",
                quoted(&name)
            )));
        }
        let is_known = self.scopes.find(scope, &name).is_some() || global_value(&name).is_some();
        if removes && is_known {
            self.scopes.remove(scope, &name);
            return Ok(());
        }
        if default.is_some() && is_known {
            return Ok(());
        }
        let is_lazy = self.switch(element.attribute("lazy_eval"), true, scope)?;
        let place = element.attribute("scope").map(|scope| &*scope.text);
        let target = match place {
            Some("global") => self.scopes.outermost(scope),
            Some("parent") => self.scopes.parent(scope).ok_or_else(|| {
                failure_with_hint(
                    "there is no scope around the file",
                    "write scope=\"parent\" in a macro",
                )
            })?,
            _ => scope,
        };
        let is_lazy = is_lazy && target == scope && place != Some("global");
        let Some(value) = value.or(default) else {
            let name = format!("**{name}").into();
            let block = Symbol::Block(std::rc::Rc::clone(element));
            self.scopes.set(target, &name, block);
            return Ok(());
        };
        let symbol = if is_lazy {
            match literal(Value::Text(std::rc::Rc::clone(&value.text))) {
                Value::Text(text) if text == value.text => Symbol::Lazy(value.clone()),
                // The text without its single quotes is still evaluated.
                Value::Text(text) => Symbol::Lazy(Written {
                    text,
                    ..value.clone()
                }),
                typed => Symbol::Value(typed),
            }
        } else {
            match self.value(value, scope) {
                Ok(found) => Symbol::Value(literal(found)),
                Err(failure) => {
                    self.report_in(value, failure);
                    Symbol::Failed
                }
            }
        };
        self.scopes.set(target, &name, symbol);
        Ok(())
    }

    /// The value of an attribute that is true or false.
    fn switch(
        &mut self,
        written: Option<&Written>,
        default: bool,
        scope: ScopeId,
    ) -> Result<bool, Failure> {
        match written {
            None => Ok(default),
            Some(written) => {
                let value = self.value(written, scope)?;
                boolean(&value, &written.text)
            }
        }
    }
}
