//! The module in Python, and its stub for editors and type checkers.
//!
//! In: a [`Class`]. Out: the texts of `__init__.py` and `__init__.pyi`. Text of a description is printed only in
//! docstrings and as checked names.

use std::fmt::Write;

use super::class::{LIMITS, vectors};
use super::described::{Class, Method};
use super::literals::docstring;
use crate::print::documentation;

/// The module.
pub(super) fn init(class: &Class<'_>) -> String {
    let mut text = format!("# {}\n", head());
    text.push_str(&docstring(&of_module(class), ""));
    text.push_str("\n\n");
    if class.methods.iter().any(|method| method.tuple.is_some()) {
        text.push_str("from typing import NamedTuple as _NamedTuple\n\nimport numpy as _np\n\n");
    }
    let native = format!("from ._{} import {}\n", class.import_name, class.name);
    text.push_str(&native);
    for (method, tuple) in tuples(class) {
        let base = "_NamedTuple";
        tuple_class(&mut text, class, method, tuple, base, "_np.ndarray");
    }
    let names: Vec<String> = [&class.name]
        .into_iter()
        .chain(tuples(class).map(|(_, tuple)| tuple))
        .map(|name| format!("\"{name}\""))
        .collect();
    // Writing to a string cannot fail.
    let _ = writeln!(text, "\n__all__ = [{}]", names.join(", "));
    text
}

/// The stub.
pub(super) fn stub(class: &Class<'_>) -> String {
    let mut text = format!(
        "# {}\n{}\n\nfrom typing import Final as _Final, NamedTuple as _NamedTuple\n\nimport numpy as _np\n\
         from numpy.typing import ArrayLike as _ArrayLike, NDArray as _NDArray\n",
        head(),
        docstring(&of_module(class), "")
    );
    let array = format!("_NDArray[_np.{}]", class.dtype());
    for (method, tuple) in tuples(class) {
        tuple_class(&mut text, class, method, tuple, "_NamedTuple", &array);
    }
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\nclass {}:\n    {}\n\n    NQ: _Final[int]\n    NV: _Final[int]",
        class.name,
        docstring(&class.about, "    ")
    );
    for (name, about, _) in &class.names {
        let about = docstring(&[(*about).to_owned()], "    ");
        let _ = writeln!(text, "    {name}: _Final[tuple[str, ...]]\n    {about}");
    }
    constructor(&mut text, class);
    let limits = LIMITS.iter().map(|(name, about, _)| (*name, *about));
    let vectors = vectors(class).into_iter();
    let vectors = vectors.map(|(name, about, _)| (name, about));
    for (name, about) in limits.chain(vectors) {
        property(&mut text, name, "_NDArray[_np.float64]", about);
    }
    for (name, field) in &class.fields {
        let kind = number_or_list(field.target.entries());
        property(
            &mut text,
            name,
            kind,
            &documentation::of_field(&field.target),
        );
    }
    for each in &class.methods {
        method(&mut text, class, each, &array);
    }
    text
}

fn head() -> String {
    format!(
        "{} {}; do not edit.",
        super::MARK,
        env!("CARGO_PKG_VERSION")
    )
}

/// Documentation of the module.
pub(super) fn of_module(class: &Class<'_>) -> Vec<String> {
    let Class {
        import_name, name, ..
    } = class;
    let mut lines = vec![
        "Kinematics and dynamics of one robot, as straight-line code.".to_owned(),
        String::new(),
        format!("from {import_name} import {name}"),
        String::new(),
        "Every function takes one state or arrays of them, of any leading shape (...); leading axes are".to_owned(),
        "broadcast as in NumPy. Arrays are read in place if they are aligned, contiguous in C order".to_owned(),
    ];
    lines.push(format!(
        "and of {}, and copied if NumPy can cast them safely. A TypeError reports an unsafe",
        class.dtype()
    ));
    lines.extend(
        [
            "cast, a ValueError wrong shapes. More than a few states are computed by all cores; their",
            "number (RAYON_NUM_THREADS) changes no bit. Python's lock is released: do not write to arguments",
            "meanwhile. A state with NaN, infinite or huge numbers follows IEEE 754 arithmetic and",
            "changes no other. An array passed as out, contiguous and of the shape and type of the result, is",
            "written to and returned.",
        ]
        .map(str::to_owned),
    );
    lines
}

fn tuples<'c>(class: &'c Class<'_>) -> impl Iterator<Item = (&'c Method, &'c String)> {
    let methods = class.methods.iter();
    methods.filter_map(|method| method.tuple.as_ref().map(|tuple| (method, tuple)))
}

fn tuple_class(
    text: &mut String,
    class: &Class<'_>,
    method: &Method,
    tuple: &str,
    base: &str,
    array: &str,
) {
    let title = format!("Result of {}.{}.", class.name, method.name);
    let results = method.results.iter();
    let about = [title, String::new()].into_iter();
    let about = about.chain(results.map(|result| format!("- {}.", result.documented())));
    let about: Vec<String> = about.collect();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n\nclass {tuple}({base}):\n    {}\n",
        docstring(&about, "    ")
    );
    for result in &method.results {
        let _ = writeln!(text, "    {}: {array}", result.field);
    }
}

fn constructor(text: &mut String, class: &Class<'_>) {
    let fields = class.fields.iter();
    let fields = fields.map(|(name, field)| {
        let kind = number_or_list(field.target.entries());
        format!(", {name}: {kind}")
    });
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n    def __init__(self{}) -> None: ...",
        fields.collect::<String>()
    );
}

const fn number_or_list(entries: usize) -> &'static str {
    match entries {
        1 => "float",
        _ => "list[float]",
    }
}

fn property(text: &mut String, name: &str, kind: &str, about: &str) {
    let about = docstring(&[about.to_owned()], "        ");
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n    @property\n    def {name}(self) -> {kind}:\n        {about}"
    );
}

fn method(text: &mut String, class: &Class<'_>, method: &Method, array: &str) {
    let arguments = method.arguments.iter();
    let arguments: Vec<String> = arguments
        .map(|(argument, _)| format!(", {argument}: _ArrayLike"))
        .collect();
    let arguments = arguments.concat();
    let out = if method.tuple.is_none() {
        format!(", *, out: {array} | None = None")
    } else {
        String::new()
    };
    let returned = match (&method.tuple, &*method.results) {
        (Some(tuple), _) => tuple.clone(),
        (None, [result]) if result.is_number() => format!("{array} | _np.{}", class.dtype()),
        (None, _) => array.to_owned(),
    };
    let about = docstring(&method.about, "        ");
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "\n    def {}(self{arguments}{out}) -> {returned}:\n        {about}",
        method.name
    );
}
