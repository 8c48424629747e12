//! Indices of frames and scopes.

/// Index of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct FrameIndex(pub(super) usize);

/// Index of a scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ScopeIndex(pub(super) usize);
