//! Processors and the costs of their operations.
//!
//! In: a name and a scalar type. Out: whether products fuse with sums, and for how many cycles each operation occupies
//! an arithmetic unit.

use crate::real::Real;
use crate::wording::known;

/// Processor that code is generated for.
///
/// It decides which algorithms and operations are used, and which costs are printed, never the function that is
/// computed; code for one processor runs on every other. Products fuse with sums only if `Scalar::mul_add` of the
/// runtime can be the instruction: never in a file for `core` alone, because `core` has no fused product on stable
/// compilers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Processor {
    /// Any processor: fused if the processor has the instruction; costs are operation counts.
    #[default]
    Portable,
    /// Arm Cortex-M4F: single precision only, and never fused, since VFMA takes 3 cycles, and VMUL and VADD take 2.
    CortexM4,
    /// Arm Cortex-M7 with a double-precision unit. Not fused: VFMA waits 6 cycles for an addend, VADD takes 3, and code
    /// without the standard library has no access to VFMA.
    CortexM7,
    /// x86-64 without extensions, without fused products.
    X86_64,
    /// x86-64 with AVX2 and FMA, for `-C target-cpu=x86-64-v3` or `native`.
    X86_64V3,
    /// 64-bit Arm, with fused products.
    AArch64,
}

/// Cycles for which an operation occupies an arithmetic unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Costs {
    /// A sum, a difference or a negation.
    pub(crate) add: usize,
    pub(crate) mul: usize,
    /// A fused product and sum; `None` if there is no such instruction.
    pub(crate) fused: Option<usize>,
    pub(crate) div: usize,
    pub(crate) sqrt: usize,
    /// A sine or a cosine: half of the pair.
    pub(crate) turn: usize,
    /// Number of parallel units.
    pub(crate) units: usize,
}

impl Processor {
    /// All processors, in the order of the documentation.
    pub const ALL: [Self; 6] = [
        Self::Portable,
        Self::CortexM4,
        Self::CortexM7,
        Self::X86_64,
        Self::X86_64V3,
        Self::AArch64,
    ];

    /// Name in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            Self::CortexM4 => "cortex-m4",
            Self::CortexM7 => "cortex-m7",
            Self::X86_64 => "x86-64",
            Self::X86_64V3 => "x86-64-v3",
            Self::AArch64 => "aarch64",
        }
    }

    /// The processor with this name.
    ///
    /// # Errors
    /// For an unknown name: a hint that lists the known ones.
    pub fn from_name(name: &str) -> Result<Self, String> {
        let mut all = Self::ALL.into_iter();
        all.find(|processor| processor.name() == name)
            .ok_or_else(|| known(name, "processors", &Self::ALL.map(Self::name)))
    }

    /// True if the processor has instructions for a scalar type.
    #[must_use]
    pub fn has(self, scalar: Real) -> bool {
        (self, scalar) != (Self::CortexM4, Real::F64)
    }

    /// True if a fused product and sum costs no more than both.
    #[must_use]
    pub fn fuses(self, scalar: Real) -> bool {
        let costs = self.costs(scalar);
        costs
            .fused
            .is_some_and(|fused| fused <= costs.mul + costs.add)
    }

    /// Costs by scalar type.
    ///
    /// Sources: the Technical Reference Manual of the Cortex-M4 (Arm DDI 0439, timing of floating-point instructions);
    /// the pipeline of the Cortex-M7 in GCC (`cortex-m7.md`); Skylake in Agner Fog's instruction tables; the Neoverse
    /// N1 in LLVM (`AArch64SchedNeoverseN1.td`). A sine on the M4F and the M7 is half of the instructions counted in
    /// `examples/cortex_m`; elsewhere it is the share of one in a vector, measured on x86-64.
    #[rustfmt::skip]
    pub(crate) const fn costs(self, scalar: Real) -> Costs {
        let single = matches!(scalar, Real::F32);
        match self {
            Self::Portable => Costs { add: 1, mul: 1, fused: Some(2), div: 15, sqrt: 15, turn: 10, units: 1 },
            Self::CortexM4 => Costs { add: 1, mul: 1, fused: None, div: 14, sqrt: 14, turn: 38, units: 1 },
            Self::CortexM7 if single => Costs { add: 1, mul: 1, fused: None, div: 16, sqrt: 16, turn: 34, units: 1 },
            Self::CortexM7 => Costs { add: 1, mul: 3, fused: None, div: 31, sqrt: 31, turn: 68, units: 1 },
            Self::X86_64 if single => Costs { add: 1, mul: 1, fused: None, div: 3, sqrt: 3, turn: 10, units: 2 },
            Self::X86_64 => Costs { add: 1, mul: 1, fused: None, div: 4, sqrt: 6, turn: 10, units: 2 },
            Self::X86_64V3 => Costs { fused: Some(1), ..Self::X86_64.costs(scalar) },
            Self::AArch64 => Costs { add: 1, mul: 1, fused: Some(1), div: 7, sqrt: 7, turn: 10, units: 2 },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Processor;
    use crate::real::Real;

    #[test]
    fn names_are_read_back() {
        for processor in Processor::ALL {
            assert_eq!(Processor::from_name(processor.name()), Ok(processor));
        }
        assert_eq!(
            Processor::from_name("cortex-m5"),
            Err(
                "did you mean \"cortex-m4\"? known processors: portable, cortex-m4, cortex-m7, \
                 x86-64, x86-64-v3 and aarch64"
                    .to_owned()
            )
        );
    }

    /// The model stage divides once by each pivot and multiplies by the reciprocal afterwards.
    #[test]
    fn a_reciprocal_that_two_products_share_costs_no_more_than_two_quotients() {
        for processor in Processor::ALL {
            for scalar in [Real::F32, Real::F64] {
                let costs = processor.costs(scalar);
                assert!(costs.div + 2 * costs.mul <= 2 * costs.div, "{processor:?}");
            }
        }
    }

    #[test]
    fn products_fuse_if_the_instruction_exists_and_pays() {
        let fuse = Processor::ALL.into_iter();
        let fuse: Vec<_> = fuse
            .filter(|processor| processor.fuses(Real::F32))
            .collect();
        assert_eq!(
            fuse,
            [Processor::Portable, Processor::X86_64V3, Processor::AArch64]
        );
        assert!(!Processor::CortexM4.has(Real::F64) && Processor::CortexM7.has(Real::F64));
    }
}
