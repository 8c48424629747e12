//! What is known while a file is read.
//!
//! A shared noun: each part of the reader adds to it what it reads, and finds in it what others have read.

use std::path::PathBuf;

use super::assets::Meshes;
use super::class::Defaults;
use super::lost::Met;
use super::names::Names;
use super::settings::Compiler;
use super::tree::Tree;
use crate::description::xml::element::Reader;

/// What reading has found so far.
pub(super) struct Mjcf<'a> {
    pub(super) reader: Reader<'a, 'a>,
    pub(super) compiler: Compiler,
    pub(super) defaults: Defaults<'a>,
    pub(super) tree: Tree,
    pub(super) loop_names: Names,
    pub(super) meshes: Meshes<'a>,
    pub(super) met: Met,
    /// Where other files are looked for.
    pub(super) folder: Option<PathBuf>,
    /// Other files that were read, beside those that are included.
    pub(super) beside: Vec<PathBuf>,
}
