//! The controller compared with the C of CasADi.
//!
//! In: for each board the observations of the controller, and of the firmware with the functions of `CasADi`: original
//! and edited, each with the sines of newlib and with sines that return at once. Out: the rows of a table, and a line for
//! each number in which the controller is not better. All errors are relative to the same exact results.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use crate::error;
use crate::judge::{Board, read};

/// The rows of a function: the name of the code in the table, and its folder; none for the controller.
const CODES: [(&str, Option<&str>); 3] = [
    ("`homogen`", None),
    ("CasADi", Some("plain")),
    ("CasADi, edited", Some("restrict")),
];

/// The cost of one code on one board.
struct Cost {
    /// The least and the most of the realistic states, and the most of all.
    instructions: [u32; 3],
    without_sines: u32,
    text: u32,
    stack: u32,
}

/// The rows of the table for the arm with observations in `seen` on these boards, and a line for each number in which
/// the controller is not better.
///
/// # Errors
/// A file that cannot be read.
pub fn table(arm: &str, seen: &str, boards: &[&str]) -> Result<[String; 2], String> {
    let mut table = String::new();
    let mut behind = String::new();
    for function in error::FUNCTIONS {
        let mut own = Vec::new();
        for (title, folder) in CODES {
            let mut costs = Vec::new();
            for board in boards {
                costs.push(match folder {
                    None => of_controller(&Path::new(seen).join(arm).join(board), function)?,
                    Some(how) => of_peer(&place(seen, arm, board, how), function)?,
                });
            }
            let found = match folder {
                None => error::worst(function, |_, state| error::controller(function, state)),
                Some(how) => {
                    let results = results(&place(seen, arm, boards[0], how), function)?;
                    let length = results.len() / controller::TRUSTED;
                    error::worst(function, |index, _| {
                        results[index * length..][..length].to_vec()
                    })
                }
            };
            row(&mut table, [arm, function, title], &costs, found);
            if folder.is_none() {
                own = costs;
                continue;
            }
            for ((board, own), peer) in boards.iter().zip(&own).zip(&costs) {
                let numbers = [
                    ("instructions", own.instructions[2], peer.instructions[0]),
                    (
                        "instructions without sines",
                        own.without_sines,
                        peer.without_sines,
                    ),
                    ("bytes of text", own.text, peer.text),
                ];
                for (what, own, peer) in numbers {
                    if own >= peer {
                        // Writing to a string cannot fail.
                        let _ = writeln!(
                            behind,
                            "* {arm}, `{function}` on {board}: {own} {what}, {title} {peer}"
                        );
                    }
                }
            }
        }
    }
    Ok([table, behind])
}

fn place(seen: &str, arm: &str, board: &str, how: &str) -> PathBuf {
    Path::new(seen).join("peer").join(arm).join(board).join(how)
}

fn row(table: &mut String, title: [&str; 3], costs: &[Cost], error: f64) {
    let cell = |number: &dyn Fn(&Cost) -> String| {
        let cells: Vec<_> = costs.iter().map(number).collect();
        cells.join(" / ")
    };
    let [arm, function, code] = title;
    // Writing to a string cannot fail.
    let _ = writeln!(
        table,
        "| {arm} | `{function}` | {code} | {} | {} | {} | {} | {} | {error:.1} |",
        cell(&|cost| match cost.instructions {
            [least, most, _] if least == most => most.to_string(),
            [least, most, _] => format!("{least} to {most}"),
        }),
        cell(&|cost| cost.instructions[2].to_string()),
        cell(&|cost| cost.without_sines.to_string()),
        cell(&|cost| cost.text.to_string()),
        cell(&|cost| cost.stack.to_string()),
    );
}

fn of_controller(folder: &Path, function: &str) -> Result<Cost, String> {
    let board = Board::read(folder, &mut Vec::new())?;
    let cost = board.cost(function);
    Ok(Cost {
        instructions: [cost.instructions; 3],
        without_sines: cost.instructions - board.inside_sines(function),
        text: cost.text,
        stack: cost.stack,
    })
}

fn of_peer(folder: &Path, function: &str) -> Result<Cost, String> {
    let whole = Board::read(&folder.join("newlib"), &mut Vec::new())?;
    let bare = Board::read(&folder.join("none"), &mut Vec::new())?;
    let &[least, most, worst, stack] = &*whole.reported("cost", function) else {
        return Err(format!(
            "no {function} in the output of the peer's firmware"
        ));
    };
    let without = bare.reported("cost", function);
    let size = format!(" peer_{function}");
    let symbols = read(&folder.join("newlib/symbols"))?;
    let line = symbols.lines().find(|line| line.ends_with(&size));
    let text = line.and_then(|line| line.split(' ').nth(1));
    let text = text.and_then(|size| u32::from_str_radix(size, 16).ok());
    Ok(Cost {
        instructions: [least, most, worst],
        without_sines: without.get(1).copied().unwrap_or_default(),
        text: text.ok_or_else(|| format!("no symbol peer_{function}"))?,
        stack,
    })
}

/// All results of a function, state by state.
fn results(folder: &Path, function: &str) -> Result<Vec<f32>, String> {
    let log = read(&folder.join("newlib/log"))?;
    let start = format!("result {function} ");
    let words = log.lines().filter_map(|line| line.strip_prefix(&start));
    Ok(words
        .filter_map(|word| word.parse().ok())
        .map(f32::from_bits)
        .collect())
}
