//! C++17: a header of templates over the scalar, in a namespace, without sources.
//!
//! In: a [`Module`] and a [`Header`]. Out: the text of the header. Bodies are those of the C file: operations, their order
//! and, for `double`, the sines are the same, and so are the bits.

mod described;
mod functions;
mod support;

pub use functions::call;

use std::fmt::Write;

use super::COptions;
use super::comments::comment;
use super::names::{self, unscoped};
use crate::formulation::Sines;
use crate::module::Module;
use crate::print::documentation::{self, SineAngles};
use crate::request::ForC;
use crate::space::Order;

/// Options of the output.
#[derive(Clone, Copy, Debug)]
pub struct Header<'a> {
    /// Prefix of the names of the file in C, whose letters are the namespace.
    pub prefix: &'a str,
    /// The request.
    pub asked: &'a str,
    /// Order of the two halves of twists, wrenches and momenta.
    pub order: Order,
}

/// Text of the header; generic numbers are by default `double`.
#[must_use]
pub fn header(module: &Module, header: &Header<'_>) -> String {
    let namespace = namespace(header.prefix);
    let angles = match module.sines {
        Sines::Own => SineAngles::own(module.scalar),
        Sines::Platform => SineAngles::As("std::sin".to_owned()),
    };
    let options = COptions {
        prefix: "",
        header: "",
        asked: header.asked,
        fused: false,
        for_c: ForC::default(),
        templates: true,
        order: header.order,
    };
    let mut head = documentation::head(module, header.asked);
    head.push(NEEDS.to_owned());
    let [first, second] = header.order.halves(["angular", "linear"]);
    head.push(format!(
        "Twists, wrenches and momenta have six numbers: the {first} three, then the {second} three."
    ));
    let mut text = comment(&head);
    let guard = format!("HOMOGEN_{}_HPP", namespace.to_uppercase());
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "#ifndef {guard}\n#define {guard}\n\n{INCLUDES}\nnamespace {namespace} {{\n"
    );
    text.push_str(&described::constants(module));
    text.push_str(&described::structure(module));
    text.push_str(&support::text(module, &options));
    text.push_str(&functions::text(module, &options, &angles));
    let _ = writeln!(text, "{EIGEN}\n}} // namespace {namespace}\n\n#endif");
    text
}

/// Namespace for a prefix: `two_link` for `two_link_`.
#[must_use]
pub fn namespace(prefix: &str) -> String {
    let name = prefix.trim_matches('_');
    let name = if name.is_empty() { "robot" } else { name };
    let mut names = unscoped();
    for other in ["std", "Eigen"] {
        names.take(other);
    }
    names.alone(&names::ascii(name))
}

/// Requirements for compilation.
const NEEDS: &str = "Needs: C++17. An argument is anything with one number for each index: arrays, std::array, std::vector, \
                     vectors of Eigen. Results are std::array, row by row, and eigen(…) makes vectors and matrices of Eigen \
                     of them. Numbers are those of the file, or of a class with +, -, *, / and sin, cos, sqrt: dual numbers, \
                     symbols. Results have the bits of the file in C with -ffp-contract=off and without -ffast-math.";

/// Headers of the standard library, and of Eigen if it is there.
const INCLUDES: &str = "\
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#if __has_include(<Eigen/Core>)
#include <Eigen/Core>
#endif
";

/// Results as vectors and matrices of Eigen.
const EIGEN: &str = "
#if __has_include(<Eigen/Core>)
/* A result as a vector of Eigen. */
template <class T, std::size_t N>
Eigen::Matrix<T, static_cast<int>(N), 1> eigen(const std::array<T, N>& result)
{
    return Eigen::Map<const Eigen::Matrix<T, static_cast<int>(N), 1>>(result.data());
}

/* A result as a matrix of Eigen: `result[row][column]` is its entry (row, column). */
template <class T, std::size_t Rows, std::size_t Columns>
Eigen::Matrix<T, static_cast<int>(Rows), static_cast<int>(Columns)> eigen(
    const std::array<std::array<T, Columns>, Rows>& result)
{
    Eigen::Matrix<T, static_cast<int>(Rows), static_cast<int>(Columns)> matrix;
    for (std::size_t row = 0; row < Rows; row++) {
        for (std::size_t column = 0; column < Columns; column++) {
            matrix(static_cast<int>(row), static_cast<int>(column)) = result[row][column];
        }
    }
    return matrix;
}
#endif
";
