//! The command that writes a file again.
//!
//! In: the options of a [`Builder`], and the file that it reads. Out: a line for a shell. It says every option that
//! there is, so that equal lines make equal files; of folders it says nothing.

use std::fmt::Write;
use std::num::NonZeroUsize;

use super::Builder;
use crate::description::Name;
use crate::description::fingerprint::fingerprint;
use crate::module::Module;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::Parameter;
use crate::wording::code;

/// The version of the format of generated files: another one where what a program reads of their heads, their names
/// or their layout changes.
pub const FORMAT: u32 = 1;

/// What the files are written in.
#[derive(Clone, Copy, Debug)]
pub(super) enum Language<'a> {
    Rust,
    /// With the name by which the source includes its header.
    C(&'a str),
    /// With the lanes of a vector.
    Llvm(NonZeroUsize),
}

impl Builder {
    /// What the head of a file says was asked for: the command, with a hash by which two files tell whether it was
    /// the same.
    pub(super) fn asked(&self, module: &Module, language: Language<'_>) -> String {
        let file = module.about.source.as_ref().map(|(file, _)| file.as_str());
        let command = self.command(file, language);
        let hash = fingerprint(command.as_bytes());
        let command = code(&command);
        format!("Made by {command} (FNV-1a {hash:016x}), in format {FORMAT}.")
    }

    /// The command that writes the file again.
    fn command(&self, file: Option<&str>, language: Language<'_>) -> String {
        let mut command = Command("homogen generate".to_owned());
        match file {
            // What begins with a dash is no option.
            Some(file) if file.starts_with('-') => command.word(&format!("./{file}")),
            // What was standard input is so again.
            Some("<stdin>") | None => command.word("-"),
            Some(file) => command.word(file),
        }
        self.robot(&mut command);
        self.functions(&mut command);
        let request = &self.request;
        match (request.scalar, &request.runtime) {
            (Real::F32, _) => command.option("scalar", "f32"),
            (Real::F64, Some(_)) => command.option("scalar", "f64"),
            _ => {}
        }
        for parameter in &request.parameters {
            command.option("field", &field(parameter));
            if let Some([least, most]) = parameter.range {
                command.option("range", &format!("{}={least}..{most}", parameter.field));
            }
        }
        command.switch("prepare", request.prepare);
        command.switch("batch", request.batch);
        if let Some(most) = request.section {
            command.option("section", &most.to_string());
        }
        if let Some(path) = &request.runtime {
            command.option("runtime", &spelled(path));
        }
        if let Some(path) = &self.library.sin_cos {
            command.option("sin-cos", &spelled(path));
        }
        if let Some(prefix) = &self.library.c_prefix {
            command.option("extern-c", prefix);
        }
        if let Some(name) = &self.name {
            command.option("name", &name.to_string());
        }
        command.switch("ascii", self.ascii);
        match language {
            Language::Rust => {}
            Language::C(header) => {
                command.option("language", "c");
                let source = header.strip_suffix(".h").unwrap_or(header);
                command.option("output", &format!("{source}.c"));
            }
            Language::Llvm(lanes) => {
                command.option("language", "llvm");
                command.option("lanes", &lanes.to_string());
            }
        }
        let Command(text) = command;
        text
    }

    /// Which robot, and which part of it.
    fn robot(&self, command: &mut Command) {
        let request = &self.request;
        command.names("base", &request.base);
        command.switch("floating", request.floating);
        command.names("tip", &request.tip);
        command.switch("path-only", request.path_only);
        for (joint, at) in &request.lock {
            let at = at.map_or_else(String::new, |at| format!("={}", at.value));
            command.option("lock", &format!("{}{at}", joint.text));
        }
        command.names("drop", &request.drop);
        for text in &self.loops {
            command.option("loop", text);
        }
        command.names("actuated", &request.actuated);
        if let Some(gravity) = request.gravity {
            let [x, y, z] = gravity.map(|entry| entry.value);
            command.option("gravity", &format!("{x},{y},{z}"));
        }
        command.names("external", &request.external);
        command.switch("external-in-frame-0", request.external_in_frame_0);
        command.switch("friction", request.friction);
        command.switch("rotors", request.rotors);
        for (joint, part, numbers) in &request.drives {
            let numbers = numbers.iter().map(|number| number.value.to_string());
            let numbers: Vec<String> = numbers.collect();
            let said = format!("--{}={}={}", part.word(), joint.text, numbers.join(","));
            command.word(&said);
        }
        command.switch("exact", request.exact);
        command.switch("strict", request.strict);
        if request.processor != Processor::Portable {
            command.option("processor", request.processor.name());
        }
        let formulation = request.formulation.words().join(",");
        if !formulation.is_empty() {
            let words = formulation.replace(" = ", "=").replace('_', "-");
            command.option("formulation", &words);
        }
    }

    fn functions(&self, command: &mut Command) {
        let items = self.request.functions.iter().map(|functions| {
            let names = functions.iter().map(|function| function.name());
            names.collect::<Vec<_>>().join("+")
        });
        let items: Vec<String> = items.collect();
        if !items.is_empty() {
            command.option("functions", &items.join(","));
        }
        command.names("frames", &self.request.frames);
    }
}

/// `payload=mass_of:hand`.
fn field(parameter: &Parameter) -> String {
    let item = parameter.target.item();
    let item = item.map_or_else(String::new, |name| format!(":{}", name.text));
    format!("{}={}{item}", parameter.field, parameter.target.key())
}

/// A path without spaces.
fn spelled(path: &proc_macro2::TokenStream) -> String {
    path.to_string().replace(' ', "")
}

/// A line for a shell.
struct Command(String);

impl Command {
    /// A word, in quotes where the shell would read something else.
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

    fn names<'n>(&mut self, option: &str, names: impl IntoIterator<Item = &'n Name>) {
        for name in names {
            self.option(option, &name.text);
        }
    }
}
