//! The time of the derive with all functions, for each robot of the repository.
//!
//! In: the attributes of a struct. Out: time and size of the generated code. Run it without
//! `--release`, since cargo builds procedural macros without optimisation:
//! `cargo run -p homogen-examples --bin expansion`.

use std::error::Error;
use std::time::{Duration, Instant};

use homogen_codegen::front_end::derive;
use homogen_examples::machine;
use proc_macro2::TokenStream;

const ROBOTS: [(&str, &str); 9] = [
    ("two_link", "tip"),
    ("scara", "tool"),
    ("stanford", "tool"),
    ("stanford_general", "tool"),
    ("puma560", "tool"),
    ("puma560_general", "tool"),
    ("ur5_class", "tool0"),
    ("panda_class", "link8"),
    ("quadruped", "fl_foot"),
];

fn main() -> Result<(), Box<dyn Error>> {
    println!("  robot                  ms  characters");
    for (robot, tip) in ROBOTS {
        let (time, text) = expand(robot, tip)?;
        let ms = 1e3 * time.as_secs_f64();
        println!("  {robot:<17} {ms:>7.0} {:>11}", text.chars().count());
    }
    println!("  {}", machine::describe());
    Ok(())
}

/// The best time of three runs, and the generated code.
///
/// # Errors
/// If the derive reports an error, for example because `CARGO_MANIFEST_DIR` is another folder.
fn expand(robot: &str, tip: &str) -> Result<(Duration, String), Box<dyn Error>> {
    let item =
        format!("#[robot(urdf = \"../robots/{robot}.urdf\", tip = \"{tip}\")] struct Robot;");
    let tokens: TokenStream = item.parse()?;
    let once = || {
        let start = Instant::now();
        let code = derive(tokens.clone(), None);
        (start.elapsed(), code)
    };
    let runs = [once(), once(), once()];
    let best = runs.iter().map(|(time, _)| *time).min().unwrap_or_default();
    let [(_, code), ..] = runs;
    let code = code.to_string();
    if code.contains("compile_error") {
        return Err(format!("{robot} was refused; is this run by cargo?").into());
    }
    Ok((best, code))
}
