//! Printed code is the same on every platform: the engine calls no function whose last bit depends on a platform's
//! library or compiler.
//!
//! In: the sources of the engine. The test searches for such functions outside of tests. Those in [`ALLOWED`] belong to
//! our own types of number, which have their own sines, or do not affect what is printed.

use homogen_tests::sources::{Source, code, engine};

/// Functions of `f64` whose accuracy Rust does not specify. Sums, products, quotients, square roots and `mul_add` are
/// correctly rounded everywhere.
const OPEN: [&str; 26] = [
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "cos", "cosh", "exp",
    "exp2", "exp_m1", "hypot", "ln", "ln_1p", "log", "log10", "log2", "powf", "powi", "sin",
    "sin_cos", "sinh", "tan", "tanh",
];

/// File, function, reason why it may be called there.
const ALLOWED: [(&str, &str, &str); 30] = [
    (
        "chain/merge/displacement.rs",
        "sin_cos",
        "of a scalar of the graph",
    ),
    (
        "chain/merge/reader.rs",
        "sin_cos",
        "of a scalar of the graph",
    ),
    (
        "chain/axis_rotation.rs",
        "atan2",
        "an initial value; a step in doubles gives the same result everywhere",
    ),
    ("chain/axis_rotation.rs", "sin_cos", "of a double"),
    ("check/closing.rs", "sin_cos", "of a double"),
    (
        "check/robot/matrices.rs",
        "sin_cos",
        "of a double and its error",
    ),
    (
        "check/robot/written.rs",
        "sin_cos",
        "of a double and its error",
    ),
    ("description/mjcf/orientation.rs", "sin_cos", "of a double"),
    ("description/spatial.rs", "sin_cos", "of a double"),
    (
        "description/xacro/expression/elementary.rs",
        "atan2",
        "an initial value; the result for numbers beyond 1e140 and below 1e-140",
    ),
    (
        "description/xacro/expression/elementary.rs",
        "ln",
        "an initial value; a step in doubles gives the same result everywhere",
    ),
    (
        "description/xacro/expression/elementary.rs",
        "powf",
        "of zero, infinity and NaN",
    ),
    (
        "description/xacro/expression/elementary.rs",
        "sin_cos",
        "of a double",
    ),
    ("dense/approximate.rs", "sin_cos", "of a double"),
    ("dense/matrix.rs", "sin_cos", "of our own arithmetic"),
    (
        "dense/configuration.rs",
        "sin_cos",
        "of a double and its error",
    ),
    ("plan/measured/rounded.rs", "sin_cos", "of a double"),
    ("expand/review.rs", "sin_cos", "of a double"),
    (
        "expression/evaluate.rs",
        "sin_cos",
        "eval computes as the platform does",
    ),
    (
        "expression/derivative.rs",
        "sin_cos",
        "of a scalar of the graph",
    ),
    ("expression/graph.rs", "sin_cos", "of a double"),
    ("expression/term.rs", "sin_cos", "of a scalar of the graph"),
    ("joint/manifold.rs", "sin_cos", "of a scalar of the graph"),
    (
        "joint/manifold/steps.rs",
        "sin_cos",
        "of a scalar of the graph",
    ),
    ("schedule/bound/value.rs", "sin_cos", "of a double"),
    ("print/llvm/body.rs", "sin_cos", "the name of a function"),
    ("print/llvm/sines.rs", "sin_cos", "the name of a function"),
    (
        "print/python/package/number.rs",
        "sin_cos",
        "what packages compute at run time beyond their own sines",
    ),
    (
        "print/python/package/pack.rs",
        "sin_cos",
        "the same, lane by lane",
    ),
    (
        "schedule/run.rs",
        "sin_cos",
        "eval computes as the platform does",
    ),
];

/// The calls of such functions in code.
fn calls(code: &str) -> Vec<&'static str> {
    let called = |name: &&&str| {
        let method = format!(".{name}(");
        let path = ["f64", "f32"].map(|number| format!("{number}::{name}"));
        code.contains(&method)
            || path.iter().any(|path| {
                let mut found = code.match_indices(path.as_str());
                // `f64::exp` is not `f64::exp2`.
                found.any(|(at, path)| {
                    let next = code[at + path.len()..].chars().next();
                    !next.is_some_and(|next| next.is_alphanumeric() || next == '_')
                })
            })
    };
    OPEN.iter().filter(called).copied().collect()
}

#[test]
fn no_function_is_called_whose_result_depends_on_the_platform() {
    let files = engine();
    assert!(files.len() > 80, "{} files", files.len());
    let mut diagnostics = Vec::new();
    for Source { name, code } in &files {
        for function in calls(code) {
            let mut allowed = ALLOWED.iter();
            if !allowed.any(|(file, other, _)| (*file, *other) == (name, function)) {
                diagnostics.push(format!("{name} calls {function}"));
            }
        }
    }
    assert!(diagnostics.is_empty(), "{diagnostics:#?}");
}

#[test]
fn such_calls_are_found() {
    assert_eq!(calls("let x = y.hypot(z);"), ["hypot"]);
    assert_eq!(calls("values.fold(0.0, f64::hypot)"), ["hypot"]);
    assert_eq!(calls("f64::exp2(x)"), ["exp2"]);
    let without = code("// y.hypot(z)\nx.sqrt()\n#[cfg(test)]\nmod tests { x.sin() }");
    assert!(calls(&without).is_empty());
}
