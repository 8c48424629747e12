//! Data of pages for browsers, and of answers in JSON: a robot as it was read, its skeleton, and its functions with
//! operation counts, error bounds and explained code.
//!
//! Projects to begin with, around generated code, are here too, because the command line and the site offer the same.
//!
//! The command line and the WebAssembly module of the site call it. In: a chain and a generated module of the engine.
//! Out: JSON. It knows neither files nor arguments of a program.

pub mod count;
pub mod diagnostics;
pub mod firmware;
pub mod function;
pub mod names;
pub mod packed;
pub mod project;
pub mod report;
pub mod result;
pub mod session;
pub mod skeleton;

use serde_json::{Value, json};

use homogen_codegen::chain::Chain;
use homogen_codegen::error::Errors;
use homogen_codegen::module::Module;
use homogen_codegen::wording::visible;

/// A robot with all functions of a module.
///
/// # Errors
/// If a frame of a link cannot be placed.
pub fn data(chain: &Chain, module: &Module) -> Result<Value, Errors> {
    let layouts = skeleton::layouts(chain, module);
    let mut data = robot(chain, module)?;
    data["layouts"] = shown(json!(layouts.places));
    data["functions"] = function::functions(module, &layouts);
    Ok(data)
}

/// A robot without functions. Largest torques and forces are null where the description has none.
///
/// # Errors
/// If a frame of a link cannot be placed.
pub fn robot(chain: &Chain, module: &Module) -> Result<Value, Errors> {
    let efforts = module.efforts.iter();
    let efforts = efforts.map(|effort| effort.is_finite().then_some(*effort));
    let mut robot = shown(json!({
        "version": env!("CARGO_PKG_VERSION"),
        "report": report::report(chain),
        "facts": module.about.facts,
        "formulation": module.about.formulation,
        "left_out": count::left_out(module),
        "skeleton": skeleton::skeleton(chain)?,
        "efforts": efforts.collect::<Value>(),
    }));
    robot["letters"] = names::letters();
    Ok(robot)
}

/// The value with invisible characters escaped, in names and texts.
pub(crate) fn shown(value: Value) -> Value {
    match value {
        Value::String(text) => Value::String(visible(&text).into_owned()),
        Value::Array(entries) => entries.into_iter().map(shown).collect(),
        Value::Object(entries) => {
            let entries = entries.into_iter();
            entries.map(|(key, entry)| (key, shown(entry))).collect()
        }
        other => other,
    }
}
