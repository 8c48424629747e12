//! The engine as a native module: what the Python package `homogen` is built on.
//!
//! In: descriptions, options, arrays of NumPy. Out: names, limits, documentation and LLVM IR; and results, computed by code
//! that LLVM has made of that and whose address is known here. The module compiles nothing itself.

mod function;
mod recipe;
mod states;

use pyo3::prelude::*;

/// The module `homogen._engine`.
#[pymodule]
mod _engine {
    use homogen_codegen::function::{First, Function as Name};
    use homogen_codegen::print::arrays::has_order;
    use homogen_codegen::request::setting::{ROBOT, SCOPE, SETTINGS, SOURCE};
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::function::Function;
    #[pymodule_export]
    use super::recipe::Recipe;

    /// The version of the engine.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");

    /// The options of a robot and of its file: each keyword, and a sentence about it.
    #[pyfunction]
    fn options() -> Vec<(&'static str, &'static str)> {
        let rows = SETTINGS.iter();
        let rows = rows.filter(|setting| setting.group & (SOURCE | SCOPE | ROBOT) != 0);
        rows.map(|setting| (setting.key, setting.help)).collect()
    }

    /// A function of any robot: name, sentence, names of arguments, names of several results; then flags: it is of a frame,
    /// it has an order, its result is a number; last what only robots with loops or with collision spheres have.
    type Row = (
        &'static str,
        String,
        Vec<&'static str>,
        Vec<&'static str>,
        bool,
        bool,
        bool,
        &'static str,
    );

    /// The functions, a row each.
    #[pyfunction]
    fn functions() -> Vec<Row> {
        // The frames are an argument here: `forward_kinematics` has the poses of several.
        let all = Name::every().filter(|name| *name != Name::FramePoses);
        let rows = all.map(|name| {
            let arguments = name.arguments_with(true);
            let parts = name.result().parts().filter_map(|(part, _)| part);
            (
                name.name(),
                name.sentence("the base", "the frame"),
                arguments.iter().map(|of| of.name()).collect(),
                parts.collect(),
                name.of_a_frame(),
                has_order(name, &arguments),
                name.result().is_number(),
                match name {
                    _ if name.is_of_loops() => "loops",
                    _ if name.is_of_spheres() => "spheres",
                    _ => "",
                },
            )
        });
        rows.collect()
    }

    /// The functions that have derivatives of a function: the first ones, second ones, and products with weights.
    #[pyfunction]
    fn derivatives(name: &str) -> [Vec<&'static str>; 3] {
        let of = Name::every()
            .filter(|of| of.name() == name)
            .find_map(Name::derivatives);
        let distinct = |functions: Vec<Name>| {
            let mut names: Vec<&str> = functions.iter().map(|of| of.name()).collect();
            names.dedup();
            names
        };
        let first = |of: &[First]| distinct(of.iter().map(|first| first.function).collect());
        match of {
            Some(of) => [
                first(of.first),
                distinct(of.second.iter().map(|second| second.function).collect()),
                first(of.products),
            ],
            None => Default::default(),
        }
    }

    /// The command line: standard output, standard error, and the status.
    #[pyfunction]
    fn answer(py: Python<'_>, arguments: Vec<String>) -> (String, String, u8) {
        let words = ["homogen".to_owned()].into_iter().chain(arguments);
        let words = words.map(Into::into);
        let answer = py.detach(|| homogen_cli::answer(words, &mut std::io::empty()));
        (answer.output, answer.remarks, answer.code)
    }
}
