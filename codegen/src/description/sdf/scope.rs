//! Names of a model: its links, joints, frames and nested models.

use std::collections::HashMap;

use super::index::{FrameIndex, ScopeIndex};

/// The word between a model and a name in it.
pub(super) const BETWEEN: &str = "::";

/// The frame of the model itself.
pub(super) const MODEL: &str = "__model__";

/// The fixed frame.
pub(super) const WORLD: &str = "world";

/// The names in a model.
pub(super) struct Scope {
    /// The frame of the model.
    pub(super) model: FrameIndex,
    /// Text before the names of links and joints: empty, or that of the models around them.
    pub(super) prefix: String,
    pub(super) names: HashMap<String, FrameIndex>,
    pub(super) models: HashMap<String, ScopeIndex>,
    /// The scope that has the names of this model, if it is merged into another.
    pub(super) merged: Option<ScopeIndex>,
}
