//! State of the reader, shared by its parts.

use std::path::PathBuf;

use super::model::Model;
use super::names::Names;
use super::parts::ModelId;
use super::tree::Tree;
use super::unmodelled::Noted;
use crate::description::xml::element::Reader;
use crate::list::List;

/// State of the reader.
pub(super) struct Mjcf<'a> {
    pub(super) reader: Reader<'a, 'a>,
    /// The model of the first file, and the models that may be attached.
    pub(super) models: List<ModelId, Model<'a>>,
    /// The model whose elements are being read.
    pub(super) current: ModelId,
    /// The number of elements in the trees of bodies that are listed.
    pub(super) parts: usize,
    /// The number of copies and attachments made so far.
    pub(super) copies: usize,
    pub(super) tree: Tree,
    pub(super) loop_names: Names,
    pub(super) noted: Noted,
    /// The folder of the first file, which paths of other files are relative to.
    pub(super) folder: Option<PathBuf>,
    /// Paths of further files that were read, such as meshes; included files are not among them.
    pub(super) beside: Vec<PathBuf>,
}

impl<'a> Mjcf<'a> {
    /// The model whose elements are being read.
    pub(super) fn model(&self) -> &Model<'a> {
        &self.models[self.current]
    }

    pub(super) fn model_mut(&mut self) -> &mut Model<'a> {
        &mut self.models[self.current]
    }

    /// Reads elements of a model.
    pub(super) fn within<T>(&mut self, model: ModelId, read: impl FnOnce(&mut Self) -> T) -> T {
        let around = std::mem::replace(&mut self.current, model);
        let found = read(self);
        self.current = around;
        found
    }
}
