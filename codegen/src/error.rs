//! Every mistake and every doubt about a description, each with its place.
//!
//! In: a place, a sentence, a hint. Out: one [`Errors`] that holds them all, to be shown to a
//! person or handed to the compiler, with the warnings found until then beside them, which may be the cause. It
//! never stops at the first mistake: the stages push, and ask once at the end whether anything was pushed.

use std::fmt;

use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use crate::wording::visible;

/// Where something was written.
#[derive(Clone, Copy, Debug, Default)]
pub enum Place {
    /// Nowhere that could be pointed at: a default, or an option given in code.
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
        /// The file's number among those that are included, from 0.
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
    /// Line and column in the description's file; none where it is not in that one.
    #[must_use]
    pub const fn line_and_column(self) -> Option<(u32, u32)> {
        match self {
            Self::File { line, column } => Some((line, column)),
            Self::Included { .. } | Self::Token(_) | Self::Unknown => None,
        }
    }

    /// What places in files are sorted by: the number of the file, line and column; none where it is in no file.
    #[must_use]
    pub const fn order(self) -> Option<(u32, u32, u32)> {
        match self {
            Self::File { line, column } => Some((0, line, column)),
            Self::Included { file, line, column } => Some((file + 1, line, column)),
            Self::Token(_) | Self::Unknown => None,
        }
    }
}

/// One mistake or one doubt: what is wrong, where, and what to do about it.
#[derive(Clone, Debug)]
pub struct Complaint {
    /// Where the words stand that caused it.
    pub place: Place,
    /// What is wrong, as a sentence without a full stop that names the item.
    pub message: String,
    /// What the user could write instead.
    pub hint: Option<String>,
}

/// The mistakes of one description, in the order in which they were found.
#[derive(Clone, Default)]
pub struct Errors {
    file: Option<String>,
    /// The files that are included, by their numbers.
    included: Vec<String>,
    anchor: Option<Span>,
    complaints: Vec<Complaint>,
    left_out: usize,
    /// What is shown beside mistakes.
    warnings: Vec<Complaint>,
}

/// How many warnings are shown beside mistakes.
const BESIDE: usize = 10;

/// How many mistakes are kept; of the others, which only a broken file of megabytes has, the
/// number.
const KEPT: usize = 1000;

impl Errors {
    /// No mistakes yet, in a description without a file.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Names the file that every [`Place::File`] of this list belongs to, and the token of the
    /// user's code that named it, under which the compiler shows such a mistake.
    pub fn set_file(&mut self, file: impl Into<String>, anchor: Option<Span>) {
        self.file = Some(file.into());
        self.anchor = anchor;
    }

    /// Names the files that the numbers of [`Place::Included`] stand for.
    pub fn set_included(&mut self, files: Vec<String>) {
        self.included = files;
    }

    /// Records a mistake.
    pub fn push(&mut self, place: Place, message: impl Into<String>) {
        self.record(Complaint {
            place,
            message: message.into(),
            hint: None,
        });
    }

    /// Records a mistake and what to do about it.
    pub fn push_with_hint(
        &mut self,
        place: Place,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) {
        let hint = Some(hint.into());
        self.record(Complaint {
            place,
            message: message.into(),
            hint,
        });
    }

    /// Takes over what another list holds; a file named there is kept where none is named here.
    pub fn append(&mut self, other: Errors) {
        self.file = self.file.take().or(other.file);
        self.anchor = self.anchor.or(other.anchor);
        if self.included.is_empty() {
            self.included = other.included;
        }
        self.left_out += other.left_out;
        for complaint in other.complaints {
            self.record(complaint);
        }
        self.warn(other.warnings);
    }

    /// Adds warnings, to be shown where there are mistakes as well; each once.
    pub fn warn(&mut self, warnings: impl IntoIterator<Item = Complaint>) {
        for warning in warnings {
            let place = warning.place.order();
            let is_same = |known: &Complaint| {
                known.message == warning.message && known.place.order() == place
            };
            if self.warnings.len() < KEPT && !self.warnings.iter().any(is_same) {
                self.warnings.push(warning);
            }
        }
    }

    /// The same mistakes with warnings beside them.
    #[must_use]
    pub fn beside(mut self, warnings: impl IntoIterator<Item = Complaint>) -> Self {
        self.warn(warnings);
        self
    }

    /// Records a complaint as a mistake.
    pub fn record(&mut self, complaint: Complaint) {
        if self.complaints.len() < KEPT {
            self.complaints.push(complaint);
        } else {
            self.left_out += 1;
        }
    }

    /// Whether nothing was pushed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.complaints.is_empty()
    }

    /// The mistakes in the order in which they were found; the first thousand, if they are more.
    #[must_use]
    pub fn complaints(&self) -> &[Complaint] {
        &self.complaints
    }

    /// Gives `value` back if nothing was pushed.
    ///
    /// # Errors
    /// All the mistakes, where there are any.
    pub fn into_result<T>(self, value: T) -> Result<T, Errors> {
        if self.is_empty() {
            Ok(value)
        } else {
            Err(self)
        }
    }

    /// One line for a complaint, as editors and people read it:
    /// `arm.urdf:112:7: joint "elbow" has no <axis>`. What cannot be seen is written out:
    /// `\u{202e}`.
    #[must_use]
    pub fn locate(&self, complaint: &Complaint) -> String {
        let message = visible(&complaint.message);
        match (complaint.place, &self.file) {
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

    /// The mistakes as `compile_error!`s, each under the word that caused it.
    #[must_use]
    pub fn to_compile_errors(&self) -> TokenStream {
        let anchor = self.anchor.unwrap_or_else(Span::call_site);
        let last = self.complaints.len().saturating_sub(1);
        let errors = self.complaints.iter().enumerate().map(|(k, complaint)| {
            let span = match complaint.place {
                Place::Token(span) => span,
                Place::File { .. } | Place::Included { .. } | Place::Unknown => anchor,
            };
            let mut message = self.with_hint(complaint, "hint: ");
            // Macros have no warnings of their own.
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

    /// A complaint with its hint in a line of its own.
    fn with_hint(&self, complaint: &Complaint, before: &str) -> String {
        let message = self.locate(complaint);
        match &complaint.hint {
            Some(hint) => format!("{message}\n{before}{}", visible(hint)),
            None => message,
        }
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for complaint in &self.complaints {
            writeln!(out, "error: {}", self.with_hint(complaint, "  hint: "))?;
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

/// The same as for people, because a build script that returns the mistakes shows them so.
impl fmt::Debug for Errors {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(out)?;
        fmt::Display::fmt(self, out)
    }
}

impl std::error::Error for Errors {}
