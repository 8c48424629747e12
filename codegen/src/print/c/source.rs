//! Source files: functions and their requirements on the compiler.
//!
//! In: a [`Module`] and options. Out: definitions of the functions in the header, in one file or in one for each function.

use std::fmt::Write;

use super::COptions;
use super::body::{self, FunctionBody, body, once};
use super::comments::comment;
use super::declarations::{self, of_prepare, parameters};
use super::header::guard;
use super::names::{prepared_symbols, symbols};
use super::{acados, casadi, review, roots, sections, sines, steps};
use crate::formulation::Sines;
use crate::module::Module;
use crate::print::steps::ConfigurationFunction;
use crate::print::{Fields, documentation};
use crate::real::Real;
use crate::schedule::{Names, Program};

/// Text of the file with everything.
pub(super) fn source(module: &Module, options: &COptions<'_>) -> String {
    let symbols = symbols(module, options.prefix);
    let functions = functions(module, options, &symbols);
    let counts = functions.iter().flat_map(|function| &function.counts);
    let mut text = opening(module, options, counts.cloned(), Needs::of(&functions));
    for function in functions {
        text.push_str(&function.text);
    }
    text + &rest(module, options, &symbols)
}

/// Names and texts of a file for each function; the first, with the name of the header, has the rest.
pub(super) fn sources(module: &Module, options: &COptions<'_>) -> Vec<(String, String)> {
    let symbols = symbols(module, options.prefix);
    let functions = functions(module, options, &symbols);
    let (own, together): (Vec<_>, Vec<_>) = functions
        .into_iter()
        .partition(|function| function.is_asked);
    let mut text = opening(module, options, [], Needs::of(&together));
    for function in together {
        text.push_str(&function.text);
    }
    text.push_str(&rest(module, options, &symbols));
    let stem = options.header.strip_suffix(".h").unwrap_or(options.header);
    let mut names = Names::default();
    names.take(stem);
    let mut files = vec![(format!("{stem}.c"), text)];
    for function in own {
        let name = names.alone(&file_name(&function.name));
        let text = opening(module, options, function.counts, function.needs) + &function.text;
        files.push((format!("{name}.c"), text));
    }
    files
}

/// Comment, includes, macros and the private functions that functions need.
fn opening(
    module: &Module,
    options: &COptions<'_>,
    counts: impl IntoIterator<Item = String>,
    needs: Needs,
) -> String {
    let mut head = documentation::head(module, options.asked);
    head.push(options.needs());
    head.extend(counts);
    let mut text = comment(&head);
    text.push('\n');
    let (guard, header) = (guard(options.prefix), options.header);
    // Writing to a string cannot fail.
    let _ = writeln!(text, "#ifndef {guard}\n#include \"{header}\"\n#endif");
    let own_sines = module.sines == Sines::Own && needs.angles;
    text.push_str("#include <float.h>\n");
    if needs.angles && !own_sines {
        text.push_str("#include <math.h>\n");
    }
    if own_sines || needs.roots {
        text.push_str("#include <stdint.h>\n");
    }
    text.push_str(&arithmetic(module.scalar));
    if options.fused {
        text.push_str(&product_and_sum(&options.mul_add(), module.scalar));
    }
    if own_sines {
        text.push('\n');
        text.push_str(&sines::function(module.scalar, options));
    }
    if needs.roots {
        text.push('\n');
        text.push_str(&roots::function(module.scalar, options));
    }
    if needs.sections {
        text.push_str(&sections::no_inline_macro(&options.no_inline()));
    }
    text
}

/// Parts after the functions: time steps, interfaces of solvers, and the material for the reviewer.
fn rest(module: &Module, options: &COptions<'_>, symbols: &[String]) -> String {
    let mut text = String::new();
    if let Some(rule) = options.for_c.steps {
        text.push_str(&steps::definitions(module, options.prefix, rule));
    }
    if options.for_c.acados {
        text.push_str(&acados::interface(module, options.prefix));
    }
    if options.for_c.casadi {
        text.push_str(&casadi::interface(module, options, symbols));
    }
    text + &review::appendix(module, options)
}

