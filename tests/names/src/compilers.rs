//! Compiles and runs the files of a batch with the compilers of each language.
//!
//! In: a [`Batch`] that is written. Out: the messages of compilers and of failing tests, as text. All robots are in
//! one program of each language, so that each is linked with each.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use homogen_codegen::print::c::{own, prefix};

use crate::files::Batch;

/// The output of a compiler or test that failed.
pub type Diagnostic = String;

/// Headers that are included before those of the robots, for the macros that they define.
const HEADERS: [&str; 12] = [
    "complex.h",
    "errno.h",
    "fenv.h",
    "float.h",
    "inttypes.h",
    "limits.h",
    "math.h",
    "signal.h",
    "stdio.h",
    "stdlib.h",
    "string.h",
    "time.h",
];

const C: [&str; 8] = [
    "-std=c99",
    "-pedantic",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Werror",
    "-O1",
    "-ffp-contract=off",
];

const CPP: [&str; 6] = [
    "-std=c++20",
    "-pedantic",
    "-Wall",
    "-Wextra",
    "-Werror",
    "-O0",
];

/// True if a program can be run.
#[must_use]
pub fn is_here(program: &str) -> bool {
    let version = Command::new(program).arg("--version").output();
    version.is_ok_and(|output| output.status.success())
}

/// Compiles the Rust files in one crate and runs their tests; the `extern "C"` files are modules beside them.
///
/// # Errors
/// The output of the compiler, or of the test that failed.
pub fn rust(batch: &Batch, edition: &str) -> Result<(), Diagnostic> {
    let mut main = "// Users choose the names.\n\
         #![deny(warnings)]\n#![allow(non_camel_case_types, non_snake_case, uncommon_codepoints)]\n\
         #![allow(confusable_idents, mixed_script_confusables, dead_code)]\n"
        .to_owned();
    for (number, _) in &batch.robots {
        for kind in ["r", "x"] {
            // Writing to a string cannot fail.
            let _ = writeln!(main, "#[path = \"{kind}{number}.rs\"]\nmod {kind}{number};");
        }
    }
    let file = batch.folder.join(format!("all_{edition}.rs"));
    write(&file, &main);
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let program = batch.folder.join(format!("all_{edition}"));
    let mut command = Command::new(rustc);
    command.args([
        "--test",
        "--edition",
        edition,
        "-C",
        "debuginfo=0",
        "-C",
        "opt-level=0",
    ]);
    succeed(command.arg("-o").arg(&program).arg(&file))?;
    succeed(Command::new(program).arg("--quiet"))
}

/// Compiles the C files, each by itself, and links them into one program that includes many headers and runs all tests.
///
/// # Errors
/// The output of the compiler, or the robots whose tests fail.
pub fn c(batch: &Batch, compiler: &str) -> Result<Vec<PathBuf>, Diagnostic> {
    let mut objects = Vec::new();
    for (number, _) in &batch.robots {
        let source = batch.folder.join(format!("c{number}.c"));
        let object = batch.folder.join(format!("c{number}_{compiler}.o"));
        let mut command = Command::new(compiler);
        command.args(C).args(["-DHOMOGEN_SELF_TEST", "-c"]);
        succeed(command.arg(source).arg("-o").arg(&object))?;
        objects.push(object);
    }
    let main = batch.folder.join("main.c");
    write(&main, &program(batch));
    let mut command = Command::new(compiler);
    // Macros of POSIX too.
    command
        .args(C)
        .args(["-D_GNU_SOURCE", "-DHOMOGEN_SELF_TEST"])
        .arg(main);
    let program = batch.folder.join(format!("main_{compiler}"));
    succeed(command.args(&objects).arg("-o").arg(&program).arg("-lm"))?;
    succeed(&mut Command::new(program))?;
    Ok(objects)
}

/// Compiles a C++ program that includes all headers, and links it with the objects of C.
///
/// # Errors
/// The output of the compiler, or the robots whose tests fail.
pub fn cpp(batch: &Batch, compiler: &str, objects: &[PathBuf]) -> Result<(), Diagnostic> {
    let main = batch.folder.join("main.cpp");
    write(&main, &program(batch));
    let mut command = Command::new(compiler);
    command.args(CPP).arg("-DHOMOGEN_SELF_TEST").arg(main);
    let program = batch.folder.join(format!("main_{compiler}"));
    succeed(command.args(objects).arg("-o").arg(&program).arg("-lm"))?;
    succeed(&mut Command::new(program))
}

