//! LLVM IR: functions of one state, and of many states in the lanes of vectors.
//!
//! In: a [`Module`], a prefix for names, and the number of lanes. Out: a module of LLVM 19 or later as text, without a
//! target, which is chosen at compilation. `NAME` takes one state, as in the C file; `NAME_batch` takes any number of
//! states with any stride; `NAME_arrays` takes the same behind a pointer, so that all functions have one signature. For a
//! GPU there is `NAME_kernel` instead, with a thread for each state. Results have the same bits as those of the C file: no
//! operation has fast-math flags.

mod batch;
mod body;
mod function;
mod kernel;
mod lanes;
mod sines;
#[cfg(test)]
mod tests;

use crate::formulation::Sines;
use crate::module::Module;
use crate::print::c::{own, symbols};
use crate::print::documentation::{self, SineAngles};
use crate::print::steps::{ConfigurationFunction, has_angles};
use crate::real::Real;
use crate::space::Order;
use crate::wording::visible;
use batch::{arrays, batch, moves};
use function::{ComputedFunction, LlvmFunction, define};
use lanes::Lanes;

/// Options of the output.
#[derive(Clone, Copy, Debug)]
pub struct LlvmOptions<'a> {
    /// Prefix of all names.
    pub prefix: &'a str,
    /// Request, quoted at the head; without it there are no comments, and equal programs are equal texts.
    pub asked: Option<&'a str>,
    /// The functions of configurations that are written.
    pub steps: Steps,
    /// Functions of many states.
    pub states: States,
    /// True if products fuse with sums, by `llvm.fma`.
    pub fused: bool,
}

/// Functions of many states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum States {
    /// `NAME_batch` and `NAME_arrays`: loops over states, which stand in so many lanes of vectors.
    InLanes(usize),
    /// `NAME_kernel`, for GPUs of NVIDIA: a thread for each state.
    InThreads,
}

/// Choice among the functions `neutral`, `integrate`, `difference` and `normalize`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// All of them for a robot with quaternions or other coordinates of several entries, none for another.
    OfQuaternions,
    /// All of them.
    All,
    /// None.
    None,
}

/// The module; [`Real::Generic`] is printed as `double`.
#[must_use]
pub fn print(module: &Module, options: &LlvmOptions<'_>) -> String {
    let real = match module.scalar {
        Real::F32 => Real::F32,
        Real::F64 | Real::Generic => Real::F64,
    };
    let widths = match options.states {
        States::InLanes(several) if several > 1 => vec![1, several],
        States::InLanes(_) | States::InThreads => vec![1],
    };
    let widths: Vec<Lanes> = (widths.into_iter())
        .map(|count| Lanes { real, count })
        .collect();
    let symbols = symbols(module, options.prefix);
    let mut text = String::new();
    if let Some(asked) = options.asked {
        let mut head = documentation::head(module, asked);
        for (generated, name) in module.functions.iter().zip(&symbols) {
            head.extend(documentation::operation_count(generated, name));
        }
        text.push_str(&comment(&head));
        text.push('\n');
    }
    let own_sines = module.sines == Sines::Own && has_angles(module);
    for &lanes in widths.iter().filter(|_| own_sines) {
        text.push_str(&sines::define(lanes, options.fused));
    }
    for &lanes in &widths {
        text.push_str(&moves(lanes, options.states == States::InThreads));
    }
    let angles = match module.sines {
        Sines::Own => SineAngles::own(real),
        Sines::Platform => SineAngles::As("llvm.sin".to_owned()),
    };
    let functions = module
        .functions
        .iter()
        .zip(symbols)
        .map(|(generated, symbol)| (ComputedFunction::State(generated), symbol));
    let steps = match options.steps {
        Steps::OfQuaternions => ConfigurationFunction::of(module),
        Steps::All => &ConfigurationFunction::ALL,
        Steps::None => &[],
    };
    let steps = steps.iter();
    let steps = steps.map(|&step| {
        (
            ComputedFunction::Step(step),
            own(options.prefix, step.name()),
        )
    });
    for (of, symbol) in functions.chain(steps) {
        if options.asked.is_some() {
            text.push_str(&comment(&match of {
                ComputedFunction::State(generated) => documentation::of_function(
                    module,
                    generated,
                    Some((&angles, Order::AngularFirst)),
                    None,
                ),
                ComputedFunction::Step(step) => documentation::of_step(module, step, Some(&angles)),
            }));
        }
        let function = LlvmFunction::new(module, of, &symbol, options.fused);
        for &lanes in &widths {
            text.push_str(&define(&function, lanes));
        }
        match options.states {
            States::InLanes(_) => {
                text.push_str(&batch(&function, &widths));
                text.push_str(&arrays(&function));
            }
            States::InThreads => text.push_str(&kernel::kernel(&function, widths[0])),
        }
    }
    for lanes in widths {
        text.push_str(&lanes.declarations());
    }
    if options.states == States::InThreads {
        text.push_str(&kernel::declarations());
    }
    text
}

/// Lines as comments; each stays one line.
fn comment(lines: &[String]) -> String {
    let lines = lines.iter().map(|line| format!("; {}", visible(line)));
    let lines = lines.map(|line| line.trim_end().to_owned() + "\n");
    lines.collect()
}
