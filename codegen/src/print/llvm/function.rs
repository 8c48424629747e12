//! A function of a module: its parameters, loads and stores.
//!
//! In: a [`GeneratedFunction`] or a function of configurations, its symbol, and the type of a value. Out: its
//! definition. With one lane the parameters are those of the C file; with several, each entry of an argument and a
//! result is a vector. Fields are numbers in the order of the robot's struct, the same for all lanes.

use std::fmt::Write;

use super::body::{LlvmWriter, local};
use super::lanes::Lanes;
use crate::module::{GeneratedFunction, Module};
use crate::print::Fields;
use crate::print::arrays::below;
use crate::print::c::results;
use crate::print::large::columns;
use crate::print::steps::ConfigurationFunction;
use crate::print::walk::walk;
use crate::schedule::{Entries, Names, Readable, Routine, Stored, Work};

/// Name of the parameter that points to the fields.
pub(super) const ROBOT: &str = "robot";

/// A function for any number of lanes.
pub(super) struct LlvmFunction<'l> {
    module: &'l Module,
    of: ComputedFunction<'l>,
    pub(super) symbol: &'l str,
    fused: bool,
}

/// Function that it computes.
#[derive(Clone, Copy)]
pub(super) enum ComputedFunction<'l> {
    /// Function of the state.
    State(&'l GeneratedFunction),
    /// Function of configurations.
    Step(ConfigurationFunction),
}

/// Parameter that points to numbers.
pub(super) struct Pointer {
    /// Name.
    pub name: String,
    /// Count of numbers of one state.
    pub len: usize,
    /// Constant row below a matrix, which the function does not store.
    pub below: Option<[f64; 4]>,
}

impl<'l> LlvmFunction<'l> {
    pub(super) fn new(
        module: &'l Module,
        of: ComputedFunction<'l>,
        symbol: &'l str,
        fused: bool,
    ) -> Self {
        Self {
            module,
            of,
            symbol,
            fused,
        }
    }

    /// True if its first parameter is a pointer to fields.
    pub(super) fn has_fields(&self) -> bool {
        !self.module.parameters.is_empty()
    }

    pub(super) fn arguments(&self) -> Vec<Pointer> {
        let spaces = &self.module.spaces;
        let pointer = |name: &str, space| Pointer {
            name: name.to_owned(),
            len: spaces.len(space),
            below: None,
        };
        match self.of {
            ComputedFunction::State(generated) => (generated.arguments(spaces).iter())
                .map(|argument| pointer(argument.name(), argument.space()))
                .collect(),
            ComputedFunction::Step(step) => (step.arguments().iter())
                .map(|&(name, space)| pointer(name, space))
                .collect(),
        }
    }

    pub(super) fn results(&self) -> Vec<Pointer> {
        let generated = match self.of {
            ComputedFunction::State(generated) => generated,
            ComputedFunction::Step(step) => {
                return vec![Pointer {
                    name: step.name().to_owned(),
                    len: self.module.spaces.len(step.result()),
                    below: None,
                }];
            }
        };
        let results = results(&generated.functions);
        let is_only = results.len() == 1;
        let results = results.into_iter().map(|(name, quantity)| Pointer {
            name,
            // In the order of arrays, results have fourth rows below each of several matrices.
            len: if is_only {
                generated.program.results.len()
            } else {
                quantity.size(&self.module.spaces)
            },
            below: below(&quantity),
        });
        results.collect()
    }

    /// Symbol of the function for these lanes.
    pub(super) fn name(&self, lanes: Lanes) -> String {
        format!("@{}{}", self.symbol, lanes.suffix())
    }

    /// Count of the numbers of all fields.
    pub(super) fn fields(&self) -> usize {
        let fields = Fields::Own(&self.module.parameters).entries();
        fields.iter().map(Vec::len).sum()
    }

    fn routine(&self) -> Routine {
        let mut names = Names::default();
        names.take(ROBOT);
        let results = self.results();
        for result in &results {
            names.take(&result.name);
        }
        let generated = match self.of {
            ComputedFunction::State(generated) => generated,
            ComputedFunction::Step(step) => {
                for argument in self.arguments() {
                    names.take(&argument.name);
                }
                return step.routine(self.module, names);
            }
        };
        let fields = Fields::Own(&self.module.parameters).entries();
        let readable = Readable {
            arguments: &generated.arguments(&self.module.spaces),
            spaces: &self.module.spaces,
            // Vectors hold several states.
            limbs: &[],
            fields: &fields,
        };
        let large = columns(&generated.functions, &self.module.spaces).is_some();
        let when = if large {
            Stored::Early
        } else {
            Stored::AtTheEnd
        };
        let program = (&generated.program, self.module.length);
        Routine::of(program, &readable, names, when)
    }
}

