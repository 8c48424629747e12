//! Why a result has no bound.

/// Why a result has no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Its sines are not promised for every angle that may come.
    Angle,
    /// A number may become larger than the type has one.
    Overflow,
    /// What is divided by, or the root taken of, may be zero.
    Divisor,
}

impl Reason {
    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Angle => "angles leave the range of its sines",
            Self::Overflow => "a number may overflow, as far as ranges tell",
            Self::Divisor => "a divisor may be zero, as far as ranges tell",
        }
    }
}
