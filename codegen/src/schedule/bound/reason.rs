//! Reasons for the lack of a bound.

/// Reason why a result has no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// An angle may leave the range in which its sine is accurate.
    Angle,
    /// A value may exceed the range of the type.
    Overflow,
    /// A divisor or the argument of a root may be zero.
    Divisor,
}

impl Reason {
    /// Text for comments.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Angle => "angles leave the range of its sines",
            Self::Overflow => "a number may overflow within the range",
            Self::Divisor => "a divisor may be zero within the range",
        }
    }
}
