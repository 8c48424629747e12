//! Types of values: a number, or a vector with a lane for each state.
//!
//! In: a scalar type and a number of lanes. Out: types, literals, and the intrinsics that are declared for them.

use crate::real::Real;

/// Type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lanes {
    /// Scalar type: `F32` or `F64`.
    pub real: Real,
    /// Number of lanes.
    pub count: usize,
}

impl Lanes {
    /// Scalar type.
    pub fn number(self) -> &'static str {
        match self.real {
            Real::F32 => "float",
            Real::F64 | Real::Generic => "double",
        }
    }

    /// Size of a scalar [bytes], to which all accesses are aligned.
    pub fn size(self) -> usize {
        match self.real {
            Real::F32 => 4,
            Real::F64 | Real::Generic => 8,
        }
    }

    /// Type of a value.
    pub fn value(self) -> String {
        self.of(self.number())
    }

    /// Type of integers as wide as the scalars.
    pub fn bits(self) -> String {
        self.of(&format!("i{}", 8 * self.size()))
    }

    fn of(self, kind: &str) -> String {
        match self.count {
            1 => kind.to_owned(),
            count => format!("<{count} x {kind}>"),
        }
    }

    /// Number in all lanes, rounded to the type and written as the bits of a double, which LLVM reads for both types.
    pub fn literal(self, value: f64) -> String {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "rounding to the type is the purpose"
        )]
        let rounded = match self.real {
            Real::F32 => f64::from(value as f32),
            Real::F64 | Real::Generic => value,
        };
        self.all(self.number(), &format!("0x{:016X}", rounded.to_bits()))
    }

    /// Integer in all lanes.
    pub fn integer(self, value: u64) -> String {
        self.all(&format!("i{}", 8 * self.size()), &value.to_string())
    }

    fn all(self, kind: &str, value: &str) -> String {
        match self.count {
            1 => value.to_owned(),
            _ => format!("splat ({kind} {value})"),
        }
    }

    /// Type of a comparison.
    pub fn truth(self) -> String {
        self.of("i1")
    }

    /// Suffix of functions for these values; empty for scalars.
    pub fn suffix(self) -> String {
        match self.count {
            1 => String::new(),
            count => format!(".{count}"),
        }
    }

    /// Name of the function for sine and cosine.
    pub fn sin_cos(self) -> String {
        format!("@sin_cos{}", self.suffix())
    }

    /// Name of an intrinsic for these values.
    pub fn intrinsic(self, name: &str) -> String {
        let bits = 8 * self.size();
        match self.count {
            1 => format!("@llvm.{name}.f{bits}"),
            count => format!("@llvm.{name}.v{count}f{bits}"),
        }
    }

    /// Declarations of all intrinsics that a module may call.
    pub fn declarations(self) -> String {
        let value = self.value();
        let declare = |name: &str, arguments: usize| {
            let arguments = vec![value.as_str(); arguments].join(", ");
            format!("declare {value} {}({arguments})\n", self.intrinsic(name))
        };
        let of_one = ["sqrt", "sin", "cos"].map(|name| declare(name, 1));
        of_one.concat() + &declare("fma", 3)
    }
}

#[cfg(test)]
mod tests {
    use super::Lanes;
    use crate::real::Real;

    #[test]
    fn numbers_are_spelled_by_the_bits_of_a_double() {
        let single = |count| Lanes {
            real: Real::F32,
            count,
        };
        assert_eq!(single(1).literal(0.5), "0x3FE0000000000000");
        assert_eq!(single(8).literal(0.1), "splat (float 0x3FB99999A0000000)");
        let double = Lanes {
            real: Real::F64,
            count: 4,
        };
        assert_eq!(double.literal(-0.0), "splat (double 0x8000000000000000)");
        assert_eq!(double.intrinsic("fma"), "@llvm.fma.v4f64");
        assert_eq!(double.value(), "<4 x double>");
    }
}
