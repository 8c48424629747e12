//! The type of number that generated code computes with, and the sines that it calls.
//!
//! A shared noun: names, and what an operation of the type can lose. It never knows who asked for it.

/// The type of number in generated code.
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
    /// All of them, in the order of the documentation.
    pub const ALL: [Self; 3] = [Self::F32, Self::F64, Self::Generic];

    /// The word in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Generic => "generic",
        }
    }

    /// Half the distance from 1 to the next larger number; of `f64` where any type is meant.
    #[must_use]
    pub const fn roundoff(self) -> f64 {
        match self {
            Self::F32 => f32::EPSILON as f64 / 2.0,
            Self::F64 | Self::Generic => f64::EPSILON / 2.0,
        }
    }

    /// Which part of the whole a pivot may be that is left by rounding: what depends on others has no more,
    /// and what does not has more. That of `f64` where any type is meant.
    #[must_use]
    pub const fn vanishing(self) -> f64 {
        match self {
            Self::F32 => 1.0 / 65_536.0,
            Self::F64 | Self::Generic => 1.0 / 1_073_741_824.0,
        }
    }

    /// The smallest positive number of full precision; of `f64` where any type is meant.
    #[must_use]
    pub const fn smallest(self) -> f64 {
        match self {
            Self::F32 => f32::MIN_POSITIVE as f64,
            Self::F64 | Self::Generic => f64::MIN_POSITIVE,
        }
    }

    /// The nearest number of the type; of `f64` where any type is meant.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    pub const fn rounded(self, x: f64) -> f64 {
        match self {
            Self::F32 => x as f32 as f64,
            Self::F64 | Self::Generic => x,
        }
    }

    /// The largest number; of `f64` where any type is meant.
    #[must_use]
    pub const fn largest(self) -> f64 {
        match self {
            Self::F32 => f32::MAX as f64,
            Self::F64 | Self::Generic => f64::MAX,
        }
    }
}

/// Which sines and cosines generated code calls: how exact they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Trigonometry {
    /// The runtime's: within one unit in the last place at every angle.
    #[default]
    Runtime,
    /// Those that a file for `core` alone brings along: the same up to an angle.
    Own,
    /// The platform's, or a function that the user names: taken to be as exact.
    Other,
}

impl Trigonometry {
    /// The greatest magnitude of an angle \[rad\] whose sine and cosine are within one unit in the last
    /// place, in the type.
    #[must_use]
    pub const fn reach(self, scalar: Real) -> f64 {
        match (self, scalar) {
            (Self::Own, Real::F32) => 3200.0,
            (Self::Own, Real::F64 | Real::Generic) => 2e5,
            (Self::Runtime | Self::Other, _) => f64::INFINITY,
        }
    }
}
