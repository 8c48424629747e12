//! Errors and warnings about a description, each with its place.
//!
//! The stages report every error to one [`Errors`] and continue; the caller asks once at the end if there are any. The
//! errors are shown to a person or passed to the compiler, together with the warnings found so far, which may explain
//! them.

use std::fmt;

use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use crate::wording::visible;

/// The place of a word in the user's text.
#[derive(Clone, Copy, Debug, Default)]
pub enum Place {
    /// Unknown: a default, or an option set in code.
    #[default]
    Unknown,
    /// A line and a column of the description's file, both counted from 1.
    File {
        /// Line, from 1.
        line: u32,
        /// Column in characters, from 1.
        column: u32,
    },
    /// A line and a column of a file that the description's file includes.
    Included {
        /// The index of the file in the list of included files.
        file: u32,
        /// Line, from 1.
        line: u32,
        /// Column in characters, from 1.
        column: u32,
    },
    /// A token of the user's Rust code.
    Token(Span),
}

impl Place {
    /// Line and column in the description's file; `None` for other places.
    #[must_use]
    pub const fn line_and_column(self) -> Option<(u32, u32)> {
        match self {
            Self::File { line, column } => Some((line, column)),
            Self::Included { .. } | Self::Token(_) | Self::Unknown => None,
        }
    }

    /// The place some columns to the right.
    #[must_use]
    pub(crate) const fn shifted(self, columns: u32) -> Self {
        match self {
            Self::File { line, column } => Self::File {
                line,
                column: column + columns,
            },
            Self::Included { file, line, column } => Self::Included {
                file,
                line,
                column: column + columns,
            },
            Self::Token(_) | Self::Unknown => self,
        }
    }

    /// Key to sort places by: the number of the file, line and column; `None` if the place is not in a file.
    #[must_use]
    pub const fn order(self) -> Option<(u32, u32, u32)> {
        match self {
            Self::File { line, column } => Some((0, line, column)),
            Self::Included { file, line, column } => Some((file + 1, line, column)),
            Self::Token(_) | Self::Unknown => None,
        }
    }
}

/// An error or a warning: what is wrong, where, and what to do.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// The place of the words that caused it.
    pub place: Place,
    /// A sentence without a full stop that names the item.
    pub message: String,
    /// Advice: what to write instead.
    pub hint: Option<String>,
}

/// The errors of one description, in the order in which they were found.
#[derive(Clone, Default)]
pub struct Errors {
    file: Option<String>,
    /// The names of included files, by their indices.
    included: Vec<String>,
    anchor: Option<Span>,
    diagnostics: Vec<Diagnostic>,
    left_out: usize,
    /// Warnings, shown beside errors.
    warnings: Vec<Diagnostic>,
}

/// Maximum number of warnings shown beside errors.
const BESIDE: usize = 10;

/// Maximum number of errors that are kept; further ones, of a broken file of megabytes, are counted.
const KEPT: usize = 1000;

impl Errors {
    /// An empty list, of a description without a file.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the file of every [`Place::File`], and the token that named it in the user's code, under which the compiler
    /// shows such errors.
    pub fn set_file(&mut self, file: impl Into<String>, anchor: Option<Span>) {
        self.file = Some(file.into());
        self.anchor = anchor;
    }

    /// Sets the names of included files, which [`Place::Included`] refers to.
    pub fn set_included(&mut self, files: Vec<String>) {
        self.included = files;
    }

    /// Adds an error.
    pub fn push(&mut self, place: Place, message: impl Into<String>) {
        self.record(Diagnostic {
            place,
            message: message.into(),
            hint: None,
        });
    }

    /// Adds an error with a hint.
    pub fn push_with_hint(
        &mut self,
        place: Place,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) {
        let hint = Some(hint.into());
        self.record(Diagnostic {
            place,
            message: message.into(),
            hint,
        });
    }

    /// Adds the errors of another list; its file is taken over if this list has none.
    pub fn append(&mut self, other: Errors) {
        self.file = self.file.take().or(other.file);
        self.anchor = self.anchor.or(other.anchor);
        if self.included.is_empty() {
            self.included = other.included;
        }
        self.left_out += other.left_out;
        for diagnostic in other.diagnostics {
            self.record(diagnostic);
        }
        self.warn(other.warnings);
    }

    /// The value of a result, unless this list or the result has errors: then both.
    ///
    /// # Errors
    ///
    /// The errors of both.
    pub fn joined<T>(mut self, result: Result<T, Errors>) -> Result<T, Errors> {
        match result {
            Ok(value) => self.into_result(value),
            Err(others) => {
                self.append(others);
                Err(self)
            }
        }
    }

