//! The generated C beside the generated Rust.
//!
//! In: for each board the image of the controller and the object of the functions in C, taken apart. Out:
//! the rows of a table, or everything that is wrong with the latter: what no image may have, and a function
//! that takes more instructions than the same in Rust by more than its share.

use std::fmt::Write;
use std::path::Path;

use crate::error;
use crate::image::{self, Functions};
use crate::judge::read;

/// How many instructions in C may stand against a hundred in Rust.
const SHARE: u32 = 103;

/// Of the arm whose images and objects lie in `seen`, for these boards.
///
/// # Errors
/// Everything that is wrong, a line each.
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
            // What is not there takes none.
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

/// The functions of an image that lies in a folder, taken apart.
fn functions(folder: &Path, wrong: &mut Vec<String>) -> Result<Functions, String> {
    let [symbols, code] = ["symbols", "code"].map(|file| read(&folder.join(file)));
    Ok(image::read(&symbols?, &code?, wrong))
}
