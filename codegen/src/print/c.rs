//! C: functions in C99, and the header of functions that are written in another language.
//!
//! In: a [`Module`], and how names begin. Out: a [`Source`], or the header alone. It never names a value
//! of a program: that is done before.

mod body;
mod comments;
mod declarations;
mod header;
mod literals;
mod names;
mod review;
mod roots;
mod sections;
mod sines;
mod source;
#[cfg(test)]
mod tests;

use super::documentation::Angles;
use crate::formulation::Sines;
use crate::module::Module;
use crate::real::Real;

pub(super) use declarations::results;
pub(super) use header::Header;
pub use names::own;
pub(super) use names::symbols;

/// Functions in C99.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// The header: what the functions are called, what they take and return, in units and frames.
    pub header: String,
    /// The functions themselves, which include the header where it has not been read.
    pub text: String,
}

/// How a robot is written.
#[derive(Clone, Copy, Debug)]
pub struct Writing<'a> {
    /// How all names begin.
    pub prefix: &'a str,
    /// The name by which the source includes the header.
    pub header: &'a str,
    /// What was asked for.
    pub asked: &'a str,
    /// Whether products fuse with sums where the target can: only then are results those of Rust where
    /// that fuses them.
    pub fused: bool,
}

/// How the names of a robot begin where nothing else was asked for: `double pendulum` is
/// `double_pendulum_`.
#[must_use]
pub fn prefix(robot: &str) -> String {
    names::prefix(robot)
}

/// The functions and their header; [`Real::Generic`] is taken for `double`.
#[must_use]
pub fn print(module: &Module, writing: &Writing<'_>) -> Source {
    let angles = match (module.sines, module.scalar) {
        (Sines::Own, real) => Angles::own(real),
        (Sines::Platform, Real::F32) => Angles::As("sinf".to_owned()),
        (Sines::Platform, Real::F64 | Real::Generic) => Angles::As("sin".to_owned()),
    };
    let header = Header {
        prefix: writing.prefix,
        guard: writing.prefix,
        asked: writing.asked,
        angles: &angles,
        needs: Some(&writing.needs()),
    };
    Source {
        header: header.text(module),
        text: source::source(module, writing),
    }
}

impl Writing<'_> {
    /// A name of the file alone.
    fn own(&self, name: &str) -> String {
        own(self.prefix, name)
    }

    /// The macro for a product and a sum.
    fn mul_add(&self) -> String {
        names::constant(self.prefix, "mul_add")
    }

    /// The macro before functions that are not to be inlined.
    fn apart(&self) -> String {
        names::constant(self.prefix, "apart")
    }

    /// What the files need to be compiled.
    fn needs(&self) -> String {
        let bits = if self.fused {
            "where products fuse with sums as HOMOGEN_FMA does"
        } else {
            "where no product fuses with a sum"
        };
        format!(
            "Needs: C99, without -ffast-math. The bits are those of the same functions in Rust {bits}; \
             for that GCC needs -ffp-contract=off, Clang for CUDA as well, and nvcc --fmad=false."
        )
    }
}
