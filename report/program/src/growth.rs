//! Growth with the number of joints.
//!
//! In: a limit. Out: for chains of 1 to 64 joints, the operation count of each function and the times to expand, to
//! compile and to call it. Each program is compiled alone, as a crate that needs `core` and the platform's sines.

use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;
use std::{env, fs};

use homogen_codegen::Function::{
    self, ForwardDynamics, ForwardKinematics, Gravity, InverseDynamics, MassMatrix,
};
use homogen_codegen::description::Description;
use homogen_codegen::expand::expand;
use homogen_codegen::print::rust::{self, CoreFunctions, Item, Library};
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::OperationCount;

use crate::chain::chain;
use crate::progress::Progress;
use crate::truth::as_one;

/// The functions, one for each kind of growth.
pub const FUNCTIONS: [Function; 5] = [
    ForwardKinematics,
    Gravity,
    InverseDynamics,
    MassMatrix,
    ForwardDynamics,
];

/// The costs of one function of one chain.
#[derive(Clone, Debug)]
pub struct Grown {
    /// Number of joints.
    pub joints: usize,
    /// The function.
    pub function: Function,
    /// Its operations.
    pub operation_count: OperationCount,
    /// From the description to tokens \[s\].
    pub expansion: f64,
    /// From the source to an optimised executable \[s\]; `None` if it was not compiled.
    pub compilation: Option<f64>,
    /// Time per call, median \[ns\].
    pub call: Option<f64>,
}

/// The numbers of joints.
pub const JOINTS: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];

/// Measures all functions of all chains; functions of more than `most` operations are only counted.
///
/// # Errors
/// A failure of the compiler.
pub fn measure(
    joints: &[usize],
    most: usize,
    folder: &Path,
    progress: &mut Progress,
) -> Result<Vec<Grown>, Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let mut grown = Vec::new();
    for &joints in joints {
        let description = chain(joints).map_err(as_one)?;
        for function in FUNCTIONS {
            progress.advance(&format!("chain of {joints}: {}", function.name()));
            grown.push(one(&description, joints, function, most, folder)?);
        }
    }
    Ok(grown)
}

fn one(
    description: &Description,
    joints: usize,
    function: Function,
    most: usize,
    folder: &Path,
) -> Result<Grown, Box<dyn Error>> {
    let request = Request {
        functions: vec![vec![function]],
        scalar: Real::F64,
        ..Request::default()
    };
    let start = Instant::now();
    let module = expand(description, &request).map_err(as_one)?;
    let item = Item::named_after("chain");
    // The file has its own sines.
    let tokens = rust::print(&module, &item, &Library::Core(CoreFunctions::default())).to_string();
    let expansion = start.elapsed().as_secs_f64();
    let operation_count = module.functions[0].operation_count;
    let mut grown = Grown {
        joints,
        function,
        operation_count,
        expansion,
        compilation: None,
        call: None,
    };
    if operation_count.mul + operation_count.add <= most {
        let name = format!("{}_{joints}", function.name());
        let path = folder.join(&name).with_extension("rs");
        fs::write(&path, program(&tokens, joints, function))?;
        let executable = folder.join(name).with_extension(env::consts::EXE_EXTENSION);
        let start = Instant::now();
        let output = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
            .args(["--edition=2024", "-Copt-level=3", "-Awarnings", "-o"])
            .args([&executable, &path])
            .output()?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into());
        }
        grown.compilation = Some(start.elapsed().as_secs_f64());
        let output = Command::new(&executable).output()?.stdout;
        grown.call = Some(String::from_utf8(output)?.trim().parse()?);
    }
    Ok(grown)
}

/// A program that prints the time per call.
fn program(tokens: &str, joints: usize, function: Function) -> String {
    let timing = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/src/timing.rs");
    let names: Vec<&str> = function.arguments().iter().map(|a| a.name()).collect();
    let (arguments, function) = (names.join(", "), function.name());
    format!(
        "#[path = \"{}\"]
mod timing;
{tokens}
fn main() {{
    let number = |k: usize| (k % 61) as f64 / 16.0 - 1.9;
    let states: Vec<[[f64; {joints}]; 4]> = (0..256)
        .map(|k| std::array::from_fn(|i| std::array::from_fn(|j| number(13 * k + 7 * i + 11 * j))))
        .collect();
    let batch = || {{
        for [q, qd, qdd, tau] in &states {{
            let _ = (q, qd, qdd, tau);
            std::hint::black_box(&Chain.{function}({arguments}));
        }}
    }};
    let times = timing::alternate(11, 256, std::time::Duration::from_micros(200), &[&batch]);
    println!(\"{{:.2}}\", times[0].median);
}}
",
        timing.display()
    )
}
