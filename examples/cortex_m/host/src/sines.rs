//! Sines beside each other.
//!
//! In: for each board a folder with `log` and `symbols` of the firmware that compares them. Out: the
//! rows of a table.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use homogen::trigonometry::single;

/// The functions: what the log calls them, what the table does, and the function.
const SINES: [(&str, &str, fn(f32) -> (f32, f32)); 3] = [
    ("moderate", "`homogen`, up to 3200 rad", single::sin_cos_moderate),
    ("any", "`homogen`, any angle", single::sin_cos),
    ("libm", "`libm::sincosf`", libm::sincosf),
];

/// The table's rows, from what was seen of each board.
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
    for (name, title, function) in SINES {
        let counts = boards.iter().map(|(log, _)| counts(log, name));
        let counts: Vec<_> = counts.collect();
        let bytes = boards.iter().map(|(_, symbols)| bytes(symbols, name).to_string());
        let bytes: Vec<_> = bytes.collect();
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "| {title} | {} | {} | {:.2} |",
            counts.join(" / "),
            bytes.join(" / "),
            worst(function),
        );
    }
    Ok(table)
}

/// `76`, or `32 to 2947`.
fn counts(log: &str, name: &str) -> String {
    let start = format!("sines {name} ");
    let line = log.lines().find_map(|line| line.strip_prefix(&start)).unwrap_or("?");
    match line.split_once(' ') {
        Some((least, most)) if least != most => format!("{least} to {most}"),
        Some((least, _)) => least.to_owned(),
        None => line.to_owned(),
    }
}

/// The bytes of the function and of all that exists for it.
fn bytes(symbols: &str, name: &str) -> u32 {
    let own = |symbol: &str| match name {
        "moderate" => symbol == "controller::sines::sin_cos",
        "any" => symbol == "sines::any" || symbol.ends_with("single::sin_cos_wide"),
        _ => {
            let starts = ["sines::libm", "libm::", "compiler_builtins::float", "__aeabi_d", "__aeabi_f2d", "__aeabi_i2d"];
            starts.iter().any(|start| symbol.starts_with(start))
        }
    };
    let lines = symbols.lines().map(|line| line.splitn(4, ' ').collect::<Vec<_>>());
    let sizes = lines.filter_map(|line| match *line {
        [_, size, _, symbol] if own(symbol) => u32::from_str_radix(size, 16).ok(),
        _ => None,
    });
    sizes.sum()
}

/// The worst error over angles up to 3200 rad, in units of rounding (2⁻²⁴) of each value.
fn worst(function: fn(f32) -> (f32, f32)) -> f64 {
    let angles = (0..2_000_000_u32).map(|i| f32::from_bits(0x3000_0000 + 119 * i));
    let errors = angles.filter(|angle| *angle <= single::LIMIT).map(|angle| {
        let (sine, cosine) = function(angle);
        let (true_sine, true_cosine) = f64::from(angle).sin_cos();
        let error = |found: f32, truth: f64| ((f64::from(found) - truth) / truth).abs();
        error(sine, true_sine).max(error(cosine, true_cosine))
    });
    errors.fold(0.0, f64::max) * 16_777_216.0
}