/// Private functions and macros that a definition needs.
#[derive(Clone, Copy, Default)]
struct Needs {
    /// Sines and cosines.
    angles: bool,
    /// Square roots.
    roots: bool,
    /// The macro of sections.
    sections: bool,
}

impl Needs {
    fn of(functions: &[FunctionText]) -> Self {
        let all = functions.iter().map(|function| function.needs);
        all.fold(Self::default(), |all, own| Self {
            angles: all.angles || own.angles,
            roots: all.roots || own.roots,
            sections: all.sections || own.sections,
        })
    }

    fn of_program(program: &Program) -> Self {
        Self {
            angles: !program.angles.is_empty(),
            roots: program.has_roots(),
            sections: false,
        }
    }
}

/// Definition of a function.
struct FunctionText {
    name: String,
    /// True for functions of the request, which may have files of their own.
    is_asked: bool,
    text: String,
    needs: Needs,
    /// Its operation counts and error bounds, for the head of its file.
    counts: Vec<String>,
}

impl FunctionText {
    fn of(name: String, parameters: &str, body: &FunctionBody, needs: Needs) -> Self {
        let (sections, body) = (&body.sections, &body.text);
        let head = format!("HOMOGEN_FN HOMOGEN_CLONES void {name}({parameters})");
        Self {
            name,
            is_asked: true,
            text: format!("{sections}\n{head}\n{{\n{body}}}\n"),
            needs: Needs {
                sections: !sections.is_empty(),
                ..needs
            },
            counts: Vec::new(),
        }
    }
}

fn functions(module: &Module, options: &COptions<'_>, symbols: &[String]) -> Vec<FunctionText> {
    let prefix = options.prefix;
    let prepared = prepared_symbols(module, prefix);
    let mut names = Names::default();
    for name in symbols.iter().chain(&prepared) {
        names.take(name);
    }
    let mut functions = Vec::new();
    for (generated, name) in module.functions.iter().zip(symbols) {
        let parameters = parameters(module, generated, (prefix, "robot"));
        let fields = Fields::Own(&module.parameters);
        let mut own = |section: &str| names.alone(&format!("{name}_{section}"));
        let body = body(module, (generated, fields), options, &mut own);
        let needs = Needs::of_program(&generated.program);
        functions.push(FunctionText {
            counts: documentation::operation_count(generated, name),
            ..FunctionText::of(name.clone(), &parameters, &body, needs)
        });
    }
    for &step in ConfigurationFunction::of(module) {
        let parameters = declarations::of_step(step, module, prefix);
        let body = body::of_step(step, module, options);
        let needs = Needs {
            angles: step.turns(module),
            roots: true,
            sections: false,
        };
        functions.push(FunctionText {
            is_asked: false,
            ..FunctionText::of(options.own(step.name()), &parameters, &body, needs)
        });
    }
    let Some(all) = &module.prepared else {
        return functions;
    };
    let prepare = options.own("prepare");
    let mut own = |section: &str| names.alone(&format!("{prepare}_{section}"));
    let once = once(module, all, options, &mut own);
    let needs = Needs::of_program(&all.once);
    functions.push(FunctionText::of(prepare, &of_prepare(prefix), &once, needs));
    for (generated, name) in all.functions.iter().zip(prepared) {
        let parameters = parameters(module, generated, (prefix, "prepared"));
        let fields = Fields::Computed(&all.names);
        let mut own = |section: &str| names.alone(&format!("{name}_{section}"));
        let body = body(module, (generated, fields), options, &mut own);
        let needs = Needs::of_program(&generated.program);
        functions.push(FunctionText::of(name, &parameters, &body, needs));
    }
    functions
}

/// A name that file systems accept, also those that do not distinguish capitals.
fn file_name(symbol: &str) -> String {
    symbol.to_ascii_lowercase().chars().take(100).collect()
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
/* 16 is 0 for these types: with it, numbers of half precision are rounded, too. */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
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
