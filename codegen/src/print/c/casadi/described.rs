//! Text of a function of `CasADi`, with its description of itself.
//!
//! In: an [`External`]. Out: the function and the symbols by which `casadi.external` reads its sizes, names and sparsity.

use std::fmt::Write;

use super::call::body;
use super::external::{External, Port};
use super::tables::Tables;
use crate::module::Module;
use crate::print::c::COptions;
use crate::print::c::comments::comment;
use crate::print::review::filled;

/// The function and its description.
pub(super) fn text(
    external: &External,
    module: &Module,
    options: &COptions<'_>,
    symbols: &[String],
    tables: &mut Tables,
) -> String {
    let name = &external.name;
    let body = body(external, module, options, symbols, tables);
    let inputs: Vec<&Port> = external.all_inputs().collect();
    let outputs: Vec<&Port> = external.outputs.iter().collect();
    let names = |ports: &[&Port]| {
        let names = ports.iter().map(|port| port.name.as_str());
        names.collect::<Vec<_>>().join(", ")
    };
    let about = format!("{name}: ({}) -> ({})", names(&inputs), names(&outputs));
    let mut text = format!(
            "
{}CASADI_SYMBOL_EXPORT int {name}(const double **arg, double **res, casadi_int *iw, double *w, int mem)
{{
{body}    (void)iw;
    (void)w;
    (void)mem;
    return 0;
}}

CASADI_SYMBOL_EXPORT void {name}_incref(void)
{{
}}

CASADI_SYMBOL_EXPORT void {name}_decref(void)
{{
}}
",
            comment(&[about])
        );
    for (side, ports) in [("in", inputs), ("out", outputs)] {
        describe(&mut text, (name, side), &ports, tables);
    }
    if external.fields.is_some() {
        let index = external.arguments.len();
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "
CASADI_SYMBOL_EXPORT int {name}_diff_in(casadi_int i)
{{
    return i != {index};
}}
"
        );
    }
    let [inputs, outputs] = [external.count_inputs(), external.outputs.len()];
    let _ = write!(
            text,
            "
CASADI_SYMBOL_EXPORT int {name}_work(casadi_int *sz_arg, casadi_int *sz_res, casadi_int *sz_iw, casadi_int *sz_w)
{{
    if (sz_arg) {{
        *sz_arg = {inputs};
    }}
    if (sz_res) {{
        *sz_res = {outputs};
    }}
    if (sz_iw) {{
        *sz_iw = 0;
    }}
    if (sz_w) {{
        *sz_w = 0;
    }}
    return 0;
}}
"
        );
    text
}

/// Number, names and sparsity of inputs or outputs.
fn describe(text: &mut String, (name, side): (&str, &str), ports: &[&Port], tables: &mut Tables) {
    let count = ports.len();
    let names: Vec<String> = ports
        .iter()
        .map(|port| format!("\"{}\"", port.name))
        .collect();
    let patterns = ports
        .iter()
        .map(|port| tables.pattern(port.matrix.pattern()));
    let patterns: Vec<String> = patterns.collect();
    let indent = "        ";
    let names = filled(
        (
            &format!("    static const char *const names[{count}] = {{"),
            indent,
        ),
        &names,
        "};",
    );
    let patterns = filled(
        (
            &format!("    static const casadi_int *const patterns[{count}] = {{"),
            indent,
        ),
        &patterns,
        "};",
    );
    // Writing to a string cannot fail.
    let _ = write!(
        text,
        "
CASADI_SYMBOL_EXPORT casadi_int {name}_n_{side}(void)
{{
    return {count};
}}

CASADI_SYMBOL_EXPORT const char *{name}_name_{side}(casadi_int i)
{{
{names}
    return i >= 0 && i < {count} ? names[i] : 0;
}}

CASADI_SYMBOL_EXPORT const casadi_int *{name}_sparsity_{side}(casadi_int i)
{{
{patterns}
    return i >= 0 && i < {count} ? patterns[i] : 0;
}}
"
    );
}
