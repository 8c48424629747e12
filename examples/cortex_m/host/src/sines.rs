//! Comparison of functions for sines.
//!
//! In: for each board a folder with `log` and `symbols` of the firmware that compares them. Out: the
//! rows of a table.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use controller::sines;
use homogen::trigonometry::single;

/// A function from an angle to its sine and cosine.
type SinCos = fn(f32) -> (f32, f32);

/// The functions: the name in the log, the name in the table, the largest angle of the errors \[rad\], and the function.
const SINES: [(&str, &str, f32, SinCos); 4] = [
    (
        "own",
        "those of the file, up to 3200 rad",
        single::LIMIT,
        single::sin_cos_moderate,
    ),
    (
        "any",
        "`homogen::trigonometry`, any angle",
        single::LIMIT,
        single::sin_cos,
    ),
    (
        "libm",
        "`libm::sincosf`, any angle",
        single::LIMIT,
        libm::sincosf,
    ),
    (
        "user",
        "`crate::sines::quick`, up to 7 rad",
        sines::QUICK,
        sines::quick,
    ),
];

/// The rows of the table, from the observations of each board.
///
/// # Errors
/// A file that cannot be read.
pub fn table(folders: &[&str]) -> Result<String, String> {
    let mut boards = Vec::new();
    for folder in folders {
        let read = |file| {
            let path = Path::new(folder).join(file);
            fs::read_to_string(&path)
                .map_err(|reason| format!("cannot read {}: {reason}", path.display()))
        };
        boards.push((read("log")?, read("symbols")?));
    }
    let mut table = String::new();
    for (name, title, limit, function) in SINES {
        let counts = boards.iter().map(|(log, _)| counts(log, name));
        let counts: Vec<_> = counts.collect();
        let bytes = boards
            .iter()
            .map(|(_, symbols)| bytes(symbols, name).to_string());
        let bytes: Vec<_> = bytes.collect();
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "| {title} | {} | {} | {} |",
            counts.join(" / "),
            bytes.join(" / "),
            worst(limit, function),
        );
    }
    Ok(table)
}

/// `76`, or `32 to 2947`.
fn counts(log: &str, name: &str) -> String {
    let start = format!("sines {name} ");
    let line = log
        .lines()
        .find_map(|line| line.strip_prefix(&start))
        .unwrap_or("?");
    match line.split_once(' ') {
        Some((least, most)) if least != most => format!("{least} to {most}"),
        Some((least, _)) => least.to_owned(),
        None => line.to_owned(),
    }
}

/// The bytes of the function and of the code and constants that only it uses.
fn bytes(symbols: &str, name: &str) -> u32 {
    let own = |symbol: &str| match name {
        "own" | "user" => symbol.strip_prefix("sines::") == Some(name),
        "any" => symbol == "sines::any" || symbol.ends_with("single::sin_cos_wide"),
        _ => {
            let starts = [
                "sines::libm",
                "libm::",
                "compiler_builtins::float",
                "__aeabi_d",
                "__aeabi_f2d",
                "__aeabi_i2d",
            ];
            starts.iter().any(|start| symbol.starts_with(start))
        }
    };
    let lines = symbols
        .lines()
        .map(|line| line.splitn(4, ' ').collect::<Vec<_>>());
    let sizes = lines.filter_map(|line| match *line {
        [_, size, _, symbol] if own(symbol) => u32::from_str_radix(size, 16).ok(),
        _ => None,
    });
    sizes.sum()
}

/// The worst errors over angles up to `limit`, in units of rounding (2⁻²⁴): of each value, and of 1.
fn worst(limit: f32, function: SinCos) -> String {
    let angles = (0..2_000_000_u32).map(|i| f32::from_bits(0x3000_0000 + 119 * i));
    let (mut relative, mut absolute) = (0.0_f64, 0.0_f64);
    for angle in angles.filter(|angle| *angle <= limit) {
        let (sine, cosine) = function(angle);
        let (true_sine, true_cosine) = f64::from(angle).sin_cos();
        for (found, truth) in [(sine, true_sine), (cosine, true_cosine)] {
            let error = (f64::from(found) - truth).abs() * 16_777_216.0;
            relative = relative.max(error / truth.abs());
            absolute = absolute.max(error);
        }
    }
    format!("{relative:.2} | {absolute:.2}")
}
