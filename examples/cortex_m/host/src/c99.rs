//! The generated C compared with the generated Rust.
//!
//! In: for each board the disassembled image of the controller and object of the functions in C. Out: the rows of a
//! table, or all errors of the C: forbidden symbols and instructions, and functions with more instructions than
//! allowed relative to Rust.

use std::fmt::Write;
use std::path::Path;

use crate::error;
use crate::image::{self, Functions};
use crate::judge::read;

/// The largest number of instructions in C for a hundred in Rust.
const SHARE: u32 = 103;

/// The table of the arm whose images and objects are in `seen`, for these boards.
///
/// # Errors
/// All errors, a line each.
pub fn table(arm: &str, seen: &str, boards: &[&str]) -> Result<String, String> {
    let mut wrong = Vec::new();
    let mut images = Vec::new();
    for board in boards {
        let rust = Path::new(seen).join(arm).join(board);
        let c = Path::new(seen).join("c").join(arm).join(board).join("c99");
        let rust = functions(&rust, &mut Vec::new())?;
        images.push([rust, functions(&c, &mut wrong)?]);
    }
    let mut table = String::new();
    for function in error::FUNCTIONS {
        for ([rust, c], board) in images.iter().zip(boards) {
            let [rust, c] = [rust, c].map(|functions| image::instructions(functions, function));
            // A missing function has none.
            if c == 0 || rust == 0 || 100 * c > SHARE * rust {
                wrong.push(format!(
                    "{board}: {function} has {c} instructions in C, {rust} in Rust"
                ));
            }
        }
        let cell = |language: usize, number: &dyn Fn(&Functions) -> u32| {
            let cells = images.iter().map(|images| number(&images[language]));
            let cells: Vec<_> = cells.map(|number| number.to_string()).collect();
            cells.join(" / ")
        };
        let instructions = |functions: &Functions| image::instructions(functions, function);
        let bytes = |functions: &Functions| functions.get(function).map_or(0, |of| of.bytes);
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "| {arm} | `{function}` | {} | {} | {} | {} |",
            cell(0, &instructions),
            cell(1, &instructions),
            cell(0, &bytes),
            cell(1, &bytes),
        );
    }
    if wrong.is_empty() {
        Ok(table)
    } else {
        Err(wrong.join("\n"))
    }
}

/// The functions of the disassembled image in a folder.
fn functions(folder: &Path, wrong: &mut Vec<String>) -> Result<Functions, String> {
    let [symbols, code] = ["symbols", "code"].map(|file| read(&folder.join(file)));
    Ok(image::read(&symbols?, &code?, wrong))
}
