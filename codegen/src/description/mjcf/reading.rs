//! State of the reader, shared by its parts.

use std::path::PathBuf;

use super::assets::Assets;
use super::class::Defaults;
use super::names::Names;
use super::settings::Compiler;
use super::tree::Tree;
use super::unmodelled::Noted;
use crate::description::xml::element::Reader;

/// State of the reader.
pub(super) struct Mjcf<'a> {
    pub(super) reader: Reader<'a, 'a>,
    pub(super) compiler: Compiler,
    pub(super) defaults: Defaults<'a>,
    pub(super) tree: Tree,
    pub(super) loop_names: Names,
    pub(super) assets: Assets<'a>,
    pub(super) noted: Noted,
    /// The folder of the first file, which paths of other files are relative to.
    pub(super) folder: Option<PathBuf>,
    /// Paths of further files that were read, such as meshes; included files are not among them.
    pub(super) beside: Vec<PathBuf>,
}