/// The program that runs all tests, the same in C and C++.
fn program(batch: &Batch) -> String {
    let mut text = String::new();
    for header in HEADERS {
        // The complex.h of C++ is not that of C.
        let _ = match header {
            "complex.h" => writeln!(text, "#ifndef __cplusplus\n#include <complex.h>\n#endif"),
            header => writeln!(text, "#include <{header}>"),
        };
    }
    for word in ["near", "far", "small", "interface", "signals", "slots"] {
        let _ = writeln!(text, "#define {word}");
    }
    for (number, _) in &batch.robots {
        let _ = writeln!(text, "#include \"c{number}.h\"");
    }
    text.push_str("int main(void)\n{\n    int wrong = 0;\n");
    for (number, robot) in &batch.robots {
        let test = own(&prefix(&robot.name), "self_test");
        let _ = writeln!(
            text,
            "    if ({test}() != 0) {{ wrong++; fprintf(stderr, \"robot {number}\\n\"); }}"
        );
    }
    text + "    return wrong != 0;\n}\n"
}

/// Parses the Python files of all packages.
///
/// # Errors
/// The output of Python.
pub fn python_texts(packages: &[PathBuf]) -> Result<(), Diagnostic> {
    const READ: &str = "\
import ast, keyword, pathlib, sys
for folder in map(pathlib.Path, sys.stdin.read().splitlines()):
    assert folder.name.isidentifier() and not keyword.iskeyword(folder.name), folder
    assert folder.name not in getattr(sys, 'stdlib_module_names', ()), folder
    for file in [*folder.rglob('*.py'), *folder.rglob('*.pyi')]:
        ast.parse(file.read_text(encoding='utf-8'), str(file))
        compile(file.read_text(encoding='utf-8'), str(file), 'exec')
";
    let list = packages.iter().map(|folder| folder.display().to_string());
    let list = list.collect::<Vec<_>>().join("\n");
    let Some(folder) = packages.first().and_then(|package| package.parent()) else {
        return Ok(());
    };
    let [script, input] = ["read.py", "packages"].map(|name| folder.with_file_name(name));
    write(&script, READ);
    write(&input, &list);
    let input = fs::File::open(input).map_err(|reason| reason.to_string())?;
    succeed(Command::new("python3").arg(script).stdin(input))
}

/// Checks the Rust crates of the packages in one workspace, without linking.
///
/// # Errors
/// The output of cargo.
pub fn python_crates(packages: &[PathBuf]) -> Result<(), Diagnostic> {
    let Some(folder) = packages.first().and_then(|package| package.parent()) else {
        return Ok(());
    };
    for package in packages {
        let manifest = package.join("Cargo.toml");
        let text = fs::read_to_string(&manifest).map_err(|reason| reason.to_string())?;
        // A package alone is a workspace of its own.
        let (text, _) = text.rsplit_once("[workspace]").unwrap_or((&text, ""));
        let text: String = text.lines().fold(String::new(), |mut text, line| {
            let profile = line == "[profile.release]" || line == "strip = true";
            text.push_str(if profile { "" } else { line });
            text.push('\n');
            text
        });
        write(&manifest, &text);
    }
    let members = packages.iter().filter_map(|package| package.file_name());
    let members = members.map(|name| format!("{:?}", name.to_string_lossy()));
    let members = members.collect::<Vec<_>>().join(", ");
    let text = format!("[workspace]\nresolver = \"3\"\nmembers = [{members}]\n");
    write(&folder.join("Cargo.toml"), &text);
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["check", "--workspace", "--quiet"]);
    // Dependencies are built once for all batches.
    let batches = folder.ancestors().nth(2).unwrap_or(folder);
    command.env("CARGO_TARGET_DIR", batches.join("checked"));
    succeed(
        command
            .arg("--manifest-path")
            .arg(folder.join("Cargo.toml")),
    )
}

fn write(file: &Path, text: &str) {
    fs::write(file, text).expect("a file in a folder of our own");
}

/// Runs a command; an exit status other than 0 is an error.
fn succeed(command: &mut Command) -> Result<(), Diagnostic> {
    let output = command.output();
    let output = output.map_err(|reason| format!("{command:?}: {reason}"))?;
    if output.status.success() {
        return Ok(());
    }
    let texts =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    let text = texts.concat();
    let head: String = text
        .lines()
        .take(60)
        .fold(String::new(), |head, line| head + line + "\n");
    Err(format!("{command:?}\n{head}"))
}