    /// Adds warnings, each once, to be shown if there are errors.
    pub fn warn(&mut self, warnings: impl IntoIterator<Item = Diagnostic>) {
        for warning in warnings {
            let place = warning.place.order();
            let is_same = |known: &Diagnostic| {
                known.message == warning.message && known.place.order() == place
            };
            if self.warnings.len() < KEPT && !self.warnings.iter().any(is_same) {
                self.warnings.push(warning);
            }
        }
    }

    /// The same errors, with warnings beside them.
    #[must_use]
    pub fn beside(mut self, warnings: impl IntoIterator<Item = Diagnostic>) -> Self {
        self.warn(warnings);
        self
    }

    /// The same errors and warnings at other places.
    #[must_use]
    pub(crate) fn placed(mut self, place: impl Fn(Place) -> Place) -> Self {
        let warnings = self.warnings.iter_mut();
        for diagnostic in self.diagnostics.iter_mut().chain(warnings) {
            diagnostic.place = place(diagnostic.place);
        }
        self
    }

    /// Adds a [`Diagnostic`] as an error.
    pub fn record(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() < KEPT {
            self.diagnostics.push(diagnostic);
        } else {
            self.left_out += 1;
        }
    }

    /// True if there are no errors.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// The warnings that are shown if there are errors.
    #[must_use]
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }

    /// The errors, in the order in which they were found; at most the first thousand.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// Returns `value` if there are no errors.
    ///
    /// # Errors
    /// All errors, if there are any.
    pub fn into_result<T>(self, value: T) -> Result<T, Errors> {
        if self.is_empty() {
            Ok(value)
        } else {
            Err(self)
        }
    }

    /// One line for an error or a warning, as editors and people read it: `arm.urdf:112:7: joint "elbow" has no
    /// <axis>`. Invisible characters are escaped: `\u{202e}`.
    #[must_use]
    pub fn locate(&self, diagnostic: &Diagnostic) -> String {
        let message = visible(&diagnostic.message);
        match (diagnostic.place, &self.file) {
            (Place::File { line, column }, Some(file)) => {
                format!("{}:{line}:{column}: {message}", visible(file))
            }
            (Place::Included { file, line, column }, _) => {
                let file = self.included.get(file as usize);
                let file = file.map_or("an included file", String::as_str);
                format!("{}:{line}:{column}: {message}", visible(file))
            }
            (Place::File { line, column }, None) => format!("{line}:{column}: {message}"),
            (_, _) => message.into_owned(),
        }
    }

    /// The errors as `compile_error!`s, each at the word that caused it.
    #[must_use]
    pub fn to_compile_errors(&self) -> TokenStream {
        let anchor = self.anchor.unwrap_or_else(Span::call_site);
        let last = self.diagnostics.len().saturating_sub(1);
        let errors = self.diagnostics.iter().enumerate().map(|(k, diagnostic)| {
            let span = match diagnostic.place {
                Place::Token(span) => span,
                Place::File { .. } | Place::Included { .. } | Place::Unknown => anchor,
            };
            let mut message = self.with_hint(diagnostic, "hint: ");
            // Stable Rust has no warnings of macros, so they go with the last error.
            if k == last {
                for warning in self.warnings.iter().take(BESIDE) {
                    let warning = self.with_hint(warning, "hint: ");
                    message = format!("{message}\nwarning: {warning}");
                }
            }
            quote_spanned!(span=> ::core::compile_error! { #message })
        });
        errors.collect()
    }

    /// A message with its hint on a line of its own.
    fn with_hint(&self, diagnostic: &Diagnostic, before: &str) -> String {
        let message = self.locate(diagnostic);
        match &diagnostic.hint {
            Some(hint) => format!("{message}\n{before}{}", visible(hint)),
            None => message,
        }
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for diagnostic in &self.diagnostics {
            writeln!(out, "error: {}", self.with_hint(diagnostic, "  hint: "))?;
        }
        if self.left_out > 0 {
            writeln!(out, "and {} more", self.left_out)?;
        }
        if self.is_empty() {
            return Ok(());
        }
        for warning in self.warnings.iter().take(BESIDE) {
            writeln!(out, "warning: {}", self.with_hint(warning, "  hint: "))?;
        }
        let more = self.warnings.len().saturating_sub(BESIDE);
        if more > 0 {
            writeln!(out, "and {more} more warnings")?;
        }
        Ok(())
    }
}

/// Equal to `Display`, because build scripts print returned errors by `Debug`.
impl fmt::Debug for Errors {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(out)?;
        fmt::Display::fmt(self, out)
    }
}

impl std::error::Error for Errors {}
