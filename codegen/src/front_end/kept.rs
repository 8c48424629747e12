//! Expansions that are kept from one run of the compiler to the next.
//!
//! In: all that an expansion depends on. Out: the expansion, if a folder has it. The compiler expands every macro in
//! each of its runs, even if nothing of it has changed, and an expansion takes far longer than reading it back. A file
//! that is missing, of other tokens or engines, or cut short is as good as none, and so is a folder that cannot be
//! written.

use std::cmp::Reverse;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;
use syn::LitStr;

use crate::description::Source;
use crate::description::fingerprint::fingerprint;

/// The most bytes in the folder: a few hundred arms, or a dozen humanoids with all functions.
const MOST: u64 = 256 << 20;

/// A folder of expansions by one engine.
pub struct Kept<'k> {
    /// The folder, which need not exist.
    pub folder: &'k Path,
    /// The name of the engine, which no other engine has.
    pub engine: &'k str,
    /// Parses tokens. The compiler's own parser is faster by far than [`FromStr`](std::str::FromStr) of
    /// [`TokenStream`], which parses twice.
    pub parse: fn(&str) -> Option<TokenStream>,
}

/// The code of a robot, and the texts of its warnings.
pub(super) struct Expansion {
    pub(super) robot: TokenStream,
    pub(super) warnings: Vec<String>,
}

/// The place of an expansion in the folder.
pub(super) struct CacheEntry<'k> {
    kept: &'k Kept<'k>,
    /// All that the expansion depends on: the engine, the macro, its tokens; then the files of the description.
    depends_on: String,
}

impl Kept<'_> {
    /// The place of an expansion by a macro; `None` for tokens that text does not hold.
    pub(super) fn entry(&self, of: &str, tokens: &TokenStream) -> Option<CacheEntry<'_>> {
        is_text(tokens).then(|| CacheEntry {
            kept: self,
            depends_on: format!("{}\n{of}\n{tokens}\n", self.engine),
        })
    }
}

/// False if some tokens are grouped by no delimiter, as `macro_rules` does.
fn is_text(tokens: &TokenStream) -> bool {
    tokens.clone().into_iter().all(|token| match token {
        TokenTree::Group(group) => group.delimiter() != Delimiter::None && is_text(&group.stream()),
        _ => true,
    })
}

impl CacheEntry<'_> {
    /// The same of a description.
    pub(super) fn of(mut self, source: &Source) -> Self {
        let beside = source.beside.iter().map(|path| path.to_string_lossy());
        for file in source.file.iter().map(Into::into).chain(beside) {
            let _ = writeln!(self.depends_on, "{file}");
        }
        let _ = writeln!(self.depends_on, "{:016x}", source.hash);
        self
    }

    fn path(&self) -> PathBuf {
        let name = fingerprint(self.depends_on.as_bytes());
        self.kept.folder.join(format!("{name:016x}"))
    }

    /// The expansion, if it has been kept.
    pub(super) fn find(&self) -> Option<Expansion> {
        let text = fs::read_to_string(self.path()).ok()?;
        let text = text.strip_prefix(&self.depends_on)?;
        let (length, code) = text.split_once('\n')?;
        if length.parse() != Ok(code.len()) {
            return None;
        }
        let mut tokens = (self.kept.parse)(code)?.into_iter();
        let (Some(TokenTree::Group(warnings)), Some(TokenTree::Group(robot))) =
            (tokens.next(), tokens.next())
        else {
            return None;
        };
        let warnings = warnings.stream().into_iter().map(|warning| {
            let warning: LitStr = syn::parse2(warning.into()).ok()?;
            Some(warning.value())
        });
        Some(Expansion {
            robot: robot.stream(),
            warnings: warnings.collect::<Option<_>>()?,
        })
    }

    /// Keeps an expansion, and removes the oldest ones where there are too many.
    pub(super) fn keep(&self, Expansion { robot, warnings }: &Expansion) {
        let code = quote! { { #(#warnings)* } { #robot } }.to_string();
        let (folder, path) = (self.kept.folder, self.path());
        // Other runs of the compiler read and write at the same time: a file is complete when it gets its name.
        let part = path.with_extension(format!("{}.part", std::process::id()));
        let text = format!("{}{}\n{code}", self.depends_on, code.len());
        let written = fs::create_dir_all(folder)
            .and_then(|()| fs::write(&part, text))
            .and_then(|()| fs::rename(&part, &path));
        if written.is_err() {
            let _ = fs::remove_file(&part);
            return;
        }
        let files = fs::read_dir(folder).into_iter().flatten().flatten();
        let files = files.filter_map(|file| {
            let about = file.metadata().ok()?;
            Some((about.modified().ok()?, about.len(), file.path()))
        });
        for path in surplus(files.collect()) {
            let _ = fs::remove_file(path);
        }
    }
}

/// The oldest of some files with their lengths, beyond the most bytes; never the newest.
fn surplus(mut files: Vec<(SystemTime, u64, PathBuf)>) -> impl Iterator<Item = PathBuf> {
    files.sort_by_key(|(modified, ..)| Reverse(*modified));
    let mut bytes = 0;
    files.into_iter().filter_map(move |(_, length, path)| {
        let fits = bytes == 0 || bytes + length <= MOST;
        bytes += length;
        (!fits).then_some(path)
    })
}

#[cfg(test)]
mod tests;
