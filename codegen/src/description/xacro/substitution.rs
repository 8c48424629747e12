//! Substitutions: `$(find package)`, `$(arg name)`, `$(env NAME)` and `$(optenv NAME default)`.

use super::expansion::Expansion;
use super::expression::value::Value;
use super::failure::{Failure, failure, failure_with_hint};
use crate::wording::{known, quoted};

const COMMANDS: [&str; 5] = ["arg", "env", "eval", "find", "optenv"];

impl Expansion {
    /// The value of the inside of `$(…)`, other than `eval`.
    pub(super) fn substituted(&mut self, inside: &str) -> Result<Value, Failure> {
        let words: Vec<&str> = inside.split(' ').filter(|word| !word.is_empty()).collect();
        match words[..] {
            ["arg", name] => self.argument(name).map(Value::Text),
            ["find", package] => self.files.find(package).map(Value::from),
            ["env", name] => {
                let unread = || {
                    failure_with_hint(
                        format!("environment variable {} is not read", quoted(name)),
                        format!(
                            "the same file gives the same code on every machine; give the value as an argument of this \
                             name: arguments({name} = \"…\"), .argument(\"{name}\", \"…\") or --arguments {name}=…"
                        ),
                    )
                };
                let found = self.environment(name).map(Value::Text);
                found.ok_or_else(unread)
            }
            ["optenv", name, ref default @ ..] => {
                if let Some(found) = self.environment(name) {
                    return Ok(Value::Text(found));
                }
                let default = default.join(" ");
                let here = self.here();
                self.warn(
                    here,
                    format!(
                        "environment variable {} is not read: its default {} counts",
                        quoted(name),
                        quoted(&default)
                    ),
                    Some("give the value as an argument of this name".to_owned()),
                );
                Ok(default.into())
            }
            ["cwd" | "dirname", ..] => Err(failure_with_hint(
                format!("$({inside}) is a path of one machine"),
                "paths are relative to the file; write $(find package)/… for others",
            )),
            [command @ ("arg" | "find" | "env" | "optenv"), ..] => Err(failure(format!(
                "$({command} …) needs one name: {}",
                quoted(inside)
            ))),
            [command, ..] => Err(failure_with_hint(
                format!("unknown substitution $({command} …)"),
                known(command, "substitutions", &COMMANDS),
            )),
            [] => Err(failure("the substitution $() is empty")),
        }
    }
}
