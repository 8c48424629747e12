//! Scopes of properties and of macros.
//!
//! A macro sees the properties of its caller, as in the tool. An included file with a namespace has a scope of its own.

use std::collections::HashMap;
use std::rc::Rc;

use super::expression::value::{ScopeId, Value};
use super::tree::{Element, Written};

/// A property, or a block of elements.
#[derive(Clone, Debug)]
pub(super) enum Symbol {
    Value(Value),
    /// A text that is evaluated at its first use.
    Lazy(Written),
    /// A property whose evaluation is under way.
    Open,
    /// A property whose error is reported.
    Failed,
    Block(Rc<Element>),
}

/// A macro.
#[derive(Debug)]
pub(super) struct Macro {
    pub(super) name: Rc<str>,
    pub(super) body: Rc<Element>,
    pub(super) parameters: Vec<Parameter>,
}

/// A parameter of a macro.
#[derive(Clone, Debug)]
pub(super) struct Parameter {
    /// Its name; with `*` or `**` in front if it is a block.
    pub(super) name: Rc<str>,
    pub(super) default: Option<Default>,
}

/// The value of a parameter that a call leaves out.
#[derive(Clone, Debug)]
pub(super) struct Default {
    /// True if it is the value of the caller's property of the same name, if there is one.
    pub(super) is_forwarded: bool,
    pub(super) value: Option<Written>,
}

/// The number of a scope of macros.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MacroScopeId(usize);

/// The scopes at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Here {
    pub(super) symbols: ScopeId,
    pub(super) macros: MacroScopeId,
}

#[derive(Debug, Default)]
struct Table<T, P> {
    entries: HashMap<Rc<str>, T>,
    parent: Option<P>,
    is_namespace: bool,
}

/// All scopes of an expansion.
#[derive(Default)]
pub(super) struct Scopes {
    symbols: Vec<Table<Symbol, ScopeId>>,
    macros: Vec<Table<MacroSymbol, MacroScopeId>>,
}

#[derive(Clone, Debug)]
enum MacroSymbol {
    Macro(Rc<Macro>),
    Namespace(MacroScopeId),
}

impl Scopes {
    /// A scope inside another one, or the outermost scope.
    pub(super) fn inside(&mut self, parent: Option<Here>) -> Here {
        Here {
            symbols: self.add_symbols(parent.map(|here| here.symbols), false),
            macros: self.add_macros(parent.map(|here| here.macros)),
        }
    }

    /// A scope for an included file with a namespace. It sees the properties around it, and no macros.
    pub(super) fn namespace(&mut self, name: &Rc<str>, here: Here) -> Here {
        let inner = Here {
            symbols: self.add_symbols(Some(here.symbols), true),
            macros: self.add_macros(None),
        };
        let value = Symbol::Value(Value::Scope(inner.symbols));
        self.set(here.symbols, name, value);
        let macros = &mut self.macros[here.macros.0].entries;
        macros.insert(Rc::clone(name), MacroSymbol::Namespace(inner.macros));
        inner
    }

    fn add_symbols(&mut self, parent: Option<ScopeId>, is_namespace: bool) -> ScopeId {
        self.symbols.push(Table {
            entries: HashMap::new(),
            parent,
            is_namespace,
        });
        ScopeId(self.symbols.len() - 1)
    }

    fn add_macros(&mut self, parent: Option<MacroScopeId>) -> MacroScopeId {
        self.macros.push(Table {
            entries: HashMap::new(),
            parent,
            is_namespace: false,
        });
        MacroScopeId(self.macros.len() - 1)
    }

    /// Defines a symbol.
    pub(super) fn set(&mut self, scope: ScopeId, name: &Rc<str>, symbol: Symbol) {
        let entries = &mut self.symbols[scope.0].entries;
        entries.insert(Rc::clone(name), symbol);
    }

