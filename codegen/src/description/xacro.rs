//! xacro, the macro language of ROS for URDF.
//!
//! Expands the text of a file and the files that it includes to URDF, as the tool `xacro` does: properties, macros,
//! blocks, conditions, included files, arguments, YAML files and expressions. The reader of URDF reads
//! the result; its errors have the places of the user's files. An expansion reads no environment and no file outside
//! its packages, and its time, memory and depth are bounded.

mod budget;
mod call;
mod element;
mod expansion;
mod expression;
mod failure;
mod files;
mod include;
mod property;
mod scope;
mod substitution;
mod text;
mod tree;
mod write;
mod yaml;

use std::collections::HashMap;
use std::path::Path;
use std::thread;

use proc_macro2::Span;

use self::budget::{Budget, FEW_LEVELS, MOST_LEVELS, STACK};
use self::expansion::{Expansion, Report, XacroArgument};
use self::files::Files;
use self::tree::{FileId, Origin};
use self::write::Fragment;
use super::fingerprint::fingerprint;
use super::position::{Positions, Segment, Segments};
use super::xml::{self, plain};
use super::{Description, FileFormat, Given, Source, urdf};
use crate::error::{Diagnostic, Errors, Place};
use crate::wording::{list, quoted};

/// A text of URDF, with the places of its words and its sources.
struct Urdf {
    text: String,
    segments: Segments,
    source: Source,
    warnings: Vec<Diagnostic>,
}

/// Reads the text of the file `file` in `folder`; `anchor` is the token that named the file, for the compiler.
///
/// A description returned together with errors is partial: good for counting joints, not for computing.
pub fn read(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, anchor);
    let urdf = expand(text, file, folder, given, errors)?;
    let source = Source {
        anchor,
        ..urdf.source
    };
    let positions = Positions::of_expanded(&urdf.text, urdf.segments);
    urdf::read_at(&positions, source, urdf.warnings, errors)
}

/// The URDF that a file expands to.
pub fn expanded(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    errors: &mut Errors,
) -> Option<String> {
    errors.set_file(file, None);
    expand(text, file, folder, given, errors).map(|urdf| {
        errors.warn(urdf.warnings);
        urdf.text
    })
}

fn expand(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    errors: &mut Errors,
) -> Option<Urdf> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    // Errors of the first file's XML are those of any XML file.
    xml::parse(
        &plain::plain(text),
        &Positions::new(text),
        "a xacro file begins with <robot name=\"…\">",
        errors,
    )?;
    let Outcome {
        files,
        arguments,
        errors: found,
        warnings,
        written,
    } = on_a_large_stack(text, file, folder, given);
    errors.set_included(files.included());
    let all = (0..files.count()).map(|file| files.positions(FileId(file)));
    let all: Vec<Positions<'_>> = all.collect();
    let place = |origin: Origin| all[origin.file.0].place(origin.offset);
    let diagnostic = |report: Report| Diagnostic {
        place: place(report.origin),
        message: report.what,
        hint: report.hint,
    };
    let mut warnings: Vec<Diagnostic> = warnings.into_iter().map(diagnostic).collect();
    warnings.extend(unused(&arguments));
    if !found.is_empty() {
        errors.warn(warnings);
        for report in found {
            errors.record(diagnostic(report));
        }
        return None;
    }
    let (text, fragments) = written?;
    let segments = fragments.into_iter().map(|fragment| Segment {
        start: fragment.start,
        place: place(fragment.origin),
        is_verbatim: fragment.is_verbatim,
    });
    Some(Urdf {
        segments: segments.collect(),
        source: Source {
            file: Some(file.to_owned()),
            format: Some(FileFormat::Xacro),
            anchor: None,
            included: files.included(),
            beside: files.beside(),
            hash: fingerprint(text.as_bytes()),
        },
        text,
        warnings,
    })
}

/// Result of an expansion.
struct Outcome {
    files: Files,
    arguments: HashMap<String, XacroArgument>,
    errors: Vec<Report>,
    warnings: Vec<Report>,
    /// The text of URDF, with the places of its parts; `None` if the first file is no XML.
    written: Option<(String, Vec<Fragment>)>,
}

/// The result of [`elements`], on a stack for deep recursions of macros where the platform has threads.
fn on_a_large_stack(text: &str, file: &str, folder: Option<&Path>, given: &Given) -> Outcome {
    let ended = thread::scope(|scope| {
        let large = thread::Builder::new().stack_size(STACK);
        let run = || elements(text, file, folder, given, MOST_LEVELS);
        let spawned = large.spawn_scoped(scope, run);
        spawned.ok().and_then(|thread| thread.join().ok())
    });
    ended.unwrap_or_else(|| elements(text, file, folder, given, FEW_LEVELS))
}

/// Expands the elements of a file.
fn elements(
    text: &str,
    file: &str,
    folder: Option<&Path>,
    given: &Given,
    levels: usize,
) -> Outcome {
    let arguments = given.arguments.iter().map(|(name, value)| {
        let argument = XacroArgument {
            value: value.clone(),
            is_given: true,
            is_used: false,
        };
        (name.clone(), argument)
    });
    let files = Files::new(text, file, folder, given);
    let mut expansion = Expansion::new(files, arguments.collect(), Budget::new(levels));
    let first = FileId(0);
    let here = expansion.scopes.inside(None);
    let written = match expansion.root(first) {
        Ok(root) => Some(write::write(&expansion.expand(&root, here))),
        Err(failure) => {
            let offset = 0;
            expansion.report(
                Origin {
                    file: first,
                    offset,
                },
                failure,
            );
            None
        }
    };
    Outcome {
        files: expansion.files,
        arguments: expansion.arguments,
        errors: expansion.errors,
        warnings: expansion.warnings,
        written,
    }
}

/// The warning of given arguments that the file does not have.
fn unused(arguments: &HashMap<String, XacroArgument>) -> Option<Diagnostic> {
    let names = |is_used: bool| {
        let names = arguments
            .iter()
            .filter(|(_, argument)| argument.is_used == is_used);
        let mut names: Vec<String> = names.map(|(name, _)| quoted(name)).collect();
        names.sort_unstable();
        names
    };
    let left = names(false);
    if left.is_empty() {
        return None;
    }
    let known = names(true);
    let hint = if known.is_empty() {
        "the file has no arguments".to_owned()
    } else {
        format!("its arguments: {}", list(known.iter().map(String::as_str)))
    };
    Some(Diagnostic {
        place: Place::Unknown,
        message: format!(
            "the file does not use the given {}",
            list(left.iter().map(String::as_str))
        ),
        hint: Some(hint),
    })
}

#[cfg(test)]
mod tests;
