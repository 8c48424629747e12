//! The header.
//!
//! In: a [`Module`], and the language of its functions. Out: declarations with their comments.

use std::fmt::Write;

use super::comments::comment;
use super::declarations::{
    self, base_parameters, indices, of_prepare, of_step, parameters, structure,
};
use super::names::{ascii, own, prepared_symbols, symbols};
use super::{review, steps};
use crate::module::{Module, Prepared};
use crate::print::documentation::{self, SineAngles};
use crate::print::steps::ConfigurationFunction;
use crate::request::Integrator;
use crate::space::Order;

/// Options of a header.
pub(in crate::print) struct Header<'a> {
    /// Prefix of the functions.
    pub prefix: &'a str,
    /// Prefix of the include guard.
    pub guard: &'a str,
    /// The request.
    pub asked: &'a str,
    /// Angles for which the functions are accurate.
    pub angles: &'a SineAngles,
    /// Requirements for compilation, for functions in C.
    pub needs: Option<&'a str>,
    /// Rule of time steps, if the source has them.
    pub steps: Option<Integrator>,
}

impl Header<'_> {
    /// Text of the file.
    pub fn text(&self, module: &Module) -> String {
        let prefix = self.prefix;
        let mut head = documentation::head(module, self.asked);
        head.push(
            "No pointer may be null, and no result may overlap an argument or another result."
                .to_owned(),
        );
        head.extend(self.needs.map(str::to_owned));
        let mut text = comment(&head);
        let guard = guard(self.guard);
        let _ = writeln!(text, "#ifndef {guard}\n#define {guard}\n");
        let is_c = self.needs.is_some();
        if is_c {
            text.push_str(QUALIFIER);
        }
        text.push_str("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
        if is_c || module.review.is_some() {
            indices(&mut text, module, prefix);
        }
        review::limits(&mut text, module, prefix);
        review::configurations(&mut text, module, prefix);
        structure(&mut text, module, prefix);
        let prepared = module.prepared.as_ref().filter(|_| is_c);
        if prepared.is_some() {
            declarations::prepared(&mut text, module, prefix);
        }
        base_parameters(&mut text, module, prefix);
        let qualifier = if is_c { "HOMOGEN_FN " } else { "" };
        let plain = Some((self.angles, Order::AngularFirst));
        for (generated, name) in module.functions.iter().zip(symbols(module, prefix)) {
            let about = documentation::of_function(module, generated, plain, None);
            text.push_str(&comment(&about));
            let parameters = parameters(module, generated, (prefix, "robot"));
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{qualifier}void {name}({parameters});\n");
        }
        for &step in ConfigurationFunction::of(module) {
            let about = documentation::of_step(module, step, Some(self.angles));
            text.push_str(&comment(&about));
            let (name, parameters) = (own(prefix, step.name()), of_step(step, module, prefix));
            let _ = writeln!(text, "{qualifier}void {name}({parameters});\n");
        }
        if let Some(rule) = self.steps {
            text.push_str(&steps::declarations(module, prefix, rule));
        }
        if let Some(prepared) = prepared {
            text.push_str(&self.prepared(module, prepared));
        }
        if is_c {
            review::declaration(&mut text, module, prefix);
        }
        text.push_str("#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
        text
    }
}

impl Header<'_> {
    /// The function that prepares a robot, and those that read it.
    fn prepared(&self, module: &Module, prepared: &Prepared) -> String {
        let prefix = self.prefix;
        let mut text = comment(&documentation::of_prepare(&prepared.operation_count));
        let filled = of_prepare(prefix);
        let prepare = own(prefix, "prepare");
        let _ = writeln!(text, "HOMOGEN_FN void {prepare}({filled});\n");
        let symbols = prepared_symbols(module, prefix);
        let plain = Some((self.angles, Order::AngularFirst));
        for (generated, name) in prepared.functions.iter().zip(symbols) {
            let once = Some(&prepared.operation_count);
            let about = documentation::of_function(module, generated, plain, once);
            text.push_str(&comment(&about));
            let parameters = parameters(module, generated, (prefix, "prepared"));
            // Writing to a string cannot fail.
            let _ = writeln!(text, "HOMOGEN_FN void {name}({parameters});\n");
        }
        text
    }
}

/// The include guard.
pub(super) fn guard(beginning: &str) -> String {
    format!("HOMOGEN_{}H", ascii(beginning)).to_uppercase()
}

/// Text before all functions.
const QUALIFIER: &str = "\
/* Printed before every function; define it as __device__, for example. */
#ifndef HOMOGEN_FN
#define HOMOGEN_FN
#endif
/* Define HOMOGEN_DISPATCH to compile every function for AVX-512 and AVX2 as well; the program chooses when it starts
 * (GCC from 12 on Linux for x86-64; no effect elsewhere). With -ffp-contract=off results have the same bits; without
 * it they are fused on processors that can. GCC 12 fuses pairs of them with that option too, hence no pairs.
 */
#ifndef HOMOGEN_CLONES
#if defined(HOMOGEN_DISPATCH) && defined(__x86_64__) && defined(__linux__) && \\
    defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__)
#define HOMOGEN_CLONES \\
    __attribute__((optimize(\"no-tree-slp-vectorize\"), \\
        target_clones(\"arch=x86-64-v4\", \"arch=x86-64-v3\", \"default\")))
#else
#define HOMOGEN_CLONES
#endif
#endif

";
