//! A model: the first file with its included files, or a model that may be attached to it.
//!
//! Each model is read by its own settings, defaults and assets, wherever its elements are attached.

use std::collections::{HashMap, HashSet};

use super::assets::Assets;
use super::class::Defaults;
use super::element::Element;
use super::parts::{ModelId, Parts};
use super::settings::{Compiler, Gravity};

/// A model.
pub(super) struct Model<'a> {
    /// The root element of its first file.
    pub(super) root: Element<'a>,
    pub(super) compiler: Compiler,
    pub(super) defaults: Defaults<'a>,
    pub(super) assets: Assets<'a>,
    pub(super) gravity: Gravity,
    /// The models that it may attach, by name.
    pub(super) attachable: HashMap<String, ModelId>,
    /// The prefixes with which it attaches each model.
    pub(super) attached: HashMap<ModelId, HashSet<String>>,
    /// Its tree of bodies.
    pub(super) parts: Parts<'a>,
}

impl<'a> Model<'a> {
    /// A model of which nothing is read yet.
    pub(super) fn new(root: Element<'a>) -> Self {
        Self {
            root,
            compiler: Compiler::default(),
            defaults: Defaults::none(),
            assets: Assets::default(),
            gravity: Gravity::default(),
            attachable: HashMap::new(),
            attached: HashMap::new(),
            parts: Parts::default(),
        }
    }
}
