//! Errors of an expansion, before their place is known.

/// The reason why something has no value.
#[derive(Clone, Debug)]
pub(super) enum Failure {
    /// An error to report.
    Mistake(Mistake),
    /// The consequence of an error that is reported already.
    Reported,
}

/// An error without its place.
#[derive(Clone, Debug)]
pub(super) struct Mistake {
    /// A sentence without a full stop.
    pub(super) what: String,
    pub(super) hint: Option<String>,
    /// Offset of its cause in the text that was evaluated.
    pub(super) at: usize,
}

/// A failure without a hint.
pub(super) fn failure(what: impl Into<String>) -> Failure {
    Failure::Mistake(Mistake {
        what: what.into(),
        hint: None,
        at: 0,
    })
}

/// A failure with a hint.
pub(super) fn failure_with_hint(what: impl Into<String>, hint: impl Into<String>) -> Failure {
    Failure::Mistake(Mistake {
        what: what.into(),
        hint: Some(hint.into()),
        at: 0,
    })
}