/// Definition for these lanes, with those of its sections.
pub(super) fn define(function: &LlvmFunction<'_>, lanes: Lanes) -> String {
    let routine = function.routine();
    let mut writer = LlvmWriter::new(lanes, function.fused, function.module.sines);
    let results = function.results();
    writer.filled = results.first().map(|result| result.name.clone());
    load(&mut writer, function, &routine);
    walk(&mut writer, &routine.statements);
    let mut sections = String::new();
    if let Some(work) = &routine.work {
        call(&mut writer, function, work);
        sections = define_sections(function, work, lanes);
    }
    let mut values = routine.results.iter().enumerate();
    for result in &results {
        for (k, (index, value)) in values.by_ref().take(result.len).enumerate() {
            if routine.stored.contains(&index) {
                continue;
            }
            let value = writer.read(value);
            let address = writer.entry(&local(&result.name), &k.to_string());
            writer.store_at(&address, &value);
        }
    }
    let fields = function.has_fields().then(|| ROBOT.to_owned()).into_iter();
    let pointers = function.arguments().into_iter().chain(results);
    let parameters = fields.chain(pointers.map(|pointer| pointer.name));
    let parameters = parameters.map(|name| format!("ptr {}", local(&name)));
    let parameters: Vec<String> = parameters.collect();
    let visible = if lanes.count == 1 { "" } else { "internal " };
    let mut text = sections;
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "define {visible}void {}({}) nounwind {{\n{}  ret void\n}}\n",
        function.name(lanes),
        parameters.join(", "),
        writer.finish()
    );
    text
}

/// Loads all arguments and fields that are read, before any result is stored.
fn load(writer: &mut LlvmWriter, function: &LlvmFunction<'_>, routine: &Routine) {
    let (value, size) = (writer.lanes.value(), writer.lanes.size());
    let state = routine.arguments.iter().map(|(_, entries)| entries);
    let (arguments, fields): (Vec<_>, &[Entries]) = match function.of {
        ComputedFunction::State(_) => (state.collect(), &routine.fields),
        ComputedFunction::Step(_) => (routine.fields.iter().collect(), &[]),
    };
    for (argument, entries) in function.arguments().iter().zip(arguments) {
        for (k, name) in entries.iter().enumerate() {
            let Some(name) = name else { continue };
            let address = writer.entry(&local(&argument.name), &k.to_string());
            writer.load_as(name, &address);
        }
    }
    let number = writer.lanes.number();
    for (k, name) in fields.iter().flatten().enumerate() {
        let Some(name) = name else { continue };
        let address = writer.between(&format!(
            "getelementptr {number}, ptr {}, i64 {k}",
            local(ROBOT)
        ));
        let load = format!("load {number}, ptr {address}, align {size}");
        if writer.lanes.count == 1 {
            writer.bind(name, &load);
            continue;
        }
        let one = writer.between(&load);
        let first = writer.between(&format!(
            "insertelement {value} poison, {number} {one}, i64 0"
        ));
        let count = writer.lanes.count;
        writer.bind(
            name,
            &format!(
                "shufflevector {value} {first}, {value} poison, <{count} x i32> zeroinitializer"
            ),
        );
    }
}

fn section(function: &LlvmFunction<'_>, name: &str, lanes: Lanes) -> String {
    format!("@{}.{name}{}", function.symbol, lanes.suffix())
}

/// The work array, its initial values, and the calls of the sections.
fn call(writer: &mut LlvmWriter, function: &LlvmFunction<'_>, work: &Work) {
    let kind = format!("[{} x {}]", work.len, writer.lanes.value());
    writer.array(&work.name, &kind);
    writer.work = Some(work.name.clone());
    for (place, value) in &work.initial {
        let value = writer.read(value);
        let address = writer.work_entry(*place);
        writer.store_at(&address, &value);
    }
    for each in &work.sections {
        let name = section(function, &each.name, writer.lanes);
        writer.line(&format!("call void {name}(ptr {})", local(&work.name)));
    }
}

/// Sections, each a function of the work array alone.
fn define_sections(function: &LlvmFunction<'_>, work: &Work, lanes: Lanes) -> String {
    let mut text = String::new();
    for each in &work.sections {
        let mut writer = LlvmWriter::new(lanes, function.fused, function.module.sines);
        writer.work = Some(work.name.clone());
        for (place, name) in &each.loads {
            let address = writer.work_entry(*place);
            writer.load_as(name, &address);
        }
        walk(&mut writer, &each.statements);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "define internal void {}(ptr {}) noinline nounwind {{\n{}  ret void\n}}\n",
            section(function, &each.name, lanes),
            local(&work.name),
            writer.finish()
        );
    }
    text
}
