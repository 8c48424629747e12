//! The type of a value: a number, or a vector of them with a lane for each state.
//!
//! In: a type of number and a count of lanes. Out: the spelling of types, of numbers, and of the intrinsics that are
//! declared for them. It writes no instruction.

use crate::real::Real;

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lanes {
    /// The type of number: `F32` or `F64`.
    pub real: Real,
    /// How many numbers a value has.
    pub count: usize,
}

impl Lanes {
    /// The type of one number.
    pub fn number(self) -> &'static str {
        match self.real {
            Real::F32 => "float",
            Real::F64 | Real::Generic => "double",
        }
    }

    /// The size of one number [bytes], to which all accesses are aligned.
    pub fn size(self) -> usize {
        match self.real {
            Real::F32 => 4,
            Real::F64 | Real::Generic => 8,
        }
    }

    /// The type of a value.
    pub fn value(self) -> String {
        self.of(self.number())
    }

    /// The type of integers as wide as the value's numbers.
    pub fn bits(self) -> String {
        self.of(&format!("i{}", 8 * self.size()))
    }

    fn of(self, kind: &str) -> String {
        match self.count {
            1 => kind.to_owned(),
            count => format!("<{count} x {kind}>"),
        }
    }

    /// A number in all lanes, rounded to the type: its bits as those of a double, which is how LLVM reads both.
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

    /// An integer in all lanes.
    pub fn integer(self, value: u64) -> String {
        self.all(&format!("i{}", 8 * self.size()), &value.to_string())
    }

    fn all(self, kind: &str, value: &str) -> String {
        match self.count {
            1 => value.to_owned(),
            _ => format!("splat ({kind} {value})"),
        }
    }

    /// The type of a comparison.
    pub fn truth(self) -> String {
        self.of("i1")
    }

    /// What is appended to the names of functions of such values; nothing for one number.
    pub fn suffix(self) -> String {
        match self.count {
            1 => String::new(),
            count => format!(".{count}"),
        }
    }

    /// The name of the function that gives sine and cosine.
    pub fn sin_cos(self) -> String {
        format!("@sin_cos{}", self.suffix())
    }

    /// The name of an intrinsic for values of the type.
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
