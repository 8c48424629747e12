//! The source file: functions and their requirements on the compiler.
//!
//! In: a [`Module`] and options. Out: definitions of the functions in the header.

use std::fmt::Write;

use super::Writing;
use super::body::{self, Body, body, once};
use super::comments::comment;
use super::declarations::{self, of_prepare, parameters};
use super::header::guard;
use super::names::{prepared_symbols, symbols};
use super::{acados, casadi, review, roots, sections, sines, steps};
use crate::formulation::Sines;
use crate::module::Module;
use crate::print::steps::{Step, has_angles, has_roots};
use crate::print::{Fields, documentation};
use crate::real::Real;
use crate::schedule::Names;

/// Text of the file.
pub(super) fn source(module: &Module, writing: &Writing<'_>) -> String {
    let symbols = symbols(module, writing.prefix);
    let mut head = documentation::head(module, writing.asked);
    head.push(writing.needs());
    for (generated, name) in module.functions.iter().zip(&symbols) {
        head.extend(documentation::operation_count(generated, name));
    }
    let mut text = comment(&head);
    text.push('\n');
    let (guard, header) = (guard(writing.prefix), writing.header);
    // Writing to a string cannot fail.
    let _ = writeln!(text, "#ifndef {guard}\n#include \"{header}\"\n#endif");
    let (has_angles, has_roots) = (has_angles(module), has_roots(module));
    let own_sines = module.sines == Sines::Own && has_angles;
    text.push_str("#include <float.h>\n");
    if has_angles && !own_sines {
        text.push_str("#include <math.h>\n");
    }
    if own_sines || has_roots {
        text.push_str("#include <stdint.h>\n");
    }
    text.push_str(&arithmetic(module.scalar));
    if writing.fused {
        text.push_str(&product_and_sum(&writing.mul_add(), module.scalar));
    }
    if own_sines {
        text.push('\n');
        text.push_str(&sines::function(module.scalar, writing));
    }
    if has_roots {
        text.push('\n');
        text.push_str(&roots::function(module.scalar, writing));
    }
    let functions = functions(module, writing, &symbols);
    if functions.has_sections {
        text.push_str(&sections::no_inline_macro(&writing.no_inline()));
    }
    text.push_str(&functions.text);
    if let Some(rule) = writing.for_c.steps {
        text.push_str(&steps::definitions(module, writing.prefix, rule));
    }
    if writing.for_c.acados {
        text.push_str(&acados::interface(module, writing.prefix));
    }
    if writing.for_c.casadi {
        text.push_str(&casadi::interface(module, writing, &symbols));
    }
    text + &review::appendix(module, writing)
}

/// Definitions of functions.
struct Functions {
    text: String,
    /// True if a function has sections.
    has_sections: bool,
}

impl Functions {
    fn push(&mut self, head: &str, body: &Body) {
        self.has_sections |= !body.sections.is_empty();
        self.text.push_str(&body.sections);
        // Writing to a string cannot fail.
        let _ = writeln!(
            self.text,
            "\nHOMOGEN_FN HOMOGEN_CLONES void {head}\n{{\n{}}}",
            body.text
        );
    }
}

fn functions(module: &Module, writing: &Writing<'_>, symbols: &[String]) -> Functions {
    let prefix = writing.prefix;
    let prepared = prepared_symbols(module, prefix);
    let mut names = Names::default();
    for name in symbols.iter().chain(&prepared) {
        names.take(name);
    }
    let mut functions = Functions {
        text: String::new(),
        has_sections: false,
    };
    for (generated, name) in module.functions.iter().zip(symbols) {
        let parameters = parameters(module, generated, (prefix, "robot"));
        let fields = Fields::Own(&module.parameters);
        let mut own = |section: &str| names.alone(&format!("{name}_{section}"));
        let body = body(module, (generated, fields), writing, &mut own);
        functions.push(&format!("{name}({parameters})"), &body);
    }
    for &step in Step::of(module) {
        let name = writing.own(step.name());
        let parameters = declarations::of_step(step, module, prefix);
        let body = body::of_step(step, module, writing);
        functions.push(&format!("{name}({parameters})"), &body);
    }
    let Some(all) = &module.prepared else {
        return functions;
    };
    let prepare = writing.own("prepare");
    let mut own = |section: &str| names.alone(&format!("{prepare}_{section}"));
    let once = once(module, all, writing, &mut own);
    functions.push(&format!("{prepare}({})", of_prepare(prefix)), &once);
    for (generated, name) in all.functions.iter().zip(prepared) {
        let parameters = parameters(module, generated, (prefix, "prepared"));
        let fields = Fields::Computed(&all.names);
        let mut own = |section: &str| names.alone(&format!("{name}_{section}"));
        let body = body(module, (generated, fields), writing, &mut own);
        functions.push(&format!("{name}({parameters})"), &body);
    }
    functions
}

/// Checks of the scalar type and of compiler options that change results.
fn arithmetic(real: Real) -> String {
    let (number, digits) = match real {
        Real::F32 => ("float", "FLT_MANT_DIG != 24"),
        Real::F64 | Real::Generic => ("double", "DBL_MANT_DIG != 53"),
    };
    format!(
        "
#if FLT_RADIX != 2 || {digits}
#error \"{number} is not an IEEE 754 type here.\"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error \"Results need exact IEEE 754 sums: compile without -ffast-math.\"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error \"Every number must be rounded to its type: compile with -msse2 -mfpmath=sse.\"
#endif
/* GCC has no such pragma: compile with -ffp-contract=off. */
#if defined(__clang__) || !defined(__GNUC__)
#pragma STDC FP_CONTRACT OFF
#endif
"
    )
}

/// Macro for a product and a sum, fused if the target has the instruction.
fn product_and_sum(name: &str, real: Real) -> String {
    let letter = match real {
        Real::F32 => "f",
        Real::F64 | Real::Generic => "",
    };
    let macros = letter.to_uppercase();
    format!(
        "
/* Fused, with one rounding, if the target has the instruction, or by HOMOGEN_FMA{macros}(a, b, c) if that is
 * defined; never by a library.
 */
#if defined(HOMOGEN_FMA{macros})
#define {name}(a, b, c) HOMOGEN_FMA{macros}(a, b, c)
#elif defined(__FP_FAST_FMA{macros}) || \\
    (defined(__GNUC__) && (defined(__FMA__) || defined(__aarch64__)))
#define {name}(a, b, c) __builtin_fma{letter}(a, b, c)
#else
#define {name}(a, b, c) ((a) * (b) + (c))
#endif
"
    )
}
