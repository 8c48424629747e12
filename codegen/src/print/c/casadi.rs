//! External interface of `CasADi` to the functions of a C file.
//!
//! In: a [`Module`] and options. Out: for each function the symbols by which `casadi.external` reads sizes, names and
//! sparsity and calls it; and the same for its Jacobian (`jac_…`), the product of the transposed Jacobian with weights
//! (`adj1_…`) and the Jacobian of that product (`jac_adj1_…`), if their results are generated.
//!
//! Matrices of `CasADi` are stored column by column, without structural zeros. An input that is null is zero; an output
//! that is null is not computed. The interface has a derivative by every argument of a function, or none: `CasADi`
//! takes what is missing for zero.

mod call;
mod derived;
mod described;
mod external;
mod matrix;
mod tables;

use std::collections::BTreeSet;

use super::COptions;
use super::names::own;
use crate::module::Module;
use crate::print::c::comments::comment;
use crate::print::c::declarations::results;
use crate::space::Space;
use derived::{adjoint, adjoint_jacobian, jacobian, without_derivatives};
use described::text;
use external::{External, Port, Store, input};
use matrix::SparseMatrix;
use tables::Tables;

/// Text of the interface.
pub(super) fn interface(module: &Module, options: &COptions<'_>, symbols: &[String]) -> String {
    // C has no arrays of length 0.
    if module.spaces.len(Space::Velocities) == 0 {
        return String::new();
    }
    let mut tables = Tables::new(own(options.prefix, "casadi"));
    let (mut functions, mut remarks) = (String::new(), Vec::new());
    for (of, name) in names(module, options.prefix).into_iter().enumerate() {
        let function = function(module, (of, name));
        remarks
            .extend(without_derivatives(module, of).map(|why| format!("{}: {why}", function.name)));
        let all = [
            jacobian(module, of, &function),
            adjoint(module, of, &function),
            adjoint_jacobian(module, of, &function),
        ];
        for external in [Some(function)].into_iter().chain(all).flatten() {
            functions.push_str(&text(&external, module, options, symbols, &mut tables));
        }
    }
    let head = comment(&about(module, remarks));
    format!("\n{head}{TYPES}{}{functions}\n{END}", tables.text())
}

/// Names in `CasADi`, which allows no two adjacent underscores.
fn names(module: &Module, prefix: &str) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let functions = module.functions.iter();
    let names = functions.map(|generated| {
        let whole = format!("{prefix}casadi_{}", super::names::ascii(&generated.name()));
        let words: Vec<&str> = whole.split('_').filter(|word| !word.is_empty()).collect();
        let mut name = words.join("_");
        while !taken.insert(name.clone()) {
            name.push('x');
        }
        name
    });
    names.collect()
}

/// A function itself.
fn function(module: &Module, (of, name): (usize, String)) -> External {
    let generated = &module.functions[of];
    let arguments = generated.arguments(&module.spaces);
    let mut operands = &*generated.program.results;
    let results = results(&generated.functions);
    let outputs: Vec<Port> = (results.into_iter())
        .map(|(name, quantity)| {
            let (own, others) = operands.split_at(quantity.size(&module.spaces));
            operands = others;
            Port {
                name,
                matrix: SparseMatrix::of(&quantity, &module.spaces, own),
            }
        })
        .collect();
    let matrices: Vec<SparseMatrix> = outputs.iter().map(|port| port.matrix.clone()).collect();
    let mut function = External {
        name,
        inputs: arguments.iter().map(|&of| input(of, module)).collect(),
        arguments,
        fields: External::fields(module),
        further: Vec::new(),
        seeds: None,
        outputs,
        calls: Vec::new(),
    };
    for (k, matrix) in matrices.into_iter().enumerate() {
        function.store(of, (k, k, Store::Entries(matrix)));
    }
    function
}

/// Lines of the comment above the interface.
fn about(module: &Module, remarks: Vec<String>) -> Vec<String> {
    let mut lines = vec![
        "External interface of CasADi: casadi.external(name, library).".to_owned(),
        String::new(),
        "Vectors are columns; a Jacobian of the robot has a column for each velocity, a pose is 4×4, wrenches have a row \
         each. The order within six numbers is that of the functions above."
            .to_owned(),
    ];
    if !module.parameters.is_empty() {
        lines.push(
            "p: the fields, in the order of the struct. CasADi is told not to differentiate by them.".to_owned(),
        );
    }
    if !remarks.is_empty() {
        lines.push("Without derivatives:".to_owned());
        lines.extend(remarks);
    }
    lines
}

/// Types and linkage, as in the code that `CasADi` prints.
const TYPES: &str = "\
#ifndef casadi_int
#define casadi_int long long int
#endif
#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32) || defined(__CYGWIN__)
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define CASADI_SYMBOL_EXPORT __attribute__((visibility(\"default\")))
#else
#define CASADI_SYMBOL_EXPORT
#endif
#endif

#ifdef __cplusplus
extern \"C\" {
#endif
";

/// End of the linkage.
const END: &str = "\
#ifdef __cplusplus
}
#endif
";