    /// Removes a symbol from a scope and all scopes around it.
    pub(super) fn remove(&mut self, scope: ScopeId, name: &str) {
        let mut at = Some(scope);
        while let Some(scope) = at {
            self.symbols[scope.0].entries.remove(name);
            at = self.symbols[scope.0].parent;
        }
    }

    /// The innermost symbol of a name, and its scope.
    pub(super) fn find(&self, scope: ScopeId, name: &str) -> Option<(ScopeId, &Symbol)> {
        let mut at = Some(scope);
        while let Some(scope) = at {
            let table = &self.symbols[scope.0];
            if let Some(symbol) = table.entries.get(name) {
                return Some((scope, symbol));
            }
            at = table.parent;
        }
        None
    }

    /// The names of all properties that a scope sees, in alphabetical order.
    pub(super) fn names(&self, scope: ScopeId) -> Vec<String> {
        let mut names = Vec::new();
        let mut at = Some(scope);
        while let Some(scope) = at {
            let table = &self.symbols[scope.0];
            let own = table.entries.keys().filter(|name| !name.starts_with('*'));
            names.extend(own.map(ToString::to_string));
            at = table.parent;
        }
        names.sort_unstable();
        names.dedup();
        names
    }

    /// The outermost scope.
    pub(super) fn outermost(&self, scope: ScopeId) -> ScopeId {
        let mut at = scope;
        while let Some(parent) = self.symbols[at.0].parent {
            at = parent;
        }
        at
    }

    /// The scope of the caller of a macro, or around a namespace.
    pub(super) fn parent(&self, scope: ScopeId) -> Option<ScopeId> {
        let table = &self.symbols[scope.0];
        let mut parent = table.parent?;
        while !table.is_namespace && self.symbols[parent.0].is_namespace {
            parent = self.symbols[parent.0].parent?;
        }
        Some(parent)
    }

    /// Defines a macro.
    pub(super) fn define(&mut self, scope: MacroScopeId, defined: Macro) {
        let entries = &mut self.macros[scope.0].entries;
        entries.insert(
            Rc::clone(&defined.name),
            MacroSymbol::Macro(Rc::new(defined)),
        );
    }

    fn find_macro(&self, scope: MacroScopeId, name: &str) -> Option<&MacroSymbol> {
        let mut at = Some(scope);
        while let Some(scope) = at {
            let table = &self.macros[scope.0];
            if let Some(entry) = table.entries.get(name) {
                return Some(entry);
            }
            at = table.parent;
        }
        None
    }

    /// The macro with a name, which may begin with namespaces, and the scopes that it is expanded in.
    pub(super) fn resolve(&self, here: Here, name: &str) -> Option<(Here, Rc<Macro>)> {
        if let Some(MacroSymbol::Macro(found)) = self.find_macro(here.macros, name) {
            return Some((here, Rc::clone(found)));
        }
        let (namespaces, name) = name.rsplit_once('.')?;
        let mut inner = here;
        for namespace in namespaces.split('.') {
            inner = match (
                self.find_macro(inner.macros, namespace)?,
                self.find(inner.symbols, namespace)?,
            ) {
                (MacroSymbol::Namespace(macros), (_, Symbol::Value(Value::Scope(symbols)))) => {
                    Here {
                        symbols: *symbols,
                        macros: *macros,
                    }
                }
                _ => return None,
            };
        }
        match self.find_macro(inner.macros, name)? {
            MacroSymbol::Macro(found) => Some((inner, Rc::clone(found))),
            MacroSymbol::Namespace(_) => None,
        }
    }

    /// The names of all macros that a scope sees, in alphabetical order.
    pub(super) fn macro_names(&self, scope: MacroScopeId) -> Vec<String> {
        let mut names = Vec::new();
        let mut at = Some(scope);
        while let Some(scope) = at {
            let table = &self.macros[scope.0];
            names.extend(table.entries.keys().map(ToString::to_string));
            at = table.parent;
        }
        names.sort_unstable();
        names.dedup();
        names
    }
}
