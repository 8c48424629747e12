//! Numbers of a description reach code exactly, or in 106 bits: none is computed in `f64`, where errors have no bound.
//!
//! In: the sources of the engine from the readers to the layout. The test searches for conversions of a number to
//! `f64`, computations with a written number, and scalars made from anything but literals. Those in [`ALLOWED`] decide,
//! warn or print, or are exact.

use homogen_tests::sources::{Source, code, engine};

/// The folders through which numbers go until they are scalars of a graph.
const FOLDERS: [&str; 6] = [
    "description",
    "chain",
    "layout",
    "joint",
    "closure",
    "matrix",
];

/// Base parameters are sums of parameters with factors that have errors of their own.
const BASE_PARAMETERS: &str = "chain/base_parameters";

/// The expressions of xacro are Python's and round as those do.
const XACRO: &str = "description/xacro/expression";

/// File, part of a line, reason why it is allowed.
const ALLOWED: [(&str, &str, &str); 35] = [
    ("chain/angle.rs", ".value", "decides what digits mean"),
    (
        "chain/merge/reader.rs",
        "(angle)",
        "a nominal value of a field",
    ),
    ("chain/merge/reader.rs", "(sine)", "0 or 1"),
    ("chain/merge/reader.rs", "law.", "printed in a report"),
    (
        "chain/merge/reader.rs",
        "Double::to_f64",
        "a nominal value of a field",
    ),
    ("chain/merge/displacement.rs", "entries", "0 or 1"),
    (
        "chain/axis_rotation.rs",
        ".to_f64()",
        "a nominal value of a field",
    ),
    ("description/axis.rs", ".to_f64()", "a power of two"),
    (
        "description/constant.rs",
        "== 0.0",
        "decides whether there is a quotient",
    ),
    (
        "description/mjcf/geom.rs",
        ".to_f64()",
        "decides whether there is a mass or a size",
    ),
    (
        "description/mjcf/inertial.rs",
        ".to_f64() > 0.0",
        "decides which is larger",
    ),
    (
        "description/mjcf/inertial.rs",
        "Double::to_f64",
        "decides as MuJoCo does",
    ),
    (
        "description/mjcf/assets.rs",
        ".to_f64()",
        "decides an order, and whether there is a size",
    ),
    (
        "description/mjcf/mesh/hull.rs",
        ".to_f64()",
        "decides on which side a point is",
    ),
    (
        "description/mjcf/shape.rs",
        "along.to_f64() > 0.0",
        "decides whether there is a size",
    ),
    (
        "description/mjcf/shape.rs",
        "(a - b).sign().to_f64()",
        "decides which is larger",
    ),
    (
        "description/mjcf/orientation.rs",
        ".sign().to_f64()",
        "chooses a formula",
    ),
    (
        "description/sdf/gearbox.rs",
        ".sign().to_f64()",
        "decides which way a hinge turns",
    ),
    (
        "description/spatial.rs",
        ".sign().to_f64()",
        "chooses a formula",
    ),
    (
        "description/spatial.rs",
        "h.to_f64() < 0.0",
        "chooses a root",
    ),
    (
        "description/spatial.rs",
        "d[i][j].to_f64()",
        "decides when to stop",
    ),
    ("layout/frames.rs", ">= NEARLY_PARALLEL", "chooses a frame"),
    ("layout/frames.rs", "< 0.0", "chooses one of two formulas"),
    ("matrix/pose.rs", "Double::to_f64", "chooses an axis"),
    ("matrix/vector.rs", "abs()", "chooses a power of two"),
    ("matrix/vector.rs", "towards_one", "a power of two"),
    ("chain/merge/reader.rs", "GRAVITY", "a literal"),
    ("chain/physical.rs", "Double::to_f64", "warns"),
    ("matrix/pose.rs", "entries", "0 or 1"),
    ("matrix/pose.rs", "size.max", "chooses a power of two"),
    ("matrix/pose.rs", "towards_one", "a power of two"),
    ("chain/merge/reader.rs", "rotation.map", "0, 1 or -1"),
    ("joint/manifold.rs", "let constant =", "0 or 1"),
    (
        "joint/manifold/steps.rs",
        "constant(",
        "numbers of the formulas",
    ),
    ("matrix/vector.rs", "entries", "constants of the caller"),
];

/// The lines of code in which a number may lose digits.
fn suspicious(code: &str) -> Vec<&str> {
    let lines = code.lines().map(str::trim);
    let is = |line: &&str| {
        let computes = line.contains(".value")
            && !line.contains(".value(")
            && [" + ", " - ", " * ", " / ", ".sqrt()"]
                .iter()
                .any(|operation| line.contains(operation));
        let made = line.split("constant(").skip(1).any(|argument| {
            let plain = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
            let argument = argument.trim_start_matches("graph, [");
            !argument.starts_with(plain) && !line.contains("fn constant(")
        });
        line.contains("to_f64") || computes || made
    };
    lines.filter(is).collect()
}

#[test]
fn no_written_number_is_computed_in_f64() {
    let mut files = engine();
    files.retain(|Source { name, .. }| {
        let folder = name.split('/').next().unwrap_or_default();
        FOLDERS.contains(&folder.trim_end_matches(".rs"))
            && !name.starts_with(BASE_PARAMETERS)
            && !name.starts_with(XACRO)
    });
    assert!(files.len() > 60, "{} files", files.len());
    let mut diagnostics = Vec::new();
    for Source { name, code } in &files {
        for line in suspicious(code) {
            let mut allowed = ALLOWED.iter();
            if !allowed.any(|(file, part, _)| file == name && line.contains(part)) {
                diagnostics.push(format!("{name}: {line}"));
            }
        }
    }
    assert!(diagnostics.is_empty(), "{diagnostics:#?}");
}

#[test]
fn suspicious_lines_are_found() {
    assert_eq!(suspicious("let x = a.value / length;").len(), 1);
    assert_eq!(suspicious("graph.constant(pitch.value)").len(), 1);
    assert_eq!(suspicious("let x = (a * b).to_f64();").len(), 1);
    let without = code("// a.value / b\ngraph.constant(1.0)\nx.value() * y\n");
    assert!(suspicious(&without).is_empty());
}
