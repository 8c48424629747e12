//! C: functions in C99, and headers for functions in another language.
//!
//! In: a [`Module`] and a prefix for names. Out: a [`CSource`], a source for each function, or the header alone; on
//! request with `CasADi`'s external interface.

mod acados;
mod body;
mod casadi;
mod comments;
pub mod cpp;
mod declarations;
mod header;
mod literals;
mod names;
mod results;
mod review;
mod roots;
mod sections;
mod sines;
mod source;
mod steps;
#[cfg(test)]
mod tests;

use super::documentation::SineAngles;
use crate::formulation::Sines;
use crate::module::Module;
use crate::real::Real;
use crate::request::ForC;
use crate::space::Order;

pub(super) use declarations::results;
pub(super) use header::Header;
pub use names::own;
pub(super) use names::symbols;
pub use steps::check as check_steps;

/// Functions in C99.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CSource {
    /// The header: declarations with units and frames.
    pub header: String,
    /// The source, which includes the header unless it has been included before.
    pub text: String,
}

/// Options of the output.
#[derive(Clone, Copy, Debug)]
pub struct COptions<'a> {
    /// Prefix of all names.
    pub prefix: &'a str,
    /// Name by which the source includes the header.
    pub header: &'a str,
    /// The request.
    pub asked: &'a str,
    /// True if products fuse with sums where the target has the instruction; then results are those of Rust with fused
    /// operations.
    pub fused: bool,
    /// Parts beside the functions.
    pub for_c: ForC,
    /// True for bodies of C++ templates over the scalar `T`.
    pub templates: bool,
    /// Order of the two halves of twists, wrenches and momenta.
    pub order: Order,
}

/// Default prefix: `double_pendulum_` for the robot `double pendulum`.
#[must_use]
pub fn prefix(robot: &str) -> String {
    names::prefix(robot)
}

/// Functions and their header; [`Real::Generic`] is printed as `double`.
#[must_use]
pub fn print(module: &Module, options: &COptions<'_>) -> CSource {
    CSource {
        header: header(module, options),
        text: source::source(module, options),
    }
}

/// The same in a file for each function: names and texts, the header first, and then the source with everything that is
/// not a function of the request.
#[must_use]
pub fn print_apart(module: &Module, options: &COptions<'_>) -> Vec<(String, String)> {
    let header = (options.header.to_owned(), header(module, options));
    let sources = source::sources(module, options);
    std::iter::once(header).chain(sources).collect()
}

fn header(module: &Module, options: &COptions<'_>) -> String {
    let angles = match (module.sines, module.scalar) {
        (Sines::Own, real) => SineAngles::own(real),
        (Sines::Platform, Real::F32) => SineAngles::As("sinf".to_owned()),
        (Sines::Platform, Real::F64 | Real::Generic) => SineAngles::As("sin".to_owned()),
    };
    let header = Header {
        prefix: options.prefix,
        guard: options.prefix,
        asked: options.asked,
        angles: &angles,
        needs: Some(&options.needs()),
        steps: options.for_c.steps,
    };
    header.text(module)
}

impl COptions<'_> {
    /// A name private to the file.
    fn own(&self, name: &str) -> String {
        own(self.prefix, name)
    }

    /// Macro for a product and a sum.
    fn mul_add(&self) -> String {
        names::constant(self.prefix, "mul_add")
    }

    /// Macro that prevents inlining.
    fn no_inline(&self) -> String {
        names::constant(self.prefix, "apart")
    }

    /// Requirements for compilation.
    fn needs(&self) -> String {
        let bits = if self.fused {
            "if products fuse with sums as by HOMOGEN_FMA"
        } else {
            "if no product fuses with a sum"
        };
        format!(
            "Needs: C99, without -ffast-math. Results have the same bits as in Rust {bits}; this requires \
             -ffp-contract=off for GCC and for Clang with CUDA, and --fmad=false for nvcc."
        )
    }
}
