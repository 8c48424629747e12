//! The command line that writes a file again.
//!
//! It has every option of the [`Builder`], so that equal commands make equal files. Folders are left out.

use std::fmt::Write;
use std::num::NonZeroUsize;

use super::Builder;
use crate::description::fingerprint::fingerprint;
use crate::description::{Name, Number};
use crate::joint::actuator::ActuatorQuantity;
use crate::module::Module;
use crate::print::arrays::Order;
use crate::request::Parameter;
use crate::request::setting::SETTINGS;
use crate::request::setting::text::{numbers, spelled};
use crate::wording::code;

/// Version of the format of generated files; it changes if heads, names or layouts change for programs that read them.
pub const FORMAT: u32 = 1;

/// Language of the file.
#[derive(Clone, Copy, Debug)]
pub enum Language<'a> {
    /// For `core` alone, or with the runtime.
    Rust,
    /// With the name of the header in `#include`.
    C(&'a str),
    /// With the name of the file and the order of six numbers.
    Cpp(&'a str, Order),
    /// With the number of lanes of a vector.
    Llvm(NonZeroUsize),
    /// With the order of six numbers.
    Python(Order),
}

impl Builder {
    /// The line in the head of a file: the command, with a hash that shows if two files were made by the same one.
    pub(super) fn asked(&self, module: &Module, language: Language<'_>) -> String {
        let file = module.about.source.file.as_deref();
        let command = self.command(file, language);
        let hash = fingerprint(command.as_bytes());
        let command = code(&command);
        format!("Made by {command} (FNV-1a {hash:016x}), in format {FORMAT}.")
    }

    /// The command that writes the file again.
    #[doc(hidden)]
    #[must_use]
    pub fn command(&self, file: Option<&str>, language: Language<'_>) -> String {
        let mut command = self.words("homogen generate", file);
        match language {
            Language::Rust => {}
            Language::C(header) => {
                command.option("language", "c");
                let source = header.strip_suffix(".h").unwrap_or(header);
                command.option("output", &format!("{source}.c"));
            }
            Language::Cpp(file, order) => {
                command.option("language", "cpp");
                if order == Order::LinearFirst {
                    command.option("order", "linear-first");
                }
                command.option("output", file);
            }
            Language::Llvm(lanes) => {
                command.option("language", "llvm");
                command.option("lanes", &lanes.to_string());
            }
            Language::Python(order) => {
                command.option("language", "python");
                if order == Order::AngularFirst {
                    command.option("order", "angular-first");
                }
            }
        }
        let Command(text) = command;
        text
    }

    /// The command that writes a folder with the robot: another program, such as `homogen new crate`, with the same
    /// options.
    #[doc(hidden)]
    #[must_use]
    pub fn command_of(&self, program: &str, file: Option<&str>, folder: &str) -> String {
        let mut command = self.words(program, file);
        command.option("output", folder);
        let Command(text) = command;
        text
    }

    /// A program with the description and all options.
    fn words(&self, program: &str, file: Option<&str>) -> Command {
        let mut command = Command(program.to_owned());
        match file {
            // A file name that begins with a dash would be read as an option.
            Some(file) if file.starts_with('-') => command.word(&format!("./{file}")),
            // Standard input again.
            Some("<stdin>") | None => command.word("-"),
            Some(file) => command.word(file),
        }
        let mut request = self.request.clone();
        for setting in &SETTINGS {
            let name = setting.flag_name();
            for value in setting.values(&mut request) {
                match value {
                    Some(value) if setting.may_stand_alone() => {
                        command.word(&format!("--{name}={value}"));
                    }
                    Some(value) => command.option(&name, &value),
                    None => command.switch(&name, true),
                }
            }
            match setting.key {
                // The first of two numbers for the same quantity counts, whatever options are between them.
                "rotors" => command.actuators(&request.actuators),
                "scalar" => command.fields(&request.parameters),
                _ => {}
            }
        }
        if let Some(path) = &self.core_functions.sin_cos {
            command.option("sin-cos", &spelled(path));
        }
        if let Some(prefix) = &self.core_functions.c_prefix {
            command.option("extern-c", prefix);
        }
        if let Some(name) = &self.name {
            command.option("name", &name.to_string());
        }
        command.switch("ascii", self.ascii);
        command
    }
}

/// A command line for a shell.
struct Command(String);

impl Command {
    /// Adds a word, quoted if the shell would change it.
    fn word(&mut self, word: &str) {
        let plain = |letter: char| letter.is_ascii_alphanumeric() || "-_./,:=+@%".contains(letter);
        if !word.is_empty() && word.chars().all(plain) {
            let _ = write!(self.0, " {word}");
        } else {
            // Writing to a string cannot fail.
            let _ = write!(self.0, " '{}'", word.replace('\'', r"'\''"));
        }
    }

    fn option(&mut self, name: &str, value: &str) {
        if value.starts_with('-') {
            self.word(&format!("--{name}={value}"));
        } else {
            self.word(&format!("--{name}"));
            self.word(value);
        }
    }

    fn switch(&mut self, name: &str, is_on: bool) {
        if is_on {
            self.word(&format!("--{name}"));
        }
    }

    fn actuators(&mut self, actuators: &[(Name, ActuatorQuantity, Vec<Number>)]) {
        for (joint, part, values) in actuators {
            let (part, values) = (part.word(), numbers(values));
            self.word(&format!("--{part}={}={values}", joint.text));
        }
    }

    /// `--field payload=mass_of:hand`, and its range.
    fn fields(&mut self, parameters: &[Parameter]) {
        for Parameter {
            field,
            target,
            range,
        } in parameters
        {
            let item = target.item();
            let item = item.map_or_else(String::new, |name| format!(":{}", name.text));
            self.option("field", &format!("{field}={}{item}", target.key()));
            if let Some([least, most]) = range {
                self.option("range", &format!("{field}={least}..{most}"));
            }
        }
    }
}
