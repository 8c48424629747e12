//! LLVM IR: functions of one state, and of many states in the lanes of vectors.
//!
//! In: a [`Module`], a prefix for names, and the number of lanes. Out: a module of LLVM 19 or later as text, without a
//! target, which is chosen at compilation. `NAME` takes one state, as in the C file; `NAME_batch` takes any number of
//! states with any stride. Results have the same bits as those of the C file: no operation has fast-math flags.

mod batch;
mod body;
mod function;
mod lanes;
mod sines;
#[cfg(test)]
mod tests;

use crate::formulation::Sines;
use crate::module::Module;
use crate::print::c::{own, symbols};
use crate::print::documentation::{self, Angles};
use crate::print::steps::{Step, has_angles};
use crate::real::Real;
use crate::wording::visible;
use batch::{batch, moves};
use function::{Function, Of, define};
use lanes::Lanes;

/// Options of the output.
#[derive(Clone, Copy, Debug)]
pub struct Writing<'a> {
    /// Prefix of all names.
    pub prefix: &'a str,
    /// The request.
    pub asked: &'a str,
    /// Number of lanes of a vector of states.
    pub lanes: usize,
    /// True if products fuse with sums, by `llvm.fma`.
    pub fused: bool,
}

/// The module; [`Real::Generic`] is printed as `double`.
#[must_use]
pub fn print(module: &Module, writing: &Writing<'_>) -> String {
    let real = match module.scalar {
        Real::F32 => Real::F32,
        Real::F64 | Real::Generic => Real::F64,
    };
    let [one, several] = [1, writing.lanes].map(|count| Lanes { real, count });
    let widths = if writing.lanes > 1 {
        vec![one, several]
    } else {
        vec![one]
    };
    let symbols = symbols(module, writing.prefix);
    let mut head = documentation::head(module, writing.asked);
    for (generated, name) in module.functions.iter().zip(&symbols) {
        head.extend(documentation::operation_count(generated, name));
    }
    let mut text = comment(&head) + "\n";
    let own_sines = module.sines == Sines::Own && has_angles(module);
    for &lanes in widths.iter().filter(|_| own_sines) {
        text.push_str(&sines::define(lanes, writing.fused));
    }
    for &lanes in &widths {
        text.push_str(&moves(lanes));
    }
    let angles = match module.sines {
        Sines::Own => Angles::own(real),
        Sines::Platform => Angles::As("llvm.sin".to_owned()),
    };
    let functions = module
        .functions
        .iter()
        .zip(symbols)
        .map(|(generated, symbol)| {
            let about = documentation::of_function(module, generated, Some(&angles), None);
            (about, Of::State(generated), symbol)
        });
    let steps = Step::of(module).iter().map(|&step| {
        let about = documentation::of_step(module, step, Some(&angles));
        (about, Of::Step(step), own(writing.prefix, step.name()))
    });
    for (about, of, symbol) in functions.chain(steps) {
        text.push_str(&comment(&about));
        let function = Function::new(module, of, &symbol, writing.fused);
        for &lanes in &widths {
            text.push_str(&define(&function, lanes));
        }
        text.push_str(&batch(&function, &widths));
    }
    for lanes in widths {
        text.push_str(&lanes.declarations());
    }
    text
}

/// Lines as comments; each stays one line.
fn comment(lines: &[String]) -> String {
    let lines = lines.iter().map(|line| format!("; {}", visible(line)));
    let lines = lines.map(|line| line.trim_end().to_owned() + "\n");
    lines.collect()
}
