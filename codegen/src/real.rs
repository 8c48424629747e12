//! Scalar types of generated code, their rounding, and the sines that they use.

/// Scalar type of generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Real {
    /// Every type that implements the runtime's `Scalar`.
    #[default]
    Generic,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl Real {
    /// All types, in the order of the documentation.
    pub const ALL: [Self; 3] = [Self::F32, Self::F64, Self::Generic];

    /// Word in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Generic => "generic",
        }
    }

    /// Unit roundoff u: half the distance from 1 to the next larger number; that of `f64` for generic code.
    #[must_use]
    pub const fn roundoff(self) -> f64 {
        match self {
            Self::F32 => f32::EPSILON as f64 / 2.0,
            Self::F64 | Self::Generic => f64::EPSILON / 2.0,
        }
    }

    /// Relative size below which a pivot counts as rounding error: dependent rows leave less, independent ones more.
    /// That of `f64` for generic code.
    #[must_use]
    pub const fn zero_pivot(self) -> f64 {
        match self {
            Self::F32 => 1.0 / 65_536.0,
            Self::F64 | Self::Generic => 1.0 / 1_073_741_824.0,
        }
    }

    /// Smallest positive normal number; that of `f64` for generic code.
    #[must_use]
    pub const fn smallest(self) -> f64 {
        match self {
            Self::F32 => f32::MIN_POSITIVE as f64,
            Self::F64 | Self::Generic => f64::MIN_POSITIVE,
        }
    }

    /// Nearest number of the type; that of `f64` for generic code.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    pub const fn rounded(self, x: f64) -> f64 {
        match self {
            Self::F32 => x as f32 as f64,
            Self::F64 | Self::Generic => x,
        }
    }

    /// Largest finite number; that of `f64` for generic code.
    #[must_use]
    pub const fn largest(self) -> f64 {
        match self {
            Self::F32 => f32::MAX as f64,
            Self::F64 | Self::Generic => f64::MAX,
        }
    }
}

/// Sines and cosines in generated code, by accuracy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Trigonometry {
    /// Those of the runtime: within one ulp at every angle.
    #[default]
    Runtime,
    /// Those in a file for `core` alone: within one ulp up to a maximum angle.
    Own,
    /// Those of the platform or the user: assumed to be as accurate as [`Self::Runtime`].
    Other,
}

impl Trigonometry {
    /// Maximum magnitude of an angle \[rad\] whose sine and cosine are within one ulp.
    #[must_use]
    pub const fn reach(self, scalar: Real) -> f64 {
        match (self, scalar) {
            (Self::Own, Real::F32) => 3200.0,
            (Self::Own, Real::F64 | Real::Generic) => 2e5,
            (Self::Runtime | Self::Other, _) => f64::INFINITY,
        }
    }
}
