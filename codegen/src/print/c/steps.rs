//! Time steps of a robot in C, and their first and second derivatives.
//!
//! In: a [`Module`] with forward dynamics, or with inverse dynamics for the implicit midpoint rule, and a rule. Out: what
//! the files [`explicit`] and [`midpoint`] say.

mod bodies;
mod explicit;
mod midpoint;
mod rule;
mod texts;

use std::fmt::Write;

use self::explicit::Explicit;
use self::rule::Table;
use self::texts::{INVERSE, Texts, VALUE, index};
pub(super) use self::texts::{has_derivatives, has_hessian};
use super::comments::comment;
use crate::function::Function;
use crate::module::{DataMotion, Module};
use crate::request::Integrator;
use crate::space::Space;

/// Message and hint if a module cannot have steps, or not those that acados needs.
///
/// # Errors
/// If coordinates are not added, loops are closed, functions are missing, or acados cannot pass what they take.
pub fn check(module: &Module, rule: Integrator, acados: bool) -> Result<(), [String; 2]> {
    let mut motions = module.data.motions.iter().zip(&module.data.names);
    let manifold = motions.find(|(motion, _)| matches!(motion, DataMotion::Manifold(_)));
    if let Some((_, name)) = manifold {
        return Err([
            format!("`steps` needs coordinates that are added, and joint `{name}` has others"),
            "leave it out; `homogen::step` in Rust and `step` in Python have such steps".to_owned(),
        ]);
    }
    if module.spaces.len(Space::Constraints) > 0 {
        return Err([
            "`steps` is not for robots with loops, which a step would open".to_owned(),
            "leave it out, or leave out the loops".to_owned(),
        ]);
    }
    let is_explicit = Table::of(rule).is_some();
    if acados && !is_explicit {
        return Err([
            "`acados` needs a rule that gives the state after a step, and the midpoint rule is an equation for it".to_owned(),
            "write steps by rk4, euler or semi-implicit".to_owned(),
        ]);
    }
    let item = if is_explicit { VALUE } else { INVERSE };
    let needed = [
        (index(module, item).is_some(), item[0]),
        (
            !acados || has_derivatives(module),
            Function::ForwardDynamicsDerivatives,
        ),
    ];
    if let Some((_, function)) = needed.into_iter().find(|(has, _)| !has) {
        let name = function.name();
        let option = if acados { "acados" } else { "steps" };
        return Err([
            format!("`{option}` needs the function {name}"),
            format!("add {name} to the functions, by itself"),
        ]);
    }
    let passed = [
        (!module.parameters.is_empty(), "fields"),
        (module.spaces.actions() > 0, "external wrenches"),
    ];
    match passed.into_iter().find(|(has, _)| acados && *has) {
        None => Ok(()),
        Some((_, what)) => Err([
            format!("`acados` has no place for {what}"),
            format!("leave out the {what}, or call the steps from functions of your own"),
        ]),
    }
}

/// Declarations with their comments.
pub(super) fn declarations(module: &Module, prefix: &str, rule: Integrator) -> String {
    let texts = Texts::of(module, prefix);
    let heads = match Table::of(rule) {
        Some(table) => explicit::heads(&Explicit::of(texts, table)),
        None => midpoint::heads(&texts),
    };
    let mut text = String::new();
    for (about, head) in heads {
        text.push_str(&comment(&about));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "HOMOGEN_FN void {head};\n");
    }
    text
}

/// Definitions.
pub(super) fn definitions(module: &Module, prefix: &str, rule: Integrator) -> String {
    let texts = Texts::of(module, prefix);
    match Table::of(rule) {
        Some(table) => explicit::definitions(&Explicit::of(texts, table)),
        None => midpoint::definitions(&texts),
    }
}
